// SPDX-License-Identifier: GPL-3.0-or-later
// What a program does against the part: the wire's way and constant taper's, measured at the true faces and sections.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "checks.hpp"
#include "passes.hpp"
#include "planes.hpp"
#include "seen_distance.hpp"

namespace hdconj::wedm {
namespace {

region::SegmentTree neighbourhood(std::vector<Vec2> const& pitch, WireFaces const& faces)
{
    return region::SegmentTree(with_neighbours(pitch, faces, pitch.size() - 1));
}

}  // namespace

WireFailures check_sweep(WireFaces const& faces, WireProgram& program)
{
    WireFailures failures;
    std::array<region::SegmentTree, 2> const part{neighbourhood(faces.pitch.lower, faces),
                                                  neighbourhood(faces.pitch.upper, faces)};
    for (WirePass const& pass : program.passes) {
        PairedPath const path = pitch_of(pass, program);
        // along a straight block the distance of a corner changes by step^2/(8 offset) between two places
        double const step = 0.5 * std::sqrt(pass.offset * program.tolerance);
        double worst = 0;
        Vec2 place = Vec2::Zero();
        auto const look = [&](Vec2 const& lower, Vec2 const& upper) {
            Lean const lean(lower, upper, program.machine.thickness);
            for (bool const in_upper : {false, true}) {
                Vec2 const& p = in_upper ? upper : lower;
                double const error = std::abs(seen_distance(part[in_upper ? 1 : 0], p, lean) - pass.offset);
                place = error > worst ? p : place;
                worst = std::max(worst, error);
            }
        };
        look(path.lower.front(), path.upper.front());
        for (std::size_t i = 1; i < path.size(); ++i) {
            Vec2 const lower = path.lower[i] - path.lower[i - 1], upper = path.upper[i] - path.upper[i - 1];
            auto const parts = static_cast<int>(std::ceil(std::max(lower.norm(), upper.norm()) / step));
            for (int k = 1; k <= parts; ++k)
                look(path.lower[i - 1] + lower * k / parts, path.upper[i - 1] + upper * k / parts);
        }
        program.figures.face_error = std::max(program.figures.face_error, worst);
        if (!(worst <= program.tolerance))
            failures.push_back(
                fmt::format("sweep: pass {} is {:.6g} mm from its distance {:.6g} mm to the part at {} of space 0, and "
                            "the tolerance is {:.6g} mm",
                            pass.number, worst, pass.offset, place_text(place), program.tolerance));
    }
    return failures;
}

WireFailures check_sections(WireFaces const& faces, std::vector<std::vector<char>> const& residual_at, double limit,
                            WireProgram& program)
{
    WireFailures failures;
    WireFigures& figures = program.figures;
    for (SectionBetween const& between : faces.between) {
        region::SegmentTree const rulings = neighbourhood(section(faces.pitch, program.machine, between.share), faces);
        double ruling = 0;
        for (Vec2 const& p : between.points)
            ruling = std::max(ruling, seen_distance(rulings, p));
        figures.ruling_error = std::max(figures.ruling_error, ruling);
        for (std::size_t n = 0; n < program.passes.size(); ++n) {
            WirePass const& pass = program.passes[n];
            region::SegmentTree const wire =
                neighbourhood(section(pitch_of(pass, program), program.machine, between.share), faces);
            double worst = 0;
            Vec2 where = Vec2::Zero();
            for (std::size_t i = 0; i < between.points.size(); ++i) {
                Lean const lean(faces.pitch.lower[i], faces.pitch.upper[i], program.machine.thickness);
                double const error = seen_distance(wire, between.points[i], lean) - pass.offset;
                double const counted = residual_at[n][i] != 0 ? std::max(0.0, -error) : std::abs(error);
                where = counted > worst ? between.points[i] : where;
                worst = std::max(worst, counted);
            }
            figures.middle_error = std::max(figures.middle_error, worst);
            if (!(worst <= limit))
                failures.push_back(fmt::format(
                    "sections: pass {} is {:.6g} mm from the true section at z = {:.6g} mm, at {}; straight rulings "
                    "are {:.6g} mm from it, the rest is twist along them; accepted are {:.6g} mm (wedm.surface_limit)",
                    pass.number, worst, between.share * program.machine.thickness, place_text(where), ruling, limit));
        }
    }
    constexpr double margin = 1.01;  // of what is written, beyond the digits that are printed
    std::string const limit_of_all = fmt::format("{:.3g}", margin * figures.middle_error);
    for (WireFailure& failure : failures) {
        failure.remedy = "to accept all sections write wedm.surface_limit = " + limit_of_all;
        failure.set = "wedm.surface_limit=" + limit_of_all;
    }
    if (!faces.knows_sections)
        figures.middle_error = figures.ruling_error = std::numeric_limits<double>::quiet_NaN();
    return failures;
}

double guide_chord_error(PairedPath const& path, std::vector<std::size_t> const& kept, WireMachine const& machine)
{
    PairedPath guides;
    for (std::size_t i = 0; i < path.size(); ++i) {
        WirePoints const at = guides_of(machine, {path.lower[i], path.upper[i]});
        guides.add(at.lower, at.upper);
    }
    double worst = 0;
    for (std::size_t n = 1; n < kept.size(); ++n)
        for (std::size_t k = kept[n - 1] + 1; k < kept[n]; ++k)
            worst = std::max(worst, from_move(guides, k, kept[n - 1], kept[n]));
    return worst;
}

LargestDistance constant_taper_error(WireFaces const& faces)
{
    std::vector<Vec2> const &low = faces.pitch.lower, &up = faces.pitch.upper;
    if (low == up)
        return {};
    region::SegmentTree const lower = neighbourhood(low, faces);
    double const shift = up.front().norm() - low.front().norm();
    constexpr double reached = 0.999;  // of the shift: what is nearer to another place than its own is cut away
    double walls = 0, kept = 0;        // length in the lower face, and that of what a taper leaves of it
    LargestDistance worst;
    double before = -1;  // of the edge before; below 0: it is on no wall
    bool follows_worst = false;
    for (std::size_t i = 1; i < low.size(); ++i) {
        double here = -1;
        if (faces.wall[i] != 0 && faces.wall[i - 1] != 0) {
            Vec2 const edge = low[i] - low[i - 1], out = right_of(edge.normalized());
            Vec2 const from = 0.5 * (low[i - 1] + low[i]), to = 0.5 * (up[i - 1] + up[i]);
            here = std::abs(std::copysign(seen_distance(lower, to), out.dot(to - from)) - shift);
            walls += edge.norm();
            kept += seen_distance(lower, from + shift * out) >= reached * std::abs(shift) ? edge.norm() : 0;
        }
        if (here > worst.value) {
            worst = {here, before >= 0 ? here - before : 0};
            follows_worst = true;
        } else if (follows_worst) {
            worst.spread = here >= 0 ? std::max(worst.spread, worst.value - here) : worst.spread;
            follows_worst = false;
        }
        before = here;
    }
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return kept < walls / 2 || walls == 0 ? LargestDistance{unknown, unknown} : worst;
}

}  // namespace hdconj::wedm
