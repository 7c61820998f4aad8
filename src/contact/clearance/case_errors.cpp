// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/parallel_trim.hpp"
#include "contact_error.hpp"
#include "hdconj/base/parallel.hpp"
#include "numeric/least_between.hpp"
#include "tip_error.hpp"

namespace hdconj::contact {
namespace {

double distance_to(std::vector<Vec2> const& line, Vec2 const& p)
{
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        Vec2 const along = line[i + 1] - line[i];
        double const length2 = along.squaredNorm();
        double const t = length2 > 0 ? std::clamp((p - line[i]).dot(along) / length2, 0.0, 1.0) : 0.0;
        best = std::min(best, (p - line[i] - t * along).squaredNorm());
    }
    return std::sqrt(best);
}

/// Largest distance of the ruled flanks from the conjugate outlines of the planes of @p surface, one by one.
std::vector<double> deviations(CaseSurface const& surface, FlankGrid const& grid, double tip)
{
    conjugate::MatchedOutline const outlines = surface.conjugate_outlines(tip);
    FlankGrid const to_tip = moved_into_material(grid, 0);
    std::vector<double> worst(grid.slices(), 0);
    parallel_for(grid.slices(), surface.context().threads, 1, [&](std::size_t k) {
        for (auto const& flank : to_tip.point)
            for (Vec2 const& p : flank[k])
                worst[k] = std::max(worst[k], distance_to(outlines.points[k], p));
    });
    return worst;
}

/// The planes in which errors are estimated: those of the scene, or more.
struct ErrorPlanes
{
    CaseSurface const& surface;
    TurnWork const& nominal;    ///< full turns of the part as made
    PartFlanks const& cleared;  ///< flanks of the cleared surface
};

/// How far a ruled surface deviates, told in the slices of the scene: they are all planes, or every so many.
void write_deviation(ErrorPlanes const& planes, Surfaces const& made, ContactCase& result)
{
    std::size_t const slices = made.flanks.grid.slices();
    if (!planes.surface.is_ruled_on_cone() || slices < 2)
        return;
    std::vector<double> low = deviations(planes.surface, planes.cleared.grid, made.cleared.tip);
    for (std::size_t k = 0; k < low.size(); k += (low.size() - 1) / (slices - 1))
        result.ruled_deviation = std::max(result.ruled_deviation, low[k]);
    for (double& each : low)
        each = -each;
    // the distance is pointed where it is largest; an outline is known to its chords
    result.ruled_deviation_error = -numeric::least_between(low, numeric::pointed_function) - result.ruled_deviation +
                                   planes.surface.context().tolerance.length;
}

void write_errors_in(ErrorPlanes const& planes, CaseSurface const& in_slices, Surfaces const& made, ContactCase& result)
{
    ContactContext const& context = planes.surface.context();
    double const chord = context.tolerance.length;
    FlankGrid const& flanks = made.flanks.grid;
    FlankGrid const& cleared = made.cleared.flanks.grid;
    ClearanceErrors const errors = clearance_errors(context, planes.nominal, made.given, result.slices);
    // planes between slices that are solved anew have their own chords, were made to clear a tooth by points, and have
    // corners that move along the flank
    bool const anew = planes.surface.is_solved_per_plane() && flanks.slices() > 1;
    double const chords = anew ? 2 * chord : 0;
    // a clearance falls no faster than the flank goes on
    double const unseen = unseen_length(flanks, made.given) + chords + (anew ? overlap_at_ends(flanks, made.given) : 0);
    result.clearance_error = errors.flank + unseen;
    result.root_clearance_error = errors.root;
    // a ruled surface is exact in its end planes; between them its lines join places that are known to the chords
    for (std::size_t k = 0; k < result.slices.size(); ++k) {
        bool const joined = planes.surface.is_ruled_on_cone() && k > 0 && k + 1 < result.slices.size();
        result.slices[k].flank_error = errors.flanks[k] + unseen + (joined ? chord : 0);
        result.slices[k].root_error = errors.roots[k] + (joined ? chord : 0);
    }
    SliceClearances const& clearances = planes.nominal.clearances;
    result.clearing_offset_error =
        clearing_error(context, clearances, flank_set(planes.cleared.grid, !has_mirrored_flanks(context)),
                       result.clearing_offset, false) +
        unseen_length(cleared, result.clearing_offset) + chords +
        (anew ? overlap_at_ends(cleared, result.clearing_offset) : 0);
    result.clearing_root_error = clearing_error(
        context, clearances, root_set(planes.nominal.outline, context.tolerance), result.clearing_root, true);
    result.clearing_tip_error = clearing_tip_error(in_slices, planes.surface, planes.cleared, made.cleared,
                                                   result.clearing_offset_error, made.given);
    write_deviation(planes, made, result);
}

}  // namespace

void write_errors(CaseSurface const& surface, SliceClearances const& clearances, Surfaces const& made,
                  ContactCase& result)
{
    std::size_t const fewest = surface.is_ruled() ? fewest_planes : fewest_turn_planes;
    if (surface.is_alike() || surface.z().size() >= fewest) {
        TurnWork const nominal{clearances, made.outline, made.flanks.grid, &made.flank, &made.root};
        return write_errors_in({surface, nominal, made.cleared.flanks}, surface, made, result);
    }
    CaseSurface finer = surface;
    while (finer.z().size() < fewest)
        finer = finer.refined();
    SliceClearances const finer_clearances(surface.context(), finer.builder());
    conjugate::MatchedOutline const outline = finer.outline(made.tip);
    double const most = std::max(made.given, result.clearing_offset);
    PartFlanks const flanks = part_flanks(finer, outline, made.tip, most);
    PartFlanks const cleared = made.cleared.tip == made.tip
                                   ? flanks
                                   : part_flanks(finer, finer.outline(made.cleared.tip), made.cleared.tip, most);
    TurnWork const nominal{finer_clearances, outline, flanks.grid};
    write_errors_in({finer, nominal, cleared}, surface, made, result);
}

}  // namespace hdconj::contact
