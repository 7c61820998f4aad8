// SPDX-License-Identifier: GPL-3.0-or-later
// Slices and flank points for the contact area.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "contact/study/contact_by_planes.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/error.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
namespace {

/// The scene as `contact` is asked for it, with an axis where it has none.
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
    scene.tilt.reset();
    scene.slices.emplace();
    scene.slices->surface = ToothSurface::per_slice;
    if (!scene.contact) {
        scene.contact.emplace();
        scene.contact->gap = 0x1p-10;
    }
    return scene;
}

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

StudyRecord area_record(std::string method, std::string knob, int value, double points)
{
    StudyRecord record;
    record.study = "contact-area";
    record.method = std::move(method);
    record.knob = std::move(knob);
    record.value = value;
    record.unit = "mm^2";
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

/// Fifty times the flank points of the finest tested, in the same planes; half as many say what they leave open: of
/// second order that is three times its error.
AreaReference by_points(StudyRun const& bench, Scene const& scene, int slices, int points)
{
    return found_by(
        bench,
        area_record("reference: flank points", "contact.flank_points", points, static_cast<double>(slices) * points),
        [&] {
            double const all = area(scene, {slices, points}).contact_area,
                         half = area(scene, {slices, points / 2}).contact_area;
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
            record.estimate = (series.slices ? state.share_error : state.share_error_along) * state.flank_area;
            bench.keep(record);
        }
    }
    bench.keep(reference.record);
    if (bench.sampled)
        return;
    std::string const part =
        reference.record.error > 0 ? short_number(std::floor(finest / reference.record.error)) : "infinity";
    bench.report.notes.push_back("contact-area: no reference in 50 digits; " + std::string(series.method) +
                                 " are measured against " + short_number(reference.record.value) +
                                 (series.slices ? " planes with edges of contact as roots, and no cells between them"
                                                : " of them in the same planes") +
                                 ", whose own error is " + short_number(reference.record.error) + " mm^2, 1/" + part +
                                 " of the finest tested");
}

void run_area_series(StudyRun const& bench)
{
    Scene scene = coned(bench);
    scene.solver.threads = bench.threads;
    if (scene.circular_spline.backlash_offset != 0) {
        if (!bench.sampled)
            bench.report.notes.push_back(
                "contact-area: backlash_offset left out: measured where conjugate flanks touch");
        scene.circular_spline.backlash_offset = 0;
    }
    if (bench.quick) {
        constexpr int planes = 257, few = 20, many = 1000;
        measure(bench, scene, {"slices", "slices.count", {2, 3}, true, 40, by_planes(bench, scene, planes, few)});
        measure(bench, scene,
                {"flank points", "contact.flank_points", {10, 20}, false, 3, by_points(bench, scene, 3, many)});
        return;
    }
    if (bench.sampled) {
        constexpr int planes = 513, few = 50, many = 2500;
        measure(bench, scene, {"slices", "slices.count", {3, 9}, true, 50, by_planes(bench, scene, planes, few)});
        measure(bench, scene,
                {"flank points", "contact.flank_points", {12, 25, 50}, false, 3, by_points(bench, scene, 3, many)});
        return;
    }
    constexpr int planes = 1025, few = 100, many = 5000;
    measure(bench, scene, {"slices", "slices.count", {2, 3, 5, 9, 17}, true, 50, by_planes(bench, scene, planes, few)});
    measure(bench, scene,
            {"flank points", "contact.flank_points", {12, 25, 50, 100}, false, 3, by_points(bench, scene, 3, many)});
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
