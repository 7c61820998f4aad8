// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_case.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "hdconj/contact/contact_area.hpp"
#include "hdconj/contact/gap_field.hpp"
#include "hdconj/contact/take_up.hpp"
#include "hdconj/load/flank_contacts.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/pipeline/load.hpp"
#include "loaded_shape.hpp"

namespace hdconj::detail {
namespace {

constexpr double search_share = 0.15;      // of the module: contacts with a smaller gap are in the problem
constexpr double settled_share = 4e-6;     // of the module: gap of the loaded shape against that of the linear model (1 nm on type-50)
constexpr int most_rounds = 60;
constexpr int free_rounds = 4;              // after which curvatures stay as they are
constexpr int moving_rounds = 10;           // after which contacts that carry force stay where they are
constexpr int held_rounds = 5;              // but for one round in so many
constexpr double held_share = 1e-3;        // of the module: what the gap beside such a contact may be smaller (0.25 um on type-50)
constexpr double start_load = 1;           // [N/mm] at which a contact without force is linearised
constexpr double flattest = 0.02;          // curvatures looked at, times the module: from this ...
constexpr double sharpest = 50;            // ... to this

/// One torque of a surface: what the rounds hand on.
struct Loaded
{
    Equilibrium state;
    std::vector<FlankContact> contacts;
    Eigen::MatrixXd forces;
    LoadedShape shape;
    double residual = 0;
    int rounds = 0;
    int steps = 0;
};

struct Worker
{
    ContactBench const& bench;
    ElasticDrive const& drive;
    FlankGrid const& grid;

    [[nodiscard]] Scene const& scene() const { return bench.scene; }
    [[nodiscard]] std::size_t spaces() const { return static_cast<std::size_t>(scene().drive.circular_spline_teeth / drive.response.sectors()); }

    [[nodiscard]] FlankSearch search(double turn, double limit) const
    {
        double const m = scene().drive.module;
        auto const whole = static_cast<std::size_t>(scene().drive.circular_spline_teeth);
        // the sector around the major axis, so that a picture of it shows the mesh in one piece
        std::size_t const first = (whole - spaces()) / 2;
        return {turn, limit, first, spaces(), drive.phase, scene().drive.flexspline_teeth, scene().drive.circular_spline_teeth, flattest / m, sharpest / m};
    }

    [[nodiscard]] double width_of(FlankContact const& c) const { return drive.slice_width[c.slice]; }

