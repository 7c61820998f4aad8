// SPDX-License-Identifier: GPL-3.0-or-later
// The circular spline's outline where its tooth is given and not solved for.
#pragma once

#include "centred_outline.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// One pitch of the circular spline with the given tooth: from the middle of one tooth's tip across the space to that
/// of the next. Between the roots the bottom of the space is a circle about the drive's axis.
/// @param radius  of the origin of the tooth's frame
/// @param chord   largest chord error [mm]
[[nodiscard]] CentredOutline given_spline(profile::Profile const& tooth, double radius, double pitch, double chord);

/// Writes it into @p out as its one slice, with its landmarks and measures.
void publish_given_spline(Solution& out, profile::Profile const& tooth, CentredOutline const& spline, double pitch);

}  // namespace hdconj::conjugate
