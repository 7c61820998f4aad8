// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "hdconj/contact/take_up.hpp"
#include "hdconj/load/flank_contacts.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/pipeline/load.hpp"
#include "hdconj/profile/builder.hpp"
#include "load_coarse.hpp"
#include "load_settle.hpp"
#include "load_tables.hpp"

namespace hdconj::detail {
namespace {

/// Turns at which the teeth touch on either side without torque: of the assembled shape.
struct Play
{
    double right = 0;  ///< [rad] turn to first touch of the right flanks
    double left = 0;   ///< and of the left ones, counter-clockwise
};

/// Turn from @p from on in the direction @p sense at which the first flank of either side touches: a tip may touch on the far side of its space. Newton's method on the least
/// of all gaps, no step longer than what was looked at.
double first_touch(LoadWork const& work, GapField const& field, double from, double sense)
{
    double const limit = work.reach();
    double const settled = work.settled();
    double turn = from;
    constexpr int budget = 60;
    for (int i = 0; i < budget; ++i)
    {
        double step = limit / field.reach();
        for (FlankContact const& c : flank_contacts(field, work.search(turn, limit), work.bench.threads))
            if (sense * c.lever > 0)
                step = std::min(step, c.gap / (sense * c.lever));
        turn += sense * step;
        if (std::abs(step) * field.reach() <= settled)
            break;
    }
    return turn;
}

/// Gaps without a turn of one sector of the ring: the others have the same.
GapMap sector_at_rest(LoadWork const& work, GapField const& field)
{
    GapMap map{field.grid().z, field.grid().station, {}, {}};
    for (std::size_t s = 0; s < work.spaces(); ++s)
        map.angle.push_back(field.space_angle(s));
    std::size_t const slices = map.z.size();
    map.gap.resize(work.spaces() * 2 * slices * map.station.size());
    constexpr std::size_t grain = 4;
    parallel_for(work.spaces(), work.bench.threads, grain, [&](std::size_t s) {
        std::vector<double> gap;
        for (int const flank : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)})
            for (std::size_t k = 0; k < slices; ++k)
            {
                field.along(s, flank, k, 0, gap);
                std::copy(gap.begin(), gap.end(), map.gap.begin() + static_cast<std::ptrdiff_t>(map.index(s, flank, k, 0)));
            }
    });
    return map;
}

constexpr double model_accuracy = 1e-3;  // of the module: gaps that may be rounding of the finite-element model

/// What to write depends on what the scene says already.
NumericalError no_assembly(Scene const& scene, SurfaceChoice const& choice, double side_clearance)
{
    bool const in_planes = scene.coning && scene.coning->axial_shift != "mapped";
    std::string const advice = in_planes ? "axial_shift = \"mapped\" in [coning], since the cup's sections do not stay in their planes" : choice.surface != "per-slice" ? "surface = \"per-slice\" in [slices]" : "a larger circular_spline.backlash_offset";
    return NumericalError("load", "assembly", "the teeth of the bent cup stand in the way of those of the circular spline at every turn, with a side clearance of " + short_number(side_clearance)
                                                  + " mm; write " + advice + ", or a larger circular_spline.inner_radius");
}

/// Nothing where the teeth stand in each other's way at every turn; a negative sum where they do at every turn but not by much.
std::optional<Play> play_of(LoadWork const& work, LoadedShape const& shape)
{
    GapField const field = work.field(shape, work.edges);
    GapMap const rest = sector_at_rest(work, field);
    double const pitch = 2 * std::numbers::pi / work.scene().drive.circular_spline_teeth;
    // the teeth of the solved cup are some nanometres from where its outlines were made for them: mesh and interpolation, not teeth in each other's way
    double const touches = model_accuracy * work.scene().drive.module;
    try
    {
        double const right = take_up(field, rest, GapMap::right, pitch, work.bench.threads, touches).turn;
        double const left = take_up(field, rest, GapMap::left, pitch, work.bench.threads, touches).turn;
        if (right + left < 0)
            return Play{right, left};
        double const middle = 0.5 * (right - left);
        return Play{first_touch(work, field, middle, 1), -first_touch(work, field, middle, -1)};
    }
    catch (NumericalError const&)
    {
        return std::nullopt;  // no turn within a pitch at which one side just touches
    }
}

