// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a running drive.
#pragma once

#include <string>

#include "figure_of.hpp"
#include "hdconj/running.hpp"

namespace hdconj::figures {

/// Of the study as a whole.
[[nodiscard]] Rows<RunStudy> run_study_figures();
/// Of one sequence. @param under_torque  false: without those of the torque on the wave generator
[[nodiscard]] Rows<RunSequence> run_sequence_figures(bool under_torque);
/// At one position. @param under_torque  as above
[[nodiscard]] Rows<RunPosition> run_position_rows(bool under_torque);
/// Of one order.
[[nodiscard]] Rows<RunOrder> run_order_rows();
/// At one torque, speed and temperature.
[[nodiscard]] Rows<EfficiencyRow> efficiency_rows();
/// Of the losses as a whole, but for the back-driving torque.
[[nodiscard]] Rows<RunLosses> run_loss_figures();

/// The torque on the output that turns the wave generator, where it was found.
struct BackDriving
{
    double torque = 0;
    double error = 0;
};
[[nodiscard]] Rows<BackDriving> back_driving_figures();

/// "one tooth pitch", "one turn of the wave generator": a span in words.
[[nodiscard]] std::string span_words(RunSpan span);

/// The largest order of a sequence; null where there is none.
[[nodiscard]] RunOrder const* largest_order(RunSequence const& sequence);

}  // namespace hdconj::figures
