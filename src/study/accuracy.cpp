// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/study/accuracy.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <optional>

#include "bench.hpp"
#include "designs.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/pipeline/solve.hpp"
#include "hdconj/scene/suggest.hpp"

namespace hdconj {
namespace {

using namespace detail;

struct Study
{
    StudyKind kind;
    void (*run)(StudyBench const&);
    bool sampled;   ///< over the sample of designs too
};

std::vector<Study> const& studies()
{
    static std::vector<Study> const all = {
        {{"tolerance", "what each digit of solver.tolerance costs"}, study_tolerance, true},
        {{"sampling", "equal steps of u against the adaptive sampler"}, study_sampling, true},
        {{"motion-model", "first order and material against exact motion"}, study_motion_model, true},
        {{"polynomial-fit", "grid in phi, iterate, fit a polynomial: where the fit stops helping"}, study_fit, false},
        {{"union", "brute-force union of tooth positions"}, study_union, false},
        {{"roots", "closed form against certified roots against a plain scan"}, study_roots, false},
        {{"number-type", "float, double, long double"}, study_precision, false},
        {{"contact-area", "slices and flank points for the contact area"}, study_contact, false},
        {{"load", "harmonics, slices, points, circles under torque"}, study_load, false},
        {{"threads", "what more threads give, and that they change no bit"}, study_threads, false}};
    return all;
}

bool wanted(AccuracyOptions const& options, Study const& study)
{
    return options.studies.empty() || std::find(options.studies.begin(), options.studies.end(), study.kind.name) != options.studies.end();
}

/// The drive that is measured: nothing along the axis, nothing cut away that no tooth has touched.
Scene plain(Scene const& scene, std::vector<std::string>& notes)
{
    Scene plain = scene;
    auto const leave_out = [&](bool there, char const* what) {
        if (there)
            notes.push_back(std::string(what) + " left out: the studies are of one plane, and contact-area and load bring slices of their own");
    };
    leave_out(scene.tilt.has_value(), "[tilt]");
    leave_out(scene.slices.has_value(), "[slices]");
    plain.tilt.reset();
    plain.slices.reset();
    if (scene.circular_spline.root_clearance > 0)
        notes.emplace_back("root_clearance left out: it is the difference of two given lengths");
    plain.circular_spline.root_clearance = 0;
    if (scene.circular_spline.automatic_backlash)
        notes.emplace_back("backlash_offset = \"auto\" left out: measured with none");
    plain.circular_spline.automatic_backlash = false;
    plain.wedm.reset();
    return plain;
}

std::string processor()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            return line.substr(std::min(line.find(':') + 2, line.size()));
    return "unknown";
}

/// A drive of the sample with its reference.
struct Sampled
{
    StudyDrive drive;
    ReferenceCurve reference;
    double entry = 0;
};

/// Those of designs @p first ... @p first + @p count - 1 about @p scene that make a drive.
std::vector<std::unique_ptr<Sampled>> designs_of(Scene const& scene, std::uint64_t seed, int first, int count, int threads)
{
    std::vector<std::unique_ptr<Sampled>> made(static_cast<std::size_t>(count));
    parallel_for(made.size(), threads, 1, [&](std::size_t i) {
        try
        {
            Scene design = design_near(scene, seed, first + static_cast<int>(i));
            design.solver.threads = 1;
            if (!check_scene(design).empty())
                return;
            StudyDrive drive = study_drive(design);
            ReferenceCurve reference = reference_of(drive);
            constexpr int points = 24, positions = 600;
            double const entry = entry_of(drive, reference, points, positions);
            made[i] = std::make_unique<Sampled>(Sampled{std::move(drive), std::move(reference), entry});
        }
        catch (NumericalError const&)
        {
            made[i].reset();   // no drive: counted as refused
        }
        catch (InputError const&)
        {
            made[i].reset();
        }
    });
    std::erase(made, nullptr);
    return made;
}

}  // namespace

std::vector<StudyKind> const& study_kinds()
{
    static std::vector<StudyKind> const kinds = [] {
        std::vector<StudyKind> all;
        for (Study const& study : studies())
            all.push_back(study.kind);
        return all;
    }();
    return kinds;
}

