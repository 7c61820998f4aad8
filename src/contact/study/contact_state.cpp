// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_state.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "conjugate/plane/plane_motion.hpp"
#include "contact/clearance/side_clearance_search.hpp"
#include "contact/contact_area.hpp"
#include "contact/gap_field.hpp"
#include "contact/open_gaps.hpp"
#include "contact/resolved_area.hpp"
#include "contact/turn_to_contact.hpp"
#include "hdconj/base/parallel.hpp"
#include "place_teeth.hpp"

namespace hdconj::contact {
namespace {

/// Spaces of one lobe in which the gap of @p flank may be within @p limit between the points and slices of @p map:
/// where it is twice that, and one space on.
std::vector<std::size_t> spaces_near(GapField const& field, GapMap const& map, int flank, double limit)
{
    constexpr double few = 2;
    constexpr std::size_t on = 1;
    std::size_t const spaces = map.angle.size();
    std::vector<std::uint8_t> wanted(spaces, 0);
    for (std::size_t s = 0; s < spaces; ++s) {
        auto const first = map.gap.begin() + static_cast<std::ptrdiff_t>(map.index(s, flank, 0, 0));
        if (*std::min_element(first, first + static_cast<std::ptrdiff_t>(map.z.size() * map.station.size())) >
            few * limit)
            continue;
        for (std::size_t i = 0; i <= 2 * on; ++i)
            wanted[(s + spaces + i - on) % spaces] = 1;
    }
    std::vector<std::size_t> found;
    for (std::size_t s = field.first_of_lobe(); s < field.first_of_lobe() + field.spaces_of_lobe(); ++s)
        if (wanted[s] != 0)
            found.push_back(s);
    return found;
}

/// The circular spline turned both ways until it touches.
struct Turned
{
    std::shared_ptr<GapMap> rest;  ///< before
    SmallestGap smallest;          ///< before
    double turn_to_contact = 0, reverse_turn_to_contact = 0;
};

Turned turned(PhaseWork const& work, FlankGrid const& grid, GapField const& field)
{
    ContactContext const& context = work.context;
    Turned result;
    context.clock.run(Stage::gap_map, [&] { result.rest = work.rest(context, grid, field, work.phase); });
    double const pitch = 2 * std::numbers::pi / context.scene.drive.circular_spline_teeth;
    context.clock.run(Stage::contact, [&] {
        double const touches = clearance_accuracy(context.tolerance);
        TurnToContact const right =
            turn_to_contact(field, *result.rest, GapMap::right, pitch, context.threads, touches);
        TurnToContact const left = turn_to_contact(field, *result.rest, GapMap::left, pitch, context.threads, touches);
        result.smallest = left.at_rest.gap < right.at_rest.gap ? left.at_rest : right.at_rest;
        result.turn_to_contact = right.turn;
        result.reverse_turn_to_contact = left.turn;
    });
    return result;
}

/// Where the smallest gap at rest may lie: planes and spaces whose own is as small within its error.
void write_place(GapField const& field, GapMap const& rest, int threads, ContactState& state)
{
    std::size_t const slices = rest.z.size(), points = rest.station.size();
    double const level = state.smallest_gap + state.smallest_gap_error;
    std::vector<std::vector<double>> low(field.spaces_of_lobe(),
                                         std::vector<double>(slices, std::numeric_limits<double>::infinity()));
    constexpr std::size_t grain = 4;
    parallel_for(low.size(), threads, grain, [&](std::size_t s) {
        std::size_t const space = field.first_of_lobe() + s;
        for (int const flank : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)})
            for (std::size_t k = 0; k < slices; ++k) {
                double const* const gap = rest.gap.data() + rest.index(space, flank, k, 0);
                double const on_points = *std::min_element(gap, gap + points);
                bool const follow = on_points > level && on_points - 0.5 * field.spacing() <= level;
                low[s][k] = std::min({low[s][k], on_points,
                                      follow ? smallest_on_line(field, {space, flank, k, 0}, gap, 0,
                                                                level + smallest_gap_accuracy(field))
                                                   .gap
                                             : on_points});
            }
    });
    std::vector<double> excess(slices, std::numeric_limits<double>::infinity());
    state.smallest_spaces = 0;
    for (auto const& space : low) {
        for (std::size_t k = 0; k < slices; ++k)
            excess[k] = std::min(excess[k], space[k] - state.smallest_gap);
        state.smallest_spaces += *std::min_element(space.begin(), space.end()) <= level ? field.lobes() : 0;
    }
    PlaceRange const range = place_range(rest.z, excess, state.smallest_gap_error);
    state.smallest_z_from = range.from;
    state.smallest_z_to = range.to;
}

}  // namespace

