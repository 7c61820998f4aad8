// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference_outline.hpp"

#include "accuracy/study_drive.hpp"
#include "hdconj/accuracy.hpp"
#include "hdconj/error.hpp"

namespace hdconj::accuracy {

ReferenceCurve reference_outline(Scene const& scene)
{
    Faults const faults = check_accuracy(scene, {});
    if (!faults.empty())
        throw InputError(faults);
    return reference_of(study_drive(scene));
}

}  // namespace hdconj::accuracy
