// SPDX-License-Identifier: GPL-3.0-or-later
// Drives as the studies take them: the scene's own, and designs about it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study_list.hpp"

namespace hdconj::accuracy {

/// The drive that is measured: nothing along the axis, nothing cut away that no tooth has touched. What is left out is
/// said in @p notes.
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
