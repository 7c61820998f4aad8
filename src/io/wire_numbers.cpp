// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hdconj {
namespace {

FaceRadii radii_of(std::vector<Vec2> const& contour)
{
    FaceRadii radii{std::numeric_limits<double>::infinity(), 0};
    for (auto const& point : contour) {
        radii.inner = std::min(radii.inner, point.norm());
        radii.outer = std::max(radii.outer, point.norm());
    }
    return contour.empty() ? FaceRadii{} : radii;
}

PassFigures figures_of(WirePass const& pass)
{
    PassFigures figures;
    figures.shortest = pass.moves.size() > 1 ? std::numeric_limits<double>::infinity() : 0;
    for (std::size_t i = 0; i < pass.moves.size(); ++i) {
        auto const& move = pass.moves[i];
        figures.largest_lean = std::max(figures.largest_lean, (move.upper - move.lower).norm());
        if (i > 0) {
            double const lower = (move.lower - pass.moves[i - 1].lower).norm();
            double const upper = (move.upper - pass.moves[i - 1].upper).norm();
            ++figures.blocks;
            figures.length += lower;
            figures.shortest = std::min({figures.shortest, lower, upper});
        }
    }
    return figures;
}

}  // namespace

WireNumbers::WireNumbers(WireProgram const& program)
    : lower(radii_of(program.nominal.lower)), upper(radii_of(program.nominal.upper))
{
    auto const& nominal = program.nominal;
    std::size_t const count = std::min(nominal.lower.size(), nominal.upper.size());
    least_shift = count > 0 ? std::numeric_limits<double>::infinity() : 0;
    for (std::size_t k = 0; k < count; ++k) {
        double const shift = (nominal.upper[k] - nominal.lower[k]).norm();
        face_shift = std::max(face_shift, shift);
        least_shift = std::min(least_shift, shift);
    }
    double lean = face_shift;
    for (auto const& pass : program.passes) {
        passes.push_back(figures_of(pass));
        lean = std::max(lean, passes.back().largest_lean);
        for (auto const& residual : program.residuals) {
            if (residual.pass == pass.number) {
                passes.back().residual = std::max(passes.back().residual, residual.height);
                ++passes.back().residuals;
            }
        }
    }
    meshing_residual = std::any_of(program.residuals.begin(), program.residuals.end(), [](auto const& each) { return each.meshing; });
    auto const& machine = program.machine;
    guide_offset = machine.guide_distance() / machine.thickness * lean;
    largest_tilt = std::atan2(lean, machine.thickness);
    ellipse = program.wire_diameter / 2 * (1 / std::cos(largest_tilt) - 1);
}

std::string WireNumbers::larger_face() const
{
    double const change = (upper.inner + upper.outer) - (lower.inner + lower.outer);
    double const rounding = 4 * std::numeric_limits<double>::epsilon() * (lower.inner + lower.outer);
    return std::abs(change) <= rounding ? "as the lower face" : change < 0 ? "SMALLER than the lower face" : "LARGER than the lower face";
}

}  // namespace hdconj
