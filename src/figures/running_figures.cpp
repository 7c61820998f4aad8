// SPDX-License-Identifier: GPL-3.0-or-later
#include "running_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "joined_tables.hpp"
#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

inline constexpr Unit arcsec{"rad", "arcsec", "arcsec", 60 * per_arcmin};
inline constexpr Unit rpm{"rad/s", "rpm", "rpm", 1 / hdconj::rpm};
inline constexpr Unit celsius{"degC", "degC", "deg C"};

/// "-" where there is no value.
template <std::string (*format)(double)>
std::string if_determined(double value)
{
    return std::isnan(value) ? "-" : format(value);
}

constexpr std::array error_figures = {
    figure<&RunSequence::planned>("planned_positions", one, "positions asked for, with and without a result"),
    pair<&RunSequence::peak_to_peak, &RunSequence::peak_to_peak_error>(
        "peak_to_peak", arcsec, "transmission error, peak to peak over the positions",
        {"peak to peak", if_determined<significant<3>>, two_digits}),
    pair<&RunSequence::rms, &RunSequence::rms_error>("rms", arcsec, "its root mean square about the mean",
                                                     {"rms", significant<3>, two_digits}),
    figure<&RunSequence::seconds>("seconds", second, "wall time", {"time", significant<3>})
        .keyed("time")
        .without(hdf5)};

constexpr std::array torque_figures = {
    pair<&RunSequence::mean_torque, &RunSequence::mean_torque_error>(
        "mean_torque", newton_metre, "on the wave generator without friction, mean over the positions",
        {"mean", significant<4>, two_digits}),
    pair<&RunSequence::torque_ripple, &RunSequence::torque_ripple_error>(
        "torque_ripple", newton_metre, "peak to peak of that torque", {"ripple", significant<3>, two_digits})};

constexpr std::array place_rows = {
    figure<&RunPosition::angle>("angle", degree, "of the wave generator against the ring that is held"),
    pair<&RunPosition::error, &RunPosition::error_error>(
        "error", arcsec, "transmission error: by how much the output is ahead; its own error is that about the mean")};

constexpr std::array torque_rows = {
    pair<&RunPosition::wave_generator_torque, &RunPosition::torque_error>(
        "wave_generator_torque", newton_metre, "on the wave generator without friction, by its bearing"),
    pair<&RunPosition::torque_by_teeth, &RunPosition::torque_error>("torque_by_teeth", newton_metre,
                                                                    "the same by the forces of the teeth")};

}  // namespace

Rows<RunStudy> run_study_figures()
{
    using T = RunStudy;
    static constexpr std::array rows = {
        figure<&T::ratio>("ratio", one, "turns of the wave generator for one of the output", {"ratio", decimals<4>}),
        figure<&T::torque>("torque", newton_metre, "largest torque on the output; 0: first contact only",
                           {"torque on the output", significant<5>}),
        figure<&T::spline_torque>("spline_torque", newton_metre, "the same on the circular spline",
                                  {"on the circular spline", significant<5>}),
        figure<&T::backlash_offset>("backlash_offset", um, "side clearance of the flanks",
                                    {"side clearance", fixed<2>}),
        figure<&T::side_clearance_increased>("side_clearance_increased", one,
                                             "whether this is more than the scene gives"),
        figure<&T::tip>("tip_radius", mm, "tip circle at z = 0", {"tip circle", decimals<6>}),
        figure<&T::tip_radius_increase>("tip_radius_increase", um,
                                        "how much wider the tip circle is than the scene gives",
                                        {"wider", decimals<2>})};
    return Rows<T>(rows);
}

Rows<RunSequence> run_sequence_figures(bool under_torque)
{
    static constexpr std::array all = joined(error_figures, torque_figures);
    return under_torque ? Rows<RunSequence>(all) : Rows<RunSequence>(error_figures);
}

Rows<RunPosition> run_position_rows(bool under_torque)
{
    static constexpr std::array all = joined(place_rows, torque_rows);
    return under_torque ? Rows<RunPosition>(all) : Rows<RunPosition>(place_rows);
}

