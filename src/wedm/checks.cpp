// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "hdconj/numeric/tolerance.hpp"
#include "hdconj/wedm/planes.hpp"
#include "segment_grid.hpp"

namespace hdconj {
namespace {

using detail::SegmentGrid;

/// "12.3456": enough digits to find the place.
std::string text(double value)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(6);
    out << value;
    return out.str();
}

std::string text(Vec2 const& p)
{
    return "(" + text(p.x()) + ", " + text(p.y()) + ") mm";
}

std::string name(WirePass const& pass)
{
    return "pass " + std::to_string(pass.number);
}

/// Lead-in point, contour and stop: the path along the part; where it closes, its closing point is repeated.
std::vector<WireMove> contour_path(WirePass const& pass)
{
    std::vector<WireMove> path;
    for (WireMove const& move : pass.moves)
        if (move.tag == WireTag::lead_in || move.tag == WireTag::contour || move.tag == WireTag::stop)
            path.push_back(move);
    return path;
}

/// The same without the point that only the stop put there.
std::vector<WireMove> even_path(WirePass const& pass, int spaces)
{
    std::vector<WireMove> path = contour_path(pass);
    auto const count = static_cast<std::size_t>(spaces);
    auto const stop = std::find_if(path.begin(), path.end(), [](WireMove const& m) { return m.tag == WireTag::stop; });
    if (stop != path.end() && path.size() % count != 1 % count)
        path.erase(stop);
    if (spaces < 1 || path.size() < count + 1 || (path.size() - 1) % count != 0)
        throw std::invalid_argument("the moves of pass " + std::to_string(pass.number) + " are not those of " + std::to_string(spaces) + " equal tooth spaces");
    if (pass.reversed)
        std::reverse(path.begin(), path.end());
    return path;
}

std::vector<Vec2> section(PairedPath const& path, WireMachine const& machine, double share)
{
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < path.size(); ++i)
        points.push_back(at_height(machine, {path.lower[i], path.upper[i]}, share * machine.thickness));
    return points;
}

SegmentGrid neighbourhood(std::vector<Vec2> const& pitch, WireFaces const& faces)
{
    return {with_neighbours(pitch, faces, pitch.size() - 1), false};
}

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
    for (double const share : one ? std::vector<double>{0.0} : std::vector<double>{0.0, 0.5, 1.0})
    {
        std::string const place = what + " at z = " + text(share * machine.thickness) + " mm";
        std::vector<Vec2> const points = section(path, machine, share);
        if (points.size() < 3)
        {
            failures.push_back({"crossing", place + " has " + std::to_string(points.size()) + " points: no contour"});
            continue;
        }
        auto const [i, j] = SegmentGrid(points, closed).crossing();
        if (i != j)
            failures.push_back({"crossing", place + " crosses itself at " + text(points[i]) + ": moves " + std::to_string(i) + " and " + std::to_string(j)});
        if ((signed_area(points) > 0) == clockwise)
            failures.push_back({"crossing", place + (clockwise ? " goes counter-clockwise" : " goes clockwise")});
    }
}

}  // namespace

PairedPath pitch_of(WirePass const& pass, WireProgram const& program)
{
    std::vector<WireMove> const path = even_path(pass, program.spaces());
    std::size_t const steps = (path.size() - 1) / static_cast<std::size_t>(program.spaces());
    PairedPath pitch;
    // the point behind the first belongs to the first space either way round
    int const space = path[1].tooth;
    for (std::size_t i = 0; i <= steps; ++i)
        pitch.add(turned_to(path[i].lower, -space, program.teeth), turned_to(path[i].upper, -space, program.teeth));
    return pitch;
}

