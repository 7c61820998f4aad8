// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_by_planes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact_study_data.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::contact {
namespace {

/// A stretch of a flank, its ends as FlankGrid::between() counts.
struct ContactStretch
{
    double from = 0, to = 0;
};

/// The edges of contact, met one after the other along a flank.
template <class Excess>
class Edges
{
  public:
    Edges(Excess const& excess, double s, double at_s)
        : excess_(excess), s_(s), at_s_(at_s), open_(at_s <= 0), begin_(s)
    {
    }

    /// On to @p to, @p way further along the flank: halved where an end may lie between.
    void go_on(double to, double at_to, double way, int halvings)
    {
        // an arc is longer than its chord by less than this for any flank of a tooth
        constexpr double longer = 1.25;
        bool const same = (at_s_ <= 0) == (at_to <= 0);
        if (halvings > 0 && !(same && std::abs(at_s_) + std::abs(at_to) > longer * way)) {
            double const middle = 0.5 * (s_ + to);
            go_on(middle, excess_(middle), way / 2, halvings - 1);
            go_on(to, at_to, way / 2, halvings - 1);
            return;
        }
        if (!same) {
            double const edge = numeric::bracketed_root(excess_, s_, to, at_s_, at_to).x;
            if (open_)
                found_.push_back({begin_, edge});
            begin_ = edge;
            open_ = !open_;
        }
        s_ = to;
        at_s_ = at_to;
    }

    /// Ends where it stands.
    [[nodiscard]] std::vector<ContactStretch> found() &&
    {
        if (open_ && s_ > begin_)
            found_.push_back({begin_, s_});
        return std::move(found_);
    }

  private:
    Excess const& excess_;
    double s_, at_s_;
    bool open_;
    double begin_;
    std::vector<ContactStretch> found_;
};

/// Where the gap of a flank of one space in one plane is at most @p limit [mm] at turn 0, in order along the flank.
///
/// The ends are roots of the exact gap (bracketed_root()), to the last bits. No gap changes faster than the flank goes
/// on: where that rules out an edge between two stations the gap is not looked at; elsewhere they are halved up to
/// three times, and two edges within an eighth of them may be missed.
/// @param stride  only every so many stations are looked at, and the last one: what another stride changes tells how
/// much is hidden
std::vector<ContactStretch> contact_stretches(GapField const& field, std::size_t space, int flank, std::size_t slice,
                                              double limit, std::size_t stride)
{
    constexpr int halvings = 3;  // between two stations
    FlankGrid const& grid = field.grid();
    auto const& line = grid.point[static_cast<std::size_t>(flank)][slice];
    std::vector<double> gap(line.size());
    field.along(space, flank, slice, 0, gap.data());
    auto const excess = [&](double s) { return field.gap_between(space, flank, slice, s, 0) - limit; };
    Edges edges(excess, grid.place(flank, 0), gap.front() - limit);
    for (std::size_t j = 0, next = 0; j + 1 < line.size(); j = next) {
        next = std::min(j + stride, line.size() - 1);
        edges.go_on(grid.place(flank, next), gap[next] - limit, (line[next] - line[j]).norm(), halvings);
    }
    return std::move(edges).found();
}

/// What those stretches add to the area per length of the axis: the integral of sqrt(1 + v^2) along them, v the speed
/// at which the flank moves along its normal from plane to plane [mm^2/mm].
///
/// The outward rate of a surface that z cuts: dA = ds dz sqrt(1 + (n . dp/dz)^2), whatever points of two planes belong
/// together. Of v: central differences between the planes beside, at an end plane to the one that is there.
double area_per_length(FlankGrid const& grid, int flank, std::size_t slice,
                       std::vector<ContactStretch> const& stretches)
{
    auto const f = static_cast<std::size_t>(flank);
    auto const& line = grid.line[f].empty() ? grid.point[f] : grid.line[f];
    auto const& normal = grid.line[f].empty() ? grid.normal[f] : grid.line_normal[f];
    std::size_t const low = slice > 0 ? slice - 1 : slice, high = std::min(slice + 1, grid.slices() - 1);
    auto const speed = [&](std::size_t i) {
        return high > low ? normal[slice][i].dot(line[high][i] - line[low][i]) / (grid.z[high] - grid.z[low]) : 0.0;
    };
    double sum = 0;
    for (ContactStretch const& stretch : stretches) {
        auto i = static_cast<std::size_t>(stretch.from);
        for (double s = stretch.from; s < stretch.to && i + 1 < line[slice].size(); ++i) {
            double const end = std::min(stretch.to, static_cast<double>(i + 1));
            double const v = 0.5 * (speed(i) + speed(i + 1));
            sum += (end - s) * (line[slice][i + 1] - line[slice][i]).norm() * std::sqrt(1 + v * v);
            s = end;
        }
    }
    return sum;
}

/// Lengths of contact in one plane, of all spaces together.
struct PlaneLength
{
    double all = 0;     ///< by all stations
    double second = 0;  ///< by every second one
};

/// Lengths in neighbouring planes, which are solved together.
std::vector<PlaneLength> lengths(ContactContext const& context, surface::ToothSurfaceBuilder& maker, double tip,
                                 double phase)
{
    int const z_f = context.scene.drive.flexspline_teeth, z_c = context.scene.drive.circular_spline_teeth;
    conjugate::MatchedOutline const outline = maker.outline({ToothSurface::per_slice, TiltKind::radial, 0}, tip,
                                                            {context.tolerance.length, context.request.flank_points});
    FlankGrid const grid = flank_grid(outline, maker.z(), context.request.flank_points);
    ToothPoses const places = tooth_places(context, phase, grid.z);
    GapField const field(context.tooth, grid, places, z_f, z_c, phase);
    std::vector<PlaneLength> result(grid.slices());
    constexpr std::size_t grain = 1;
    parallel_for(grid.slices(), context.threads, grain, [&](std::size_t k) {
        auto const length = [&](std::size_t space, std::size_t stride) {
            return area_per_length(grid, GapMap::right, k,
                                   contact_stretches(field, space, GapMap::right, k, context.request.gap, stride));
        };
        for (std::size_t space = 0; space < field.spaces(); ++space) {
            result[k].all += length(space, 1);
            result[k].second += length(space, 2);
        }
    });
    return result;
}

/// Trapezoidal rule over every @p stride of the planes.
double trapezoid(std::vector<PlaneLength> const& length, double PlaneLength::*which, std::size_t stride, double width)
{
    std::size_t const last = length.size() - 1;
    double sum = 0;
    for (std::size_t k = 0; k <= last; k += stride)
        sum += (k == 0 || k == last ? 0.5 : 1) * length[k].*which;
    return sum * width * static_cast<double>(stride) / static_cast<double>(last);
}

void check(Scene const& scene)
{
    Faults faults = check_contact(scene, {});
    if (scene.circular_spline.automatic_backlash || scene.circular_spline.backlash_offset != 0)
        faults.push_back({"circular_spline.backlash_offset", 0, "",
                          "the area by planes is that of flanks that touch without being turned", "write 0"});
    throw_if_any(faults);
}

}  // namespace

