// SPDX-License-Identifier: GPL-3.0-or-later
#include "tooth_outline.hpp"

#include <algorithm>

namespace hdconj::conjugate {

ToothOutline::ToothOutline(profile::Profile const& profile, double chord, std::vector<Vec2>& points)
    : pitch_line_(profile.pitch_line), points_(points)
{
    std::size_t count = 1;
    for (profile::ProfilePiece const& piece : profile.pieces) {
        if (piece.corner)
            continue;
        runs_.push_back({&piece.shape, count, profile::steps_of(piece.shape, chord)});
        count += static_cast<std::size_t>(runs_.back().steps);
    }
    points_.resize(count);
}

void ToothOutline::operator()(std::size_t b) const
{
    std::size_t const last = std::min(points_.size(), (b + 1) * block);
    std::size_t k = b * block;
    if (k == 0) {
        points_.front() = profile::start_of(*runs_.front().shape).point;
        points_.front().y() -= pitch_line_;
        k = 1;
    }
    auto run = std::upper_bound(runs_.begin(), runs_.end(), k,
                                [](std::size_t point, Run const& r) { return point < r.before; }) -
               1;
    for (; k < last; ++k) {
        while (k >= run->before + static_cast<std::size_t>(run->steps))
            ++run;
        points_[k] = profile::point_at(*run->shape, static_cast<double>(k - run->before + 1) / run->steps);
        points_[k].y() -= pitch_line_;
    }
}

}  // namespace hdconj::conjugate