Faults check_accuracy(Scene const& scene, AccuracyOptions const& options)
{
    Faults faults;
    std::vector<std::string_view> names;
    for (StudyKind const& kind : study_kinds())
        names.push_back(kind.name);
    for (std::string const& name : options.studies)
    {
        if (std::find(names.begin(), names.end(), name) != names.end())
            continue;
        std::string known;
        for (std::string_view const one : names)
            known += (known.empty() ? "" : ", ") + std::string(one);
        auto const meant = nearest(name, names);
        faults.push_back({"--study", 0, name, "there is no such study", (meant ? "write " + std::string(*meant) : "write one of them") + "; known: " + known});
    }
    if (scene.is_reverse())
        faults.push_back({"circular_spline.profile", 0, "", "the reference in 50 digits is of the circular spline, and here the flexspline's tooth is solved for",
                          "give the flexspline's profile"});
    if (!given_shape(scene))
        faults.push_back({"wave_generator.family", scene.wave_generator.shape.line, scene.wave_generator.shape.family,
                          "the reference in 50 digits is of series, which do not follow the jumps in this wave generator's third derivative",
                          "write \"cosine\", \"ellipse\" or \"ring-on-cosine-cam\": what accuracy costs hardly depends on the family"});
    if (scene.solver.kinematics != Kinematics::exact)
        faults.push_back({"solver.kinematics", 0, std::string(to_string(scene.solver.kinematics)),
                          "errors are measured against exact motion, and the study motion-model compares the others with it", "write \"exact\", or leave the key out"});
    return faults;
}

AccuracyReport measure_accuracy(Scene const& scene, AccuracyOptions const& options, StudyProgress const& progress)
{
    Faults const faults = check_accuracy(scene, options);
    if (!faults.empty())
        throw InputError(faults);
    auto const start = std::chrono::steady_clock::now();
    AccuracyReport report;
    report.quick = options.quick;
    report.scene = plain(scene, report.notes);
    report.threads = thread_count(scene.solver.threads);
    report.machine = processor();
    auto const say = [&](std::string const& what, double share) {
        if (progress)
            progress(what, share);
    };
    say("reference in 50 digits", 0);
    Scene flat = report.scene;
    flat.coning.reset();
    StudyDrive const drive = study_drive(flat);
    ReferenceCurve const reference = reference_of(drive);
    constexpr int points = 240, positions = 1200;
    report.reference_error = reference.error();
    report.reference_entry = entry_of(drive, reference, points, positions);

    bool const any_sampled = std::any_of(studies().begin(), studies().end(), [&](Study const& s) { return s.sampled && wanted(options, s); });
    double const scene_share = any_sampled && options.sample > 0 ? 0.5 : 1.0;
    std::size_t done = 0;
    for (Study const& study : studies())
    {
        ++done;
        if (!wanted(options, study))
            continue;
        say(std::string(study.kind.name), scene_share * static_cast<double>(done - 1) / static_cast<double>(studies().size()));
        bool const own_axis = study.run == study_contact;
        StudyDrive with_axis = drive;
        with_axis.scene.coning = report.scene.coning;
        study.run({report, own_axis ? with_axis : drive, reference, report.scene.drive.name, options.quick ? 1 : options.repeats, options.quick, false, report.threads});
    }
    // a few designs at a time: their references take more memory than what is measured
    constexpr int most_drawn = 4;   // times as many as wanted
    for (int drawn = 0; any_sampled && report.sample < options.sample && drawn < most_drawn * options.sample;)
    {
        int const batch = std::min(options.sample - report.sample, report.threads);
        std::vector<std::unique_ptr<Sampled>> const designs = designs_of(flat, options.seed, drawn, batch, report.threads);
        drawn += batch;
        report.sample_refused += batch - static_cast<int>(designs.size());
        for (auto const& one : designs)
        {
            report.reference_error = std::max(report.reference_error, one->reference.error());
            report.reference_entry = std::max(report.reference_entry, one->entry);
            std::string const name = "design-" + std::string(report.sample < 10 ? "0" : "") + std::to_string(report.sample);
            say(name, scene_share + (1 - scene_share) * report.sample / options.sample);
            ++report.sample;
            for (Study const& study : studies())
            {
                if (!study.sampled || !wanted(options, study))
                    continue;
                try
                {
                    study.run({report, one->drive, one->reference, name, 1, options.quick, true, 1});
                }
                catch (NumericalError const& error)
                {
                    // such as another motion model with which the teeth have no land: what was measured before stays
                    report.notes.push_back(std::string(study.kind.name) + ": " + name + " not finished: " + error.what());
                }
            }
        }
    }
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

}  // namespace hdconj