/// The assembled cup among teeth that it does not touch.
Loaded untouched(ContactBench const& bench, ElasticDrive const& drive, Assembly const& start)
{
    Loaded free;
    free.state = start.state;
    free.forces = start.forces;
    free.shape = loaded_shape(bench, drive, free.forces);
    return free;
}

/// The play about a turn that is known to lie within it, to a coarse grid's difference.
Play play_about(LoadWork const& work, LoadedShape const& shape, double middle)
{
    GapField const field = work.field(shape, work.edges);
    return {first_touch(work, field, middle, 1), -first_touch(work, field, middle, -1)};
}

/// A drive that is taken from torque to torque, from the assembled cup on.
class Walk
{
  public:
    /// @param play  of the assembled cup; a negative one: it presses
    Walk(LoadWork const& work, Loaded free, Play const& play)
        : work_(work), free_(std::move(free)), now_(free_), play_(play), middle_(0.5 * (play.right - play.left)), pressed_(play.right + play.left < 0)
    {
        if (!pressed_)
            return;
        now_.state.turn = middle_;
        now_ = settled_at(work_, 0, now_);
        middle_ = now_.state.turn;
    }

    /// The drive at @p torque [N mm], from where it is, and from first touch where it was not loaded to that side.
    /// @throws NumericalError as settled_at() does; the drive stays where it was
    void go_to(double torque)
    {
        if (torque == 0 && !pressed_)
        {
            now_ = free_;
            now_.state.turn = middle_;
        }
        else if (!pressed_ && last_ * torque <= 0)
        {
            Loaded touching = free_;
            touching.state.turn = torque > 0 ? play_.right : -play_.left;
            now_ = settled_at(work_, torque, touching);
        }
        else
            now_ = settled_at(work_, torque, now_);
        last_ = torque;
    }

    [[nodiscard]] Loaded const& now() const { return now_; }
    [[nodiscard]] LoadedState summary() const { return summary_of(work_, now_, last_, middle_); }
    [[nodiscard]] double middle() const { return middle_; }  ///< of the play, from which twist counts [rad]

  private:
    LoadWork const& work_;
    Loaded free_, now_;
    Play play_;
    double middle_;
    bool pressed_;
    double last_ = 0;
};

/// Errors of the play and of every torque, from the same walk on the coarse grid.
/// @param bearing  of every state of the curve
/// @param fine_middle  of the play on the fine grid [rad]
void estimate(ContactBench const& bench, CoarseDrive const& coarse, FlankGrid const& fine, double fine_middle, std::vector<BearingMap> const& bearing, LoadCase& result, CaseReport& report)
{
    constexpr int patience = 3;  // torques without a balance, after which no more are tried
    FlankGrid const grid = thinned(fine, coarse.grid.slices);
    LoadWork const work{bench, coarse.model.drive, grid};
    double const safety = grid_safety(fine.slices());
    result.curve_error.assign(result.curve.size(), std::nullopt);
    std::optional<Walk> walk;
    try
    {
        Loaded free = untouched(bench, coarse.model.drive, coarse.start);
        std::optional<Play> const play = result.backlash < 0 ? play_of(work, free.shape) : play_about(work, free.shape, fine_middle);
        if (!play)
            return;
        walk.emplace(work, std::move(free), *play);
        result.backlash_error = safety * std::abs(result.backlash - (play->right + play->left));
    }
    catch (NumericalError const&)
    {
        return;  // no balance on the coarse grid: nothing to compare with
    }
    int failed = 0;
    for (std::size_t i = 0; i < result.curve.size() && failed < patience; ++i)
    {
        LoadedState const& state = result.curve[i];
        try
        {
            walk->go_to(state.torque);
        }
        catch (NumericalError const&)
        {
            ++failed;
            continue;
        }
        result.curve_error[i] = error_between(state, walk->summary(), safety);
        result.curve_error[i]->twist += state.residual / bench.geometry.r_m;
        double& ball = result.curve_error[i]->ball_force;
        ball = std::max(ball, safety * ball_distance(bearing[i], bearing_map(coarse.model.drive, walk->now().state), coarse.model.drive.response.sectors()));
        if (i == result.rated)
            report.coarse = walk->now().forces;
    }
    // at one torque of a curve two grids may agree by chance: none is known much better than the others
    std::vector<double> relative;
    for (std::size_t i = 0; i < result.curve.size(); ++i)
        if (result.curve_error[i] && result.curve[i].twist != 0)
            relative.push_back(result.curve_error[i]->twist / std::abs(result.curve[i].twist));
    std::sort(relative.begin(), relative.end());
    for (std::size_t i = 0; i < result.curve.size() && !relative.empty(); ++i)
        if (auto& error = result.curve_error[i])
            error->twist = std::max(error->twist, relative[relative.size() / 2] * std::abs(result.curve[i].twist));
    if (auto const& rated = result.curve_error[result.rated])
    {
        result.error = *rated;
        result.estimated = true;
    }
}

}  // namespace

