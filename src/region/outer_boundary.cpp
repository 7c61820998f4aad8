// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/region/outer_boundary.hpp"

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hdconj/error.hpp"

namespace hdconj::region {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SegmentTraits = CGAL::Arr_segment_traits_2<Kernel>;

/// Which polygon side an arrangement edge came from.
struct Source
{
    int curve;
    int side;
    bool operator==(Source const&) const = default;
};

using Traits = CGAL::Arr_consolidated_curve_data_traits_2<SegmentTraits, Source>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Halfedge = Arrangement::Halfedge_const_handle;

Vec2 rounded(Arrangement::Vertex_const_handle v)
{
    return {CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y())};
}

/// Position of a point known to lie on a side.
double position_on(std::vector<Vec2> const& polygon, int side, Vec2 const& p)
{
    Vec2 const a = polygon[static_cast<std::size_t>(side)];
    Vec2 const d = polygon[static_cast<std::size_t>(side) + 1] - a;
    return side + std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
}

/// The side an edge belongs to; where sides overlap, one of the curve walked last, so that runs are not torn.
Source source_of(Halfedge edge, std::optional<int> last)
{
    std::optional<Source> first;
    for (Source const& source : edge->curve().data()) {
        if (last && source.curve == *last)
            return source;
        if (!first)
            first = source;
    }
    return *first;
}

std::vector<Traits::Curve_2> sides_of(std::vector<std::vector<Vec2>> const& curves)
{
    std::vector<Traits::Curve_2> sides;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        auto const& polygon = curves[c];
        for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
            if (polygon[i] == polygon[i + 1])
                continue;
            Kernel::Point_2 const a(polygon[i].x(), polygon[i].y());
            Kernel::Point_2 const b(polygon[i + 1].x(), polygon[i + 1].y());
            sides.emplace_back(SegmentTraits::Curve_2(a, b), Source{static_cast<int>(c), static_cast<int>(i)});
        }
    }
    return sides;
}

/// The vertices at both ends of a curve; nothing where the arrangement has none there.
struct EndVertices
{
    std::optional<Arrangement::Vertex_const_handle> first, last;
};

EndVertices end_vertices(Arrangement const& arrangement, std::vector<Vec2> const& curve)
{
    EndVertices found;
    for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
        Vec2 const p = rounded(v);
        if (p == curve.front())
            found.first = v;
        if (p == curve.back())
            found.last = v;
    }
    return found;
}

/// Adds an edge that runs along @p polygon of the curve of @p source to the runs: to the last one where it goes on.
void add_edge(Halfedge edge, Source const& source, std::vector<Vec2> const& polygon, std::vector<BoundaryRun>& runs)
{
    double const begin = position_on(polygon, source.side, rounded(edge->source()));
    double const end = position_on(polygon, source.side, rounded(edge->target()));
    bool const forward = runs.empty() || runs.back().end >= runs.back().begin;
    bool const same_way = forward == (end >= begin);
    // the walk is contiguous on a curve when this edge starts where the run stopped
    constexpr double adjoining = 1e-6;  // in vertices: positions are rounded projections
    if (!runs.empty() && runs.back().curve == source.curve && same_way && std::abs(runs.back().end - begin) < adjoining)
        runs.back().end = end;
    else
        runs.push_back({source.curve, begin, end});
}

}  // namespace

OuterBoundary outer_boundary(std::vector<std::vector<Vec2>> const& curves, int floor, double same)
{
    std::vector<Traits::Curve_2> const sides = sides_of(curves);
    Arrangement arrangement;
    CGAL::insert(arrangement, sides.begin(), sides.end());
    auto const [start, goal] = end_vertices(arrangement, curves[static_cast<std::size_t>(floor)]);
    if (!start || !goal || (*start)->degree() != 1)
        throw NumericalError(ErrorCode::no_land, "region", "tip circle",
                             "the arrangement has no free floor to walk along");

    OuterBoundary result;
    result.segments = sides.size();
    Halfedge edge = (*start)->incident_halfedges()->twin();
    auto const outside = edge->face();
    std::optional<int> last;
    Vec2 reached = curves[static_cast<std::size_t>(floor)].front();  // by the boundary, before a loose place
    for (std::size_t steps = 0; steps <= 2 * arrangement.number_of_edges(); ++steps) {
        Source const source = source_of(edge, last);
        if (source.curve != floor && edge->twin()->face() == outside) {
            if (Vec2 const p = rounded(edge->target()); (p - reached).norm() > same)
                result.loose.push_back(p);
        } else {
            reached = rounded(edge->target());
            add_edge(edge, source, curves[static_cast<std::size_t>(source.curve)], result.runs);
            last = source.curve;
        }
        if (edge->target() == *goal)
            return result;
        edge = edge->next();
    }
    throw NumericalError(ErrorCode::no_land, "region", "tip circle",
                         "the walk along the boundary does not come back to the tip circle");
}

}  // namespace hdconj::region
