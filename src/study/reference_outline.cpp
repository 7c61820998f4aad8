// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/study/reference_outline.hpp"

#include "hdconj/study/accuracy.hpp"
#include "study_drive.hpp"

namespace hdconj {

ReferenceCurve reference_outline(Scene const& scene)
{
    Faults const faults = check_accuracy(scene, {});
    if (!faults.empty())
        throw InputError(faults);
    return detail::reference_of(detail::study_drive(scene));
}

}  // namespace hdconj
