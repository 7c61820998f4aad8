// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of all verbs as scripts, see plot_script.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "figures/load_figures.hpp"
#include "figures/measured_figures.hpp"
#include "hdconj/accuracy_files.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/running.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wanted_curve.hpp"
#include "hdconj/wedm.hpp"

namespace hdconj::report {

/// The tooth space with the teeth that sweep it, the branches of the envelope and the outline; of the reverse problem
/// the flexspline tooth.
[[nodiscard]] std::string tooth_space_script(Solution const& solution);

/// Whether some surface was computed at two tilts or more.
[[nodiscard]] bool has_tilt_curve(ContactStudy const& study);
/// Contact area (left axis) and least side clearance (right axis) against tilt, a pair of curves for each surface and
/// kind, the best tilts marked.
[[nodiscard]] std::string tilt_script(ContactStudy const& study);
/// Smallest gap along the flank over tooth space and slice, both flanks. Needs a map.
[[nodiscard]] std::string map_script(ContactStudy const& study);
/// Gap over the flank that has most contact, along the flank and z. Needs a map.
[[nodiscard]] std::string flank_script(ContactStudy const& study);

/// Whether some case was computed at two torques or more.
[[nodiscard]] bool has_curve(LoadStudy const& study);
/// Torque against twist: every case with its play, its two lines, and what was measured. @param measured  null: nothing
[[nodiscard]] std::string load_curve_script(LoadStudy const& study, Measurement const* measured);
/// Stiffness against torque: every case with its error, and K1, K2, K3. Needs a curve.
[[nodiscard]] std::string load_stiffness_script(LoadStudy const& study);
/// Pressure over tooth space and slice of the case shown, and the force on each tooth. Needs its map.
[[nodiscard]] std::string load_pressure_script(LoadStudy const& study);
/// Whether some flank of the case shown carries force.
[[nodiscard]] bool has_loaded_flank(LoadStudy const& study);
/// The flank that carries most: where it is pressed, and how much over the face width. Needs has_loaded_flank().
[[nodiscard]] std::string load_flank_script(LoadStudy const& study);
/// Angles of a rig less those of its own straight lines, and less those of the case shown.
[[nodiscard]] std::string load_residual_script(LoadStudy const& study, Measurement const& measured);
/// Section of the cup, as it is and deformed, at the major and the minor axis. Needs a shape.
[[nodiscard]] std::string load_cup_script(LoadStudy const& study);
/// Section of the cup coloured by the largest stress over all angles, and the stress around the axis where it is
/// largest. Needs a shape with stress.
[[nodiscard]] std::string load_stress_script(LoadStudy const& study);
/// Whether there are single balls in the bearing of the case shown.
[[nodiscard]] bool has_balls(LoadStudy const& study);
/// Forces of the balls all round the ring at the largest torque of the case shown. Needs balls.
[[nodiscard]] std::string load_ball_script(LoadStudy const& study);

/// Transmission error over the wave generator: a curve for each sequence. Needs a sequence.
[[nodiscard]] std::string run_error_script(RunStudy const& study);
/// Orders of the transmission error: bars for each sequence. Needs a sequence.
[[nodiscard]] std::string run_spectrum_script(RunStudy const& study);
/// Efficiency over torque: a curve for each speed and temperature. Needs losses.
[[nodiscard]] std::string run_efficiency_script(RunStudy const& study);

/// One tooth space in both faces, the wire of every pass and its circles.
[[nodiscard]] std::string wire_tooth_script(WireProgram const& program);
/// The whole contour, the start hole and the leads.
[[nodiscard]] std::string wire_ring_script(WireProgram const& program);
/// Height of what the last pass leaves, around the part, of all set-ups. Needs residuals.
[[nodiscard]] std::string wire_residual_script(WireSetUps const& programs);

/// Displacement, curvature and error of a neutral curve that was wanted.
[[nodiscard]] std::string wanted_curve_script(WantedCurve const& found);
/// Deviations along the flanks, positions and radial shifts round the ring.
[[nodiscard]] std::string inspect_chart_script(Inspection const& inspection);

/// What the picture of a study shows: error against time, or time against threads.
[[nodiscard]] std::string picture_words(std::vector<ConvergenceSeries> const& series_list, std::string const& name);
/// That picture.
[[nodiscard]] std::string accuracy_script(StoredAccuracy const& study,
                                          std::vector<ConvergenceSeries> const& series_list, std::string const& name);
/// Whether a study has two points to draw.
[[nodiscard]] bool has_picture(std::vector<ConvergenceSeries> const& series_list, std::string const& name);

/// One picture of several: NAME.svg becomes NAME-what.svg.
[[nodiscard]] std::filesystem::path picture_part(std::filesystem::path const& file, std::string const& what);

/// What gnuplot draws by a script of @ref plot_script. @param file  that an error names
/// @throws InputError for an ending that is not known; FileError with gnuplot's own words
[[nodiscard]] std::string drawing(std::string const& script, std::filesystem::path const& file);

/// "type-50:  tilted, radial 0.2 deg,  28 N m": heads the pictures of one case under torque.
[[nodiscard]] std::string shown_load(LoadStudy const& study);

}  // namespace hdconj::report
