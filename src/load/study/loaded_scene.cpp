// SPDX-License-Identifier: GPL-3.0-or-later
#include "loaded_scene.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/option_faults.hpp"
#include "base/text.hpp"
#include "drive/drive.hpp"
#include "drive/elastic_cup.hpp"
#include "hdconj/check.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "load/model/wave_generator.hpp"
#include "scene/usual_cup.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj {
namespace {

void require_cup_and_bearing(Scene const& scene, Faults& faults)
{
    if (!scene.flexspline.cup)
        faults.push_back({"flexspline.cup", 0, "", "this table is missing: a load needs the cup's dimensions",
                          scene::UsualCup(scene).advice_on_cup()});
    if (!scene.bearing)
        faults.push_back({"bearing", 0, "", "this table is missing: a load needs what pushes the cup outward",
                          scene::UsualCup(scene).advice_on_bearing()});
}

void refuse_torque(double torque_nm, std::string reason, Faults& faults)
{
    faults.push_back(
        {"--torque", 0, fmt::format("{:g}", torque_nm), std::move(reason), "write a torque in N m such as 28"});
}

void require_torque(Scene const& scene, LoadOptions const& options, Faults& faults)
{
    std::string const usual = scene::usual_torque(scene.drive);
    if (!options.torque && !(scene.load && scene.load->torque))
        faults.push_back({"load.torque", scene.load ? scene.load->line : 0, "",
                          "this key is missing: nothing says which torque is meant",
                          "write torque = " + usual + ", in N m, in [load], or --torque " + usual});
    if (!options.torque)
        return;
    double const given = *options.torque / newton_metre;
    if (!std::isfinite(given))
        refuse_torque(given, "not a finite number", faults);
    else if (std::abs(given) > scene::bounds::largest_torque)
        refuse_torque(given, fmt::format("larger than any drive has, {:g} N m", scene::bounds::largest_torque), faults);
}

/// Where the scene gives @p key; the file is empty for the scene's own.
std::pair<int, std::string> place_of(Scene const& scene, std::string const& key)
{
    auto const given = scene.given.find(key);
    int const line = given == scene.given.end() ? 0 : given->second.line;
    return {line, line > 0 ? "" : "--set"};
}

/// Rigid balls hold the outer ring at as many points: no more than its harmonics have coefficients.
void validate_balls(Scene const& scene, load::RingGrid const& around, Faults& faults)
{
    int const balls = *scene.bearing->balls, sectors = around.sectors;
    int const most = 2 * around.highest_harmonic(scene.load.value_or(LoadRequest()).harmonics) + sectors;
    if (balls <= most)
        return;
    int const enough = balls / sectors / 2 * sectors;
    auto const [line, file] = place_of(scene, "bearing.balls");
    faults.push_back(
        {"bearing.balls", line, fmt::format("{}", balls),
         fmt::format("more rigid balls than the harmonics of the outer ring tell apart, {}", most),
         (enough <= around.highest_harmonic() ? fmt::format("write load.harmonics = {}, or ", enough) : "") +
             "leave the number out for a continuous row of balls",
         file});
}

/// The angles of the teeth against the harmonics asked for, and against rigid balls.
void validate_ring(Scene const& scene, Faults& faults)
{
    bool const harmonics = scene.load && scene.given.contains("load.harmonics");
    bool const rigid_balls = scene.bearing && scene.bearing->balls && !scene.bearing->radial_stiffness;
    if (!harmonics && !rigid_balls)
        return;
    load::RingGrid const around = load::ring_grid(scene);
    int const highest = around.highest_harmonic();
    if (harmonics && scene.load->harmonics > highest) {
        auto const [line, file] = place_of(scene, "load.harmonics");
        faults.push_back({"load.harmonics", line, fmt::format("{}", scene.load->harmonics),
                          "more than the angles of the teeth tell apart", fmt::format("write at most {}", highest),
                          file});
    }
    if (rigid_balls)
        validate_balls(scene, around, faults);
}

/// Stiffnesses between torques need these in order; where both are given: scene/axial_faults.cpp.
void validate_catalogue(Scene const& scene, LoadOptions const& options, Faults& faults)
{
    if (!scene.load || !(scene.load->first_torque || scene.load->second_torque) || !options.curve)
        return;
    double const rated = load::rated_torque(scene, options);
    auto const [first, second, lost_motion] = load::catalogue_torques(scene, rated);
    auto const fault = [&](char const* key, double value, char const* reason, char const* side, double limit) {
        auto const [line, file] = place_of(scene, key);
        faults.push_back({key, line, fmt::format("{:g}", value / newton_metre),
                          fmt::format("{}, {:g} N m", reason, limit / newton_metre),
                          fmt::format("write one {} {:g} N m", side, limit / newton_metre), file});
    };
    if (scene.load->first_torque && !(first < second))
        fault("load.first_torque", first, "T1 is not below the usual T2", "below", second);
    else if (!(first < second))
        fault("load.second_torque", second, "T2 is not above the usual T1", "above", first);
    if (!(second < std::abs(rated)))
        fault("load.second_torque", second, "T2 is not below the rated torque", "below", std::abs(rated));
}

/// Scene and options against each other, but for the cup.
Faults request_faults(Scene const& scene, LoadOptions const& options)
{
    Faults faults = check_contact(scene, load::contact_options(options));
    require_cup_and_bearing(scene, faults);
    std::size_t const before = faults.size();
    require_torque(scene, options, faults);
    if (faults.size() == before)
        validate_catalogue(scene, options, faults);
    validate_ring(scene, faults);
    require_whole(faults, "--points", options.points, 1, scene::bounds::most_torques,
                  "one such as 10, or leave it out for as many as the stiffness needs");
    return faults;
}

/// Under load the cup bends, whatever its outlines follow.
/// @param scene  as loaded_scene() completes one in which check_scene() finds no fault
void validate_bent_cup(Scene const& scene, Faults& faults)
{
    if (scene.flexspline.cup && scene.bearing && scene.coning->bottom_to_middle)
        drive::validate_cup(scene, drive::pair_geometry(scene).flexspline_inner_radius, faults);
}

}  // namespace

