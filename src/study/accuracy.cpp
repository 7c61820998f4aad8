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
    void (*outline)(StudyBench const&);   ///< measured against the reference; null: see axial
    void (*axial)(StudyRun const&);       ///< measured against its own finest rung
    bool sampled;                         ///< over the sample of designs too
    char const* forward_only;             ///< why the reverse problem has no such study; null where it has
};

std::vector<Study> const& studies()
{
    constexpr char const* of_flexspline = "it needs the flexspline's tooth given";
    static std::vector<Study> const all = {
        {{"tolerance", "what each digit of solver.tolerance costs"}, study_tolerance, nullptr, true, nullptr},
        {{"sampling", "equal steps of u against the adaptive sampler"}, study_sampling, nullptr, true, nullptr},
        {{"motion-model", "first order and material against exact motion"}, study_motion_model, nullptr, true, nullptr},
        {{"polynomial-fit", "grid in phi, iterate, fit a polynomial: where the fit stops helping"}, study_fit, nullptr, false, nullptr},
        {{"union", "brute-force union of tooth positions"}, study_union, nullptr, true, "it unites positions of a flexspline tooth"},
        {{"roots", "closed form against certified roots against a plain scan"}, study_roots, nullptr, true, nullptr},
        {{"number-type", "float, double, long double"}, study_precision, nullptr, true, nullptr},
        {{"contact-area", "slices and flank points for the contact area"}, nullptr, study_contact, false, of_flexspline},
        {{"load", "harmonics, slices, points, circles under torque"}, nullptr, study_load, false, of_flexspline},
        {{"threads", "what more threads give, and that they change no bit"}, study_threads, nullptr, false, nullptr}};
    return all;
}

bool named(AccuracyOptions const& options, Study const& study)
{
    return std::find(options.studies.begin(), options.studies.end(), study.kind.name) != options.studies.end();
}

