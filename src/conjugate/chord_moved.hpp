// SPDX-License-Identifier: GPL-3.0-or-later
// The chord error of an outline that is moved radially.
#pragma once

#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::conjugate {

/// Chord error of @p points, which had @p chord, once they are moved outward by @p distance: what lay beside a chord is
/// stretched by up to 1 + distance/r, with r the least radius, and a straight line bends. The second derivative of the
/// unit vector to a point of a line h from the axis, x along it, is h sqrt(4 x^2 + h^2)/r^4: a chord of length L bends
/// by up to |distance| L^2/8 times that, sqrt(4/3)/r^2 at most, nothing for a line through the axis.
[[nodiscard]] double chord_moved_radially(std::vector<Vec2> const& points, double chord, double distance);

/// What to sample an outline to, so that it keeps a chord error when it has been moved: first that itself, since an
/// outline keeps its points where they are enough.
class MovedChord
{
  public:
    /// @param wanted  [mm]
    explicit MovedChord(double wanted) : wanted_(wanted), asked_(wanted) {}

    [[nodiscard]] double asked() const { return asked_; }

    /// Whether to sample once more, to the asked() that follows from @p got: chords and what they bend by shrink
    /// together.
    [[nodiscard]] bool is_longer(double got)
    {
        constexpr int budget = 4;
        constexpr double slack = 0.98;
        if (got <= wanted_ || ++rounds_ == budget)
            return false;
        asked_ *= slack * wanted_ / got;
        return true;
    }

  private:
    double wanted_, asked_;
    int rounds_ = 0;
};

/// Largest distance by which a scene's tilt of kind "radial" moves an outline; 0 without one [mm].
[[nodiscard]] double largest_radial_shift(Scene const& scene);

}  // namespace hdconj::conjugate