WireFailures check_numbers(WireProgram const& program)
{
    WireFailures failures;
    WireMachine const& m = program.machine;
    auto const need = [&](bool good, std::string const& what, double value) {
        if (!good || !std::isfinite(value))
            failures.push_back({"numbers", what + " is " + text(value) + " mm"});
    };
    need(m.thickness > 0, "thickness of the workpiece", m.thickness);
    need(m.lower_guide >= 0, "lower guide", m.lower_guide);
    need(m.upper_guide >= 0, "upper guide", m.upper_guide);
    need(program.wire_diameter > 0, "wire diameter", program.wire_diameter);
    need(program.spark_gap >= 0, "spark gap", program.spark_gap);
    need(program.tolerance > 0, "tolerance", program.tolerance);
    for (WirePass const& pass : program.passes)
    {
        double const expected = program.wire_diameter / 2 + program.spark_gap + pass.stock;
        need(pass.stock >= 0, "stock of " + name(pass), pass.stock);
        need(std::abs(pass.offset - expected) <= 64 * unit_roundoff * expected, "offset of " + name(pass), pass.offset);
    }
    if (program.passes.empty() || program.passes.back().stock != 0)
        failures.push_back({"numbers", "no pass leaves the nominal part"});
    auto const finite = [](Vec2 const& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); };
    bool const contour = std::all_of(program.nominal.lower.begin(), program.nominal.lower.end(), finite)
                         && std::all_of(program.nominal.upper.begin(), program.nominal.upper.end(), finite);
    if (!contour)
        failures.push_back({"numbers", "a point of the nominal contour is not finite"});
    for (WirePass const& pass : program.passes)
        if (!std::all_of(pass.moves.begin(), pass.moves.end(), [&](WireMove const& move) { return finite(move.lower) && finite(move.upper); }))
            failures.push_back({"numbers", "a move of " + name(pass) + " is not finite"});
    return failures;
}

WireFailures check_pairing(WireProgram const& program)
{
    WireFailures failures;
    PairedContour const& nominal = program.nominal;
    if (nominal.lower.size() != nominal.upper.size())
        failures.push_back({"pairing", "the nominal contour has " + std::to_string(nominal.lower.size()) + " points below and " + std::to_string(nominal.upper.size()) + " above"});
    bool const rising = std::adjacent_find(nominal.sync.begin(), nominal.sync.end(), std::greater_equal<>()) == nominal.sync.end();
    if (!rising || (!nominal.sync.empty() && nominal.sync.back() >= nominal.lower.size()))
        failures.push_back({"pairing", "the sync marks of the nominal contour do not increase"});
    for (std::size_t i = 1; i < std::min(nominal.lower.size(), nominal.upper.size()); ++i)
        if (nominal.lower[i] == nominal.lower[i - 1] || nominal.upper[i] == nominal.upper[i - 1])
            failures.push_back({"pairing", "points " + std::to_string(i - 1) + " and " + std::to_string(i) + " of the nominal contour are one point in one face"});
    for (WirePass const& pass : program.passes)
    {
        if (pass.moves.size() < 2)
        {
            failures.push_back({"pairing", name(pass) + " has no moves"});
            continue;
        }
        WireMove const& first = pass.moves.front();
        WireMove const& last = pass.moves.back();
        bool const vertical = first.lower == first.upper && last.lower == last.upper;
        bool const apart = program.closed() && first.lower != last.lower;
        if (!vertical || apart || first.tag != WireTag::thread || last.tag != WireTag::lead_out)
            failures.push_back({"pairing", name(pass) + " does not begin and end in the start hole with the wire vertical"});
        for (std::size_t i = 1; i < pass.moves.size(); ++i)
            if (pass.moves[i].lower == pass.moves[i - 1].lower || pass.moves[i].upper == pass.moves[i - 1].upper)
                failures.push_back({"pairing", "move " + std::to_string(i) + " of " + name(pass) + " has length zero in one face, at " + text(pass.moves[i].lower)});
        std::vector<WireMove> const path = contour_path(pass);
        if (program.closed() && (path.front().lower != path.back().lower || path.front().upper != path.back().upper))
            failures.push_back({"pairing", name(pass) + " does not close: from " + text(path.front().lower) + " to " + text(path.back().lower)});
    }
    return failures;
}