namespace load {

Faults check_either_sense(Scene const& scene, LoadOptions const& options)
{
    Faults faults = request_faults(scene, options);
    if (scene.flexspline.cup && scene.bearing && check_scene(scene).empty())
        validate_bent_cup(loaded_scene(scene, options), faults);
    return faults;
}

}  // namespace load

Faults check_load(Scene const& scene, LoadOptions const& options)
{
    Faults faults = load::check_either_sense(scene, options);
    if (options.torque && *options.torque < scene::bounds::least_torque * newton_metre)
        refuse_torque(*options.torque / newton_metre,
                      fmt::format("must be at least {:g} N m", scene::bounds::least_torque), faults);
    return faults;
}

Scene loaded_scene(Scene asked, LoadOptions const& options)
{
    constexpr int load_slices = 9;
    if (!asked.slices)
        asked.slices =
            Slices{load_slices, options.surfaces.empty() ? ToothSurface::tilted : options.surfaces.front(), 0};
    bool const tilts = std::any_of(options.tilts.begin(), options.tilts.end(), [](double tilt) { return tilt != 0; });
    if (tilts && !asked.tilt)
        asked.tilt = Tilt{options.tilts.front(), options.kinds.empty() ? TiltKind::radial : options.kinds.front(), 0};
    if (!asked.coning && asked.flexspline.cup) {
        // The middle of the teeth is that of the bearing.
        Cup const& cup = *asked.flexspline.cup;
        asked.coning =
            Coning{ConingModel::elastic, cup.length - cup.front_land - cup.tooth_width / 2, 0, AxialShift::mapped, 0};
    }
    return asked;
}

namespace load {

ContactOptions contact_options(LoadOptions const& options)
{
    return {.tilts = options.tilts, .surfaces = options.surfaces, .kinds = options.kinds};
}

Scene checked_scene(Scene const& asked, LoadOptions const& options)
{
    Scene completed = loaded_scene(asked, options);
    Faults own = check_scene(asked), faults = request_faults(asked, options);
    if (own.empty())
        validate_bent_cup(completed, faults);
    std::ranges::move(own, std::back_inserter(faults));
    throw_if_any(faults);
    return completed;
}

std::optional<std::string> note_on_bent_cup(Scene const& asked, Scene const& loaded)
{
    if (asked.coning || !loaded.coning)
        return std::nullopt;
    return fmt::format(
        "the conjugate teeth here are made for the bent cup; the scene has no [coning], so that solve, contact and "
        "wedm make other teeth of it: for the same teeth in all verbs write coning.model = \"{}\" and "
        "coning.bottom_to_middle = {} into the scene",
        to_string(loaded.coning->model), short_number(*loaded.coning->bottom_to_middle));
}

double rated_torque(Scene const& scene, LoadOptions const& options)
{
    return options.torque ? *options.torque : *scene.load->torque;
}

CatalogueTorques catalogue_torques(Scene const& scene, double rated)
{
    // As in the tables of makers: 7 and 25 N m of a drive of 40 N m; lost motion at 4 %.
    constexpr double first = 0.175, second = 0.625, lost_motion = 0.04;
    auto const given = [&](std::optional<double> LoadRequest::*key, double fraction) {
        return scene.load && (*scene.load).*key ? *((*scene.load).*key) : fraction * std::abs(rated);
    };
    return {given(&LoadRequest::first_torque, first), given(&LoadRequest::second_torque, second),
            lost_motion * std::abs(rated)};
}

LoadingPath loading_path(Scene const& scene, LoadOptions const& options)
{
    double const torque = rated_torque(scene, options);
    if (torque == 0 || !options.curve)
        return {{{torque}, false, options.stop}, options.curve};
    int const points = options.points.value_or(scene.load ? scene.load->points : 0);
    LoadingPath path{{{0, torque}, points == 0, options.stop}};
    std::vector<double>& given = path.forth.given;
    auto const add = [&](double each) {
        if (std::ranges::none_of(given, [each](double other) { return is_same_torque(each, other); }))
            given.push_back(each);
    };
    auto const [first, second, lost_motion] = catalogue_torques(scene, torque);
    for (double const named : {first, second, lost_motion})
        if (named < std::abs(torque))
            add(std::copysign(named, torque));
    for (int i = 1; i < points; ++i)
        add(torque * i / points);
    std::ranges::sort(given, {}, [](double each) { return std::abs(each); });
    return path;
}

LoadedDriveData contact_data(Scene const& scene, bool errors, StageObserver const& on_stage)
{
    constexpr double step = 0.04;  // of the module
    constexpr int most_steps = 10;
    bool const given = scene.circular_spline.inner_radius.has_value() || scene.is_reverse();
    Scene widened = scene;
    for (int i = 0;; ++i) {
        try {
            if (i > 0)
                widened.circular_spline.inner_radius =
                    drive::pair_geometry(widened).circular_spline_inner_radius + step * scene.drive.module;
            return {std::make_unique<contact::ContactStudyData>(widened, Verb::load, on_stage, std::nullopt, errors),
                    i * step * scene.drive.module};
        } catch (NumericalError const& error) {
            if (given || i == most_steps || error.code() != ErrorCode::no_land || error.stage() != "region")
                throw;
        }
    }
}

}  // namespace load
}  // namespace hdconj
