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
    struct Finest
    {
        LoadCase found;
        StudyRecord record;   ///< its time and memory
    };
    std::optional<Finest> at_standard;
    auto const solved = [&](StudyRecord record, Counts const& counts) -> std::optional<Finest> {
        record.study = "load";
        record.unit = "1";   // both against the finest rung's own, so that they share a diagram
        record.points = static_cast<double>(counts.slices) * counts.points;
        std::optional<LoadCase> found = bench.timed(record, [&] { return at_rated_torque(bench, scene, counts); });
        if (!found)
            return {};
        return Finest{std::move(*found), std::move(record)};
    };
    for (Ladder const& ladder : ladders)
    {
        auto const counts = [&](int value) {
            Counts all = standard;
            all.*ladder.count = value;
            return all;
        };
        bool const is_standard = standard.*ladder.count == ladder.finest;
        std::optional<Finest> reference = is_standard && at_standard ? at_standard : solved({}, counts(ladder.finest));
        if (is_standard)
            at_standard = reference;
        if (!reference)
            continue;
        LoadedState const& finest = reference->found.curve[reference->found.rated];
        if (finest.twist == 0 || finest.largest_force == 0)
        {
            bench.leave_out("load", "at this torque nothing turns or no tooth carries");
            return;
        }
        // one run gives both numbers
        auto const keep = [&](StudyRecord record, LoadCase const& found, std::string const& figure, double LoadedState::*number) {
            bool const is_reference = &found == &reference->found;
            record.knob = ladder.knob;
            record.method = (is_reference ? "reference: " : "") + std::string(ladder.method) + ": " + figure;
            if (!is_reference)
                record.error = std::abs(found.curve[found.rated].*number / finest.*number - 1);
            record.estimate = found.estimated ? std::abs(found.error.*number / finest.*number) : not_measured;
            bench.keep(std::move(record));
        };
        auto const keep_both = [&](StudyRecord const& record, LoadCase const& found) {
            keep(record, found, "twist", &LoadedState::twist);
            keep(record, found, "largest force", &LoadedState::largest_force);
        };
        if (!bench.sampled)
        {
            LoadCase const& found = reference->found;
            auto const share = [&](double LoadedState::*number) { return number_text(std::abs(found.error.*number / finest.*number)); };
            bench.report.notes.push_back("load: no reference in 50 digits; " + std::string(ladder.method) + " are measured against " + std::to_string(ladder.finest)
                                         + " of them, twist " + number_text(finest.twist) + " rad and largest force " + number_text(finest.largest_force)
                                         + " N, which by their own estimate are off by "
                                         + (found.estimated ? share(&LoadedState::twist) + " and " + share(&LoadedState::largest_force) + " of them" : "an amount that is not known")
                                         + "; gaps of the loaded shape are met to " + number_text(finest.residual) + " mm, the floor of all of them");
        }
        for (int const value : ladder.values)
        {
            StudyRecord record;
            record.value = value;
            if (std::optional<Finest> const found = solved(record, counts(value)))
                keep_both(found->record, found->found);
        }
        reference->record.value = ladder.finest;
        keep_both(reference->record, reference->found);
    }
}

}  // namespace

std::string lacks_for_load(Scene const& scene)
{
    std::string missing;
    auto const need = [&](bool there, char const* key) { missing += there ? "" : (missing.empty() ? "" : ", ") + std::string(key); };
    need(scene.flexspline.cup.has_value(), "flexspline.cup");
    need(scene.bearing.has_value(), "bearing");
    need(scene.load && scene.load->torque, "load.torque");
    need(scene.circular_spline.width.has_value(), "circular_spline.width");
    return missing.empty() ? missing : "the scene gives no " + missing;
}

void study_load(StudyRun const& bench)
{
    if (std::string const lacking = lacks_for_load(bench.scene); !lacking.empty())
        return bench.leave_out("load", lacking);
    Scene scene = bench.scene;
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
