// SPDX-License-Identifier: GPL-3.0-or-later
// The studies, and which of them a scene has.
#pragma once

#include <string>
#include <vector>

#include "hdconj/accuracy.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {

struct Study
{
    StudyKind kind;
    void (*outline)(StudyBench const&);            ///< measured against the reference in 50 digits; null: see axial
    void (*axial)(StudyRun const&);                ///< brings slices, and what it is measured against, of its own
    char const* forward_only;                      ///< why the reverse problem has no such study; null where it has
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

}  // namespace hdconj::accuracy
