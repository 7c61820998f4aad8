// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of /load/measured, as docs/reference/hdf5.md describes it.
#include "columns.hpp"
#include "figures/measured_figures.hpp"
#include "results.hpp"

namespace hdconj::io {

void layout::write_result(Writer const& place, Measurement const& measured)
{
    auto const& [curve, found] = measured;
    place.attribute("path", curve.file);
    place.attribute("columns", curve.columns);
    place.attribute("torque_constant_Nm_per_A", curve.rig.torque_constant);
    place.attribute("counts_per_turn", curve.rig.counts_per_turn);
    place.attribute("ratio", curve.rig.ratio);
    place.attribute("efficiency", curve.rig.efficiency);
    place.attribute("angle_per_spline", curve.rig.angle_per_spline);
    layout::write_attributes(place, figures::measured_curve_figures(), found);
    place.numbers("twist", curve.twist, {"rad", "twist of the samples at the output", {"sample"}});
    place.numbers("torque", curve.torque, {"N mm", "torque of the samples at the output", {"sample"}});
    for (auto const& figure : figures::measured_figures()) {
        Estimate const& estimate = figure.value(found);
        if (estimate.count == 0)
            continue;
        layout::write_named(place, figure.name, [&](char const* name) {
            place.numbers(name, {estimate.value, estimate.error},
                          {figure.unit.stored, std::string(figure.words) + ": value and standard error", {"estimate"}});
        });
        place.figure({figure.name.now, figure.name.now, figure.name.now, figure.unit.stored, figure.words, false});
        place.integers(std::string(figure.name.now) + "_count", {estimate.count},
                       {"1", "number of values averaged", {"average"}});
        if (figure.name.former != nullptr)
            place.link(figure.name.now + std::string("_count"), figure.name.former + std::string("_count"));
    }
}

}  // namespace hdconj::io
