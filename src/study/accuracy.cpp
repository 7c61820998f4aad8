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
    void (*outline)(StudyBench const&);   ///< measured against the reference in 50 digits; null: see axial
    void (*axial)(StudyRun const&);       ///< brings slices, and what it is measured against, of its own
    char const* forward_only;             ///< why the reverse problem has no such study; null where it has
    std::string (*lacks)(Scene const&) = nullptr;   ///< what a scene gives too little of; null: nothing is needed
};

std::vector<Study> const& studies()
{
    constexpr char const* of_flexspline = "it needs the flexspline's tooth given";
    static std::vector<Study> const all = {
        {{"tolerance", "what each digit of solver.tolerance costs"}, study_tolerance, nullptr, nullptr},
        {{"sampling", "equal steps of u against the adaptive sampler"}, study_sampling, nullptr, nullptr},
        {{"motion-model", "first order and material against exact motion"}, study_motion_model, nullptr, nullptr},
        {{"polynomial-fit", "grid in phi, iterate, fit a polynomial: where the fit stops helping"}, study_fit, nullptr, nullptr},
        {{"union", "brute-force union of tooth positions"}, study_union, nullptr, "it unites positions of a flexspline tooth"},
        {{"roots", "closed form against certified roots against a plain scan"}, study_roots, nullptr, nullptr},
        {{"number-type", "float, double, long double"}, study_precision, nullptr, nullptr},
        {{"contact-area", "slices and flank points for the contact area"}, nullptr, study_contact, of_flexspline, lacks_for_contact},
        {{"load", "harmonics, slices, points, circles under torque"}, nullptr, study_load, of_flexspline, lacks_for_load},
        {{"threads", "what more threads give, and that they change no bit"}, study_threads, nullptr, nullptr}};
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
    if (scene.coning)
        notes.emplace_back("[coning] left out: outlines are measured in the plane of the middle as the wave generator shapes a ring, which an elastic cup follows only nearly; contact-area measures with it, load with the elastic cup in its place");
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

bool has_outline(Study const& study)
{
    return study.outline != nullptr;
}

/// A drive with what its studies are measured against: its own motion, and where the study motion-model is run the exact one. Neither where no study is of the outline.
struct Case
{
    Scene scene;
    std::optional<Measured> own, exact;

    /// What @p study is measured against.
    [[nodiscard]] Measured const& against(Study const& study) const { return study.outline == study_motion_model && exact ? *exact : *own; }
    [[nodiscard]] double error() const { return std::max(own ? own->reference.error() : 0, exact ? exact->reference.error() : 0); }
    [[nodiscard]] double entry() const { return std::max(own ? own->entry : 0, exact ? exact->entry : 0); }
};

Case case_of(Scene const& scene, std::vector<Study> const& chosen, int points, int positions)
{
    Case made{scene, {}, {}};
    if (std::none_of(chosen.begin(), chosen.end(), has_outline))
        return made;
    made.own = measured(scene, points, positions);
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
            if (!made[i]->own)
                (void)solve(design);
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

/// @p study of one drive. @param coned  the same drive with what it has along the axis
void run_study(Study const& study, Case const& drive, StudyRun const& run, Scene const& coned)
{
    if (has_outline(study))
    {
        Measured const& against = drive.against(study);
        study.outline({{run.report, against.drive.scene, run.name, run.repeats, run.quick, run.sampled, run.threads}, against.drive, against.reference});
        return;
    }
    study.axial({run.report, study.axial == study_contact ? coned : drive.scene, run.name, run.repeats, run.quick, run.sampled, run.report.threads});
}

/// One fault for each study that has been left out, where all of them have been.
Faults nothing_measured(std::vector<Study> const& chosen, std::vector<std::string> const& notes)
{
    Faults faults;
    for (Study const& study : chosen)
    {
        std::string const name(study.kind.name), begin = name + ": ";
        std::string why = "nothing could be measured";
        for (std::string const& note : notes)
            if (note.starts_with(begin))
                why += "; " + note.substr(begin.size());
        faults.push_back({"--study", 0, name, why, "change the scene, or ask for another study"});
    }
    return faults;
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

Faults check_studies(AccuracyOptions const& options)
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
    return faults;
}

Faults check_accuracy(Scene const& scene, AccuracyOptions const& options)
{
    Faults faults = check_studies(options);
    for (Study const& study : studies())
    {
        if (!named(options, study))
            continue;
        std::string const name(study.kind.name);
        if (scene.is_reverse() && study.forward_only != nullptr)
            faults.push_back({"--study", 0, name, "the circular spline's tooth is given, and of this study " + std::string(study.forward_only), "leave it out, or give the flexspline's profile"});
        else if (std::string const lacking = study.lacks == nullptr ? "" : study.lacks(scene); !lacking.empty())
            faults.push_back({"--study", 0, name, lacking, "leave it out, or write these keys into the scene"});
    }
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
    Scene flat = report.scene;
    flat.coning.reset();
    Case whole{flat, {}, {}};
    if (std::any_of(chosen.begin(), chosen.end(), has_outline))
    {
        say("reference in 50 digits", 0);
        constexpr int points = 240, positions = 1200;
        try
        {
            whole = case_of(flat, chosen, points, positions);
            report.reference_error = whole.error();
            report.reference_entry = whole.entry();
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

    double const scene_share = options.sample > 0 ? 1.0 / 8 : 1.0;   // of the time
    std::size_t done = 0;
    for (Study const& study : chosen)
    {
        say(std::string(study.kind.name), scene_share * static_cast<double>(done++) / static_cast<double>(chosen.size()));
        run_study(study, whole, {report, flat, report.scene.drive.name, options.quick ? 1 : options.repeats, options.quick, false, report.threads}, report.scene);
    }
    if (report.records.empty())
        throw InputError(nothing_measured(chosen, report.notes));
    // what this drive has not, designs about it have not either
    std::erase_if(chosen, [&](Study const& study) {
        return std::none_of(report.records.begin(), report.records.end(), [&](StudyRecord const& record) { return record.study == study.kind.name; });
    });
    // a few designs at a time: their references take more memory than what is measured
    constexpr int most_drawn = 4;   // times as many as wanted
    struct Unfinished
    {
        int designs = 0;
        std::string first;   ///< which, and why
    };
    std::vector<Unfinished> unfinished(chosen.size());
    for (int drawn = 0; !chosen.empty() && report.sample < options.sample && drawn < most_drawn * options.sample;)
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
            Scene coned = one->scene;
            coned.coning = report.scene.coning;
            for (std::size_t k = 0; k < chosen.size(); ++k)
            {
                try
                {
                    run_study(chosen[k], *one, {report, one->scene, name, 1, options.quick, true, 1}, coned);
                }
                catch (NumericalError const& error)
                {
                    // such as another motion model with which the teeth have no land: what was measured before stays
                    if (unfinished[k].designs++ == 0)
                        unfinished[k].first = name + ": " + error.what();
                }
            }
        }
    }
    for (std::size_t k = 0; k < chosen.size(); ++k)
        if (unfinished[k].designs > 0)
            report.notes.push_back(std::string(chosen[k].kind.name) + ": not finished on " + std::to_string(unfinished[k].designs) + " of " + std::to_string(report.sample)
                                   + " designs of the sample; the first is " + unfinished[k].first);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

}  // namespace hdconj