    /// Secant of Hertz and tooth at force @p f [mm/N].
    [[nodiscard]] double local_compliance(FlankContact const& c, double f) const
    {
        double const width = width_of(c);
        double const q = f > 0 ? f / width : start_load;
        return (approach(drive.line_contact(c), q) / q + drive.tooth_bending(c)) / width;
    }
};

/// The contact of another round that @p c was: of the same flank and slice the nearest along the flank; the end where there is none.
std::vector<FlankContact>::const_iterator same_contact(std::vector<FlankContact> const& contacts, FlankContact const& c)
{
    auto const key = [](FlankContact const& a) { return std::tuple(a.space, a.flank, a.slice); };
    auto const first = std::lower_bound(contacts.begin(), contacts.end(), c, [&](auto const& a, auto const& b) { return key(a) < key(b); });
    auto best = contacts.end();
    for (auto i = first; i != contacts.end() && key(*i) == key(c); ++i)
        if (best == contacts.end() || std::abs(i->station - c.station) < std::abs(best->station - c.station))
            best = i;
    return best;
}

/// Force that contact @p c had in another round.
double force_before(std::vector<FlankContact> const& contacts, std::vector<double> const& force, FlankContact const& c)
{
    auto const same = same_contact(contacts, c);
    return same == contacts.end() ? 0 : force[static_cast<std::size_t>(same - contacts.begin())];
}

/// Curvatures jump where a contact moves from one point of the flank to the next, and rounds could go on between two points for ever.
void keep_curvatures(std::vector<FlankContact> const& before, std::vector<FlankContact>& now)
{
    for (FlankContact& c : now)
        if (auto const same = same_contact(before, c); same != before.end())
            c.curvature = same->curvature;
}

/// Contacts that carry force stay where they are, and others are added where they lie apart from those.
std::vector<FlankContact> held(GapField const& field, FlankSearch const& search, Loaded const& before, std::vector<FlankContact> const& least, int threads)
{
    std::vector<FlankContact> carrying;
    for (std::size_t i = 0; i < before.contacts.size(); ++i)
        if (before.state.flank[i] > 0)
            carrying.push_back(before.contacts[i]);
    std::vector<FlankContact> result = at_same_places(field, search, carrying, threads);
    for (FlankContact const& c : least)
    {
        auto const same = same_contact(carrying, c);
        if (same == carrying.end() || std::abs(same->station - c.station) > contacts_apart)
            result.push_back(c);
    }
    auto const key = [](FlankContact const& c) { return std::tuple(c.space, c.flank, c.slice, c.station); };
    std::sort(result.begin(), result.end(), [&](auto const& a, auto const& b) { return key(a) < key(b); });
    return result;
}

/// Gaps of the loaded shape against those that the forces were solved for.
double mismatch(Worker const& work, std::vector<FlankContact> const& now, Loaded const& before)
{
    double worst = 0;
    for (FlankContact const& c : now)
    {
        double const f = force_before(before.contacts, before.state.flank, c);
        double const gap = c.gap + work.local_compliance(c, f) * f;
        worst = std::max(worst, f > 0 ? std::abs(gap) : -gap);
    }
    return worst;
}

/// Half of what was and half of what is, where rounds go to and fro.
void meet_half_way(Loaded const& before, std::vector<FlankContact> const& contacts, Equilibrium& now)
{
    for (std::size_t i = 0; i < contacts.size(); ++i)
        now.flank[i] = 0.5 * (now.flank[i] + force_before(before.contacts, before.state.flank, contacts[i]));
    now.bearing = 0.5 * (now.bearing + before.state.bearing);
    now.turn = 0.5 * (now.turn + before.state.turn);
}

/// Equilibrium at @p torque, from the shape of @p start on.
Loaded settle(Worker const& work, double torque, Loaded const& start)
{
    double const module = work.scene().drive.module;
    double const settled = settled_share * module;
    Loaded now = start;
    double limit = search_share * module;
    double last = std::numeric_limits<double>::infinity();
    int steps = 0;
    for (int round = 1; round <= most_rounds; ++round)
    {
        GapField const field(work.bench.tooth, work.grid, now.shape.places, work.scene().drive.flexspline_teeth, work.scene().drive.circular_spline_teeth, work.drive.phase);
        LinearGaps gaps;
        gaps.turn = now.state.turn;
        gaps.contacts = flank_contacts(field, work.search(gaps.turn, limit), work.bench.threads);
        if (round > free_rounds)
            keep_curvatures(now.contacts, gaps.contacts);
        double least = 0;
        if (round > 1)
        {
            last = least = mismatch(work, gaps.contacts, now);
            if (round > moving_rounds && (round - moving_rounds) % held_rounds != 0)
            {
                // where two places of a flank are about to become one, forces would go to and fro between them
                gaps.contacts = held(field, work.search(gaps.turn, limit), now, gaps.contacts, work.bench.threads);
                last = mismatch(work, gaps.contacts, now);
            }
            if (last <= settled && least <= (round < most_rounds / 2 ? held_share / 10 : held_share) * module)
            {
                now.residual = least;
                now.rounds = round - 1;
                now.steps = steps;
                return now;
            }
        }
        Equilibrium guess = now.state;
        guess.flank.clear();
        for (FlankContact const& c : gaps.contacts)
        {
            double const f = force_before(now.contacts, now.state.flank, c);
            guess.flank.push_back(f);
            gaps.displacement.push_back(normal_displacement(work.drive, now.shape, c));
            gaps.compliance.push_back(work.local_compliance(c, f));
        }
        Equilibrium next = equilibrium(work.drive, gaps, torque, &guess, work.bench.threads);
        steps += next.steps;
        if (round > most_rounds / 2)
            meet_half_way(now, gaps.contacts, next);
        now.state = std::move(next);
        now.contacts = std::move(gaps.contacts);
        now.forces = forces_on_cup(work.drive, now.contacts, now.state);
        now.shape = loaded_shape(work.bench, work.drive, now.forces);
    }
    throw NumericalError("load", "torque of " + std::to_string(torque / 1000) + " N m",
                         "forces and loaded shape do not settle: after " + std::to_string(most_rounds) + " rounds gaps still differ by " + std::to_string(last * 1e3) + " um");
}

/// The same; whatever fails says at which torque. A state that is not reached from below is looked for from a larger torque: tips that pass over the
/// edges of lands have more than one place to rest, and between them none that rounds find.
Loaded settled_at(Worker const& work, double torque, Loaded const& start)
{
    std::optional<NumericalError> first;
    for (double const by_way_of : {1.0, 1.25, 1.6, 2.5})
    {
        if (first && torque == 0)
            break;
        try
        {
            return by_way_of == 1 ? settle(work, torque, start) : settle(work, torque, settle(work, by_way_of * torque, start));
        }
        catch (NumericalError const& error)
        {
            if (!first)
                first.emplace(error);
        }
    }
    std::string const what = first->what();
    if (what.starts_with("load: "))
        throw NumericalError(*first);
    throw NumericalError("load", "torque of " + std::to_string(torque / 1000) + " N m", what);
}

/// Area of the strip under pressure between two slices, line loads q0 and q1 with half widths c sqrt(q).
double strip(double q0, double q1, double c0, double c1, double length)
{
    double const c = 0.5 * (c0 + c1);
    double const difference = q1 - q0;
    if (std::abs(difference) <= 1e3 * unit_roundoff * (q0 + q1))
        return 2 * c * std::sqrt(0.5 * (q0 + q1)) * length;
    return 2 * c * length * (2.0 / 3) * (q1 * std::sqrt(q1) - q0 * std::sqrt(q0)) / difference;
}

/// Flank values of one state over (space, flank, slice).
struct FlankTable
{
    std::size_t slices;
    std::vector<double> force, load, pressure, gap, height, half;

