// SPDX-License-Identifier: GPL-3.0-or-later
#include "residual.hpp"

#include <algorithm>
#include <limits>

#include "seen_distance.hpp"

namespace hdconj::wedm {
namespace {

/// How the wire leans that makes each point of one pitch, with one more point of each neighbour.
std::vector<Lean> leans_of(WireFaces const& faces, double height)
{
    auto const lower = with_neighbours(faces.pitch.lower, faces, 1);
    auto const upper = with_neighbours(faces.pitch.upper, faces, 1);
    std::vector<Lean> leans;
    for (std::size_t i = 0; i < lower.size(); ++i)
        leans.emplace_back(lower[i], upper[i], height);
    return leans;
}

std::vector<double> heights_of(WireFaces const& faces, PairedPath const& wire, CutRadius const& cut, bool upper)
{
    return uncut_heights(with_neighbours(faces.pitch.face(upper), faces, 1),
                         with_neighbours(wire.face(upper), faces, wire.size() - 1), cut.offset, cut.tolerance,
                         leans_of(faces, cut.height));
}

/// Adds a residual for each run of points of a face above which material is left. A run ends where flank and root meet.
void add_runs(WireFaces const& faces, std::vector<double> const& heights, bool upper, Uncut& uncut)
{
    std::vector<Vec2> const& points = faces.pitch.face(upper);
    bool open = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double const height = heights[i + 1];  // one more point before the pitch
        if (height <= 0) {
            open = false;
            continue;
        }
        uncut.at[i] = 1;
        bool const meshing = faces.meshing[i] != 0;
        if (!open || uncut.residuals.back().meshing != meshing)
            uncut.residuals.push_back({1, 0, points[i], upper, height, meshing});
        open = true;
        Residual& run = uncut.residuals.back();
        if (height > run.height) {
            run.height = height;
            run.where = points[i];
        }
    }
}

/// Marks the neighbours too: at the edges of a residual, heights have fallen to the tolerance in both faces, but
/// sections between them may differ by a point.
std::vector<char> widened(std::vector<char> const& narrow)
{
    std::vector<char> wide = narrow;
    for (std::size_t i = 1; i + 1 < wide.size(); ++i)
        wide[i] = narrow[i - 1] != 0 || narrow[i] != 0 || narrow[i + 1] != 0 ? 1 : 0;
    return wide;
}

}  // namespace

std::vector<double> uncut_heights(std::vector<Vec2> const& nominal, std::vector<Vec2> const& wire, double offset,
                                  double tolerance, std::vector<Lean> const& leans)
{
    region::SegmentTree const line(wire);
    std::vector<double> heights(nominal.size(), 0.0);
    for (std::size_t i = 1; i + 1 < nominal.size(); ++i) {
        double const height = seen_distance(line, nominal[i], leans.empty() ? Lean() : leans[i]) - offset;
        heights[i] = height > tolerance ? height : 0;
    }
    return heights;
}

double way_to_residual(std::vector<Vec2> const& nominal, std::vector<double> const& heights,
                       std::vector<Vec2> const& reached)
{
    region::SegmentTree const line(reached);
    double way = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < nominal.size(); ++i)
        if (heights[i] > 0)
            way = std::min(way, seen_distance(line, nominal[i]) - heights[i]);
    return way;
}

Residual const* Uncut::highest() const
{
    auto const found = std::ranges::max_element(residuals, {}, &Residual::height);
    return found == residuals.end() ? nullptr : &*found;
}

Uncut uncut_of(WireFaces const& faces, PairedPath const& wire, CutRadius const& cut)
{
    Uncut uncut;
    uncut.at.assign(faces.pitch.size(), 0);
    for (bool const upper : {false, true})
        add_runs(faces, heights_of(faces, wire, cut, upper), upper, uncut);
    uncut.at = widened(uncut.at);
    return uncut;
}

double way_to_uncut(WireFaces const& faces, PairedPath const& wire, CutRadius const& cut, WireFaces const& reached)
{
    double const longest =
        std::ranges::max(leans_of(faces, cut.height), {}, [](Lean const& lean) { return lean.secant(); }).secant();
    double way = std::numeric_limits<double>::infinity();
    for (bool const upper : {false, true}) {
        std::vector<Vec2> const& teeth = reached.pitch.face(upper);
        std::vector<double> in_face = heights_of(faces, wire, cut, upper);
        for (double& height : in_face)
            height *= longest;
        way = std::min(way, way_to_residual(with_neighbours(faces.pitch.face(upper), faces, 1), in_face,
                                            with_neighbours(teeth, faces, teeth.size() - 1)));
    }
    return way;
}

}  // namespace hdconj::wedm
