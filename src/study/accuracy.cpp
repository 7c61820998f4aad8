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

/// The first @p count designs about @p scene that make a drive.
std::vector<std::unique_ptr<Sampled>> sample_of(Scene const& scene, AccuracyOptions const& options, int count, int threads, AccuracyReport& report,
                                                std::function<void(double)> const& progress)
{
    std::vector<std::unique_ptr<Sampled>> sample;
    int drawn = 0;
    constexpr int most_drawn = 4;   // times as many as wanted
    while (static_cast<int>(sample.size()) < count && drawn < most_drawn * count)
    {
        int const missing = count - static_cast<int>(sample.size());
        int const batch = std::min(missing, 4 * threads);
        std::vector<std::unique_ptr<Sampled>> made(static_cast<std::size_t>(batch));
        parallel_for(made.size(), threads, 1, [&](std::size_t i) {
            try
            {
                Scene design = design_near(scene, options.seed, drawn + static_cast<int>(i));
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
        drawn += batch;
        for (auto& one : made)
        {
            if (one)
                sample.push_back(std::move(one));
            else
                ++report.sample_refused;
        }
        progress(static_cast<double>(sample.size()) / count);
    }
    report.sample = static_cast<int>(sample.size());
    return sample;
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
    if (scene.wave_generator.shape.family != "cosine")
        faults.push_back({"wave_generator.family", scene.wave_generator.shape.line, scene.wave_generator.shape.family,
                          "the reference in 50 digits knows the cosine wave generator only",
                          "write \"cosine\" with the same radial_deformation: what accuracy costs hardly depends on the family"});
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
    std::vector<std::unique_ptr<Sampled>> sample;
    constexpr double sample_share = 0.15, scene_share = 0.45;
    if (options.sample > 0 && any_sampled)
        sample = sample_of(flat, options, options.sample, report.threads, report, [&](double share) { say("references of the sample", sample_share * share); });
    for (auto const& one : sample)
    {
        report.reference_error = std::max(report.reference_error, one->reference.error());
        report.reference_entry = std::max(report.reference_entry, one->entry);
    }

    std::size_t done = 0;
    for (Study const& study : studies())
    {
        ++done;
        if (!wanted(options, study))
            continue;
        say(std::string(study.kind.name), sample_share + scene_share * static_cast<double>(done - 1) / static_cast<double>(studies().size()));
        bool const own_axis = study.run == study_contact;
        StudyDrive with_axis = drive;
        with_axis.scene.coning = report.scene.coning;
        study.run({report, own_axis ? with_axis : drive, reference, report.scene.drive.name, options.quick ? 1 : options.repeats, options.quick, false, report.threads});
    }
    for (std::size_t i = 0; i < sample.size(); ++i)
    {
        std::string const name = "design-" + std::string(i < 10 ? "0" : "") + std::to_string(i);
        say(name, sample_share + scene_share + (1 - sample_share - scene_share) * static_cast<double>(i) / static_cast<double>(sample.size()));
        for (Study const& study : studies())
        {
            if (!study.sampled || !wanted(options, study))
                continue;
            try
            {
                study.run({report, sample[i]->drive, sample[i]->reference, name, 1, options.quick, true, 1});
            }
            catch (NumericalError const& error)
            {
                // such as another motion model with which the teeth have no land: what was measured before stays
                report.notes.push_back(std::string(study.kind.name) + ": " + name + " not finished: " + error.what());
            }
        }
    }
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

}  // namespace hdconj