    FlankTable(std::size_t spaces, std::size_t count) : slices(count)
    {
        std::size_t const size = 2 * spaces * count;
        for (auto* v : {&force, &load, &pressure, &height, &half})
            v->assign(size, 0);
        gap.assign(size, std::numeric_limits<double>::infinity());
    }
    [[nodiscard]] std::size_t index(std::size_t space, std::size_t flank, std::size_t slice) const { return (2 * space + flank) * slices + slice; }
};

FlankTable table_of(Worker const& work, Loaded const& loaded)
{
    FlankTable table(work.spaces(), work.grid.slices());
    std::size_t const first = work.search(0, 0).first_space;
    for (std::size_t i = 0; i < loaded.contacts.size(); ++i)
    {
        FlankContact const& c = loaded.contacts[i];
        double const f = loaded.state.flank[i];
        std::size_t const at = table.index(c.space - first, static_cast<std::size_t>(c.flank), c.slice);
        double const q = f / work.width_of(c);
        LineContact const line = work.drive.line_contact(c);
        double const local = f > 0 ? work.local_compliance(c, f) * f : 0;
        double const gap = f > 0 ? -local : c.gap;
        if (gap < table.gap[at])
        {
            table.gap[at] = gap;
            table.height[at] = c.station;
        }
        table.force[at] += f;
        table.load[at] += q;
        table.pressure[at] = std::max(table.pressure[at], largest_pressure(line, q));
        table.half[at] += half_width(line, q);
    }
    return table;
}

/// Hertz strips along the flanks: between slices that both carry force as wide as both say, and from one that does to one that does not as far as
/// the force, going down in a straight line through the gap there, reaches.
double pressed_area(Worker const& work, FlankTable const& t, std::size_t flank)
{
    double area = 0;
    std::vector<double> const& z = work.grid.z;
    for (std::size_t s = 0; s < work.spaces(); ++s)
    {
        if (t.slices == 1)
            area += 2 * t.half[t.index(s, flank, 0)] * work.drive.slice_width[0];
        for (std::size_t k = 0; k + 1 < t.slices; ++k)
        {
            std::size_t const a = t.index(s, flank, k), b = t.index(s, flank, k + 1);
            double const length = z[k + 1] - z[k];
            auto const scale = [&](std::size_t i) { return t.half[i] / std::sqrt(t.load[i]); };
            if (t.load[a] > 0 && t.load[b] > 0)
                area += strip(t.load[a], t.load[b], scale(a), scale(b), length);
            else if (t.load[a] > 0 || t.load[b] > 0)
            {
                std::size_t const on = t.load[a] > 0 ? a : b, off = t.load[a] > 0 ? b : a;
                double const yields = -t.gap[on];  // by how much the contact gives way
                double const share = std::isfinite(t.gap[off]) ? yields / (yields + std::max(0.0, t.gap[off])) : 0;
                area += strip(t.load[on], 0, scale(on), scale(on), share * length);
            }
        }
    }
    return area * work.drive.response.sectors();
}

/// Area of all flanks on one side.
double flank_area(Worker const& work, std::size_t flank)
{
    FlankGrid const& grid = work.grid;
    double area = 0;
    for (std::size_t k = 0; k < grid.slices(); ++k)
    {
        double length = 0;
        auto const& line = grid.point[flank][k];
        for (std::size_t i = 1; i < line.size(); ++i)
            length += (line[i] - line[i - 1]).norm();
        area += length * work.drive.slice_width[k];
    }
    return area * work.scene().drive.circular_spline_teeth;
}

/// Share of the flanks of one side that are no farther than the contact gap in the loaded shape.
double near_share(Worker const& work, Loaded const& loaded, int flank)
{
    GapField const field(work.bench.tooth, work.grid, loaded.shape.places, work.scene().drive.flexspline_teeth, work.scene().drive.circular_spline_teeth, work.drive.phase);
    FlankSearch const search = work.search(loaded.state.turn, 0);
    GapMap map{work.grid.z, work.grid.station, {}, {}};
    for (std::size_t s = 0; s < search.spaces; ++s)
        map.angle.push_back(field.space_angle(search.first_space + s));
    double const far = work.scene().drive.module;
    map.gap.assign(search.spaces * 2 * work.grid.slices() * work.grid.points(), far);
    double const limit = work.bench.request.gap;
    std::vector<char> is_near(search.spaces, 0);
    for (FlankContact const& c : loaded.contacts)
        if (c.gap <= 2 * limit)
            is_near[c.space - search.first_space] = 1;
    constexpr std::size_t grain = 2;
    parallel_for(search.spaces, work.bench.threads, grain, [&](std::size_t s) {
        std::vector<double> gap;
        if (is_near[s])
            for (std::size_t k = 0; k < work.grid.slices(); ++k)
            {
                field.along(search.first_space + s, flank, k, search.turn, gap);
                std::copy(gap.begin(), gap.end(), map.gap.begin() + static_cast<std::ptrdiff_t>(map.index(s, flank, k, 0)));
            }
    });
    return contact_area(map, work.grid, flank, limit, work.bench.width).share();
}

LoadedState summary_of(Worker const& work, Loaded const& loaded, double torque, double middle)
{
    LoadedState state;
    state.torque = torque;
    state.twist = loaded.state.turn - middle;
    state.stiffness = loaded.state.stiffness;
    state.rounds = loaded.rounds;
    state.steps = loaded.steps;
    state.residual = loaded.residual;
    state.complementarity = loaded.state.complementarity;
    FlankTable const t = table_of(work, loaded);
    auto const side = static_cast<std::size_t>(torque < 0 ? GapMap::left : GapMap::right);
    std::size_t const sectors = static_cast<std::size_t>(work.drive.response.sectors());
    std::size_t carrying = 0, nodes = 0;
    for (std::size_t s = 0; s < work.spaces(); ++s)
    {
        double on_tooth[2] = {0, 0};
        for (std::size_t f = 0; f < 2; ++f)
            for (std::size_t k = 0; k < t.slices; ++k)
            {
                std::size_t const i = t.index(s, f, k);
                on_tooth[f] += t.force[i];
                if (f == side && t.force[i] > 0)
                    ++nodes;
                if (t.pressure[i] > state.largest_pressure)
                {
                    state.largest_pressure = t.pressure[i];
                    state.pressure_space = static_cast<int>(s);
                    state.pressure_z = work.grid.z[k];
                }
            }
        carrying += on_tooth[0] > 0 || on_tooth[1] > 0 ? 1 : 0;
        state.largest_force = std::max({state.largest_force, on_tooth[0], on_tooth[1]});
    }
    state.teeth = static_cast<int>(carrying * sectors);
    state.node_share = static_cast<double>(nodes) / static_cast<double>(work.spaces() * t.slices);
    state.contact_area = pressed_area(work, t, side);
    state.contact_share = state.contact_area / flank_area(work, side);
    state.near_share = near_share(work, loaded, static_cast<int>(side));
    for (std::size_t w = 0; w < work.drive.bearing_steps.size(); ++w)
    {
        auto const col = static_cast<Eigen::Index>(w);
        double const force = loaded.state.bearing.col(col).sum();
        state.wave_generator_force += force;
        // the surface pressed on rises by its slope per radian that it turns: forces along its normal do that work
        double const phi = work.drive.phase + work.drive.response.step() * work.drive.bearing_steps[w];
        state.wave_generator_torque -= force * work.bench.shape(phi).w1;
    }
    state.wave_generator_force *= static_cast<double>(sectors);
    state.wave_generator_torque *= static_cast<double>(sectors);
    return state;
}

LoadMap map_of(Worker const& work, Loaded const& loaded, double torque)
{
    FlankTable t = table_of(work, loaded);
    LoadMap map;
    map.torque = torque;
    map.z = work.grid.z;
    GapField const field(work.bench.tooth, work.grid, loaded.shape.places, work.scene().drive.flexspline_teeth, work.scene().drive.circular_spline_teeth, work.drive.phase);
    FlankSearch const search = work.search(0, 0);
    for (std::size_t s = 0; s < work.spaces(); ++s)
        map.angle.push_back(field.space_angle(search.first_space + s));
    map.force = std::move(t.force);
    map.line_load = std::move(t.load);
    map.pressure = std::move(t.pressure);
    map.height = std::move(t.height);
    // what is farther than was looked for
    double const far = search_share * work.scene().drive.module;
    for (double& gap : t.gap)
        gap = std::min(gap, far);
    map.gap = std::move(t.gap);
    return map;
}

/// Turns at which the teeth touch on either side without torque: of the assembled shape.
struct Play
{
    double right = 0;  ///< [rad] turn to first touch of the right flanks
    double left = 0;   ///< and of the left ones, counter-clockwise
};

/// Turn from @p from on in the direction @p sense at which the first flank of either side touches: a tip may touch on the far side of its space. Newton's method on the least
/// of all gaps, no step longer than what was looked at.
double first_touch(Worker const& work, GapField const& field, double from, double sense)
{
    double const limit = search_share * work.scene().drive.module;
    double const settled = settled_share * work.scene().drive.module;
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

/// Nothing where the teeth stand in each other's way at every turn; a negative sum where they do at every turn but not by much.
std::optional<Play> play_of(Worker const& work, LoadedShape const& shape)
{
    GapField const field(work.bench.tooth, work.grid, shape.places, work.scene().drive.flexspline_teeth, work.scene().drive.circular_spline_teeth, work.drive.phase);
    GapMap const rest = field.map(0, work.bench.threads);
    double const pitch = 2 * std::numbers::pi / work.scene().drive.circular_spline_teeth;
    try
    {
        double const right = take_up(field, rest, GapMap::right, pitch, work.bench.threads).turn;
        double const left = take_up(field, rest, GapMap::left, pitch, work.bench.threads).turn;
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

}  // namespace

Assembly assembly(ContactBench const&, ElasticDrive const& drive)
{
    Assembly result;
    result.state = equilibrium(drive, {}, std::nullopt, nullptr, 1);
    result.forces = forces_on_cup(drive, {}, result.state);
    return result;
}

LoadCase load_case(ContactBench const& bench, ElasticDrive const& drive, Assembly const& start, SurfaceChoice const& choice, std::vector<double> const& torques,
                   std::function<void()> const& on_state, Eigen::MatrixXd& rated)
{
    auto const begin = std::chrono::steady_clock::now();
    LoadCase result;
    result.surface = choice.surface;
    result.kind = choice.tilt != 0 || bench.scene.tilt ? choice.kind : "";
    result.tilt = choice.tilt;

    Loaded free;
    free.state = start.state;
    free.forces = start.forces;
    free.shape = loaded_shape(bench, drive, free.forces);
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
    Worker const work{bench, drive, surface.grid};
    result.backlash_offset = surface.offset;
    if (!play)
        throw NumericalError("load", "assembly", "the teeth of the bent cup stand in the way of those of the circular spline at every turn, with a side clearance of "
                                                     + std::to_string(surface.offset * 1e3) + " um: widen circular_spline.inner_radius, or write surface = \"per-slice\" in [slices]");
    result.backlash = play->right + play->left;
    double middle = 0.5 * (play->right - play->left);
    bool const pressed = result.backlash < 0;
    Loaded loaded = free;
    if (pressed)
    {
        loaded.state.turn = middle;
        loaded = settled_at(work, 0, loaded);
        middle = loaded.state.turn;
    }
    double largest = -1;
    for (double const torque : torques)
    {
        if (torque == 0 && !pressed)
        {
            loaded = free;
            loaded.state.turn = middle;
            LoadedState state = summary_of(work, loaded, 0, middle);
            result.curve.push_back(state);
        }
        else
        {
            bool const turns_over = !pressed && (result.curve.empty() || result.curve.back().torque * torque <= 0);
            if (turns_over)
            {
                loaded = free;
                loaded.state.turn = torque > 0 ? play->right : -play->left;
            }
            loaded = settled_at(work, torque, loaded);
            result.curve.push_back(summary_of(work, loaded, torque, middle));
        }
        if (std::abs(torque) > largest)
        {
            largest = std::abs(torque);
            result.rated = result.curve.size() - 1;
            result.map = map_of(work, loaded, torque);
            rated = loaded.forces;
        }
        if (on_state)
            on_state();
    }
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
