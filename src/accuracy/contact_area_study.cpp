// SPDX-License-Identifier: GPL-3.0-or-later
// Slices and flank points for the contact area.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "contact/study/contact_by_planes.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/error.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
namespace {

/// The scene as `contact` is asked for it, with its own tooth surface; with an axis and an outline per slice where it
/// has none.
Scene coned(StudyRun const& bench)
{
    Scene scene = bench.scene;
    double const width = scene.circular_spline.width.value_or(0);
    if (!scene.coning) {
        scene.coning.emplace();
        scene.coning->model = ConingModel::linear;
        scene.coning->bottom_to_middle = 9.0 / 7.0 * width;  // as type-50 stands in its cup
        scene.coning->axial_shift = AxialShift::mapped;
    }
    take_surface(scene);
    if (!scene.contact) {
        scene.contact.emplace();
        scene.contact->gap = 0x1p-10;
    }
    return scene;
}

constexpr char const* slice_knob = "slices.count";
constexpr char const* point_knob = "contact.flank_points";

struct Setting
{
    int slices, points;
};

ContactState area(Scene scene, Setting const& setting)
{
    scene.slices->count = setting.slices;
    scene.contact->flank_points = setting.points;
    return study_contact(scene).cases.front().state;
}

/// What a series is measured against: its record, with its own estimated error, and the area [mm^2].
struct AreaReference
{
    StudyRecord record;
    double area = 0;
};

StudyRecord area_record(char const* method, char const* knob, int value, double points)
{
    StudyRecord record{"contact-area", {}, method, knob, static_cast<double>(value), 0, "mm^2"};
    record.points = points;
    return record;
}

/// @p find gives area and error.
template <class Find>
AreaReference found_by(StudyRun const& bench, StudyRecord record, Find const& find)
{
    auto const [area, error] = bench.timed(record, find);
    record.error = record.estimate = error;
    return {std::move(record), area};
}

/// The area by lengths in exact planes, for slices.
AreaReference by_planes(StudyRun const& bench, Scene scene, int planes, int points)
{
    scene.slices->count = 1;
    scene.contact->flank_points = points;
    return found_by(bench,
                    area_record("reference: lengths in planes", "planes", planes, static_cast<double>(planes) * points),
                    [&] {
                        contact::AreaByPlanes const found = contact::contact_by_planes(scene, planes);
                        return std::pair(found.area(), found.error());
                    });
}

/// The area with @p count of what @p knob counts, far more than the finest tested; half as many say what they leave
/// open: of second order that is three times its error.
AreaReference by_count(StudyRun const& bench, Scene const& scene, char const* knob, int count, int other)
{
    bool const slices = std::string_view(knob) == slice_knob;
    auto const setting = [&](int value) { return slices ? Setting{value, other} : Setting{other, value}; };
    return found_by(bench,
                    area_record(slices ? "reference: slices" : "reference: flank points", knob, count,
                                static_cast<double>(count) * other),
                    [&] {
                        double const all = area(scene, setting(count)).contact_area,
                                     half = area(scene, setting((count + 1) / 2)).contact_area;
                        return std::pair(all, std::abs(all - half));
                    });
}

/// One series: a knob, what is tried, and the other count, which stays.
struct Series
{
    char const* method;
    char const* knob;
    std::vector<int> values;
    bool slices;
    int other;
    AreaReference reference;
};

void measure(StudyRun const& bench, Scene const& scene, Series const& series)
{
    AreaReference const& reference = series.reference;
    double finest = 0;
    int const repeats = std::min(bench.repeats, 2);
    for (int const value : series.values) {
        Setting const setting = series.slices ? Setting{value, series.other} : Setting{series.other, value};
        StudyRecord record =
            area_record(series.method, series.knob, value, static_cast<double>(setting.slices) * setting.points);
        for (record.repeat = 0; record.repeat < repeats; ++record.repeat) {
            ContactState const state = bench.timed(record, [&] { return area(scene, setting); });
            record.error = finest = std::abs(state.contact_area - reference.area);
            // planes are the same in a series of flank points, and so is what they leave open
            record.estimate =
                (series.slices ? state.contact_fraction_error : state.fraction_error_along) * state.flank_area;
            bench.keep(record);
        }
    }
    bench.keep(reference.record);
    std::string const part =
        reference.record.error > 0 ? short_number(std::floor(finest / reference.record.error)) : "infinity";
    std::string const of_what = !series.slices ? " of them in the same planes"
                                : reference.record.knob == slice_knob
                                    ? " of them"
                                    : " planes with edges of contact as roots, and no cells between them";
    bench.note("contact-area", "no reference in 50 digits; " + std::string(series.method) + " are compared with " +
                                   short_number(reference.record.value) + of_what + ", whose own error is " +
                                   short_number(reference.record.error) + " mm^2, 1/" + part + " of the finest tested");
}

void run_area_series(StudyRun const& bench)
{
    Scene scene = coned(bench);
    scene.solver.threads = bench.threads;
    note_surface(bench, "contact-area", scene);
    // only outlines per slice, as they stand, have a reference that needs no slices
    bool const has_planes = scene.slices->surface == ToothSurface::per_slice && !(scene.tilt && scene.tilt->angle != 0);
    if (has_planes && scene.circular_spline.backlash_offset != 0) {
        bench.note("contact-area", "backlash_offset left out: measured where conjugate flanks touch");
        scene.circular_spline.backlash_offset = 0;
    }
    struct Lengths
    {
        std::vector<int> slices, points;
        int planes, few, points_of_slices, many;
    };
    Lengths const full{{2, 3, 5, 9, 17}, {12, 25, 50, 100}, 1025, 100, 50, 5000};
    Lengths const of_sample{{3, 9}, {12, 25, 50}, 513, 50, 50, 2500}, of_quick{{2, 3}, {10, 20}, 257, 20, 40, 1000};
    Lengths const& n = bench.quick ? of_quick : bench.sampled ? of_sample : full;
    AreaReference const of_slices = has_planes
                                        ? by_planes(bench, scene, n.planes, n.few)
                                        : by_count(bench, scene, slice_knob, n.planes / 8 + 1, n.points_of_slices);
    measure(bench, scene, {"slices", slice_knob, n.slices, true, n.points_of_slices, of_slices});
    measure(bench, scene,
            {"flank points", point_knob, n.points, false, 3, by_count(bench, scene, point_knob, n.many, 3)});
}

}  // namespace

std::string lacks_for_contact(Scene const& scene)
{
    return scene.circular_spline.width ? ""
                                       : "the scene gives no circular_spline.width, so there are no slices to count";
}

void study_contact_area(StudyRun const& bench)
{
    if (std::string const lacking = lacks_for_contact(bench.scene); !lacking.empty())
        return bench.leave_out("contact-area", lacking);
    try {
        run_area_series(bench);
    } catch (InputError const& error) {
        bench.leave_out("contact-area", error.what());
    } catch (NumericalError const& error) {
        bench.leave_out("contact-area", error.what());
    }
}

}  // namespace hdconj::accuracy
