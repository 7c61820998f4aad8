// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/load.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "hdconj/load/drive_series.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/profile/builder.hpp"
#include "cup_shape.hpp"
#include "drive.hpp"
#include "elastic_cup.hpp"
#include "load_case.hpp"
#include "load_coarse.hpp"
#include "load_model.hpp"
#include "load_settle.hpp"
#include "load_tables.hpp"
#include "loaded_shape.hpp"
#include "outline_records.hpp"
#include "owned_bench.hpp"
#include "surface_choices.hpp"

namespace hdconj {
namespace {

using detail::ContactBench;
using detail::SurfaceChoice;

double degrees(double angle)
{
    return angle * 180 / std::numbers::pi;
}

constexpr int load_slices = 9;
constexpr int standard_points = 10;
constexpr int stress_angles = 90;   // of a sector, at which the largest stress is looked for
constexpr int shape_angles = 180;   // of the whole cup, as it is drawn

ContactOptions contact_options(LoadOptions const& options)
{
    ContactOptions result;
    result.tilts = options.tilts;
    result.surfaces = options.surfaces;
    result.kinds = options.kinds;
    return result;
}

/// Even angles of one sector.
std::vector<double> angles_of(int count, int sectors)
{
    std::vector<double> phi;
    for (int i = 0; i < count; ++i)
        phi.push_back(2 * std::numbers::pi * i / (sectors * count));
    return phi;
}

/// Slope of the line through (x, y) by least squares.
double slope_of(std::vector<double> const& x, std::vector<double> const& y)
{
    double const n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    return xx > 0 ? xy / xx : 0;
}

AssembledCup assembled(ContactBench const& bench, detail::LoadModel const& model, detail::Assembly const& start)
{
    AssembledCup cup;
    cup.z = model.drive.slice_z;
    auto const series = displacements(model.drive, start.forces);
    double const minor = std::numbers::pi / bench.scene.wave_generator.waves;
    for (std::size_t k = 0; k < cup.z.size(); ++k)
    {
        cup.w_major.push_back(series_at(model.drive, series[model.drive.stations.radial(k)], 0).value);
        cup.w_minor.push_back(series_at(model.drive, series[model.drive.stations.radial(k)], minor).value);
    }
    cup.coning_major = slope_of(cup.z, cup.w_major);
    cup.coning_minor = slope_of(cup.z, cup.w_minor);
    cup.wave_generator_force = start.state.bearing.sum() * model.drive.response.sectors();
    cup.contacts = static_cast<int>((start.state.bearing.array() > 0).count()) * model.drive.response.sectors();
    detail::BallPeak const ball = detail::ball_peak(model.drive, start.state);
    cup.ball_force = ball.force;
    cup.ball_phi = ball.phi;
    cup.balls = ball.carrying;
    HarmonicField const field = detail::cup_field(model, start.forces, bench.threads);
    StressPeak const peak = stress_peak(model.solid.mesh(), field, angles_of(stress_angles, model.drive.response.sectors()), bench.threads);
    cup.largest_stress = peak.stress;
    cup.largest_stress_error = detail::stress_at_corners(model, field, peak);
    return cup;
}

/// Errors of @p cup, from what the coarse grid says.
/// @param balls  ball_distance() of both
void estimate(AssembledCup& cup, AssembledCup const& coarse, double balls)
{
    double const safety = detail::grid_safety(cup.z.size());
    cup.coning_major_error = safety * std::abs(cup.coning_major - coarse.coning_major);
    cup.coning_minor_error = safety * std::abs(cup.coning_minor - coarse.coning_minor);
    cup.wave_generator_force_error = safety * std::abs(cup.wave_generator_force - coarse.wave_generator_force);
    cup.ball_force_error = safety * std::max(balls, std::abs(cup.ball_force - coarse.ball_force));
    cup.largest_stress_error += safety * std::abs(cup.largest_stress - coarse.largest_stress);
    cup.estimated = true;
}

/// Largest stress of the cup at the rated torque, and its error.
void add_stress(ContactBench const& bench, detail::LoadModel const& model, HarmonicField const& field, detail::CoarseDrive const* coarse, detail::CaseReport const& report, LoadCase& result)
{
    std::vector<double> const phi = angles_of(stress_angles, model.drive.response.sectors());
    LoadedState& state = result.curve[result.rated];
    StressPeak const peak = stress_peak(model.solid.mesh(), field, phi, bench.threads);
    state.largest_stress = peak.stress;
    state.stress_r = peak.at.x();
    state.stress_z = peak.at.y() - model.middle;
    state.stress_phi = peak.phi;
    if (!result.estimated)
        return;
    HarmonicField const other = detail::cup_field(coarse->model, report.coarse, bench.threads);
    result.error.largest_stress = detail::grid_safety(model.drive.slice_z.size()) * std::abs(peak.stress - stress_peak(coarse->model.solid.mesh(), other, phi, bench.threads).stress) + detail::stress_at_corners(model, field, peak);
    result.curve_error[result.rated]->largest_stress = result.error.largest_stress;
}

/// The tip circle that a scene leaves to the program [mm].
double standard_tip(Scene const& scene)
{
    Faults faults;
    Profile const tooth = detail::given_tooth(scene, faults);
    return detail::pair_geometry(scene, tooth, detail::wave_shape(scene, tooth, faults).amplitude()).circular_spline_inner_radius;
}

/// The bench of a scene. Where the scene gives no tip circle and the standard one, made for a ring that does not cone, leaves no land, it is widened in small steps.
/// @return by how much [mm]
double make_bench(std::optional<detail::OwnedBench>& owned, Scene asked, StageObserver const& on_stage)
{
    constexpr double step = 0.04;  // of the module
    constexpr int most = 10;
    bool const given = asked.circular_spline.inner_radius.has_value() || asked.is_reverse();
    for (int widened = 0;; ++widened)
    {
        try
        {
            if (widened > 0)
                asked.circular_spline.inner_radius = standard_tip(asked) + step * asked.drive.module;
            owned.emplace(asked, asked.slices->count, make_plan(asked, Verb::load), on_stage);
            return widened * step * asked.drive.module;
        }
        catch (NumericalError const& error)
        {
            if (given || widened == most || !std::string(error.what()).starts_with("region: tip circle: "))
                throw;
        }
    }
}

/// Up to the torque, down again, and to the opposite one.
std::vector<double> path(double torque, int points, bool curve)
{
    if (!curve)
        return {torque};
    std::vector<double> result;
    for (int i = 0; i <= points; ++i)
        result.push_back(torque * i / points);
    for (int i = points - 1; i >= -points; --i)
        result.push_back(torque * i / points);
    return result;
}

}  // namespace

Faults check_load(Scene const& scene, LoadOptions const& options)
{
    Faults faults = check_contact(scene, contact_options(options));
    if (!scene.flexspline.cup)
        faults.push_back({"flexspline.cup", 0, "", "this table is missing: a load needs the cup's dimensions",
                          "write the line [flexspline.cup] and below it length = 15.0, barrel_wall = 0.4, bottom = 0.5, corner_radius = 2.0, flange_radius = 13.0, "
                          "tooth_width = 8.0, front_land = 2.0"});
    if (!scene.bearing)
        faults.push_back({"bearing", 0, "", "this table is missing: a load needs what pushes the cup outward",
                          "write the line [bearing] and below it type = \"elastic\", width = 6.0, ring_thickness = 1.2"});
    if (!options.torque && !(scene.load && scene.load->torque))
        faults.push_back({"load.torque", scene.load ? scene.load->line : 0, "", "this key is missing: nothing says which torque is meant",
                          "write torque = 28.0, in N m, in [load], or --torque 28"});
    if (options.torque && !std::isfinite(*options.torque))
        faults.push_back({"--torque", 0, short_number(*options.torque), "not a finite number", "write a torque in N m such as 28"});
    if (scene.load && scene.given.contains("load.harmonics") && scene.load->harmonics > detail::highest_harmonic(scene))
        faults.push_back({"load.harmonics", scene.load->line, std::to_string(scene.load->harmonics), "more than the angles of the teeth tell apart",
                          "write at most " + std::to_string(detail::highest_harmonic(scene))});
    if (options.points && *options.points < 1)
        faults.push_back({"--points", 0, std::to_string(*options.points), "a curve has at least one torque", "write a whole number such as 10"});
    return faults;
}

Scene loaded_scene(Scene asked, LoadOptions const& options)
{
    if (!asked.slices)
        asked.slices = Slices{load_slices, options.surfaces.empty() ? "tilted" : options.surfaces.front(), 0};
    bool const tilts = std::any_of(options.tilts.begin(), options.tilts.end(), [](double tilt) { return tilt != 0; });
    if (tilts && !asked.tilt)
        asked.tilt = Tilt{options.tilts.front(), options.kinds.empty() ? "radial" : options.kinds.front(), 0};
    if (!asked.coning && asked.flexspline.cup)
    {
        // the middle of the teeth is that of the bearing
        Cup const& cup = *asked.flexspline.cup;
        asked.coning = Coning{"elastic", cup.length - cup.front_land - cup.tooth_width / 2, 0, "mapped", 0};
    }
    return asked;
}

namespace {

/// Faults of a scene as it is loaded: the cup bends under load, whatever its outlines follow.
Faults faults_of_loaded(Scene const& asked)
{
    Faults faults = check_scene(asked);
    if (faults.empty() && !asked.is_elastic() && asked.coning->bottom_to_middle)
        detail::judge_cup(asked, detail::ring_geometry(asked, detail::given_tooth(asked, faults)).flexspline_inner_radius, faults);
    return faults;
}

}  // namespace

LoadStudy load(Scene const& scene, LoadOptions const& options, StageObserver const& on_stage, Progress const& progress, std::function<void(std::string const&)> const& talk)
{
    Faults faults = check_load(scene, options);
    Scene const asked = loaded_scene(scene, options);
    for (Fault const& more : faults.empty() ? faults_of_loaded(asked) : check_scene(scene))
        faults.push_back(more);
    if (!faults.empty())
        throw InputError(faults);
    std::optional<detail::OwnedBench> made;
    LoadStudy study;
    study.tip_widened = make_bench(made, asked, on_stage);
    detail::OwnedBench& owned = *made;
    ContactBench const& bench = *owned.bench;
    std::optional<detail::LoadModel> model;
    owned.clock.run(Stage::influence, [&] { model = detail::load_model(bench, detail::load_grid(bench)); });
    ElasticDrive const& drive = model->drive;
    detail::Assembly start;
    std::optional<detail::CoarseDrive> coarse;
    owned.clock.run(Stage::assembly, [&] {
        start = detail::assembly(bench, drive);
        study.cup = assembled(bench, *model, start);
    });
    if (talk)
        talk(fmt::format("assembled: wave generator {:.0f} N, coning {:.3f} and {:.3f} deg at the major and minor axis, cup {:.0f} MPa", study.cup.wave_generator_force,
                         degrees(std::atan(study.cup.coning_major)), degrees(std::atan(study.cup.coning_minor)), study.cup.largest_stress));
    LoadRequest const request = scene.load.value_or(LoadRequest{{}, standard_points, 0, {}, 0});
    study.rated_torque = options.torque ? *options.torque : *request.torque;
    std::vector<double> const torques = path(study.rated_torque, options.points.value_or(request.points), options.curve);
    std::vector<SurfaceChoice> const wanted = detail::surface_choices(asked, contact_options(options));
    double const total = static_cast<double>(wanted.size() * torques.size());
    double done = 0;
    std::optional<NumericalError> first;
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        std::size_t const made_before = study.cases.size();
        detail::CaseReport report;
        report.on_play = [&](LoadCase const& known) {
            if (talk)
                talk(fmt::format("{}{}: side clearance {:.1f} um, play {:.2f} arcmin", known.surface, known.tilt != 0 ? fmt::format(" {:.2f} deg", degrees(known.tilt)) : "",
                                 1e3 * known.backlash_offset, 60 * degrees(known.backlash)));
        };
        report.on_state = [&] {
            done += 1;
            if (progress)
                progress("load", done / total);
        };
        owned.clock.run(Stage::load, [&] {
            if (i == 0)
            {
                coarse = detail::coarse_drive(bench);
                if (coarse)
                    estimate(study.cup, assembled(bench, coarse->model, coarse->start),
                             detail::ball_distance(detail::bearing_map(drive, start.state), detail::bearing_map(coarse->model.drive, coarse->start.state), drive.response.sectors()));
            }
            try
            {
                study.cases.push_back(detail::load_case(bench, drive, start, coarse ? &*coarse : nullptr, wanted[i], torques, report));
            }
            catch (NumericalError const& error)
            {
                study.missing.push_back(detail::no_row(wanted[i], error.what()));
                if (!first)
                    first.emplace(error);
            }
        });
        done = static_cast<double>((i + 1) * torques.size());
        if (study.cases.size() == made_before)
            continue;
        std::size_t const last = study.cases.size() - 1;
        auto const pressure = [](LoadCase const& c) { return c.curve[c.rated].largest_pressure; };
        if (last == 0 || pressure(study.cases[last]) < pressure(study.cases[study.shown]))
            study.shown = last;
        // stresses are looked for at the largest torque of every case
        HarmonicField const field = detail::cup_field(*model, report.rated, bench.threads);
        add_stress(bench, *model, field, coarse ? &*coarse : nullptr, report, study.cases[last]);
        if (last == study.shown)
            study.shape = detail::cup_shape(*model, field, shape_angles, bench.threads);
    }
    if (study.cases.empty())
        throw NumericalError(*first);
    study.solution = owned.middle;
    study.solution.scene = scene;
    study.solution.plan = owned.plan;
    study.solution.notes.insert(study.solution.notes.end(), study.missing.begin(), study.missing.end());
    study.harmonics = drive.response.harmonics().back().n;
    study.sectors = drive.response.sectors();
    study.contact_gap = bench.request.gap;
    study.pitch_radius = scene.drive.module * scene.drive.flexspline_teeth / 2;
    study.edge_radius = detail::edge_radius(scene);
    study.balls = scene.bearing->balls.value_or(0);
    Cup const& cup = *scene.flexspline.cup;
    study.sharp_steps = scene.flexspline.wall != cup.barrel_wall && !(cup.rear_fillet && cup.front_fillet);
    std::vector<StageTime> const times = owned.clock.times();
    study.solution.timing.insert(study.solution.timing.end(), times.begin(), times.end());
    return study;
}

}  // namespace hdconj
