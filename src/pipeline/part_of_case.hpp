// SPDX-License-Identifier: GPL-3.0-or-later
// The circular spline of a case of a study.
#pragma once

#include "contact/study/contact_study_data.hpp"

namespace hdconj::pipeline {

/// Writes the surface of a case in all slices into @p out, of the drive of @p data, and the judgement of that part.
/// @param tip             tip circle of the case at z = 0 [mm]
/// @param side_clearance  of the case [mm]
/// @returns the side clearance that it is written with: 0, and a note in @p out, where it cannot be made with that of
/// the case
/// @throws NumericalError where it cannot be made without either
double write_part(Solution& out, contact::ContactStudyData& data, surface::SurfaceSpec const& spec, double tip,
                  double side_clearance);

}  // namespace hdconj::pipeline
