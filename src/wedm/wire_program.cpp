// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planes.hpp"

namespace hdconj {
namespace {

FaceRadii radii_of(std::vector<Vec2> const& contour)
{
    if (contour.empty())
        return {};
    auto const [inner, outer] = std::ranges::minmax(contour, {}, [](Vec2 const& point) { return point.norm(); });
    return {inner.norm(), outer.norm()};
}

PassFigures pass_figures(WirePass const& pass)
{
    PassFigures figures;
    figures.shortest = pass.moves.size() > 1 ? std::numeric_limits<double>::infinity() : 0;
    for (std::size_t i = 1; i < pass.moves.size(); ++i) {
        double const lower = (pass.moves[i].lower - pass.moves[i - 1].lower).norm();
        double const upper = (pass.moves[i].upper - pass.moves[i - 1].upper).norm();
        ++figures.blocks;
        figures.length += lower;
        figures.shortest = std::min({figures.shortest, lower, upper});
    }
    return figures;
}

void measure_wire(WireProgram const& program, WireFigures& figures)
{
    double lean = 0;
    for (WirePass const& pass : program.passes) {
        for (WireMove const& move : pass.moves) {
            Vec2 const hole = pass.moves.front().lower;
            wedm::WirePoints const guides = wedm::guides_of(program.machine, {move.lower, move.upper});
            Vec2 const off = guides.upper - guides.lower;
            lean = std::max(lean, (move.upper - move.lower).norm());
            figures.guide_shift = std::max(figures.guide_shift, off.norm());
            figures.uv_travel = std::max(figures.uv_travel, off.cwiseAbs().maxCoeff());
            figures.travel = std::max({figures.travel, (guides.lower - hole).cwiseAbs().maxCoeff(),
                                       (guides.upper - hole).cwiseAbs().maxCoeff()});
        }
    }
    figures.tilt = std::atan2(lean, program.machine.thickness);
    figures.ellipse = (program.wire_diameter / 2 + program.spark_gap) * (1 / std::cos(figures.tilt) - 1);
}

void measure_residuals(WireProgram const& program, WireFigures& figures)
{
    for (Residual const& residual : program.residuals) {
        for (std::size_t i = 0; i < program.passes.size(); ++i) {
            if (program.passes[i].number != residual.pass)
                continue;
            figures.passes[i].residual = std::max(figures.passes[i].residual, residual.height);
            ++figures.passes[i].residuals;
            if (i + 1 == program.passes.size()) {
                figures.residual = std::max(figures.residual, residual.height);
                figures.meshing_residual = std::max(figures.meshing_residual, residual.meshing ? residual.height : 0);
            }
        }
    }
}

}  // namespace

WireFigures measured(WireProgram const& program)
{
    WireFigures figures = program.figures;
    PairedContour const& nominal = program.nominal;
    figures.lower = radii_of(nominal.lower);
    figures.upper = radii_of(nominal.upper);
    std::size_t const count = std::min(nominal.lower.size(), nominal.upper.size());
    figures.face_shift = figures.guide_shift = figures.travel = figures.uv_travel = figures.residual =
        figures.meshing_residual = 0;
    figures.least_shift = count > 0 ? std::numeric_limits<double>::infinity() : 0;
    for (std::size_t k = 0; k < count; ++k) {
        double const shift = (nominal.upper[k] - nominal.lower[k]).norm();
        figures.face_shift = std::max(figures.face_shift, shift);
        figures.least_shift = std::min(figures.least_shift, shift);
    }
    figures.passes.clear();
    for (WirePass const& pass : program.passes) {
        figures.passes.push_back(pass_figures(pass));
        figures.passes.back().residual_error = program.residual_error;
    }
    measure_wire(program, figures);
    measure_residuals(program, figures);
    return figures;
}

bool is_untilted(WireProgram const& program)
{
    auto const same = [](WireMove const& move) { return move.lower == move.upper; };
    return program.nominal.lower == program.nominal.upper &&
           std::ranges::all_of(program.passes,
                               [&](WirePass const& pass) { return std::ranges::all_of(pass.moves, same); });
}

WireProgram turned_half(WireProgram program)
{
    // 0 - x has no negative zero
    auto const turn = [](Vec2& p) { p = Vec2::Zero() - p; };
    std::ranges::for_each(program.nominal.lower, turn);
    std::ranges::for_each(program.nominal.upper, turn);
    for (WirePass& pass : program.passes) {
        std::ranges::for_each(pass.moves, turn, &WireMove::lower);
        std::ranges::for_each(pass.moves, turn, &WireMove::upper);
    }
    std::ranges::for_each(program.residuals, turn, &Residual::where);
    program.set_up.turned = !program.set_up.turned;
    return program;
}

}  // namespace hdconj
