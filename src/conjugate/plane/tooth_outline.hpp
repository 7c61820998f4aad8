// SPDX-License-Identifier: GPL-3.0-or-later
// The given tooth as results show it.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/profile/profile.hpp"

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

}  // namespace hdconj::conjugate
