// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hdconj/numeric/error.hpp"

namespace hdconj {
namespace {

constexpr char const* stage = "wire files";

void require(bool holds, std::string const& place, char const* cause)
{
    if (!holds) {
        throw NumericalError(stage, place, std::string(cause) + ": nothing was written");
    }
}

bool finite(Vec2 const& point)
{
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

void check_set_up(WireProgram const& program)
{
    auto const& machine = program.machine;
    require(machine.thickness > 0 && std::isfinite(machine.guide_distance()), "workpiece", "its thickness must be a positive number");
    require(machine.lower_guide >= 0 && machine.upper_guide >= 0, "guides", "a guide lies inside the workpiece");
    require(program.wire_diameter > 0 && std::isfinite(program.wire_diameter), "wire", "its diameter must be a positive number");
    require(program.spark_gap >= 0 && std::isfinite(program.spark_gap), "spark gap", "it must not be negative");
    require(!program.passes.empty(), "passes", "there is none");
}

void check_nominal(PairedContour const& nominal)
{
    constexpr std::size_t least = 3;
    require(nominal.lower.size() == nominal.upper.size(), "contour", "the faces have different numbers of points");
    require(nominal.lower.size() >= least, "contour", "it encloses nothing");
    require(std::all_of(nominal.lower.begin(), nominal.lower.end(), finite) && std::all_of(nominal.upper.begin(), nominal.upper.end(), finite),
            "contour", "a point is not finite");
    bool const rising = std::adjacent_find(nominal.sync.begin(), nominal.sync.end(), std::greater_equal<>()) == nominal.sync.end();
    require(rising && (nominal.sync.empty() || nominal.sync.back() < nominal.lower.size()), "contour", "its sync marks are not in order");
}

void check_pass(WireProgram const& program, WirePass const& pass, std::size_t index)
{
    std::string const place = fmt::format("pass {}", pass.number);
    constexpr std::size_t least = 5;  // start, lead-in, two on the contour, back
    require(pass.number == static_cast<int>(index) + 1, place, "passes are not numbered 1, 2, 3 ...");
    require(pass.moves.size() >= least, place, "it goes nowhere");
    auto const& first = pass.moves.front();
    auto const& last = pass.moves.back();
    require(first.tag == WireTag::thread && last.tag == WireTag::lead_out, place, "it does not begin and end at the start hole");
    require(first.lower == first.upper && last.lower == last.upper, place, "the wire leans at the start hole");
    require(!program.closed() || first.lower == last.lower, place, "it does not end where it began");
    require(std::all_of(pass.moves.begin(), pass.moves.end(), [](auto const& move) { return finite(move.lower) && finite(move.upper); }),
            place, "a point is not finite");
    constexpr double rounding = 1e-12;  // [mm]
    double const offset = program.wire_diameter / 2 + program.spark_gap + pass.stock;
    require(pass.stock >= 0 && std::abs(pass.offset - offset) <= rounding, place, "its offset is not wire radius, spark gap and stock");
}

}  // namespace

void check_program(WireProgram const& program)
{
    check_set_up(program);
    check_nominal(program.nominal);
    for (std::size_t i = 0; i < program.passes.size(); ++i) {
        check_pass(program, program.passes[i], i);
    }
}

void check_text(WirePost const& post, WireText const& file)
{
    std::size_t line = 1, column = 0;
    bool comment = false;
    auto const refuse = [&](std::string const& cause) {
        throw NumericalError(stage, fmt::format("{}, line {}", file.name, line), cause + ": nothing was written");
    };
    for (char const c : file.text) {
        if (c == '\n') {
            ++line;
            column = 0;
            comment = false;
            continue;
        }
        if (++column > post.longest_line) {
            refuse(fmt::format("more than {} characters", post.longest_line));
        }
        comment = comment || c == '(';
        bool const printable = c >= ' ' && c <= '~';
        if (!printable || (!comment && !post.alphabet.empty() && post.alphabet.find(c) == std::string_view::npos)) {
            refuse(fmt::format("character {} does not belong into {}", static_cast<int>(static_cast<unsigned char>(c)), post.dialect.name));
        }
        comment = comment && c != ')';
    }
    if (column != 0) {
        refuse("the file ends in the middle of a line");
    }
}

double check_paths(WirePost const& post, WireProgram const& program, std::vector<FacePath> const& read)
{
    auto const exact = post.exact(program);
    std::string const place(post.dialect.name);
    require(read.size() == exact.size(), place, "passes are missing when it is read back");
    double const allowed = post.allowed != nullptr ? post.allowed(program) : post.unit(program);
    bool const untilted = is_untilted(program);
    double drift = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        std::string const which = fmt::format("{}, {}", place, exact[i].what);
        require(read[i].lower.size() == exact[i].lower.size() && read[i].upper.size() == exact[i].upper.size(), which,
                "points are missing when it is read back");
        require(!untilted || read[i].lower == read[i].upper, which, "without a tilt both planes must be the same");
        for (std::size_t k = 0; k < exact[i].lower.size(); ++k) {
            Vec2 const lower = read[i].lower[k] - exact[i].lower[k], upper = read[i].upper[k] - exact[i].upper[k];
            require(lower.cwiseAbs().maxCoeff() <= allowed && upper.cwiseAbs().maxCoeff() <= allowed, fmt::format("{}, point {}", which, k),
                    "what is read back is further from the exact point than one unit of the last digit");
            drift = std::max({drift, lower.norm(), upper.norm()});
        }
    }
    return drift;
}

}  // namespace hdconj
