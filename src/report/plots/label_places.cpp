// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hdconj::report {
namespace {

constexpr double letter_width = 9.2, line_height = 17;  // [px]
constexpr double ink_step = 2;                          // between points that stand for a line [px]

/// The box of that size whose nearest edge or corner in direction (@p right, @p down) is @p gap away from @p at.
LabelBox beside(Spot const& at, double width, double height, int right, int down, double gap)
{
    auto const from = [gap](double centre, double size, int side) {
        return side == 0 ? centre - size / 2 : side > 0 ? centre + gap : centre - gap - size;
    };
    double const left = from(at.x, width, right), top = from(at.y, height, down);
    return {left, left + width, top, top + height};
}

}  // namespace

void LabelPlaces::add_line(Spot const& from, Spot const& to)
{
    int const steps = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / ink_step);
    for (int i = 0; i <= steps; ++i) {
        double const share = static_cast<double>(i) / steps;
        ink_.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    }
}

double LabelPlaces::ink_under(LabelBox const& box) const
{
    constexpr double of_label = 1e4, of_frame = 1e4, of_point = 40;
    bool const inside =
        box.left >= frame_.left && box.right <= frame_.right && box.top >= frame_.top && box.bottom <= frame_.bottom;
    double ink = inside ? 0 : of_frame;
    for (auto const& label : labels_)
        ink += label.meets(box) ? of_label : 0;
    for (auto const& point : points_)
        ink += box.holds(point) ? of_point : 0;
    return ink + static_cast<double>(
                     std::count_if(ink_.begin(), ink_.end(), [&](Spot const& spot) { return box.holds(spot); }));
}

LabelBox LabelPlaces::place(std::string const& text, Spot const& at)
{
    constexpr std::array<std::pair<int, int>, 8> sides = {
        {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}}};
    constexpr std::array<double, 5> gaps = {5, 10, 17, 26, 38};  // [px]
    double least = std::numeric_limits<double>::infinity();
    LabelBox best;
    for (double const gap : gaps) {
        for (auto const& [right, down] : sides) {
            LabelBox const box =
                beside(at, letter_width * static_cast<double>(text.size()), line_height, right, down, gap);
            if (double const cost = ink_under(box) + gap / 2; cost < least) {
                least = cost;
                best = box;
            }
        }
    }
    labels_.push_back(best);
    return best;
}

}  // namespace hdconj::report
