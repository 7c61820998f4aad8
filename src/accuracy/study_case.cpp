// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_case.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "base/option_faults.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/solve.hpp"

namespace hdconj::accuracy {
namespace {

/// Design @p number of the sample about @p scene: an additive recurrence in as many dimensions as there are numbers to
/// change, so that the designs fill the box evenly. Radial deformation 0.85 to 1.1 times that of the scene, wall 0.8
/// to 1.2, lengths and angles of the profile 0.94 to 1.06; the tip circle as it follows from them.
/// @param seed  turns the whole sequence
Scene design_near(Scene const& scene, std::uint64_t seed, int number)
{
    // square roots of primes: steps that no ratio of small numbers comes near
    static constexpr std::array<int, 16> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
    std::size_t dimension = 0;
    auto const between = [&](double low, double high) {
        double const step = std::sqrt(static_cast<double>(primes[dimension % primes.size()]));
        std::uint64_t const turned = (seed * 6364136223846793005ULL + 1442695040888963407ULL * (dimension + 1)) >> 11;
        double const start = static_cast<double>(turned) * 0x1p-53;
        ++dimension;
        double const place = start + step * (number + 1);
        return low + (high - low) * (place - std::floor(place));
    };
    Scene design = scene;
    design.circular_spline.inner_radius.reset();
    if (auto given = design.wave_generator.shape.given.find("radial_deformation");
        given != design.wave_generator.shape.given.end())
        if (auto* w0 = std::get_if<double>(&given->second.value))
            *w0 *= between(0.85, 1.1);
    design.flexspline.wall *= between(0.8, 1.2);
    scene::FamilyChoice& tooth = design.is_reverse() ? *design.circular_spline.profile : design.flexspline.profile;
    for (auto& [key, parameter] : tooth.given)
        if (auto* value = std::get_if<double>(&parameter.value); value != nullptr && key != "degree")
            *value *= between(0.94, 1.06);
    return design;
}

Measured measured(Scene const& scene, int points, int positions)
{
    StudyDrive drive = study_drive(scene);
    ReferenceCurve reference = reference_of(drive);
    double const entry = entry_of(drive, reference, points, positions);
    return {std::move(drive), std::move(reference), entry};
}

}  // namespace

std::vector<Study> const& studies()
{
    constexpr char const* of_flexspline = "it needs the flexspline's tooth given";
    static std::vector<Study> const all = {
        {{"tolerance", "what each digit of solver.tolerance costs"}, study_tolerance},
        {{"sampling", "equal steps of u against adaptive steps"}, study_sampling},
        {{"motion-model", "first-order and material motion against exact motion"}, study_motion_model},
        {{"polynomial-fit", "polynomial fitted to contacts on a grid in phi: best degree and its error"}, study_fit},
        {.kind = {"union", "brute-force union of tooth positions"},
         .outline = study_union,
         .forward_only = "it unites positions of a flexspline tooth"},
        {{"roots", "closed form, certified roots and a plain scan"}, study_roots},
        {{"number-type", "float, double, long double"}, study_precision},
        {.kind = {"contact-area", "slices and flank points for the contact area"},
         .axial = study_contact_area,
         .forward_only = of_flexspline,
         .lacks = lacks_for_contact},
        {.kind = {"load", "harmonics, slices, points, circles under torque"},
         .axial = study_load_twist,
         .forward_only = of_flexspline,
         .lacks = lacks_for_load},
        {{"threads", "speed with more threads; the result keeps every bit"}, study_threads}};
    return all;
}

bool named(AccuracyOptions const& options, Study const& study)
{
    return std::find(options.studies.begin(), options.studies.end(), study.kind.name) != options.studies.end();
}

std::vector<Study> wanted(Scene const& scene, AccuracyOptions const& options, std::vector<StudyNote>& notes)
{
    std::vector<Study> chosen;
    for (Study const& study : studies()) {
        if (!options.studies.empty() && !named(options, study))
            continue;
        if (scene.is_reverse() && study.forward_only != nullptr)
            notes.push_back({std::string(study.kind.name), std::string("left out, ") + study.forward_only});
        else
            chosen.push_back(study);
    }
    return chosen;
}

Faults nothing_measured(std::vector<Study> const& chosen, std::vector<StudyNote> const& notes)
{
    Faults faults;
    for (Study const& study : chosen) {
        std::string const name(study.kind.name);
        std::string why = "nothing could be measured";
        for (StudyNote const& note : notes)
            if (note.study == name)
                why += "; " + note.words;
        faults.push_back({"--study", 0, name, why, "change the scene, or ask for another study"});
    }
    return faults;
}

}  // namespace hdconj::accuracy