Assembly assembly(ContactBench const& bench, ElasticDrive const& drive)
{
    Assembly result;
    result.state = equilibrium(drive, {}, std::nullopt, nullptr, bench.threads);
    result.forces = forces_on_cup(drive, {}, result.state);
    return result;
}

LoadCase load_case(ContactBench const& bench, ElasticDrive const& drive, Assembly const& start, CoarseDrive const* coarse, SurfaceChoice const& choice, std::vector<double> const& torques,
                   CaseReport& report)
{
    auto const begin = std::chrono::steady_clock::now();
    LoadCase result;
    result.surface = choice.surface;
    result.kind = choice.tilt != 0 || bench.scene.tilt ? choice.kind : "";
    result.tilt = choice.tilt;

    Loaded const free = untouched(bench, drive, start);
    FlankSurface surface = flank_surface(bench, choice);
    std::optional<Play> play = play_of({bench, drive, surface.grid}, free.shape);
    bool const clear = play && play->right + play->left >= 0;
    if (!clear && !bench.scene.circular_spline.automatic_backlash)
    {
        double const given = surface.offset;
        surface = flank_surface(bench, choice, true);
        result.raised = surface.offset > given;
        play = play_of({bench, drive, surface.grid}, free.shape);
    }
    LoadWork const work{bench, drive, surface.grid};
    result.backlash_offset = surface.offset;
    result.tip = surface.tip;
    if (!bench.scene.circular_spline.automatic_backlash)
        result.tip_change = surface.tip - bench.maker.own_tip(choice);
    if (!play)
        throw no_assembly(bench.scene, choice, surface.offset);
    result.backlash = play->right + play->left;
    if (report.on_play)
        report.on_play(result);
    Walk walk(work, free, *play);
    double largest = -1;
    std::vector<BearingMap> bearing;
    for (double const torque : torques)
    {
        walk.go_to(torque);
        result.curve.push_back(walk.summary());
        bearing.push_back(bearing_map(drive, walk.now().state));
        if (std::abs(torque) > largest)
        {
            largest = std::abs(torque);
            result.rated = result.curve.size() - 1;
            result.map = map_of(work, walk.now(), torque);
            result.bearing = bearing.back();
            report.rated = walk.now().forces;
        }
        if (report.on_state)
            report.on_state();
    }
    LoadedState const& rated = result.curve[result.rated];
    std::vector<double> const& z = result.map.z;
    result.pressure_at_edge = z.size() > 1 && rated.largest_pressure > 0 && (rated.pressure_z <= z.front() || rated.pressure_z >= z.back());
    if (coarse != nullptr)
        estimate(bench, *coarse, surface.grid, walk.middle(), bearing, result, report);
    std::vector<double> twist, torque;
    for (std::size_t i = 0; i <= result.rated && i < result.curve.size(); ++i)
        if (result.curve[i].torque > 0)
        {
            twist.push_back(result.curve[i].twist);
            torque.push_back(result.curve[i].torque);
        }
    if (twist.size() > 1)
        result.stages = stiffness_stages(twist, torque);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace hdconj::detail
