// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::load {
namespace {

/// Area of the strip under pressure between two slices: line loads q0 and q1, half widths c0 sqrt(q0) and c1 sqrt(q1).
double strip_area(double q0, double q1, double c0, double c1, double length)
{
    double const c = 0.5 * (c0 + c1);
    double const difference = q1 - q0;
    if (std::abs(difference) <= 1e3 * unit_roundoff * (q0 + q1))
        return 2 * c * std::sqrt(0.5 * (q0 + q1)) * length;
    return 2 * c * length * (2.0 / 3) * (q1 * std::sqrt(q1) - q0 * std::sqrt(q0)) / difference;
}

/// Area of the strip between the entries @p a and @p b of neighbouring slices.
double area_between(FlankTable const& t, std::size_t a, std::size_t b, double length)
{
    auto const scale = [&](std::size_t i) { return t.half_width[i] / std::sqrt(t.line_load[i]); };
    bool const a_loaded = t.line_load[a] > 0, b_loaded = t.line_load[b] > 0;
    if (a_loaded && b_loaded)
        return strip_area(t.line_load[a], t.line_load[b], scale(a), scale(b), length);
    if (!a_loaded && !b_loaded)
        return 0;
    std::size_t const on = a_loaded ? a : b, off = a_loaded ? b : a;
    double const approach = -t.gap[on];
    double const fraction = std::isfinite(t.gap[off]) ? approach / (approach + std::max(0.0, t.gap[off])) : 0;
    return strip_area(t.line_load[on], 0, scale(on), scale(on), fraction * length);
}

}  // namespace

FlankTable flank_table(LoadProblem const& problem, LoadedDrive const& loaded)
{
    FlankTable table;
    table.slices = problem.flanks.slices();
    std::size_t const size = 2 * spaces_of(problem) * table.slices;
    for (auto* v : {&table.force, &table.line_load, &table.pressure, &table.off_edges, &table.on_edges, &table.flowing,
                    &table.height, &table.half_width})
        v->assign(size, 0);
    table.gap.assign(size, std::numeric_limits<double>::infinity());
    std::size_t const first = flank_search(problem, 0, 0).first_space;
    std::vector<double> const approach =
        local_compliance(problem.drive, loaded.contacts, loaded.state.flank)(loaded.state.flank);
    for (std::size_t i = 0; i < loaded.contacts.size(); ++i) {
        FlankContact const& c = loaded.contacts[i];
        double const f = loaded.state.flank[i];
        std::size_t const at = table.index(c.space - first, static_cast<std::size_t>(c.flank), c.slice);
        double const q = f / problem.drive.slice_width[c.slice];
        LineContact const line = problem.drive.line_contact(c);
        double const gap = f > 0 ? -approach[i] : c.gap;
        if (gap < table.gap[at]) {
            table.gap[at] = gap;
            table.height[at] = c.arc_fraction;
        }
        table.force[at] += f;
        table.line_load[at] += q;
        double const pressure = largest_pressure(line, q);
        table.pressure[at] = std::max(table.pressure[at], pressure);
        if (flows(line, q))
            table.flowing[at] += f;
        if (c.on_edge)
            table.on_edges[at] += f;
        else
            table.off_edges[at] = std::max(table.off_edges[at], pressure);
        table.half_width[at] += half_width(line, q);
    }
    return table;
}

double pressed_area(LoadProblem const& problem, FlankTable const& table, std::size_t flank)
{
    double area = 0;
    std::vector<double> const& z = problem.flanks.z;
    std::size_t const spaces = spaces_of(problem);
    for (std::size_t s = 0; s < spaces; ++s) {
        if (table.slices == 1)
            area += 2 * table.half_width[table.index(s, flank, 0)] * problem.drive.slice_width[0];
        for (std::size_t k = 0; k + 1 < table.slices; ++k)
            area += area_between(table, table.index(s, flank, k), table.index(s, flank, k + 1), z[k + 1] - z[k]);
    }
    return area * problem.drive.response->sectors();
}

}  // namespace hdconj::load