PlayEstimate play(PhaseWork const& work, FlankGrid const& grid)
{
    ContactContext const& context = work.context;
    int const z_f = context.scene.drive.flexspline_teeth, z_c = context.scene.drive.circular_spline_teeth;
    auto const places = context.places(context, work.phase);
    GapField const field(context.tooth, grid, *places, z_f, z_c, work.phase, nullptr, lobes_of(context));
    Turned const free = turned(work, grid, field);
    PlayEstimate result{free.turn_to_contact + free.reverse_turn_to_contact, 0};
    if (!work.errors)
        return result;
    context.clock.run(Stage::contact, [&] {
        double const limit = context.request.gap, off = clearance_accuracy(context.tolerance) + work.off;
        for (int const flank : {static_cast<int>(GapMap::right), static_cast<int>(GapMap::left)}) {
            double const turn = flank == GapMap::right ? free.turn_to_contact : -free.reverse_turn_to_contact;
            std::vector<std::size_t> const near_by =
                spaces_near(field, field.map(turn, context.threads), flank, limit + 0.5 * field.spacing());
            int const parts = work.finer.parts(near_by.size() * static_cast<std::size_t>(field.lobes()));
            FlankGrid const& fine = work.finer(parts);
            auto const fine_places = parts == 1 ? places : context.places(context, work.phase, fine.z);
            GapField const fine_field(context.tooth, fine, *fine_places, z_f, z_c, work.phase, nullptr,
                                      lobes_of(context));
            result.error += OpenGaps(open_gaps(fine_field, near_by, flank, turn, limit, context.threads),
                                     work.finer.solved_anew(), limit, work.floor(turn))
                                .turn_error(off);
        }
    });
    return result;
}