WireFailures check_crossings(WireProgram const& program)
{
    WireFailures failures;
    check_round({"the nominal contour", {program.nominal.lower, program.nominal.upper}, true, program.external}, program.machine, failures);
    for (WirePass const& pass : program.passes)
    {
        PairedPath path;
        for (WireMove const& move : contour_path(pass))
            path.add(move.lower, move.upper);
        if (program.closed())
        {
            path.lower.pop_back();
            path.upper.pop_back();
        }
        check_round({name(pass), path, program.closed(), program.external != pass.reversed}, program.machine, failures);
    }
    return failures;
}

WireFailures check_sweep(WireFaces const& faces, WireProgram& program)
{
    WireFailures failures;
    std::array<SegmentGrid, 2> const part{neighbourhood(faces.pitch.lower, faces), neighbourhood(faces.pitch.upper, faces)};
    for (WirePass const& pass : program.passes)
    {
        PairedPath const path = pitch_of(pass, program);
        double worst = 0;
        Vec2 place = Vec2::Zero();
        for (std::size_t f = 0; f < 2; ++f)
        {
            std::vector<Vec2> const& points = f == 0 ? path.lower : path.upper;
            for (std::size_t i = 0; i < points.size(); ++i)
            {
                for (Vec2 const& p : {points[i], Vec2(0.5 * (points[i] + points[i == 0 ? 0 : i - 1]))})
                {
                    double const error = std::abs(part[f].distance(p) - pass.offset);
                    place = error > worst ? p : place;
                    worst = std::max(worst, error);
                }
            }
        }
        program.figures.face_error = std::max(program.figures.face_error, worst);
        if (!(worst <= program.tolerance))
            failures.push_back({"sweep", name(pass) + " is " + text(worst) + " mm from its distance " + text(pass.offset) + " mm to the part at " + text(place)
                                             + " of space 0, and the tolerance is " + text(program.tolerance) + " mm"});
    }
    return failures;
}

WireFailures check_sections(WireFaces const& faces, std::vector<std::vector<char>> const& residual_at, double limit, WireProgram& program)
{
    WireFailures failures;
    WireFigures& figures = program.figures;
    for (SectionBetween const& between : faces.between)
    {
        std::string const place = " at z = " + text(between.share * program.machine.thickness) + " mm";
        SegmentGrid const rulings = neighbourhood(section(faces.pitch, program.machine, between.share), faces);
        double ruling = 0;
        for (Vec2 const& p : between.points)
            ruling = std::max(ruling, rulings.distance(p));
        figures.ruling_error = std::max(figures.ruling_error, ruling);
        for (std::size_t n = 0; n < program.passes.size(); ++n)
        {
            WirePass const& pass = program.passes[n];
            SegmentGrid const wire = neighbourhood(section(pitch_of(pass, program), program.machine, between.share), faces);
            double worst = 0;
            Vec2 where = Vec2::Zero();
            for (std::size_t i = 0; i < between.points.size(); ++i)
            {
                double const error = wire.distance(between.points[i]) - pass.offset;
                double const counted = residual_at[n][i] != 0 ? std::max(0.0, -error) : std::abs(error);
                where = counted > worst ? between.points[i] : where;
                worst = std::max(worst, counted);
            }
            figures.middle_error = std::max(figures.middle_error, worst);
            if (!(worst <= limit))
                failures.push_back({"sections", name(pass) + " is " + text(worst) + " mm from the true section" + place + ", at " + text(where) + "; straight rulings are "
                                                    + text(ruling) + " mm from it, the rest is twist along them; accepted are " + text(limit) + " mm (surface_limit)"});
        }
    }
    return failures;
}

