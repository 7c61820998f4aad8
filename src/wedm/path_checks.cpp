// SPDX-License-Identifier: GPL-3.0-or-later
// What the paths of a program do against themselves: crossings, rulings, one tooth space like the next.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "checks.hpp"
#include "hdconj/base/tolerance.hpp"
#include "passes.hpp"
#include "planes.hpp"
#include "region/segment_tree.hpp"

namespace hdconj::wedm {
namespace {

/// Of a path that does not close: with the straight way back from its end to its beginning.
double signed_area(std::vector<Vec2> const& points)
{
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        area += 0.5 * cross(points[i], points[i + 1 == points.size() ? 0 : i + 1]);
    return area;
}

/// A path, closed or not, and which way it must go round.
struct Round
{
    std::string name;
    PairedPath path;
    bool closed = true;
    bool clockwise = false;
};

void check_round(Round const& round, WireMachine const& machine, WireFailures& failures)
{
    auto const& [what, path, closed, clockwise] = round;
    bool const one = path.lower == path.upper;
    for (double const share : one ? std::vector<double>{0.0} : std::vector<double>{0.0, 0.5, 1.0}) {
        std::string const place = fmt::format("crossing: {} at z = {:.6g} mm", what, share * machine.thickness);
        std::vector<Vec2> const points = section(path, machine, share);
        if (points.size() < 3) {
            failures.push_back(fmt::format("{} has {} points: no contour", place, points.size()));
            continue;
        }
        auto const [i, j] = region::SegmentTree(points, closed).crossing();
        if (i != j)
            failures.push_back(
                fmt::format("{} crosses itself at {}: moves {} and {}", place, place_text(points[i]), i, j));
        if ((signed_area(points) > 0) == clockwise)
            failures.push_back(place + (clockwise ? " goes counter-clockwise" : " goes clockwise"));
    }
}

}  // namespace

WireFailures check_crossings(WireProgram const& program)
{
    WireFailures failures;
    check_round({"the nominal contour", {program.nominal.lower, program.nominal.upper}, true, program.external},
                program.machine, failures);
    for (WirePass const& pass : program.passes) {
        PairedPath const path = points_of(contour_path(pass), program.closed() ? 1 : 0);
        check_round({fmt::format("pass {}", pass.number), path, program.closed(), program.external != pass.reversed},
                    program.machine, failures);
    }
    return failures;
}

WireFailures check_rulings(WireProgram& program)
{
    WireFailures failures;
    auto const ask = [&](std::string const& what, Vec2 const& low, Vec2 const& up, Vec2 const& at) {
        if (!(low.dot(up) > 0))
            failures.push_back(
                fmt::format("rulings: {} goes opposite ways in the two faces at {}", what, place_text(at)));
        return std::atan2(std::abs(cross(low, up)), low.dot(up));
    };
    PairedContour const& nominal = program.nominal;
    for (std::size_t i = 1; i < nominal.lower.size(); ++i) {
        double const angle = ask("the nominal contour", nominal.lower[i] - nominal.lower[i - 1],
                                 nominal.upper[i] - nominal.upper[i - 1], nominal.lower[i]);
        program.figures.normal_angle = std::max(program.figures.normal_angle, angle);
    }
    for (WirePass const& pass : program.passes) {
        for (std::size_t i = 2; i + 1 < pass.moves.size(); ++i) {
            WireMove const& from = pass.moves[i - 1];
            WireMove const& to = pass.moves[i];
            (void)ask(fmt::format("pass {}", pass.number), to.lower - from.lower, to.upper - from.upper, to.lower);
        }
    }
    return failures;
}

WireFailures check_pitches(WireProgram const& program)
{
    WireFailures failures;
    WireMachine const& m = program.machine;
    int const next_space = program.external ? 1 : -1;
    // a path that does not close is compared with itself one pitch on, as far as it reaches
    auto const ask = [&](std::string const& what, PairedPath const& path, int spaces, bool closed) {
        std::size_t const steps = path.size() / static_cast<std::size_t>(spaces);
        double worst = 0;
        double scale = 0;
        for (std::size_t i = 0; i < (closed ? path.size() : path.size() - steps); ++i) {
            std::size_t const j = (i + steps) % path.size();
            WirePoints const here = guides_of(m, {path.lower[i], path.upper[i]});
            WirePoints const next = guides_of(m, {path.lower[j], path.upper[j]});
            scale = std::max({scale, here.lower.norm(), here.upper.norm()});
            worst = std::max({worst, (turned_to(here.lower, next_space, program.teeth) - next.lower).norm(),
                              (turned_to(here.upper, next_space, program.teeth) - next.upper).norm()});
        }
        double const allowed =
            Tolerance{program.tolerance, scale * (1 + 2 * (m.lower_guide + m.upper_guide) / m.thickness)}.roundoff();
        if (path.size() % static_cast<std::size_t>(spaces) != 0 || !(worst <= allowed))
            failures.push_back(fmt::format(
                "pitches: {} is not the same in every tooth space: guides differ by {:.6g} mm", what, worst));
    };
    ask("the nominal contour", {program.nominal.lower, program.nominal.upper}, program.teeth, true);
    for (WirePass const& pass : program.passes)
        ask(fmt::format("pass {}", pass.number), points_of(even_path(pass, program.spaces()), 1), program.spaces(),
            program.closed());
    return failures;
}

}  // namespace hdconj::wedm