ContactState contact_state(PhaseWork const& work, FlankGrid const& grid, std::shared_ptr<GapMap>* map)
{
    ContactContext const& context = work.context;
    double const phase = work.phase;
    Scene const& scene = context.scene;
    int const z_f = scene.drive.flexspline_teeth, z_c = scene.drive.circular_spline_teeth;
    auto const places = context.places(context, phase);
    GapField const field(context.tooth, grid, *places, z_f, z_c, phase, nullptr, lobes_of(context));
    Turned const free = turned(work, grid, field);
    ContactState state;
    state.wave_generator = phase == 0 ? 0.0 : -phase * conjugate::tooth_ratio(scene);
    state.turn_to_contact = free.turn_to_contact;
    state.reverse_turn_to_contact = free.reverse_turn_to_contact;
    state.smallest_gap = free.smallest.gap;
    state.smallest_z = grid.z[free.smallest.where.slice];
    state.smallest_space = static_cast<int>(free.smallest.where.space) - (z_c - 1) / 2;
    context.clock.run(Stage::contact, [&] {
        std::shared_ptr<GapMap> const touching =
            state.turn_to_contact == 0 ? free.rest
                                       : std::make_shared<GapMap>(field.map(state.turn_to_contact, context.threads));
        if (map != nullptr)
            *map = touching;
        double const limit = context.request.gap;
        double const few = limit + 0.5 * field.spacing();
        std::vector<std::size_t> const near_by = spaces_near(field, *touching, GapMap::right, few);
        int const parts = work.finer.parts(near_by.size() * static_cast<std::size_t>(field.lobes()));
        FlankGrid const& fine = work.finer(parts);
        auto const fine_places = parts == 1 ? places : context.places(context, phase, fine.z);
        GapField const fine_field(context.tooth, fine, *fine_places, z_f, z_c, phase, nullptr, lobes_of(context));
        ResolvedArea const found = resolved_area(fine_field, near_by, state.turn_to_contact, GapMap::right, limit,
                                                 context.width, context.threads, work.errors);
        state.contact_area = found.area.contact;
        state.flank_area = found.area.whole;
        state.contact_fraction = found.area.share();
        state.teeth = found.area.spaces;
        if (!work.errors)
            return;

        // what the planes leave open of all that was found in them
        double const off = clearance_accuracy(context.tolerance) + work.off;
        auto const look = [&](int flank, double turn, std::vector<std::size_t> const& spaces, double level) {
            return OpenGaps(open_gaps(fine_field, spaces, flank, turn, limit, context.threads),
                            work.finer.solved_anew(), level + limit, work.floor(turn), field.lobes());
        };
        GapMap const other =
            state.reverse_turn_to_contact == 0 ? GapMap{} : field.map(-state.reverse_turn_to_contact, context.threads);
        OpenGaps const right = look(GapMap::right, state.turn_to_contact, near_by, 0);
        OpenGaps const left =
            look(GapMap::left, -state.reverse_turn_to_contact,
                 spaces_near(field, state.reverse_turn_to_contact == 0 ? *free.rest : other, GapMap::left, few), 0);
        state.turn_to_contact_error = right.turn_error(off);
        state.reverse_turn_to_contact_error = left.turn_error(off);
        double least = std::numeric_limits<double>::infinity();
        for (int const flank : {static_cast<int>(GapMap::right), static_cast<int>(GapMap::left)}) {
            bool const known = (flank == GapMap::right ? state.turn_to_contact : state.reverse_turn_to_contact) == 0;
            double const level = std::max(0.0, state.smallest_gap);
            least = std::min(least,
                             known ? (flank == GapMap::right ? right : left).least()
                                   : look(flank, 0, spaces_near(field, *free.rest, flank, few + level), level).least());
        }
        state.smallest_gap_error = std::max(0.0, state.smallest_gap - least) + off;

        write_place(field, *free.rest, context.threads, state);

        // a flexspline that is turned too far, or a clearance that is wrong, lifts or lowers all gaps by no more than
        // this
        double const lift = off + right.enters();
        std::array<double, 2> lifted{lift, -lift};  // the share then
        parallel_for(lifted.size(), context.threads, 1, [&](std::size_t i) {
            lifted[i] = contact_area(*touching, grid, GapMap::right, limit + lifted[i], context.width).share();
        });
        for (OpenGap const& each : right.spaces()) {
            state.teeth_least += each.lowest <= limit - lift ? field.lobes() : 0;
            state.teeth_most += std::min(each.least, each.lowest) <= limit + lift ? field.lobes() : 0;
        }
        // where gaps bend, a patch may also be between two points and two planes
        double const cell =
            work.finer.solved_anew() && fine.slices() > 1 ? field.spacing() * (fine.z[1] - fine.z[0]) : 0;
        state.fraction_error_along = found.along;
        state.contact_area_error =
            (found.along + found.across + (lifted[0] - lifted[1])) * state.flank_area + right.missed() + cell;
        // flanks end on a tip circle that is known as the outline is, and as the side clearance by which their ends are
        // moved
        state.flank_area_error = found.whole + 2 * (context.tolerance.length + work.off) * context.width *
                                                   static_cast<double>(fine_field.spaces());
        state.contact_fraction_error =
            state.flank_area > 0
                ? (state.contact_area_error + state.contact_fraction * state.flank_area_error) / state.flank_area
                : 0;
    });
    return state;
}

}  // namespace hdconj::contact
