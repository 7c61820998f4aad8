// SPDX-License-Identifier: GPL-3.0-or-later
// The studies, and drives as they take them: the scene's own, and designs about it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hdconj/accuracy.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {

struct Study
{
    StudyKind kind;
    void (*outline)(StudyBench const&) = nullptr;  ///< measured against the reference in 50 digits; null: see axial
    void (*axial)(StudyRun const&) = nullptr;      ///< brings slices, and what it is measured against, of its own
    char const* forward_only = nullptr;            ///< why the reverse problem has no such study; null where it has
    std::string (*lacks)(Scene const&) = nullptr;  ///< what a scene gives too little of; null: nothing is needed
};

/// In the order in which they are run.
[[nodiscard]] std::vector<Study> const& studies();

/// Whether it is measured against the reference in 50 digits.
[[nodiscard]] inline bool has_outline(Study const& study)
{
    return study.outline != nullptr;
}

/// Whether @p options ask for it by name.
[[nodiscard]] bool named(AccuracyOptions const& options, Study const& study);

/// The studies that are run; of those that nobody has asked for by name, those that the scene has. What is left out is
/// said in @p notes.
[[nodiscard]] std::vector<Study> wanted(Scene const& scene, AccuracyOptions const& options,
                                        std::vector<StudyNote>& notes);

/// One fault for each study that has been left out, where all of them have been.
[[nodiscard]] Faults nothing_measured(std::vector<Study> const& chosen, std::vector<StudyNote> const& notes);

/// The drive that is measured: nothing cut away that no tooth has touched, no side clearance that is solved for. What
/// is left out of it, or of all studies of one plane, is said in @p notes.
[[nodiscard]] Scene plain(Scene const& scene, std::vector<StudyNote>& notes);

/// A drive taken apart, with its reference.
struct Measured
{
    StudyDrive drive;
    ReferenceCurve reference;
    double entry = 0;
};

/// A drive with what its studies are measured against: its own motion, and where the study motion-model is run the
/// exact one. Neither where no study is of the outline.
struct Case
{
    Scene scene;
    std::optional<Measured> own, exact;

    /// What @p study is measured against.
    [[nodiscard]] Measured const& against(Study const& study) const
    {
        return study.outline == study_motion_model && exact ? *exact : *own;
    }
    [[nodiscard]] double error() const
    {
        return std::max(own ? own->reference.error() : 0, exact ? exact->reference.error() : 0);
    }
    [[nodiscard]] double entry() const { return std::max(own ? own->entry : 0, exact ? exact->entry : 0); }
};

/// @param points, positions  where the reference is looked at for being touched and not entered
[[nodiscard]] Case case_of(Scene const& scene, std::vector<Study> const& chosen, int points, int positions);

/// Those of designs @p first ... @p first + @p count - 1 about @p scene that make a drive.
[[nodiscard]] std::vector<std::unique_ptr<Case>> designs_of(Scene const& scene, std::vector<Study> const& chosen,
                                                            std::uint64_t seed, int first, int count, int threads);

/// @p study of one drive. @param coned  the same drive with what it has along the axis
void run_study(Study const& study, Case const& drive, StudyRun const& run, Scene const& coned);

}  // namespace hdconj::accuracy