WireFailures check_rulings(WireProgram& program)
{
    WireFailures failures;
    auto const ask = [&](std::string const& what, Vec2 const& low, Vec2 const& up, Vec2 const& at) {
        if (!(low.dot(up) > 0))
            failures.push_back({"rulings", what + " goes opposite ways in the two faces at " + text(at)});
        return std::atan2(std::abs(cross(low, up)), low.dot(up));
    };
    PairedContour const& nominal = program.nominal;
    for (std::size_t i = 1; i < nominal.lower.size(); ++i)
    {
        double const angle = ask("the nominal contour", nominal.lower[i] - nominal.lower[i - 1], nominal.upper[i] - nominal.upper[i - 1], nominal.lower[i]);
        program.figures.normal_angle = std::max(program.figures.normal_angle, angle);
    }
    for (WirePass const& pass : program.passes)
    {
        for (std::size_t i = 2; i + 1 < pass.moves.size(); ++i)
        {
            WireMove const& from = pass.moves[i - 1];
            WireMove const& to = pass.moves[i];
            (void)ask(name(pass), to.lower - from.lower, to.upper - from.upper, to.lower);
        }
    }
    return failures;
}

WireFailures check_machine(MachineLimits const& limits, WireProgram& program)
{
    program.figures = measured(program);
    WireFigures const& figures = program.figures;
    WireFailures failures;
    if (figures.tilt > limits.tilt)
        failures.push_back({"machine", "the wire would be tilted by " + text(figures.tilt) + " rad, and the machine tilts it by " + text(limits.tilt)
                                           + " rad at most (wedm.largest_tilt_deg)"});
    if (figures.travel > limits.travel)
        failures.push_back({"machine", "a guide would travel " + text(figures.travel) + " mm from the start hole, and the machine " + text(limits.travel)
                                           + " mm at most (wedm.largest_travel)"});
    if (figures.uv_travel > limits.uv_travel)
        failures.push_back({"machine", "the upper guide would stand " + text(figures.uv_travel) + " mm off the lower one along an axis, and the machine moves it by "
                                           + text(limits.uv_travel) + " mm at most (wedm.largest_uv_travel)"});
    return failures;
}