AreaByPlanes contact_by_planes(Scene const& scene, int planes)
{
    check(scene);
    constexpr int at_once = 64;  // intervals solved together: outlines of many planes have the points of all
    constexpr int coarse = 17;   // planes that the tip circle is looked for in; it is decided at an end of the width
    int const intervals = planes - 1;
    StageObserver const nobody;  // the clock keeps a copy
    ContactStudyData data(scene, Verb::contact, nobody, std::min(planes, coarse));
    ContactContext const& context = *data.context;
    double const tip = context.maker.needed_tip({ToothSurface::per_slice, TiltKind::radial, 0}).radius;
    double const phase = phase_of(scene, context.request.wave_generator);
    std::vector<double> const z = surface::slice_places(planes, context.width);
    std::vector<PlaneLength> length(z.size());
    for (int first = 0; first < intervals; first += at_once) {
        int const last = std::min(first + at_once, intervals);
        surface::ToothSurfaceBuilder maker(data.middle, data.tooth, data.shape,
                                           {z.begin() + first, z.begin() + last + 1}, data.threads);
        std::vector<PlaneLength> const found = lengths(context, maker, tip, phase);
        std::copy(found.begin(), found.end(), length.begin() + first);
    }
    AreaByPlanes result;
    for (int stride = intervals / 2; stride > 0; stride /= 2)
        result.sums.push_back({intervals / stride + 1,
                               trapezoid(length, &PlaneLength::all, static_cast<std::size_t>(stride), context.width)});
    double const falls = 2 * std::sqrt(2.0), safety = 2;
    double largest = 0, scale = 1;
    constexpr std::size_t looked_at = 3;
    for (std::size_t i = result.sums.size() - 1; i > 0 && i + looked_at >= result.sums.size(); --i, scale /= falls)
        largest = std::max(largest, scale * std::abs(result.sums[i].area - result.sums[i - 1].area));
    result.across = safety * largest / (falls - 1);
    result.along = std::abs(result.area() - trapezoid(length, &PlaneLength::second, 1, context.width));
    return result;
}

}  // namespace hdconj::contact
