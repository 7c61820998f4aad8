// SPDX-License-Identifier: GPL-3.0-or-later
// What a program says of itself: numbers, pairing, machine; and all checks together.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <Eigen/Geometry>

#include "base/text.hpp"
#include "checks.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "passes.hpp"

namespace hdconj::wedm {
namespace {

bool is_finite(Vec2 const& point)
{
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

void check_contour(PairedContour const& nominal, WireFailures& failures)
{
    constexpr std::size_t fewest = 3;
    if (nominal.lower.size() < fewest)
        failures.emplace_back("pairing: the nominal contour encloses nothing");
    if (nominal.lower.size() != nominal.upper.size())
        failures.push_back(fmt::format(
            "pairing: the faces of the nominal contour have different numbers of points, {} below and {} above",
            nominal.lower.size(), nominal.upper.size()));
    bool const rising =
        std::adjacent_find(nominal.sync.begin(), nominal.sync.end(), std::greater_equal<>()) == nominal.sync.end();
    if (!rising || (!nominal.sync.empty() && nominal.sync.back() >= nominal.lower.size()))
        failures.emplace_back("pairing: the sync marks of the nominal contour do not increase");
    for (std::size_t i = 1; i < std::min(nominal.lower.size(), nominal.upper.size()); ++i)
        if (nominal.lower[i] == nominal.lower[i - 1] || nominal.upper[i] == nominal.upper[i - 1])
            failures.push_back(
                fmt::format("pairing: points {} and {} of the nominal contour are one point in one face", i - 1, i));
}

/// Whether two points are further apart than rounding puts one point.
bool are_apart(Vec2 const& a, Vec2 const& b)
{
    constexpr double roundings = 64;
    return (a - b).norm() > roundings * unit_roundoff * std::max(a.norm(), b.norm());
}

void check_ends(WirePass const& pass, bool closed, WireFailures& failures)
{
    auto const fail = [&](std::string const& what) {
        failures.push_back(fmt::format("pairing: pass {} {}", pass.number, what));
    };
    WireMove const& first = pass.moves.front();
    WireMove const& last = pass.moves.back();
    if (first.tag != WireTag::thread || last.tag != WireTag::lead_out)
        fail("does not begin and end in the start hole");
    if (first.lower != first.upper || last.lower != last.upper)
        fail("leans at the start hole");
    if (closed && first.lower != last.lower)
        fail("does not end where it began");
    std::vector<WireMove> const path = contour_path(pass);
    bool const open = !path.empty() && (are_apart(path.front().lower, path.back().lower) ||
                                        are_apart(path.front().upper, path.back().upper));
    if (closed && open)
        fail(fmt::format("does not close: from {} to {}", place_text(path.front().lower),
                         place_text(path.back().lower)));
}

/// The next length in mm or angle in degrees that is told, above @p figure by more than its rounding.
double told_above(double figure)
{
    return (std::floor(figure * told_per_mm) + 1) / told_per_mm;
}

/// Where guides come along the part.
Eigen::AlignedBox2d reach_of(WireProgram const& program)
{
    Eigen::AlignedBox2d reach;
    for (WirePass const& pass : program.passes)
        for (std::size_t i = 1; i + 1 < pass.moves.size(); ++i) {
            WirePoints const guides = guides_of(program.machine, {pass.moves[i].lower, pass.moves[i].upper});
            reach.extend(guides.lower).extend(guides.upper);
        }
    return reach;
}

/// In a ring also the shortest lead-in that is enough for the machine, or, where none is, the travel from the axis,
/// which is the least.
void add_nearer_start(MachineLimits const& limits, WireProgram const& program, WireFailure& failure)
{
    std::vector<WireMove> const& moves = program.passes.front().moves;
    Vec2 const land = moves[1].lower.normalized();
    Eigen::AlignedBox2d const reach = reach_of(program);
    std::array const furthest{reach.max().x(), reach.max().y(), -reach.min().x(), -reach.min().y()};
    std::array const nearer{-land.x(), -land.y(), land.x(), land.y()};  // per length from the axis to the start hole
    double const on_axis = limits.lead_in + moves.front().lower.dot(land);
    constexpr double beside = 2 / told_per_mm;  // the axis, so that the lead-in is not told as longer than up to it
    double const least = told_above(*std::ranges::max_element(furthest) + beside);
    if (limits.travel < least) {
        failure.remedy += fmt::format(
            ", or at least wedm.largest_travel = {:.7g} together with wedm.lead_in = {:.7g}, which starts on the axis",
            least, told_above(on_axis - beside));
        return;
    }
    double from_axis = on_axis;
    for (std::size_t k = 0; k < furthest.size(); ++k)
        if (nearer[k] > 0)
            from_axis = std::min(from_axis, (limits.travel - furthest[k]) / nearer[k]);
    std::string const lead_in = fmt::format("{:.7g}", told_above(on_axis - from_axis));
    failure.remedy += fmt::format(", or wedm.lead_in = {}, which starts nearer to the axis", lead_in);
    failure.set = "wedm.lead_in=" + lead_in;
}

/// Throws if there are @p failures.
void throw_failures(WireFailures const& failures)
{
    if (failures.empty())
        return;
    constexpr std::size_t most_told = 20;
    std::vector<std::string> causes, remedies, set;
    auto const add_new = [](std::vector<std::string>& all, std::string const& each) {
        if (!each.empty() && std::ranges::find(all, each) == all.end())
            all.push_back(each);
    };
    for (WireFailure const& failure : failures) {
        if (causes.size() < most_told)
            causes.push_back(failure.cause);
        add_new(remedies, failure.remedy);
        add_new(set, failure.set);
    }
    if (failures.size() > most_told)
        causes.push_back(fmt::format("and {} more", failures.size() - most_told));
    throw NumericalError(ErrorCode::failed_check, "wedm",
                         fmt::format("{} check{} failed", failures.size(), failures.size() == 1 ? "" : "s"),
                         fmt::format("{}", fmt::join(causes, "; ")), fmt::format("{}", fmt::join(remedies, "; ")), set);
}

}  // namespace

WireFailures check_numbers(WireProgram const& program)
{
    WireFailures failures;
    WireMachine const& m = program.machine;
    auto const need = [&](bool good, std::string const& what, double value) {
        if (!good || !std::isfinite(value))
            failures.push_back(fmt::format("numbers: {} is {:.6g} mm", what, value));
    };
    need(m.thickness > 0, "thickness of the workpiece", m.thickness);
    need(m.lower_guide >= 0, "lower guide", m.lower_guide);
    need(m.upper_guide >= 0, "upper guide", m.upper_guide);
    need(program.wire_diameter > 0, "wire diameter", program.wire_diameter);
    need(program.spark_gap >= 0, "spark gap", program.spark_gap);
    for (WirePass const& pass : program.passes) {
        double const expected = program.wire_diameter / 2 + program.spark_gap + pass.stock;
        need(pass.stock >= 0, fmt::format("stock of pass {}", pass.number), pass.stock);
        need(std::abs(pass.offset - expected) <= 64 * unit_roundoff * expected,
             fmt::format("offset of pass {}", pass.number), pass.offset);
        if (!std::ranges::all_of(pass.moves, is_finite, &WireMove::lower) ||
            !std::ranges::all_of(pass.moves, is_finite, &WireMove::upper))
            failures.push_back(fmt::format("numbers: a move of pass {} is not finite", pass.number));
    }
    if (program.passes.empty() || program.passes.back().stock != 0)
        failures.emplace_back("numbers: no pass leaves the nominal part");
    if (!std::ranges::all_of(program.nominal.lower, is_finite) ||
        !std::ranges::all_of(program.nominal.upper, is_finite))
        failures.emplace_back("numbers: a point of the nominal contour is not finite");
    return failures;
}

WireFailures check_pairing(WireProgram const& program)
{
    WireFailures failures;
    check_contour(program.nominal, failures);
    for (std::size_t k = 0; k < program.passes.size(); ++k) {
        WirePass const& pass = program.passes[k];
        if (pass.number != static_cast<int>(k) + 1)
            failures.push_back(fmt::format("pairing: pass {} is not numbered {}", pass.number, k + 1));
        constexpr std::size_t fewest = 5;  // start, lead-in, two on the contour, back
        if (pass.moves.size() < fewest) {
            failures.push_back(fmt::format("pairing: pass {} goes nowhere", pass.number));
            continue;
        }
        check_ends(pass, program.closed(), failures);
        for (std::size_t i = 1; i < pass.moves.size(); ++i)
            if (pass.moves[i].lower == pass.moves[i - 1].lower || pass.moves[i].upper == pass.moves[i - 1].upper)
                failures.push_back(fmt::format("pairing: move {} of pass {} has no length in the {} plane, at {}", i,
                                               pass.number,
                                               pass.moves[i].lower == pass.moves[i - 1].lower ? "lower" : "upper",
                                               place_text(pass.moves[i].lower)));
    }
    return failures;
}

WireFailures check_machine(MachineLimits const& limits, WireProgram& program)
{
    program.figures = measured(program);
    WireFigures const& figures = program.figures;
    WireFailures failures;
    constexpr double rounding = 0x1p-40;  // relative, of points that were moved and turned
    // in the unit of the key @p key
    auto const check = [&](double figure, double limit, char const* what, char const* key) {
        if (figure > limit * (1 + rounding))
            failures.emplace_back(
                fmt::format("machine: {} ({})", fmt::format(fmt::runtime(what), figure, limit), key),
                fmt::format("write at least {} = {:.7g} for a machine that has it", key, told_above(figure)));
    };
    check(to_deg(figures.tilt), to_deg(limits.tilt),
          "the wire would be tilted by {:.7g} degrees, and the machine tilts it by {:.7g} degrees at most",
          "wedm.largest_tilt_deg");
    check(figures.travel, limits.travel,
          "a guide would travel {:.6g} mm from the start hole, and the machine {:.6g} mm at most",
          "wedm.largest_travel");
    if (figures.travel > limits.travel && !program.external)
        add_nearer_start(limits, program, failures.back());
    check(figures.uv_travel, limits.uv_travel,
          "the upper guide would stand {:.6g} mm off the lower one along an axis, and the machine moves it by {:.6g} "
          "mm at most",
          "wedm.largest_uv_travel");
    return failures;
}

WireFailures check_untilted(WireProgram const& program)
{
    WireFailures failures;
    if (program.nominal.lower == program.nominal.upper && !is_untilted(program))
        failures.emplace_back("untilted: both faces of the part are the same, but not those of all passes");
    return failures;
}

std::vector<std::string> skim_warnings(WireProgram const& program)
{
    std::vector<std::string> warnings;
    for (std::size_t k = 0; k + 1 < program.passes.size(); ++k) {
        WirePass const& pass = program.passes[k];
        WirePass const& next = program.passes[k + 1];
        double const layer = pass.stock - next.stock;
        double highest = 0;
        for (Residual const& residual : program.residuals)
            highest = std::max(highest, residual.pass == pass.number ? residual.height : 0);
        if (highest > layer)
            warnings.push_back(
                fmt::format("pass {} leaves up to {:.6g} mm on top of its stock where it cannot follow the contour, "
                            "more than the layer of {:.6g} mm that pass {} is to take: there it cuts {:.6g} mm deep",
                            pass.number, highest, layer, next.number, highest + layer));
    }
    return warnings;
}

std::string place_text(Vec2 const& point)
{
    return fmt::format("({:.6g}, {:.6g}) mm", point.x(), point.y());
}

void check_all(WireFaces const& faces, std::vector<std::vector<char>> const& residual_at, double limit,
               MachineLimits const& limits, WireProgram& program)
{
    WireFailures failures;
    auto const add = [&](WireFailures const& found) { failures.insert(failures.end(), found.begin(), found.end()); };
    if (!(program.tolerance > 0))
        failures.push_back(fmt::format("numbers: tolerance is {:.6g} mm", program.tolerance));
    add(check_numbers(program));
    add(check_pairing(program));
    throw_failures(failures);
    add(check_pitches(program));
    throw_failures(failures);
    add(check_crossings(program));
    add(check_sweep(faces, program));
    add(check_sections(faces, residual_at, limit, program));
    add(check_rulings(program));
    add(check_machine(limits, program));
    add(check_start(program));
    add(check_untilted(program));
    throw_failures(failures);
}

}  // namespace hdconj::wedm