WireFailures check_start(WireProgram const& program)
{
    WireFailures failures;
    for (WirePass const& pass : program.passes)
    {
        Vec2 const hole = pass.moves.front().lower;
        Vec2 const out = pass.moves.back().lower;
        Vec2 const to[2] = {pass.moves[1].lower, pass.moves[1].upper};
        Vec2 const from[2] = {pass.moves[pass.moves.size() - 2].lower, pass.moves[pass.moves.size() - 2].upper};
        for (std::size_t f = 0; f < 2; ++f)
        {
            std::string const face = f == 0 ? " in the lower face" : " in the upper face";
            double clear = std::numeric_limits<double>::infinity();
            double way = clear;
            for (Vec2 const& p : f == 0 ? program.nominal.lower : program.nominal.upper)
            {
                clear = std::min({clear, (p - hole).norm(), (p - out).norm()});
                way = std::min({way, detail::distance_to_segment(p, hole, to[f]), detail::distance_to_segment(p, from[f], out)});
            }
            if (!(clear >= pass.offset + program.start_hole_radius))
                failures.push_back({"start", "the start hole's centre is " + text(clear) + " mm from the part" + face + ", and " + name(pass) + " needs "
                                                 + text(pass.offset + program.start_hole_radius) + " mm"});
            if (!(way >= pass.offset - program.tolerance))
                failures.push_back({"start", "lead-in or lead-out of " + name(pass) + " come within " + text(way) + " mm of the part" + face + ", and the offset is "
                                                 + text(pass.offset) + " mm"});
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
        for (std::size_t i = 0; i < (closed ? path.size() : path.size() - steps); ++i)
        {
            std::size_t const j = (i + steps) % path.size();
            WirePoints const here = guides_of(m, {path.lower[i], path.upper[i]});
            WirePoints const next = guides_of(m, {path.lower[j], path.upper[j]});
            scale = std::max({scale, here.lower.norm(), here.upper.norm()});
            worst = std::max({worst, (turned_to(here.lower, next_space, program.teeth) - next.lower).norm(),
                              (turned_to(here.upper, next_space, program.teeth) - next.upper).norm()});
        }
        double const allowed = Tolerance{program.tolerance, scale * (1 + 2 * (m.lower_guide + m.upper_guide) / m.thickness)}.roundoff();
        if (path.size() % static_cast<std::size_t>(spaces) != 0 || !(worst <= allowed))
            failures.push_back({"pitches", what + " is not the same in every tooth space: guides differ by " + text(worst) + " mm"});
    };
    ask("the nominal contour", {program.nominal.lower, program.nominal.upper}, program.teeth, true);
    for (WirePass const& pass : program.passes)
    {
        PairedPath path;
        for (WireMove const& move : even_path(pass, program.spaces()))
            path.add(move.lower, move.upper);
        path.lower.pop_back();
        path.upper.pop_back();
        ask(name(pass), path, program.spaces(), program.closed());
    }
    return failures;
}

WireFailures check_untilted(WireProgram const& program)
{
    WireFailures failures;
    if (program.nominal.lower != program.nominal.upper)
        return failures;
    for (WirePass const& pass : program.passes)
        if (!std::all_of(pass.moves.begin(), pass.moves.end(), [](WireMove const& move) { return move.lower == move.upper; }))
            failures.push_back({"untilted", "both faces of the part are the same, but not those of " + name(pass)});
    return failures;
}

std::vector<std::string> skim_warnings(WireProgram const& program)
{
    std::vector<std::string> warnings;
    for (std::size_t k = 0; k + 1 < program.passes.size(); ++k)
    {
        WirePass const& pass = program.passes[k];
        double const layer = pass.stock - program.passes[k + 1].stock;
        double highest = 0;
        for (Residual const& residual : program.residuals)
            highest = std::max(highest, residual.pass == pass.number ? residual.height : 0);
        if (highest > layer)
            warnings.push_back(name(pass) + " leaves up to " + text(highest) + " mm on top of its stock where it cannot follow the contour, more than the layer of " + text(layer)
                               + " mm that " + name(program.passes[k + 1]) + " is to take: there it cuts " + text(highest + layer) + " mm deep");
    }
    return warnings;
}

double guide_chord_error(PairedPath const& path, std::vector<std::size_t> const& kept, WireMachine const& machine)
{
    PairedPath guides;
    for (std::size_t i = 0; i < path.size(); ++i)
    {
        WirePoints const at = guides_of(machine, {path.lower[i], path.upper[i]});
        guides.add(at.lower, at.upper);
    }
    double worst = 0;
    for (std::size_t n = 1; n < kept.size(); ++n)
        for (std::size_t k = kept[n - 1] + 1; k < kept[n]; ++k)
            worst = std::max(worst, from_move(guides, k, kept[n - 1], kept[n]));
    return worst;
}

double constant_taper_error(WireFaces const& faces)
{
    std::vector<Vec2> const& low = faces.pitch.lower;
    if (low == faces.pitch.upper)
        return 0;
    SegmentGrid const upper = neighbourhood(faces.pitch.upper, faces);
    double const shift = faces.pitch.upper.front().norm() - low.front().norm();
    double worst = 0;
    for (std::size_t i = 1; i < low.size(); ++i)
    {
        if (faces.meshing[i] == 0 || faces.meshing[i - 1] == 0)
            continue;
        Vec2 const out = right_of((low[i] - low[i - 1]).normalized());
        Vec2 const moved = 0.5 * (low[i - 1] + low[i]) + shift * out;
        // inside the tip circle of the upper face the tip land, moved as well, has taken it away
        if (moved.norm() >= faces.pitch.upper.front().norm())
            worst = std::max(worst, upper.distance(moved));
    }
    return worst;
}

}  // namespace hdconj
