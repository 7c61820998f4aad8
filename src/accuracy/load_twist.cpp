// SPDX-License-Identifier: GPL-3.0-or-later
// Harmonics, slices, flank points and circles of the bearing for the drive under torque.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
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
    try {
        return study_load(scene, options).cases.front();
    } catch (NumericalError const& error) {
        bench.notes.push_back(
            {"load", fmt::format("{}no result with {} harmonics, {} slices, {} points and {} circles: {}",
                                 bench.sampled ? bench.name + " has " : "", counts.harmonics, counts.slices,
                                 counts.points, counts.circles, error.what())});
        return {};
    }
}

/// Loads with one count from coarse to fine, against the finest.
struct CountSeries
{
    char const* method;
    char const* knob;
    int Counts::*count;
    std::vector<int> values;
    int finest;
};

std::vector<CountSeries> load_series(StudyRun const& bench, Counts const& standard)
{
    if (bench.quick)
        return {{"harmonics", "load.harmonics", &Counts::harmonics, {24, 32}, 64}};
    if (bench.sampled)  // against what the program takes where nothing is said
        return {{"harmonics", "load.harmonics", &Counts::harmonics, {50}, standard.harmonics},
                {"slices", "slices.count", &Counts::slices, {5}, standard.slices},
                {"flank points", "contact.flank_points", &Counts::points, {50}, standard.points},
                {"circles", "bearing.circles", &Counts::circles, {7}, standard.circles}};
    // on this grid of tooth spaces more than 100 harmonics are the same 100
    return {{"harmonics", "load.harmonics", &Counts::harmonics, {25, 50, 75}, 100},
            {"slices", "slices.count", &Counts::slices, {3, 5, 9}, 17},
            {"flank points", "contact.flank_points", &Counts::points, {25, 50, 100, 200}, 400},
            {"circles", "bearing.circles", &Counts::circles, {4, 7, 13}, 25}};
}

/// A load, and the time and memory that it took.
struct SolvedLoad
{
    LoadCase load;
    StudyRecord record;

    [[nodiscard]] LoadedState const& rated() const { return load.curve[load.rated]; }
    /// The estimated error of a figure, relative to @p reference; not_measured where there is none.
    [[nodiscard]] double estimate(double LoadedState::*figure, LoadedState const& reference) const
    {
        return load.estimated ? std::abs(load.error.*figure / reference.*figure) : not_measured;
    }
};

std::optional<SolvedLoad> solve_load(StudyRun const& bench, Scene const& scene, Counts const& counts)
{
    StudyRecord record;
    record.study = "load";
    record.unit = "1";  // both against the finest level's own, so that they share a diagram
    record.points = static_cast<double>(counts.slices) * counts.points;
    std::optional<LoadCase> found = bench.timed(record, [&] { return at_rated_torque(bench, scene, counts); });
    if (!found)
        return {};
    return SolvedLoad{std::move(*found), std::move(record)};
}

/// Keeps one figure of a load, with its difference from @p reference where it is not that itself.
void keep_figure(StudyRun const& bench, CountSeries const& series, SolvedLoad const& solved,
                 SolvedLoad const& reference, std::string const& name, double LoadedState::*figure)
{
    bool const is_reference = &solved == &reference;
    StudyRecord record = solved.record;
    record.knob = series.knob;
    record.method = (is_reference ? "reference: " : "") + std::string(series.method) + ": " + name;
    if (!is_reference)
        record.error = std::abs(solved.rated().*figure / reference.rated().*figure - 1);
    record.estimate = solved.estimate(figure, reference.rated());
    bench.keep(std::move(record));
}

/// One run gives twist and largest force.
void keep_load(StudyRun const& bench, CountSeries const& series, SolvedLoad& solved, SolvedLoad const& reference,
               int value)
{
    solved.record.value = value;
    keep_figure(bench, series, solved, reference, "twist", &LoadedState::twist);
    keep_figure(bench, series, solved, reference, "largest force", &LoadedState::largest_force);
}

void note_reference(StudyRun const& bench, CountSeries const& series, SolvedLoad const& reference)
{
    LoadedState const& finest = reference.rated();
    auto const share = [&](double LoadedState::*figure) { return reference.estimate(figure, finest); };
    bench.note(
        "load",
        fmt::format(
            "no reference in 50 digits; {} are compared with {} of them, whose twist is {:.3g} rad and largest force "
            "{:.3g} N, with estimated errors of {}; gaps agree with the loaded shape to {:.3g} mm, below which no "
            "error can be seen",
            series.method, series.finest, finest.twist, finest.largest_force,
            reference.load.estimated ? fmt::format("{:.3g} and {:.3g} of them", share(&LoadedState::twist),
                                                   share(&LoadedState::largest_force))
                                     : "unknown size",
            finest.gap_mismatch));
}

void run_load_series(StudyRun const& bench, Scene const& scene)
{
    Counts const standard = bench.quick ? Counts{24, 3, 24, 2} : Counts{100, 9, 100, 13};
    std::optional<SolvedLoad> at_standard;
    for (CountSeries const& series : load_series(bench, standard)) {
        auto const counts = [&](int value) {
            Counts all = standard;
            all.*series.count = value;
            return all;
        };
        bool const is_standard = standard.*series.count == series.finest;
        std::optional<SolvedLoad> reference =
            is_standard && at_standard ? at_standard : solve_load(bench, scene, counts(series.finest));
        if (is_standard)
            at_standard = reference;
        if (!reference)
            continue;
        if (reference->rated().twist == 0 || reference->rated().largest_force == 0)
            return bench.leave_out("load", "at this torque no tooth carries or nothing turns");
        note_reference(bench, series, *reference);
        for (int const value : series.values) {
            if (std::optional<SolvedLoad> found = solve_load(bench, scene, counts(value)))
                keep_load(bench, series, *found, *reference, value);
        }
        keep_load(bench, series, *reference, *reference, series.finest);
    }
}

}  // namespace

std::string lacks_for_load(Scene const& scene)
{
    std::string missing;
    auto const need = [&](bool there, char const* key) {
        missing += there ? "" : (missing.empty() ? "" : ", ") + std::string(key);
    };
    need(scene.flexspline.cup.has_value(), "flexspline.cup");
    need(scene.bearing.has_value(), "bearing");
    need(scene.load && scene.load->torque, "load.torque");
    need(scene.circular_spline.width.has_value(), "circular_spline.width");
    return missing.empty() ? missing : "the scene gives no " + missing;
}

void study_load_twist(StudyRun const& bench)
{
    if (std::string const lacking = lacks_for_load(bench.scene); !lacking.empty())
        return bench.leave_out("load", lacking);
    Scene scene = bench.scene;
    scene.solver.threads = bench.threads;
    scene.coning.reset();
    take_surface(scene);
    scene = loaded_scene(scene);
    note_surface(bench, "load", scene);
    if (!scene.contact) {
        scene.contact.emplace();
        scene.contact->gap = 0x1p-10;
    }
    try {
        run_load_series(bench, scene);
    } catch (InputError const& error) {
        bench.leave_out("load", error.what());
    }
}

}  // namespace hdconj::accuracy
