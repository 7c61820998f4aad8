// SPDX-License-Identifier: GPL-3.0-or-later
// Branches, zones, positions and the outline of the tooth as they are written into results.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// The points of polygon_of() with the pitch line at y = 0, in blocks of fixed size that may be made in any order, by
/// any thread. The profile and the points must outlive it.
class ToothOutline
{
  public:
    /// @param chord   [mm]
    /// @param points  gets the outline's size at once, and its points block by block
    ToothOutline(profile::Profile const& profile, double chord, std::vector<Vec2>& points);

    [[nodiscard]] std::size_t blocks() const { return (points_.size() + block - 1) / block; }
    void operator()(std::size_t b) const;

  private:
    static constexpr std::size_t block = 512;

    struct Run
    {
        profile::PieceShape const* shape;
        std::size_t before;  ///< points of the runs before
        int steps;
    };

    double pitch_line_;
    std::vector<Run> runs_;
    std::vector<Vec2>& points_;
};

/// The branch sampled to the chord error, exact ends included.
[[nodiscard]] BranchRecord branch_record(envelope::AnyEnvelope const& envelope, envelope::Branch const& branch,
                                         double chord, std::size_t& evaluations);

/// Adds the conjugate zones of branch @p index to @p out: stretches on which t is monotone and the envelope stays outer
/// or inner. The branch is on the boundary where one of them is.
void append_zones(envelope::AnyEnvelope const& envelope, envelope::Branch const& branch, std::size_t index,
                  std::vector<envelope::ContactArc> const& boundary_arcs, std::vector<BoundaryPiece> const& pieces,
                  Solution& out);

/// Adds the tooth at 41 instants from one end of the lobe to the other to @p family, as polygons, each moved by -@p
/// down along y [mm].
void add_positions(profile::Profile const& tooth, motion::AnyMotion const& motion, double down,
                   std::vector<std::vector<Vec2>>& family);

}  // namespace hdconj::conjugate