Rows<RunOrder> run_order_rows()
{
    using T = RunOrder;
    static constexpr std::array rows = {
        figure<&T::per_input>("per_input", one, "periods in a turn of the wave generator",
                              {"per input turn", significant<5>}),
        figure<&T::per_output>("per_output", one, "periods in a turn of the output"),
        pair<&T::amplitude, &T::amplitude_error>("amplitude", arcsec, "of amplitude cos(per_input angle - phase)",
                                                 {"amplitude", significant<3>, two_digits}),
        pair<&T::phase, &T::phase_error>("phase", degree, "of the same; an error of 180 degrees: not known")};
    return Rows<T>(rows);
}

Rows<EfficiencyRow> efficiency_rows()
{
    using T = EfficiencyRow;
    static constexpr std::array rows = {
        figure<&T::torque>("torque", newton_metre, "on the output", {"torque", significant<4>}),
        figure<&T::speed>("speed", rpm, "of the wave generator", {"speed", significant<5>}),
        figure<&T::temperature>("temperature", celsius, "of the lubricant", {"temperature", significant<4>}),
        pair<&T::efficiency, &T::efficiency_error>(
            "efficiency", one, "power of the output over that of the wave generator",
            {"efficiency", if_determined<fixed<1>>, if_determined<two_digits>, &percent}),
        pair<&T::input_torque, &T::input_torque_error>(
            "input_torque", newton_metre, "that drives the wave generator; at torque 0 the no-load running torque",
            {"input", significant<4>, two_digits}),
        figure<&T::flanks>("flank_loss", newton_metre, "part that sliding flanks take", {"flanks", significant<3>}),
        figure<&T::bearing_load>("bearing_load_loss", newton_metre, "that of the bearing under load, M1",
                                 {"bearing M1", significant<3>}),
        figure<&T::bearing_speed>("bearing_speed_loss", newton_metre, "that of the bearing's lubricant, M0",
                                  {"bearing M0", significant<3>}),
        figure<&T::seal>("seal_loss", newton_metre, "of the seals", {"seals", significant<3>}),
        figure<&T::churning>("churning_loss", newton_metre, "of the lubricant around the wave generator",
                             {"churning", significant<3>})};
    return Rows<T>(rows);
}

Rows<RunLosses> run_loss_figures()
{
    using T = RunLosses;
    static constexpr std::array rows = {
        pair<&T::starting_torque, &T::starting_torque_error>(
            "starting_torque", newton_metre, "turns the wave generator from rest, without torque on the output",
            {"starting torque", significant<4>, two_digits}),
        pair<&T::ball_load, &T::ball_load_error>("ball_load", newton,
                                                 "sum of the forces of the balls at the largest torque",
                                                 {"sum of ball forces", significant<4>, two_digits}),
        figure<&T::bearing_diameter>("bearing_diameter", mm, "mean diameter of the wave generator's bearing",
                                     {"mean bearing diameter", decimals<3>}),
        pair<&T::largest_sliding, &T::largest_sliding_error>("largest_sliding", mm_per_rad,
                                                             "of loaded flanks for each rad of the wave generator",
                                                             {"largest sliding", significant<3>, two_digits})};
    return Rows<T>(rows);
}

Rows<BackDriving> back_driving_figures()
{
    using T = BackDriving;
    static constexpr std::array rows = {pair<&T::torque, &T::error>(
        "back_driving_torque", newton_metre, "on the output, at which the wave generator begins to turn",
        {"back-driving torque", significant<3>, two_digits})};
    return Rows<T>(rows);
}

std::string span_words(RunSpan span)
{
    return span == RunSpan::tooth_pitch  ? "one tooth pitch"
           : span == RunSpan::input_turn ? "a turn of the wave generator, at whole pitches"
                                         : "until both rings meet as before, at whole pitches";
}

RunOrder const* largest_order(RunSequence const& sequence)
{
    auto const found = std::ranges::max_element(sequence.orders, {}, &RunOrder::amplitude);
    return found == sequence.orders.end() ? nullptr : &*found;
}

}  // namespace hdconj::figures
