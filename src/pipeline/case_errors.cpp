// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact_error.hpp"
#include "finer_surface.hpp"
#include "hdconj/contact/parallel_trim.hpp"
#include "hdconj/numeric/least_between.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "tip_error.hpp"

namespace hdconj::detail {
namespace {

double distance_to(std::vector<Vec2> const& line, Vec2 const& p)
{
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
        Vec2 const along = line[i + 1] - line[i];
        double const length2 = along.squaredNorm();
        double const t = length2 > 0 ? std::clamp((p - line[i]).dot(along) / length2, 0.0, 1.0) : 0.0;
        best = std::min(best, (p - line[i] - t * along).squaredNorm());
    }
    return std::sqrt(best);
}

/// Largest distance of the ruled flanks from the conjugate outlines of the planes of @p maker, one by one.
std::vector<double> deviations(ContactBench const& bench, SurfaceMaker& maker, FlankGrid const& grid, double tip)
{
    MatchedOutline const own = maker({"per-slice", "radial", 0}, tip, bench.tolerance.length, 0);
    FlankGrid const to_tip = moved_into_material(grid, 0);
    std::vector<double> worst(grid.slices(), 0);
    parallel_for(grid.slices(), bench.threads, 1, [&](std::size_t k) {
        for (auto const& flank : to_tip.point)
            for (Vec2 const& p : flank[k])
                worst[k] = std::max(worst[k], distance_to(own.points[k], p));
    });
    return worst;
}

}  // namespace

void write_errors(ContactBench const& bench, SurfaceChoice const& choice, SliceTurns const& turns, Surfaces const& made, ContactCase& result)
{
    bool const both = !is_symmetric(bench);
    auto const write = [&](TurnWork const& as_made, SurfaceMaker& maker, PartFlanks const& cleared) {
        ClearanceErrors const errors = clearance_errors(bench, as_made, made.given, result.slices);
        // planes between slices that are solved anew have their own chords, were made to clear a tooth by points, and have corners that move along the flank
        bool const anew = choice.surface == "per-slice" && bench.scene.coning && made.flanks.grid.slices() > 1;
        double const chords = anew ? 2 * bench.tolerance.length : 0;
        // a clearance falls no faster than the flank goes on
        double const unseen = unseen_length(made.flanks.grid, made.given) + chords + (anew ? overlap_at_ends(made.flanks.grid, made.given) : 0);
        result.clearance_error = errors.flank + unseen;
        result.root_clearance_error = errors.root;
        // a ruled surface is exact in its end planes; between them its lines join places that are known to the chords
        bool const ruled = choice.surface == "ruled" && bench.scene.coning;
        for (std::size_t k = 0; k < result.slices.size(); ++k)
        {
            double const joined = ruled && k > 0 && k + 1 < result.slices.size() ? bench.tolerance.length : 0;
            result.slices[k].flank_error = errors.flanks[k] + unseen + joined;
            result.slices[k].root_error = errors.roots[k] + joined;
        }
        result.clearing_offset_error = clearing_error(bench, as_made.turns, flank_set(cleared.grid, both), result.clearing_offset, false) + unseen_length(made.cleared.flanks.grid, result.clearing_offset) + chords + (anew ? overlap_at_ends(made.cleared.flanks.grid, result.clearing_offset) : 0);
        result.clearing_root_error = clearing_error(bench, as_made.turns, root_set(as_made.outline, bench.tolerance), result.clearing_root, true);
        result.clearing_tip_error = clearing_tip_error(bench, choice, maker, cleared, made.cleared, result.clearing_offset_error, made.given);
        if (choice.surface != "ruled" || !bench.scene.coning || made.flanks.grid.slices() < 2)
            return;
        // told in the slices of the scene, of which these are all or every so many
        std::vector<double> low = deviations(bench, maker, cleared.grid, made.cleared.tip);
        for (std::size_t k = 0; k < low.size(); k += (low.size() - 1) / (made.flanks.grid.slices() - 1))
            result.ruled_deviation = std::max(result.ruled_deviation, low[k]);
        for (double& each : low)
            each = -each;
        // the distance is pointed where it is largest; an outline is known to its chords
        result.ruled_deviation_error = -least_between(low, pointed_function) - result.ruled_deviation + bench.tolerance.length;
    };
    std::size_t const slices = made.flanks.grid.slices();
    bool const alike = slices == 1 || (!bench.scene.coning && choice.tilt == 0);
    std::size_t const fewest = choice.surface == "ruled" ? fewest_planes : fewest_turn_planes;
    if (alike || slices >= fewest)
    {
        write({turns, made.outline, made.flanks.grid, &made.flank, &made.root}, bench.maker, made.cleared.flanks);
    }
    else
    {
        SurfaceMaker* maker = &bench.maker;
        while (maker->z().size() < fewest)
            maker = &maker->refined();
        SliceTurns const finer_turns(bench, *maker);
        auto const surface = [&](double tip) { return surface_of(bench, *maker, choice, tip); };
        MatchedOutline const outline = surface(made.tip);
        double const most = std::max(made.given, result.clearing_offset);
        PartFlanks const flanks = part_flanks(bench, *maker, choice, outline, made.tip, most);
        PartFlanks const cleared = made.cleared.tip == made.tip ? flanks : part_flanks(bench, *maker, choice, surface(made.cleared.tip), made.cleared.tip, most);
        write({finer_turns, outline, flanks.grid}, *maker, cleared);
    }
}

}  // namespace hdconj::detail
