// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the circular spline's toothed boundary, from the pieces that bound its tooth space.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "outline.hpp"

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

}  // namespace hdconj::conjugate
