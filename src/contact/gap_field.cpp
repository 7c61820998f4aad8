// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "hdconj/base/parallel.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/numeric/bracketed_minimum.hpp"
#include "lane_placement.hpp"

namespace hdconj::contact {
namespace {

/// Number of the first space of a turn, so that the spaces lie in -pi ... pi about the major axis.
int first_space(int spaces)
{
    return -((spaces - 1) / 2);
}

/// The tooth whose undeformed angle is nearest to that of space @p m.
int tooth_near(int m, int flexspline_teeth, int circular_spline_teeth, double phase)
{
    double const k = static_cast<double>(flexspline_teeth) / circular_spline_teeth;
    double const angle = 2 * std::numbers::pi * m / circular_spline_teeth + k * phase;
    return static_cast<int>(std::lround((angle - phase) * flexspline_teeth / (2 * std::numbers::pi)));
}

}  // namespace

std::array<int, 2> teeth_needed(int flexspline_teeth, int circular_spline_teeth, double phase)
{
    int const first = first_space(circular_spline_teeth);
    int const last = first + circular_spline_teeth - 1;
    return {tooth_near(first, flexspline_teeth, circular_spline_teeth, phase) - 1,
            tooth_near(last, flexspline_teeth, circular_spline_teeth, phase) + 1};
}

GapField::GapField(profile::Profile const& tooth, FlankGrid const& grid, ToothPoses const& places, int flexspline_teeth,
                   int circular_spline_teeth, double phase, FlankDeviation const* deviation, int lobes)
    : distance_(tooth),
      grid_(&grid),
      places_(&places),
      deviation_(deviation),
      pitch_(2 * std::numbers::pi / circular_spline_teeth),
      lobes_(lobes),
      has_mirror_image_(tooth.mirror_symmetric && phase == 0)
{
    int const first = first_space(circular_spline_teeth);
    double const k = static_cast<double>(flexspline_teeth) / circular_spline_teeth;
    for (int m = first; m < first + circular_spline_teeth; ++m) {
        space_number_.push_back(m);
        space_angle_.push_back(pitch_ * m + k * phase);
        nearest_tooth_.push_back(tooth_near(m, flexspline_teeth, circular_spline_teeth, phase));
    }
    for (auto const& flank : grid.point)
        for (auto const& slice : flank)
            for (std::size_t i = 0; i < slice.size(); ++i) {
                reach_ = std::max(reach_, slice[i].norm());
                if (i > 0)
                    spacing_ = std::max(spacing_, (slice[i] - slice[i - 1]).norm());
            }
}

int GapField::candidate(std::size_t space, int c) const
{
    // nearest first, so that the others are mostly told far by their bound
    return nearest_tooth_[space] + (c == 0 ? 0 : c == 1 ? -1 : 1);
}

double GapField::turn_between(std::size_t space, int tooth, double turn) const
{
    return deviation_ ? turn + displacement_at(deviation_->teeth, tooth).turn -
                            displacement_at(deviation_->spaces, space_number_[space]).turn
                      : turn;
}

GapField::Candidates GapField::candidates_of(std::size_t space, std::size_t slice, double turn) const
{
    Candidates teeth;
    for (int c = 0; c < candidates; ++c) {
        int const tooth = candidate(space, c);
        Pose const& pose = places_->at(tooth, slice);
        // into the frame of the tooth's own space, then back by the flexspline's turn, then into the tooth's frame
        double const angle = (space_number_[space] - tooth) * pitch_ - turn_between(space, tooth, turn);
        double const c0 = std::cos(angle);
        double const s0 = std::sin(angle);
        Placement& placement = teeth[static_cast<std::size_t>(c)];
        placement = {c0 * pose.cosine + s0 * pose.sine, s0 * pose.cosine - c0 * pose.sine,
                     pose.rotate_back(pose.origin)};
        if (deviation_)  // a point goes with its space, and the tooth away from it
            placement.shift =
                deviation_->shift(displacement_at(deviation_->teeth, tooth), slice) -
                placement(deviation_->shift(displacement_at(deviation_->spaces, space_number_[space]), slice));
    }
    return teeth;
}

double GapField::nearest(Candidates const& teeth, Vec2 const& q) const
{
    double best = std::numeric_limits<double>::infinity();
    for (Placement const& tooth : teeth) {
        Vec2 const x = tooth(q);
        if (!(distance_.lower_bound(x) < best + excess()))
            continue;
        distance::NearestPoint const found = distance_(x);
        best = std::min(best, has_heights() ? found.distance + deviation_->height(found.point.y()) : found.distance);
    }
    return best + standing_back(q);
}

void GapField::nearest(NearTeeth const& near, Vec2 const* q, std::size_t count, double less, double* out,
                       Vec2* gradient) const
{
    using distance::lanes;
    distance::DistanceLanes const* const together = distance_.together();
    std::size_t i = 0;
    for (; together != nullptr && i + 1 < count; i += lanes) {
        LanePoints points;
        PlacedLanes placed;
        std::array<Vec2, lanes> normal;
        distance::DistanceLanes::Nearest found;
        for (std::size_t l = 0; l < lanes; ++l) {
            Vec2 const& point = q[std::min(i + l, count - 1)];
            points.x[l] = point.x();
            points.y[l] = point.y();
            points.best[l] = std::numeric_limits<double>::infinity();
        }
        for (Placement const& tooth : near.teeth) {
            place(distance_, tooth.cosine, tooth.sine, tooth.shift, points, excess(), placed);
            if (!placed.any)
                continue;
            (*together)(placed.x, placed.y, found);
            for (std::size_t l = 0; has_heights() && l < lanes; ++l)
                found.distance[l] += deviation_->height(found.foot_y[l]);
            keep_nearer(found.distance, points, placed);
            for (std::size_t l = 0; gradient != nullptr && l < lanes; ++l)
                if (placed.asked[l] != 0)
                    normal[l] = tooth.rotate_back({found.normal_x[l], found.normal_y[l]});
        }
        for (std::size_t l = 0; l < lanes && i + l < count; ++l) {
            out[i + l] = points.best[l] + standing_back(q[i + l]) - less;
            if (gradient != nullptr)
                gradient[i + l] = deviation_ ? touch(near, q[i + l]).gradient() : normal[l];
        }
    }
    for (; i < count; ++i) {
        out[i] = nearest(near.teeth, q[i]) - less;
        if (gradient != nullptr)
            gradient[i] = touch(near, q[i]).gradient();
    }
}

double GapField::radius(int flank, std::size_t slice) const
{
    auto const& radius = grid_->radius[static_cast<std::size_t>(flank)];
    return radius.empty() ? 0 : radius[slice];
}

double GapField::gap(Index const& i, double turn) const
{
    return nearest(candidates_of(i.space, i.slice, turn),
                   grid_->point[static_cast<std::size_t>(i.flank)][i.slice][i.point]) -
           deduction(i.flank, i.slice);
}

double GapField::lowest_about(Index const& i, double gap, double turn, double enough) const
{
    Candidates const teeth = candidates_of(i.space, i.slice, turn);
    double const less = deduction(i.flank, i.slice);
    auto const gap_at = [&](double s) { return nearest(teeth, grid_->between(i.flank, i.slice, s)) - less; };
    double const here = grid_->place(i.flank, i.point);
    double lowest = gap;
    if (i.point > 0)
        lowest = std::min(
            lowest, numeric::minimum_of_steps(gap_at, here, grid_->place(i.flank, i.point - 1), gap, enough).value);
    if (i.point + 1 < grid_->points())
        lowest = std::min(
            lowest, numeric::minimum_of_steps(gap_at, here, grid_->place(i.flank, i.point + 1), gap, enough).value);
    return lowest;
}

void GapField::along(std::size_t space, int flank, std::size_t slice, double turn, double* out) const
{
    auto const& line = grid_->point[static_cast<std::size_t>(flank)][slice];
    gaps(near_teeth(space, slice, turn), flank, line.data(), line.size(), out);
}

GapField::Touch GapField::touch(Index const& i, double turn) const
{
    return touch(i.space, i.slice, grid_->point[static_cast<std::size_t>(i.flank)][i.slice][i.point], turn);
}

GapField::Touch GapField::touch(NearTeeth const& near, Vec2 const& q) const
{
    Touch best;
    best.nearest.distance = std::numeric_limits<double>::infinity();
    for (int c = 0; c < candidates; ++c) {
        Placement const& tooth = near.teeth[static_cast<std::size_t>(c)];
        Vec2 const x = tooth(q);
        if (!(distance_.lower_bound(x) < best.nearest.distance + excess()))
            continue;
        distance::NearestPoint found = distance_(x);
        if (has_heights()) {
            found.distance += deviation_->height(found.point.y());
            found.normal = deviating_normal(x, found.normal);
        }
        if (found.distance < best.nearest.distance)
            best = {candidate(near.space, c), found, tooth.rotate_back(found.normal), near.turn, Vec2::Zero()};
    }
    best.nearest.distance += opening(near.slice) + standing_back(q);
    best.rise = rise(q);
    best.turn = turn_between(near.space, best.tooth, near.turn);
    return best;
}

bool GapField::is_mirrored() const
{
    if (!has_mirror_image_ || deviation_ != nullptr)
        return false;
    auto const& [left, right] = grid_->point;
    auto const is_image = [](Vec2 const& a, Vec2 const& b) { return a.x() == -b.x() && a.y() == b.y(); };
    for (std::size_t k = 0; k < grid_->slices(); ++k)
        if (radius(GapMap::left, k) != radius(GapMap::right, k) ||
            !std::equal(left[k].begin(), left[k].end(), right[k].begin(), right[k].end(), is_image))
            return false;
    double const rounding = 16 * unit_roundoff;
    auto const is_near = [&](Pose const& a, Pose const& b) {
        return std::abs(a.cosine - b.cosine) <= rounding && std::abs(a.sine + b.sine) <= rounding &&
               (a.origin - Vec2(-b.origin.x(), b.origin.y())).norm() <= rounding * reach_;
    };
    int const last = places_->first + static_cast<int>(places_->pose.size() / places_->slices) - 1;
    for (int tooth = std::max(0, -last); tooth <= std::min(last, -places_->first); ++tooth)
        for (std::size_t k = 0; k < places_->slices; ++k)
            if (!is_near(places_->at(tooth, k), places_->at(-tooth, k)))
                return false;
    return true;
}

GapMap GapField::map(double turn, int threads) const
{
    GapMap result{grid_->z, grid_->station, space_angle_, {}};
    std::size_t const points = grid_->points();
    result.gap.resize(spaces() * 2 * grid_->slices() * points);
    constexpr double nanoseconds_each = 100;
    constexpr double worth_a_thread = 1e6;
    auto const per_space = nanoseconds_each * static_cast<double>(2 * grid_->slices() * points);
    auto const grain = static_cast<std::size_t>(std::ceil(worth_a_thread / per_space));
    std::size_t const lobe = spaces_of_lobe(), first = first_of_lobe();
    bool const mirrored = turn == 0 && is_mirrored();
    // the space whose right flank is the mirror image of the left one of this; none where it is not computed
    auto const image_of = [&](std::size_t space) -> std::optional<std::size_t> {
        auto const sum = 2 * static_cast<std::size_t>(-space_number_.front());
        if (!mirrored || space > sum || sum - space < first || sum - space >= first + lobe)
            return std::nullopt;
        return sum - space;
    };
    parallel_for(lobe, threads, grain, [&](std::size_t s) {
        std::size_t const space = first + s;
        bool const has_image = image_of(space).has_value();
        for (std::size_t k = 0; k < grid_->slices(); ++k) {
            NearTeeth const near = near_teeth(space, k, turn);
            for (int const flank : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)}) {
                if (flank == GapMap::left && has_image)
                    continue;
                double* const row = result.gap.data() + result.index(space, flank, k, 0);
                auto const& line = grid_->point[static_cast<std::size_t>(flank)][k];
                gaps(near, flank, line.data(), points, row);
            }
        }
    });
    for (std::size_t space = first; space < first + lobe; ++space)
        if (auto const image = image_of(space))
            std::copy_n(result.gap.begin() + static_cast<std::ptrdiff_t>(result.index(*image, GapMap::right, 0, 0)),
                        grid_->slices() * points,
                        result.gap.begin() + static_cast<std::ptrdiff_t>(result.index(space, GapMap::left, 0, 0)));
    auto const at = [&](std::size_t space) {
        return result.gap.begin() + static_cast<std::ptrdiff_t>(result.index(space, 0, 0, 0));
    };
    for (std::size_t space = 0; space < spaces(); ++space)
        if (space < first || space >= first + lobe) {
            auto const same = at(first + (space + spaces() - first) % lobe);
            std::copy(same, same + (at(1) - at(0)), at(space));
        }
    return result;
}

}  // namespace hdconj::contact
