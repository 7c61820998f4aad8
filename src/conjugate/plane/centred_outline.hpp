// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of one pitch, cut at its centre line; a symmetric pair's left half is the image of its right one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "conjugate/outline.hpp"
#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"

namespace hdconj::conjugate {

/// Samples boundary pieces to a chord error, each by itself: in any order, by any thread. Neighbours share their common
/// point. What it is made of must outlive it.
class OutlineSampler
{
  public:
    /// @param pitch  of the circular spline's teeth [rad]
    /// @param chord  [mm]
    OutlineSampler(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                   std::vector<BoundaryPiece> pieces, double pitch, double chord);

    [[nodiscard]] std::size_t count() const { return pieces_.size(); }

    /// About how many chords a piece takes, for sharing out work; land is none.
    [[nodiscard]] double expected(std::size_t i) const;

    /// Samples a piece, before joined(). @param threads  for its points
    void sample(std::size_t i, int threads);

    /// Pieces @p from ... @p to - 1, one after the other; they have been sampled. @param tip_radius  of land [mm]
    [[nodiscard]] Outline joined(double tip_radius, std::size_t from, std::size_t to) const;

  private:
    struct Sampled
    {
        std::vector<Vec2> points;
        double chord = 0;
        double error = 0;
        std::size_t evaluations = 0;
    };

    [[nodiscard]] envelope::ContactArc const& arc(BoundaryPiece const& piece) const
    {
        return arcs_[static_cast<std::size_t>(piece.arc)];
    }

    envelope::AnyEnvelope const& envelope_;
    std::vector<envelope::ContactArc> const& arcs_;
    std::vector<BoundaryPiece> pieces_;
    double pitch_;
    double chord_;
    std::vector<Sampled> sampled_;
};

/// Samples every piece to the chord error.
[[nodiscard]] Outline sample_outline(envelope::AnyEnvelope const& envelope,
                                     std::vector<envelope::ContactArc> const& arcs,
                                     std::vector<BoundaryPiece> const& pieces, double tip_radius, double pitch,
                                     double chord, int threads);

/// The outline with the index of its middle point, where x = 0.
struct CentredOutline
{
    Outline outline;
    std::size_t middle = 0;
};

/// The boundary's pieces left and right of x = 0.
struct Halves
{
    std::vector<BoundaryPiece> left;
    std::vector<BoundaryPiece> right;
};

/// Cuts the boundary where it crosses x = 0.
/// @throws NumericalError when it does not
[[nodiscard]] Halves cut_at_centre_line(envelope::AnyEnvelope const& envelope,
                                        std::vector<envelope::ContactArc> const& arcs,
                                        std::vector<BoundaryPiece> const& pieces, double pitch,
                                        Tolerance const& tolerance);

/// Mirror image of the right half of a symmetric pair's outline.
[[nodiscard]] Outline mirrored(Outline const& half, profile::Profile const& tooth);

/// Samples the boundary of one pitch, piece by piece in any order; a symmetric pair's right half is mirrored, bit for
/// bit. What it is made of must outlive it.
class CentredOutlineSampler
{
  public:
    /// @throws NumericalError when the boundary does not cross x = 0
    CentredOutlineSampler(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                          std::vector<BoundaryPiece> const& pieces, double tip_radius, double pitch,
                          Tolerance const& tolerance, double chord);

    /// Of all pieces, for sharing out work.
    [[nodiscard]] OutlineSampler& pieces() { return *pieces_; }
    /// Of all pieces, which have been sampled.
    [[nodiscard]] CentredOutline joined() const;

  private:
    profile::Profile const& profile_;
    double tip_radius_;
    std::size_t right_ = 0;  ///< pieces of the right half, which are the first
    std::optional<OutlineSampler> pieces_;
};

}  // namespace hdconj::conjugate
