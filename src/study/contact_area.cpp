// SPDX-License-Identifier: GPL-3.0-or-later
// Slices and flank points for the contact area.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bench.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/pipeline/contact.hpp"
#include "hdconj/pipeline/contact_by_planes.hpp"
#include "hdconj/profile/builder.hpp"

namespace hdconj::detail {
namespace {

/// The scene as `contact` is asked for it, with an axis where it has none.
Scene coned(StudyRun const& bench)
{
    Scene scene = bench.scene;
    double const width = scene.circular_spline.width.value_or(0);
    if (!scene.coning)
    {
        scene.coning.emplace();
        scene.coning->model = "linear";
        scene.coning->bottom_to_middle = 9.0 / 7.0 * width;   // as type-50 stands in its cup
        scene.coning->axial_shift = "mapped";
    }
    scene.tilt.reset();
    scene.slices.emplace();
    scene.slices->surface = "per-slice";
    if (!scene.contact)
    {
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
    return contact(scene).cases.front().state;
}

/// What a ladder is measured against.
struct AreaReference
{
    std::string method, knob;
    double value = 0;     ///< of the knob
    double area = 0;      ///< [mm^2]
    double error = 0;     ///< its own, estimated [mm^2]
    double points = 0;    ///< of all planes together
    double seconds = 0;
    double memory = 0;    ///< [MB]
};

/// @p find, which gives area and error, with its time and memory.
template<class Find>
AreaReference measured(std::string const& method, std::string const& knob, int value, double points, Find const& find)
{
    reset_peak_memory();
    auto const start = std::chrono::steady_clock::now();
    auto const [area, error] = find();
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {method, knob, static_cast<double>(value), area, error, points, seconds, peak_memory()};
}

/// The area by lengths in exact planes, for slices.
AreaReference by_planes(Scene scene, int planes, int points)
{
    scene.slices->count = 1;
    scene.contact->flank_points = points;
    return measured("reference: lengths in planes", "planes", planes, static_cast<double>(planes) * points, [&] {
        AreaByPlanes const found = contact_by_planes(scene, planes);
        return std::pair(found.area(), found.error());
    });
}

/// Fifty times the flank points of the finest tested, in the same planes; half as many say what they leave open: of second order that is three times its error.
AreaReference by_points(Scene const& scene, int slices, int points)
{
    return measured("reference: flank points", "contact.flank_points", points, static_cast<double>(slices) * points, [&] {
        double const all = area(scene, {slices, points}).contact_area, half = area(scene, {slices, points / 2}).contact_area;
        return std::pair(all, std::abs(all - half));
    });
}

/// One ladder: a knob, what is tried, and the other count, which stays.
struct Ladder
{
    char const* method;
    char const* knob;
    std::vector<int> values;
    bool slices;
    int other;
    AreaReference reference;
};

void measure(StudyRun const& bench, Scene const& scene, Ladder const& ladder)
{
    AreaReference const& reference = ladder.reference;
    StudyRecord own;
    own.study = "contact-area";
    own.drive = bench.name;
    own.method = reference.method;
    own.knob = reference.knob;
    own.value = reference.value;
    own.unit = "mm^2";
    own.error = own.estimate = reference.error;
    own.points = reference.points;
    own.seconds = reference.seconds;
    own.memory = reference.memory;
    own.threads = bench.threads;
    double finest = 0;
    for (int const value : ladder.values)
    {
        Setting const setting = ladder.slices ? Setting{value, ladder.other} : Setting{ladder.other, value};
        ContactState const state = area(scene, setting);
        StudyRecord record;
        record.study = own.study;
        record.method = ladder.method;
        record.knob = ladder.knob;
        record.value = value;
        record.unit = own.unit;
        record.error = finest = std::abs(state.contact_area - reference.area);
        // planes are the same in a ladder of flank points, and so is what they leave open
        record.estimate = (ladder.slices ? state.share_error : state.share_error_along) * state.flank_area;
        record.points = static_cast<double>(setting.slices) * setting.points;
        record.threads = bench.threads;
        StudyRun few = bench;
        few.repeats = std::min(bench.repeats, 2);
        few.measure(record, [&] { (void)area(scene, setting); });
    }
    bench.report.records.push_back(own);
    std::string const part = reference.error > 0 ? short_number(std::floor(finest / reference.error)) : "infinity";
    bench.report.notes.push_back("contact-area: no reference in 50 digits; " + std::string(ladder.method) + " are measured against " + short_number(reference.value)
                                 + (ladder.slices ? " planes with edges of contact as roots, and no cells between them" : " of them in the same planes") + ", whose own error is "
                                 + short_number(reference.error) + " mm^2, 1/" + part + " of the finest tested");
}

void run_ladders(StudyRun const& bench)
{
    Scene scene = coned(bench);
    scene.solver.threads = bench.threads;
    if (scene.circular_spline.backlash_offset != 0)
    {
        bench.report.notes.push_back("contact-area: backlash_offset left out: measured where conjugate flanks touch");
        scene.circular_spline.backlash_offset = 0;
    }
    constexpr int planes = 1025, points = 100, planes_of_quick = 257, points_of_quick = 20;
    if (bench.quick)
    {
        measure(bench, scene, {"slices", "slices.count", {2, 3}, true, 40, by_planes(scene, planes_of_quick, points_of_quick)});
        measure(bench, scene, {"flank points", "contact.flank_points", {10, 20}, false, 3, by_points(scene, 3, 1000)});
        return;
    }
    measure(bench, scene, {"slices", "slices.count", {2, 3, 5, 9, 17}, true, 50, by_planes(scene, planes, points)});
    measure(bench, scene, {"flank points", "contact.flank_points", {12, 25, 50, 100}, false, 3, by_points(scene, 3, 5000)});
}

}  // namespace

void study_contact(StudyRun const& bench)
{
    auto const leave = [&](std::string const& why) { bench.report.notes.push_back("contact-area: left out, " + why); };
    if (!bench.scene.circular_spline.width)
        return leave("the scene gives no circular_spline.width, so there are no slices to count");
    try
    {
        run_ladders(bench);
    }
    catch (InputError const& error)
    {
        leave(error.what());
    }
    catch (NumericalError const& error)
    {
        leave(error.what());
    }
}

}  // namespace hdconj::detail