namespace hdconj {

std::vector<StudyKind> const& study_kinds()
{
    static std::vector<StudyKind> const kinds = [] {
        std::vector<StudyKind> all;
        for (accuracy::Study const& study : accuracy::studies())
            all.push_back(study.kind);
        return all;
    }();
    return kinds;
}

Faults check_studies(AccuracyOptions const& options)
{
    Faults faults;
    require_whole(faults, "--sample", options.sample, 0, scene::bounds::most_designs, "one such as 64");
    require_whole(faults, "--repeats", options.repeats, 1, scene::bounds::most_repeats, "one such as 5");
    std::vector<std::string_view> names;
    for (StudyKind const& kind : study_kinds())
        names.push_back(kind.name);
    for (std::string const& name : options.studies) {
        if (std::find(names.begin(), names.end(), name) != names.end())
            continue;
        std::string known;
        for (std::string_view const one : names)
            known += (known.empty() ? "" : ", ") + std::string(one);
        auto const meant = nearest(name, names);
        faults.push_back({"--study", 0, name, "there is no such study",
                          (meant ? "write " + std::string(*meant) : "write one of them") + "; known: " + known});
    }
    return faults;
}

Faults check_accuracy(Scene const& scene, AccuracyOptions const& options)
{
    Faults faults = check_studies(options);
    for (accuracy::Study const& study : accuracy::studies()) {
        if (!accuracy::named(options, study))
            continue;
        std::string const name(study.kind.name);
        if (scene.is_reverse() && study.forward_only != nullptr)
            faults.push_back(
                {"--study", 0, name,
                 "the circular spline's tooth is given, and of this study " + std::string(study.forward_only),
                 "leave it out, or give the flexspline's profile"});
        else if (std::string const lacking = study.lacks == nullptr ? "" : study.lacks(scene); !lacking.empty())
            faults.push_back({"--study", 0, name, lacking, "leave it out, or write these keys into the scene"});
    }
    return faults;
}

}  // namespace hdconj

namespace hdconj::accuracy {

Scene plain(Scene const& scene, std::vector<StudyNote>& notes)
{
    Scene plain = scene;
    if (scene.slices || scene.tilt)
        notes.push_back({"", std::string(!scene.tilt     ? "[slices]"
                                         : !scene.slices ? "[tilt]"
                                                         : "[slices] and [tilt]") +
                                 " left out of outlines, which are measured in one plane; contact-area and load have "
                                 "the tooth surface of the scene, and counts of slices of their own"});
    if (scene.coning)
        notes.push_back({"",
                         "[coning] left out: outlines are measured in the middle plane of a ring, from which an "
                         "elastic cup differs slightly; contact-area has the coning, load the elastic cup instead"});
    if (scene.circular_spline.root_clearance > 0)
        notes.push_back({"", "root_clearance left out: it is the difference of two given lengths"});
    plain.circular_spline.root_clearance = 0;
    if (scene.circular_spline.automatic_backlash)
        notes.push_back({"", "backlash_offset = \"auto\" left out: measured without side clearance"});
    plain.circular_spline.automatic_backlash = false;
    plain.wedm.reset();
    return plain;
}

Case case_of(Scene const& scene, std::vector<Study> const& chosen, int points, int positions)
{
    Case made{scene, {}, {}};
    if (std::none_of(chosen.begin(), chosen.end(), has_outline))
        return made;
    made.own = measured(scene, points, positions);
    bool const compared = std::ranges::any_of(chosen, [](Study const& s) { return s.outline == study_motion_model; });
    if (compared && scene.solver.kinematics != Kinematics::exact) {
        Scene exact = scene;
        exact.solver.kinematics = Kinematics::exact;
        made.exact = measured(exact, points, positions);
    }
    return made;
}

std::vector<std::unique_ptr<Case>> designs_of(Scene const& scene, std::vector<Study> const& chosen, std::uint64_t seed,
                                              int first, int count, int threads)
{
    std::vector<std::unique_ptr<Case>> made(static_cast<std::size_t>(count));
    parallel_for(made.size(), threads, 1, [&](std::size_t i) {
        try {
            Scene design = design_near(scene, seed, first + static_cast<int>(i));
            design.solver.threads = 1;
            if (!check_scene(design).empty())
                return;
            constexpr int points = 24, positions = 600;
            made[i] = std::make_unique<Case>(case_of(design, chosen, points, positions));
            if (!made[i]->own)
                (void)solve(design);
        } catch (NumericalError const& error) {
            if (!error.is_infeasible() && error.code() != ErrorCode::no_reference)
                throw;
            made[i].reset();  // counted as refused
        } catch (InputError const&) {
            made[i].reset();
        }
    });
    std::erase(made, nullptr);
    return made;
}

void run_study(Study const& study, Case const& drive, StudyRun const& run, Scene const& coned)
{
    auto const of = [&](Scene const& scene, int threads) -> StudyRun {
        return {run.report, run.notes, scene, run.name, run.repeats, run.quick, run.sampled, threads};
    };
    if (!has_outline(study))
        return study.axial(of(coned, run.report.threads));
    Measured const& against = drive.against(study);
    study.outline({of(against.drive.scene, run.threads), against.drive, against.reference});
}

}  // namespace hdconj::accuracy
