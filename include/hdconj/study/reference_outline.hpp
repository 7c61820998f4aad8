// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The true outline of a drive, to measure others by.
#pragma once

#include "hdconj/scene/scene.hpp"
#include "hdconj/study/reference_curve.hpp"

namespace hdconj {

/// One pitch of the circular spline of @p scene under exact motion, mid-land to mid-land, in 50 digits by a path of its own.
///
/// Domain: forward problem, cosine wave generator, a side clearance that is a number; root clearance and effects along the axis are not looked at.
/// Accuracy: ReferenceCurve::error(), some 1e-16 mm.
/// @throws InputError outside that domain; NumericalError as `solve` does, and where an arc's centre is at rest
[[nodiscard]] ReferenceCurve reference_outline(Scene const& scene);

}  // namespace hdconj
