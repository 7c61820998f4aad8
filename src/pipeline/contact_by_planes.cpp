// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/contact_by_planes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hdconj/contact/contact_stretches.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/pipeline/contact.hpp"
#include "owned_bench.hpp"

namespace hdconj {
namespace {

using namespace detail;

/// Lengths of contact in one plane, of all spaces together.
struct PlaneLength
{
    double all = 0;      ///< by all stations
    double second = 0;   ///< by every second one
};

/// Lengths in neighbouring planes, which are solved together.
std::vector<PlaneLength> lengths(ContactBench const& bench, SurfaceMaker& maker, double tip, double phase)
{
    int const z_f = bench.scene.drive.flexspline_teeth, z_c = bench.scene.drive.circular_spline_teeth;
    MatchedOutline const outline = maker({"per-slice", "radial", 0}, tip, bench.tolerance.length, bench.request.flank_points);
    FlankGrid const grid = flank_grid(outline, maker.z(), bench.request.flank_points);
    ToothPlaces const places = tooth_places(bench, phase, grid.z);
    GapField const field(bench.tooth, grid, places, z_f, z_c, phase);
    std::vector<PlaneLength> result(grid.slices());
    constexpr std::size_t grain = 1;
    parallel_for(grid.slices(), bench.threads, grain, [&](std::size_t k) {
        auto const length = [&](std::size_t space, std::size_t stride) {
            return area_per_length(grid, GapMap::right, k, contact_stretches(field, space, GapMap::right, k, 0, bench.request.gap, stride));
        };
        for (std::size_t space = 0; space < field.spaces(); ++space)
        {
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
        faults.push_back({"circular_spline.backlash_offset", 0, "", "the area by planes is that of flanks that touch without being turned", "write 0"});
    if (!faults.empty())
        throw InputError(faults);
}

}  // namespace

AreaByPlanes contact_by_planes(Scene const& scene, int planes)
{
    check(scene);
    constexpr int at_once = 64;      // intervals that are solved together: outlines of many planes have the points of all of them
    constexpr int coarse = 17;       // planes that the tip circle is looked for in; it is decided at an end of the width
    int const intervals = planes - 1;
    StageObserver const nobody;      // the bench keeps a reference
    OwnedBench owned(scene, std::min(planes, coarse), make_plan(scene, Verb::contact), nobody);
    ContactBench const& bench = *owned.bench;
    double const tip = bench.maker.needed_tip({"per-slice", "radial", 0});
    double const phase = phase_of(scene, bench.request.wave_generator);
    std::vector<double> const z = slice_places(planes, bench.width);
    std::vector<PlaneLength> length(z.size());
    for (int first = 0; first < intervals; first += at_once)
    {
        int const last = std::min(first + at_once, intervals);
        SurfaceMaker maker(owned.middle, owned.tooth, owned.shape, {z.begin() + first, z.begin() + last + 1}, owned.threads);
        std::vector<PlaneLength> const found = lengths(bench, maker, tip, phase);
        std::copy(found.begin(), found.end(), length.begin() + first);
    }
    AreaByPlanes result;
    for (int stride = intervals / 2; stride > 0; stride /= 2)
        result.sums.push_back({intervals / stride + 1, trapezoid(length, &PlaneLength::all, static_cast<std::size_t>(stride), bench.width)});
    double const falls = 2 * std::sqrt(2.0), safety = 2;
    double largest = 0, scale = 1;
    constexpr std::size_t looked_at = 3;
    for (std::size_t i = result.sums.size() - 1; i > 0 && i + looked_at >= result.sums.size(); --i, scale /= falls)
        largest = std::max(largest, scale * std::abs(result.sums[i].area - result.sums[i - 1].area));
    result.across = safety * largest / (falls - 1);
    result.along = std::abs(result.area() - trapezoid(length, &PlaneLength::second, 1, bench.width));
    return result;
}

}  // namespace hdconj
