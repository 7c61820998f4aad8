// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_case.hpp"

#include "contact/clearance/clearing_search.hpp"
#include "contact_study_data.hpp"
#include "surface_choices.hpp"

namespace hdconj::contact {

ClearingNeed clearing_need(Scene const& scene)
{
    ContactStudyData data(scene, Verb::contact, {});
    surface::SurfaceSpec const spec = surface_choices(scene, {}).front();
    ContactCase const found = clearing_case(*data.context, spec);
    return {found.clearing_offset, found.clearing_tip, data.middle.geometry.circular_spline_inner_radius,
            found.clearing_offset > 0 ? clearing_accuracy(data.context->tolerance) / flattest_clearing : 0};
}

}  // namespace hdconj::contact
