// SPDX-License-Identifier: GPL-3.0-or-later
// The circular spline of a case of a study.
#pragma once

#include "contact/study/contact_study_data.hpp"

namespace hdconj::pipeline {

/// A case whose part is written.
struct PartOfCase
{
    surface::SurfaceSpec spec;
    double tip = 0;             ///< tip circle at z = 0 [mm]
    double side_clearance = 0;  ///< [mm]
};

/// The drive of @p data with the circular spline of a case: its surface in all slices, and the judgement of that part.
/// Dimensions, zones, check and errors are those of the plane z = 0 with the side clearance and the tip circle that the
/// scene gives. Where it leaves a side clearance to the program ("auto"), or the circular spline cannot be made with
/// its tip circle, they are those of the case; the latter is a note.
/// @throws NumericalError where the part cannot be made with its side clearance
[[nodiscard]] Solution solution_with_part(contact::ContactStudyData& data, PartOfCase const& part);

}  // namespace hdconj::pipeline