/// The studies that are run; of those that nobody has asked for by name, those that the scene has.
std::vector<Study> wanted(Scene const& scene, AccuracyOptions const& options, std::vector<std::string>& notes)
{
    std::vector<Study> chosen;
    for (Study const& study : studies())
    {
        if (!options.studies.empty() && !named(options, study))
            continue;
        if (scene.is_reverse() && study.forward_only != nullptr)
            notes.push_back(std::string(study.kind.name) + ": left out, " + study.forward_only);
        else
            chosen.push_back(study);
    }
    return chosen;
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

/// A drive taken apart, with its reference.
struct Measured
{
    StudyDrive drive;
    ReferenceCurve reference;
    double entry = 0;
};

Measured measured(Scene const& scene, int points, int positions)
{
    StudyDrive drive = study_drive(scene);
    ReferenceCurve reference = reference_of(drive);
    double const entry = entry_of(drive, reference, points, positions);
    return {std::move(drive), std::move(reference), entry};
}

/// A drive with what its studies are measured against: its own motion, and where the study motion-model is run the exact one.
struct Case
{
    Measured own;
    std::optional<Measured> exact;

    /// What @p study is measured against.
    [[nodiscard]] Measured const& against(Study const& study) const { return study.outline == study_motion_model && exact ? *exact : own; }
    [[nodiscard]] double error() const { return std::max(own.reference.error(), exact ? exact->reference.error() : 0); }
    [[nodiscard]] double entry() const { return std::max(own.entry, exact ? exact->entry : 0); }
};

Case case_of(Scene const& scene, std::vector<Study> const& chosen, int points, int positions)
{
    Case made{measured(scene, points, positions), std::nullopt};
    bool const compared = std::any_of(chosen.begin(), chosen.end(), [](Study const& s) { return s.outline == study_motion_model; });
    if (compared && scene.solver.kinematics != Kinematics::exact)
    {
        Scene exact = scene;
        exact.solver.kinematics = Kinematics::exact;
        made.exact = measured(exact, points, positions);
    }
    return made;
}

/// Those of designs @p first ... @p first + @p count - 1 about @p scene that make a drive.
std::vector<std::unique_ptr<Case>> designs_of(Scene const& scene, std::vector<Study> const& chosen, std::uint64_t seed, int first, int count, int threads)
{
    std::vector<std::unique_ptr<Case>> made(static_cast<std::size_t>(count));
    parallel_for(made.size(), threads, 1, [&](std::size_t i) {
        try
        {
            Scene design = design_near(scene, seed, first + static_cast<int>(i));
            design.solver.threads = 1;
            if (!check_scene(design).empty())
                return;
            constexpr int points = 24, positions = 600;
            made[i] = std::make_unique<Case>(case_of(design, chosen, points, positions));
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
    for (Study const& study : studies())
        if (scene.is_reverse() && study.forward_only != nullptr && named(options, study))
            faults.push_back({"--study", 0, std::string(study.kind.name), "the circular spline's tooth is given, and of this study " + std::string(study.forward_only),
                              "leave it out, or give the flexspline's profile"});
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
    std::vector<Study> chosen = wanted(report.scene, options, report.notes);
    auto const has_outline = [](Study const& s) { return s.outline != nullptr; };
    Scene flat = report.scene;
    flat.coning.reset();
    std::optional<Case> whole;
    if (std::any_of(chosen.begin(), chosen.end(), has_outline))
    {
        say("reference in 50 digits", 0);
        constexpr int points = 240, positions = 1200;
        try
        {
            whole = case_of(flat, chosen, points, positions);
            report.reference_error = whole->error();
            report.reference_entry = whole->entry();
        }
        catch (NumericalError const& error)
        {
            // what needs no reference still runs
            if (std::all_of(chosen.begin(), chosen.end(), has_outline))
                throw;
            for (Study const& study : chosen)
                if (has_outline(study))
                    report.notes.push_back(std::string(study.kind.name) + ": left out, " + error.what());
            std::erase_if(chosen, has_outline);
        }
    }

    bool const any_sampled = std::any_of(chosen.begin(), chosen.end(), [](Study const& s) { return s.sampled; });
    double const scene_share = any_sampled && options.sample > 0 ? 0.5 : 1.0;
    std::size_t done = 0;
    for (Study const& study : chosen)
    {
        say(std::string(study.kind.name), scene_share * static_cast<double>(done++) / static_cast<double>(chosen.size()));
        StudyRun const run{report, study.axial == study_contact ? report.scene : flat, report.scene.drive.name, options.quick ? 1 : options.repeats, options.quick, false,
                           report.threads};
        if (study.axial != nullptr)
            study.axial(run);
        else
            study.outline({run, whole->against(study).drive, whole->against(study).reference});
    }
    // a few designs at a time: their references take more memory than what is measured
    constexpr int most_drawn = 4;   // times as many as wanted
    for (int drawn = 0; any_sampled && report.sample < options.sample && drawn < most_drawn * options.sample;)
    {
        int const batch = std::min(options.sample - report.sample, report.threads);
        std::vector<std::unique_ptr<Case>> const designs = designs_of(flat, chosen, options.seed, drawn, batch, report.threads);
        drawn += batch;
        report.sample_refused += batch - static_cast<int>(designs.size());
        for (auto const& one : designs)
        {
            report.reference_error = std::max(report.reference_error, one->error());
            report.reference_entry = std::max(report.reference_entry, one->entry());
            std::string const name = "design-" + std::string(report.sample < 10 ? "0" : "") + std::to_string(report.sample);
            say(name, scene_share + (1 - scene_share) * report.sample / options.sample);
            ++report.sample;
            for (Study const& study : chosen)
            {
                if (!study.sampled)
                    continue;
                try
                {
                    Measured const& against = one->against(study);
                    study.outline({{report, against.drive.scene, name, 1, options.quick, true, 1}, against.drive, against.reference});
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
