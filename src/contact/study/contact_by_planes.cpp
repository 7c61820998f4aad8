// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_by_planes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/contact_stretches.hpp"
#include "contact_study_data.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/error.hpp"

namespace hdconj::contact {
namespace {

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
                                   contact_stretches(field, space, GapMap::right, k, 0, context.request.gap, stride));
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
    if (!faults.empty())
        throw InputError(faults);
}

}  // namespace

AreaByPlanes contact_by_planes(Scene const& scene, int planes)
{
    check(scene);
    constexpr int at_once =
        64;  // intervals that are solved together: outlines of many planes have the points of all of them
    constexpr int coarse = 17;  // planes that the tip circle is looked for in; it is decided at an end of the width
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
