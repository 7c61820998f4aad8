// SPDX-License-Identifier: GPL-3.0-or-later
// Places short labels beside points of a diagram where they lie on no line, point or other label.
#pragma once

#include <string>
#include <vector>

namespace hdconj::report {

/// [px] from the left and upper edges of the picture.
struct Spot
{
    double x = 0, y = 0;
};

/// What a text takes [px].
struct LabelBox
{
    double left = 0, right = 0, top = 0, bottom = 0;

    [[nodiscard]] bool holds(Spot const& spot) const
    {
        return spot.x > left && spot.x < right && spot.y > top && spot.y < bottom;
    }
    [[nodiscard]] bool meets(LabelBox const& other) const
    {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// A diagram's ink, and the labels placed so far.
class LabelPlaces
{
  public:
    explicit LabelPlaces(LabelBox const& frame) : frame_(frame) {}

    /// A line from one place to another: labels keep away from it where they can.
    void add_line(Spot const& from, Spot const& to);
    /// A point: labels keep away from it rather than from a line.
    void add_point(Spot const& at) { points_.push_back(at); }

    /// The box for @p text beside @p at: of places around it, near ones first, the one with the least ink under it. The
    /// next labels keep away from it.
    LabelBox place(std::string const& text, Spot const& at);

  private:
    [[nodiscard]] double ink_under(LabelBox const& box) const;

    LabelBox frame_;
    std::vector<Spot> points_, ink_;
    std::vector<LabelBox> labels_;
};

}  // namespace hdconj::report
