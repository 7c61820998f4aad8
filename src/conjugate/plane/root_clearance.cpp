// SPDX-License-Identifier: GPL-3.0-or-later
#include "root_clearance.hpp"

#include <algorithm>

#include "hdconj/error.hpp"

namespace hdconj::conjugate {

Bottom bottom_of(Outline const& outline, std::size_t middle)
{
    auto const tip = [](OutlineStretch const& s) {
        return s.kind == OutlineKind::corner || s.kind == OutlineKind::bottom || s.kind == OutlineKind::root ||
               s.kind == OutlineKind::root_wall;
    };
    Bottom bottom{middle, middle};
    for (OutlineStretch const& s : outline.stretches)
        if (tip(s) && s.first >= bottom.last && s.first <= bottom.last && s.last > middle)
            bottom.last = s.last;
    for (auto s = outline.stretches.rbegin(); s != outline.stretches.rend(); ++s)
        if (tip(*s) && s->last == bottom.first && s->first < middle)
            bottom.first = s->first;
    return bottom;
}

void deepen(Outline& outline, std::size_t middle, double clearance)
{
    Bottom const bottom = bottom_of(outline, middle);
    auto& points = outline.points;
    std::size_t left = bottom.first;
    std::size_t right = bottom.last;
    for (std::size_t i = bottom.first; i <= middle; ++i)
        if (points[i].x() < points[left].x())
            left = i;
    for (std::size_t i = middle; i <= bottom.last; ++i)
        if (points[i].x() >= points[right].x())
            right = i;
    for (std::size_t i = left; i < right; ++i)
        if (!(points[i + 1].x() > points[i].x()))
            throw NumericalError(ErrorCode::no_outline, "root clearance", near_text(points[i]),
                                 "the bottom of the tooth space folds over itself there and cannot be moved outward");
    if (right <= left)
        throw NumericalError(ErrorCode::no_outline, "root clearance", "tooth space",
                             "has no bottom that could be moved outward");

    Vec2 const shift{0, clearance};
    std::size_t const before = points.size();
    points.resize(before + 2);
    std::copy_backward(points.begin() + static_cast<std::ptrdiff_t>(right),
                       points.begin() + static_cast<std::ptrdiff_t>(before), points.end());
    for (std::size_t i = right + 1; i > left; --i)
        points[i] = points[i - 1] + shift;

    std::vector<OutlineStretch> stretches;
    for (OutlineStretch const& s : outline.stretches) {
        // what lies before the left wall stays, what lies between the walls moves by one index, what lies behind by two
        if (s.first < left)
            stretches.push_back({s.kind, s.segment, s.first, std::min(s.last, left)});
        if (s.last > left && s.first < right) {
            if (s.first <= left)
                stretches.push_back({OutlineKind::root_wall, -1, left, left + 1});
            stretches.push_back(
                {OutlineKind::root, s.segment, std::max(s.first, left) + 1, std::min(s.last, right) + 1});
            if (s.last >= right)
                stretches.push_back({OutlineKind::root_wall, -1, right + 1, right + 2});
        }
        if (s.last > right)
            stretches.push_back({s.kind, s.segment, std::max(s.first, right) + 2, s.last + 2});
    }
    outline.stretches = std::move(stretches);
}

}  // namespace hdconj::conjugate
