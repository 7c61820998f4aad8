// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Work-precision studies: for each method and knob a ladder from coarse to fine, error against time.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/scene/fault.hpp"
#include "hdconj/study/record.hpp"

namespace hdconj {

/// A study by its name, and the question it answers.
struct StudyKind
{
    std::string_view name;
    std::string_view question;
};

/// Every study, in the order in which they run.
[[nodiscard]] std::vector<StudyKind> const& study_kinds();

/// What is asked beside the scene.
struct AccuracyOptions
{
    std::vector<std::string> studies;     ///< names; empty: all
    int sample = 64;                      ///< designs beside the scene; 0: none
    int repeats = 5;
    bool quick = false;                   ///< short ladders, one repeat: for tests
    std::uint64_t seed = 20250301;        ///< of the sample
};

/// Told which study runs, and how much of all is done, 0 ... 1.
using StudyProgress = std::function<void(std::string const& what, double share)>;

/// Names of studies that there are not: all that can be said without a scene.
[[nodiscard]] Faults check_studies(AccuracyOptions const& options);

/// Whether what is asked can be measured: studies that there are, and that this scene has. Every drive that `solve` takes has a reference in 50 digits, of its own motion model and of the member
/// that it solves for; in the reverse problem there is no union, contact-area and load, nor these two where the scene lacks what they need: left out with a note where nobody names them, a fault where somebody does.
[[nodiscard]] Faults check_accuracy(Scene const& scene, AccuracyOptions const& options);

/// Runs the studies.
///
/// Effects along the axis, coning among them (contact-area alone knows of it), root clearance and an automatic side clearance are left out of the drive that is measured; `notes` says so. Errors are against the scene's own motion model, those of the
/// study motion-model against exact motion. Studies that the scene does not have, or that have no reference, are left out while others run; `notes` says why.
/// Deterministic but for the times and the memory.
/// @throws InputError for what check_accuracy() finds, and where every study had to be left out; NumericalError where the scene itself cannot be solved, or has no reference and no other study was asked for
[[nodiscard]] AccuracyReport measure_accuracy(Scene const& scene, AccuracyOptions const& options = {}, StudyProgress const& progress = {});

}  // namespace hdconj
