// SPDX-License-Identifier: GPL-3.0-or-later
// Harmonics, slices, flank points and circles of the bearing for the drive under torque.
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "bench.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/pipeline/load.hpp"

namespace hdconj::detail {
namespace {

/// The counts that a load is computed with.
struct Counts
{
    int harmonics, slices, points, circles;
};

/// At the rated torque alone; nothing, and a note, where these counts have no answer.
std::optional<LoadCase> at_rated_torque(StudyRun const& bench, Scene const& loaded, Counts const& counts)
{
    Scene scene = loaded;
    scene.load->harmonics = counts.harmonics;
    scene.slices->count = counts.slices;
    scene.contact->flank_points = counts.points;
    scene.bearing->circles = counts.circles;
    LoadOptions options;
    options.curve = false;
    try
    {
        return load(scene, options).cases.front();
    }
    catch (NumericalError const& error)
    {
        bench.report.notes.push_back("load: " + (bench.sampled ? bench.name + " has " : std::string()) + "no answer with " + std::to_string(counts.harmonics) + " harmonics, " + std::to_string(counts.slices) + " slices, "
                                     + std::to_string(counts.points) + " points and " + std::to_string(counts.circles) + " circles: " + error.what());
        return {};
    }
}

struct Ladder
{
    char const* method;
    char const* knob;
    int Counts::*count;
    std::vector<int> values;
    int finest;
};

std::string number_text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

void run_ladders(StudyRun const& bench, Scene const& scene)
{
    Counts const standard = bench.quick ? Counts{24, 3, 24, 1} : Counts{100, 9, 100, 13};
    auto const ladders = [&]() -> std::vector<Ladder> {
        if (bench.quick)
            return {{"harmonics", "load.harmonics", &Counts::harmonics, {24, 32}, 64}};
        if (bench.sampled)   // against what the program takes where nothing is said
            return {{"harmonics", "load.harmonics", &Counts::harmonics, {50}, standard.harmonics},
                    {"slices", "slices.count", &Counts::slices, {5}, standard.slices},
                    {"flank points", "contact.flank_points", &Counts::points, {50}, standard.points},
                    {"circles", "bearing.circles", &Counts::circles, {7}, standard.circles}};
        // on this grid of tooth spaces more than 100 harmonics are the same 100
        return {{"harmonics", "load.harmonics", &Counts::harmonics, {25, 50, 75}, 100},
                {"slices", "slices.count", &Counts::slices, {3, 5, 9}, 17},
                {"flank points", "contact.flank_points", &Counts::points, {25, 50, 100, 200}, 400},
                {"circles", "bearing.circles", &Counts::circles, {4, 7, 13}, 25}};
    }();
    std::optional<LoadCase> at_standard;
    for (Ladder const& ladder : ladders)
    {
        auto const counts = [&](int value) {
            Counts all = standard;
            all.*ladder.count = value;
            return all;
        };
        bool const is_standard = standard.*ladder.count == ladder.finest;
        std::optional<LoadCase> const reference = is_standard && at_standard ? at_standard : at_rated_torque(bench, scene, counts(ladder.finest));
        if (is_standard)
            at_standard = reference;
        if (!reference)
            continue;
        LoadedState const& finest = reference->curve[reference->rated];
        if (finest.twist == 0 || finest.largest_force == 0)
        {
            bench.leave_out("load", "at this torque nothing turns or no tooth carries");
            return;
        }
        if (!bench.sampled)
            bench.report.notes.push_back("load: no reference in 50 digits; " + std::string(ladder.method) + " are measured against " + std::to_string(ladder.finest)
                                         + " of them, twist " + number_text(finest.twist) + " rad and largest force " + number_text(finest.largest_force)
                                         + " N; gaps of the loaded shape are met to " + number_text(finest.residual) + " mm, the floor of all of them");
        for (int const value : ladder.values)
        {
            StudyRecord record;
            record.study = "load";
            record.knob = ladder.knob;
            record.value = value;
            record.unit = "1";   // both against the finest rung's own, so that they share a diagram
            record.points = static_cast<double>(counts(value).slices) * counts(value).points;
            std::optional<LoadCase> const found = bench.timed(record, [&] { return at_rated_torque(bench, scene, counts(value)); });
            if (!found)
                continue;
            // one run gives both numbers
            auto const keep = [&](char const* figure, double LoadedState::*number) {
                record.method = std::string(ladder.method) + ": " + figure;
                record.error = std::abs(found->curve[found->rated].*number / finest.*number - 1);
                if (found->estimated)
                    record.estimate = std::abs(found->error.*number / finest.*number);
                bench.keep(record);
            };
            keep("twist", &LoadedState::twist);
            keep("largest force", &LoadedState::largest_force);
        }
    }
}

}  // namespace

void study_load(StudyRun const& bench)
{
    auto const& given = bench.scene;
    if (!given.flexspline.cup || !given.bearing)
        return bench.leave_out("load", "the scene gives no flexspline.cup or no bearing");
    if (!given.load || !given.load->torque)
        return bench.leave_out("load", "the scene gives no load.torque");
    if (!given.circular_spline.width)
        return bench.leave_out("load", "the scene gives no circular_spline.width");
    Scene scene = given;
    scene.solver.threads = bench.threads;
    scene.coning.reset();
    scene = loaded_scene(scene);
    scene.slices->surface = "per-slice";
    if (!scene.contact)
    {
        scene.contact.emplace();
        scene.contact->gap = 0x1p-10;
    }
    try
    {
        run_ladders(bench, scene);
    }
    catch (InputError const& error)
    {
        bench.leave_out("load", error.what());
    }
}

}  // namespace hdconj::detail
