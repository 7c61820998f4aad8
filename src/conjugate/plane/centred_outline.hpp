// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of one pitch, cut at its centre line; a symmetric pair's left half is the image of its right one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "conjugate/outline_sampler.hpp"

namespace hdconj::conjugate {

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
