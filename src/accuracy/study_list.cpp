// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_list.hpp"

#include <algorithm>

#include "base/option_faults.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/scene/schema.hpp"

namespace hdconj::accuracy {

std::vector<Study> const& studies()
{
    constexpr char const* of_flexspline = "it needs the flexspline's tooth given";
    static std::vector<Study> const all = {
        {{"tolerance", "what each digit of solver.tolerance costs"}, study_tolerance, nullptr, nullptr},
        {{"sampling", "equal steps of u against adaptive steps"}, study_sampling, nullptr, nullptr},
        {{"motion-model", "first-order and material motion against exact motion"},
         study_motion_model,
         nullptr,
         nullptr},
        {{"polynomial-fit", "polynomial fitted to contacts on a grid in phi: best degree and its error"},
         study_fit,
         nullptr,
         nullptr},
        {{"union", "brute-force union of tooth positions"},
         study_union,
         nullptr,
         "it unites positions of a flexspline tooth"},
        {{"roots", "closed form, certified roots and a plain scan"}, study_roots, nullptr, nullptr},
        {{"number-type", "float, double, long double"}, study_precision, nullptr, nullptr},
        {{"contact-area", "slices and flank points for the contact area"},
         nullptr,
         study_contact_area,
         of_flexspline,
         lacks_for_contact},
        {{"load", "harmonics, slices, points, circles under torque"},
         nullptr,
         study_load_twist,
         of_flexspline,
         lacks_for_load},
        {{"threads", "speed with more threads; the result keeps every bit"}, study_threads, nullptr, nullptr}};
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
