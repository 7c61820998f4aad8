// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_study.hpp"

#include <fmt/format.h>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "contact/study/surface_choices.hpp"
#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "load/model/cup_shape.hpp"
#include "load_case.hpp"

namespace hdconj::load {
namespace {

void tell_play(LoadObserver const& observer, LoadCase const& known)
{
    if (observer.talk)
        observer.talk(fmt::format("{}{}: side clearance {:.1f} um, backlash {:.2f} arcmin", to_string(known.surface),
                                  known.tilt != 0 ? fmt::format(" {:.2f} deg", to_deg(known.tilt)) : "",
                                  per_um * known.backlash_offset, per_arcmin * known.backlash));
}

double rated_line_load(LoadCase const& each)
{
    return each.curve[each.rated].largest_line_load;
}

}  // namespace

void tell_assembly(LoadObserver const& observer, AssembledCup const& cup)
{
    if (observer.talk)
        observer.talk(
            fmt::format("assembled: wave generator {:.0f} N, coning {:.3f} and {:.3f} deg at the major and minor axis, "
                        "cup {:.0f} MPa",
                        cup.wave_generator_force, to_deg(std::atan(cup.coning_major)),
                        to_deg(std::atan(cup.coning_minor)), cup.largest_stress));
}

void add_cases(contact::ContactContext const& context, DriveGrids const& drives, LoadOptions const& options,
               LoadObserver const& observer, LoadStudy& study)
{
    std::vector<surface::SurfaceSpec> const surfaces =
        contact::surface_choices(context.scene, contact_options(options));
    LoadingPath const torques = loading_path(context.scene, options);
    study.missing = contact::impossible_choices(contact_options(options));
    std::optional<NumericalError> first;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        CaseObserver const told{[&](LoadCase const& known) { tell_play(observer, known); },
                                [&](double fraction) {
                                    if (observer.progress)
                                        observer.progress("load", (static_cast<double>(i) + fraction) /
                                                                      static_cast<double>(surfaces.size()));
                                }};
        try {
            if (torques.forth.is_stopped())
                throw NumericalError(ErrorCode::stopped, "load", "torques", "the run was stopped before");
            SolvedCase solved = load_case(context, drives, surfaces[i], torques, told);
            for (auto const& [torque, cause] : solved.result.unsettled)
                study.missing.push_back(fmt::format("no result at {:g} N m for {}: {}", torque / newton_metre,
                                                    contact::spec_words(surfaces[i]), cause));
            study.cases.push_back(std::move(solved.result));
            std::size_t const last = study.cases.size() - 1;
            if (last == 0 || rated_line_load(study.cases[last]) < rated_line_load(study.cases[study.written_case])) {
                study.written_case = last;
                study.shape = cup_shape(drives.fine.model, solved.field, context.threads);
                study.teeth = std::move(solved.teeth);
            }
        } catch (NumericalError const& error) {
            study.missing.push_back(contact::no_row(surfaces[i], error.what()));
            if (!first)
                first.emplace(error);
        }
    }
    if (study.cases.empty())
        throw NumericalError(*first);
}

}  // namespace hdconj::load
