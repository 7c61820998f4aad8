// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of /running, as docs/reference/hdf5.md describes it.
#include "columns.hpp"
#include "figures/running_figures.hpp"
#include "results.hpp"

namespace hdconj::io {
namespace {

using layout::Writer;

void write_sequence(Writer const& place, RunSequence const& sequence)
{
    bool const under_torque = sequence.torque != 0;
    place.attribute("span", to_string(sequence.span));
    place.attribute("torque_Nmm", sequence.torque);
    place.attribute("estimated", sequence.estimated ? 1 : 0);
    place.attribute("seconds", sequence.seconds);
    layout::write_attributes(place, figures::run_sequence_figures(under_torque), sequence, sequence.estimated);
    layout::write_columns(place, "position", figures::run_position_rows(under_torque), sequence.positions, "",
                          sequence.estimated);
    if (!sequence.orders.empty())
        place.group("spectrum", [&](Writer const& group) {
            layout::write_columns(group, "order", figures::run_order_rows(), sequence.orders, "", sequence.estimated);
        });
}

void write_losses(Writer const& place, RunLosses const& losses)
{
    place.attribute("estimated", losses.estimated ? 1 : 0);
    layout::write_attributes(place, figures::run_loss_figures(), losses);
    if (losses.back_driving)
        layout::write_attributes(place, figures::back_driving_figures(),
                                 {*losses.back_driving, losses.back_driving_error});
    layout::write_columns(place, "case", figures::efficiency_rows(), losses.efficiency);
}

}  // namespace

void layout::write_result(Writer const& root, RunStudy const& study)
{
    write_solution(root, study.solution, study.backlash_offset);
    root.group("running", [&](Writer const& place) {
        place.attribute("output", std::string(to_string(study.output)));
        place.attribute("elastic", study.elastic ? 1 : 0);
        if (!study.missing.empty())
            place.attribute("missing", study.missing);
        write_attributes(place, figures::run_study_figures(), study);
        place.groups("sequence", study.sequences, write_sequence);
        if (study.losses)
            place.group("losses", [&](Writer const& group) { write_losses(group, *study.losses); });
    });
}

}  // namespace hdconj::io
