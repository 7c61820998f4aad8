// SPDX-License-Identifier: GPL-3.0-or-later
#include "play.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/turn_to_contact.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"

namespace hdconj::load {
namespace {

constexpr double nearly_radial = 0.01;  ///< lever over the reach of a contact that a turn does not open
constexpr double touching = 1e-3;       ///< of the module: mesh and interpolation move teeth by some nanometres

double pitch_of(LoadProblem const& problem)
{
    return 2 * std::numbers::pi / problem.context.scene.drive.circular_spline_teeth;
}

/// The contacts at a turn, and what is known of all gaps there.
struct TurnedTeeth
{
    double turn;
    std::vector<FlankContact> contacts;
    GapBounds known;
};

/// Turn from @p from on in the direction @p sense at which the first flank of either side touches: a tip may touch on
/// the far side of its space. Newton's method on the smallest of all gaps, with steps within the gaps searched. Teeth
/// that interfere along a radius, as tips do that pass each other, are not opened by a turn: they do not count, and
/// play_of() looks for them first. Nothing where it does not converge within a pitch.
/// @param limit  of the gaps searched [mm]: a large one takes large steps, a small one looks at few flanks
std::optional<double> first_touch(LoadProblem const& problem, contact::GapField const& field, TurnedTeeth from,
                                  double sense, double limit)
{
    double const shortest_lever = nearly_radial * field.reach();
    auto& [turn, contacts, known] = from;
    double const begin = turn;
    constexpr int most_steps = 60;
    constexpr double narrower = 0.25;  // of the way of a step that ends at a flank
    double const least = std::min(limit, touching * problem.context.scene.drive.module);
    for (int i = 0; i < most_steps && std::abs(turn - begin) <= pitch_of(problem); ++i) {
        double step = limit / field.reach();
        for (FlankContact const& c : contacts)
            if (double const lever = sense * c.lever; lever > (c.gap < 0 ? shortest_lever : 0))
                step = std::min(step, c.gap / lever);
        turn += sense * step;
        if (std::abs(step) * field.reach() <= gap_tolerance(problem))
            return turn;
        if (step < limit / field.reach())
            limit = std::min(limit, std::max(least, narrower * std::abs(step) * field.reach()));
        known.lower(problem.deviation ? std::numeric_limits<double>::infinity() : std::abs(step) * field.reach());
        contacts = flank_contacts(field, flank_search(problem, turn, limit), problem.context.threads, &known);
    }
    return std::nullopt;
}

/// Gaps of one sector of the ring without a turn; the other sectors have the same.
GapMap sector_at_rest(LoadProblem const& problem, contact::GapField const& field)
{
    GapMap map{field.grid().z, field.grid().station, {}, {}};
    std::size_t const spaces = spaces_of(problem), slices = map.z.size();
    for (std::size_t s = 0; s < spaces; ++s)
        map.angle.push_back(field.space_angle(s));
    map.gap.resize(spaces * 2 * slices * map.station.size());
    constexpr std::size_t grain = 4;
    parallel_for(spaces, problem.context.threads, grain, [&](std::size_t s) {
        for (int const flank : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)})
            for (std::size_t k = 0; k < slices; ++k)
                field.along(s, flank, k, 0, map.gap.data() + map.index(s, flank, k, 0));
    });
    return map;
}

TurnedTeeth teeth_at(LoadProblem const& problem, contact::GapField const& field, double turn, double limit)
{
    TurnedTeeth teeth{turn, {}, {}};
    teeth.contacts = flank_contacts(field, flank_search(problem, turn, limit), problem.context.threads, &teeth.known);
    return teeth;
}

/// See tip_overlap().
double radial_overlap(LoadProblem const& problem, contact::GapField const& field, TurnedTeeth const& teeth)
{
    double deepest = -gap_tolerance(problem);
    for (FlankContact const& c : teeth.contacts)
        if (std::abs(c.lever) <= nearly_radial * field.reach())
            deepest = std::min(deepest, c.gap);
    return deepest < -gap_tolerance(problem) ? -deepest : 0;
}

/// Nothing where a side has no first touch.
std::optional<Play> touches_from(LoadProblem const& problem, contact::GapField const& field, TurnedTeeth const& from,
                                 double limit)
{
    std::optional<double> const right = first_touch(problem, field, from, 1, limit),
                                left = first_touch(problem, field, from, -1, limit);
    return right && left ? std::optional(Play{*right, -*left}) : std::nullopt;
}

/// The play about no turn. Nothing where teeth interfere there, or a side has no first touch.
std::optional<Play> play_from_rest(LoadProblem const& problem, contact::GapField const& field)
{
    double const limit = search_limit(problem);
    TurnedTeeth const rest = teeth_at(problem, field, 0, limit);
    bool const free = std::ranges::all_of(rest.contacts, [](FlankContact const& c) { return c.gap >= 0; });
    return free ? touches_from(problem, field, rest, limit) : std::nullopt;
}

}  // namespace

std::optional<Play> play_of(LoadProblem const& problem, LoadedShape const& shape)
{
    auto const& drive = problem.context.scene.drive;
    int const threads = problem.context.threads;
    contact::GapField const field = gap_field(problem, shape, problem.edges);
    if (std::optional<Play> const play = play_from_rest(problem, field))
        return play;
    GapMap const rest = sector_at_rest(problem, field);
    double const pitch = pitch_of(problem);
    double const touches = touching * drive.module;
    try {
        Play const play{contact::turn_to_contact(field, rest, GapMap::right, pitch, threads, touches).turn,
                        contact::turn_to_contact(field, rest, GapMap::left, pitch, threads, touches).turn};
        if (width_of(play) < 0)
            return play;
        constexpr double beyond = 16;  // times what touches
        double const limit = std::min(search_limit(problem), field.reach() * 0.5 * width_of(play) + beyond * touches);
        double const middle = middle_of(play);
        TurnedTeeth const teeth = teeth_at(problem, field, middle, limit);
        // no turn opens this overlap; the gap of no contact grows by more than the turn times the reach
        if (double const least = radial_overlap(problem, field, teeth) / field.reach(); least > 0)
            return Play{middle - least, -middle - least, true};
        return touches_from(problem, field, teeth, limit).value_or(play);
    } catch (NumericalError const& error) {
        if (error.code() != ErrorCode::no_contact && error.code() != ErrorCode::not_converged)
            throw;
        return std::nullopt;  // no turn within a pitch at which one side just touches
    }
}

double tip_overlap(LoadProblem const& problem, LoadedShape const& shape, double turn)
{
    contact::GapField const field = gap_field(problem, shape, problem.edges);
    return radial_overlap(problem, field, teeth_at(problem, field, turn, 0));
}

Play play_about(LoadProblem const& problem, LoadedShape const& shape, double middle)
{
    contact::GapField const field = gap_field(problem, shape, problem.edges);
    double const limit = search_limit(problem);
    if (std::optional<Play> const play = touches_from(problem, field, teeth_at(problem, field, middle, limit), limit))
        return *play;
    throw NumericalError(ErrorCode::interference, "load", "play",
                         "the teeth interfere, and no turn within a pitch brings them apart",
                         "write a larger circular_spline.backlash_offset");
}

}  // namespace hdconj::load
