// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The pictures of a contact study as gnuplot scripts; private to src/io.
#pragma once

#include "hdconj/pipeline/contact_study.hpp"
#include "picture_script.hpp"

namespace hdconj {

/// Whether some surface was computed at two tilts or more.
[[nodiscard]] bool has_tilt_curve(ContactStudy const& study);

/// Contact area (left axis) and clearing offset (right axis) against tilt, a pair of curves for each surface and kind, the best
/// tilts marked.
[[nodiscard]] std::string tilt_script(ContactStudy const& study, PictureFormat format);

/// Smallest gap along the flank over tooth space and slice, both flanks. Needs a map.
[[nodiscard]] std::string map_script(ContactStudy const& study, PictureFormat format);

/// Gap over the flank that has most contact, along the flank and z. Needs a map.
[[nodiscard]] std::string flank_script(ContactStudy const& study, PictureFormat format);

/// Drive and case that map and flank are of, for their headings.
[[nodiscard]] std::string shown_case(ContactStudy const& study);

}  // namespace hdconj
