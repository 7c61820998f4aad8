// SPDX-License-Identifier: GPL-3.0-or-later
#include "pitch_pass.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "checks.hpp"
#include "passes.hpp"

namespace hdconj::wedm {
namespace {

/// The marks, and the points nearest to the axis and farthest from it: radii are told to what the contour was solved
/// to, however few of its points are kept.
std::vector<std::size_t> with_extremes(WireFaces const& faces)
{
    std::vector<std::size_t> keep = faces.marks;
    for (bool const upper : {false, true}) {
        std::vector<Vec2> const& face = faces.pitch.face(upper);
        auto const [inner, outer] =
            std::ranges::minmax_element(face, {}, [](Vec2 const& p) { return p.squaredNorm(); });
        keep.push_back(static_cast<std::size_t>(inner - face.begin()));
        keep.push_back(static_cast<std::size_t>(outer - face.begin()));
    }
    std::sort(keep.begin(), keep.end());
    keep.erase(std::unique(keep.begin(), keep.end()), keep.end());
    return keep;
}

/// What stands in the programs of all set-ups; no passes yet.
WireProgram blank_program(WireJob const& job)
{
    WireFaces const& faces = job.faces;
    WireProgram program;
    program.name = job.name;
    program.machine = job.machine;
    program.wire_diameter = job.wire.wire_diameter;
    program.spark_gap = job.wire.spark_gap;
    program.decimals = job.wire.decimals;
    program.tolerance = job.wire.tolerance;
    program.stop = job.wire.stop;
    program.start_hole_radius = job.wire.start_hole_radius;
    program.teeth = faces.teeth;
    program.external = faces.external;
    program.surface = job.surface;
    program.tilt_kind = job.tilt_kind;
    program.contour_error = job.contour_error;
    program.residual_error = job.residual_error();
    program.nominal =
        whole_contour(faces, thinned(faces.pitch, share_of_moves * job.wire.tolerance, with_extremes(faces)));
    LargestDistance const taper = constant_taper_error(faces);
    program.figures.constant_taper_error = taper.value;
    program.figures.constant_taper_spread = taper.spread;
    return program;
}

/// How the passes of a set-up run; direction and stop are those of the first.
WireRun run_of(WireJob const& job, WireSetUp const& set_up)
{
    WireFaces const& faces = job.faces;
    bool const closed = set_up.of == 1;
    int const start = closed ? job.wire.start : set_up.first;
    WireRun run;
    run.start = start;
    run.hole = hole_beside(faces, start, false, job.wire.lead_in);
    run.overlap = job.wire.overlap;
    run.least = least_block(job.wire.decimals);
    if (!closed) {
        run.spaces = set_up.spaces;
        run.end = hole_beside(faces, faces.space_in_order(start, set_up.spaces - 1), true, job.wire.lead_in);
    }
    return run;
}

/// Adds the pass number @p number along all spaces of the set-up, and what it leaves in each.
void add_pass(WireProgram& program, WireFaces const& faces, PitchPass const& pitch, WireRun const& run, int number)
{
    WirePass pass = wire_pass(pitch.path, faces, run);
    pass.number = number;
    pass.offset = pitch.offset;
    pass.stock = pitch.stock;
    for (int i = 0; i < program.spaces(); ++i) {
        int const space = program.closed() ? i : faces.space_in_order(run.start, i);
        for (Residual residual : pitch.uncut.residuals) {
            residual.pass = number;
            residual.tooth = space;
            residual.where = turned_to(residual.where, space, faces.teeth);
            program.residuals.push_back(residual);
        }
    }
    program.figures.guide_chord = std::max(program.figures.guide_chord, pitch.guide_chord);
    program.passes.push_back(std::move(pass));
}

MachineLimits limits_of(WireRequest const& wire)
{
    constexpr double no_limit = std::numeric_limits<double>::infinity();
    return {wire.largest_tilt, wire.largest_travel.value_or(no_limit), wire.largest_uv_travel.value_or(no_limit),
            wire.lead_in};
}

}  // namespace

WireProgram set_up_program(WireJob const& job, std::vector<PitchPass> const& passes, WireSetUp const& set_up)
{
    WireProgram program = blank_program(job);
    program.set_up = set_up;
    WireRun run = run_of(job, set_up);
    std::vector<std::vector<char>> uncut_at;
    for (std::size_t k = 0; k < passes.size(); ++k) {
        run.reversed = job.wire.alternating && k % 2 == 1;
        run.stop_before = k == 0 ? job.wire.stop_before : 0;
        add_pass(program, job.faces, passes[k], run, static_cast<int>(k) + 1);
        uncut_at.push_back(passes[k].uncut.at);
    }
    program.figures = measured(program);
    check_all(job.faces, uncut_at, std::max(job.wire.surface_limit.value_or(0), job.wire.tolerance),
              limits_of(job.wire), program);
    program.warnings = skim_warnings(program);
    std::ranges::copy(
        short_block_warnings(program, [&](WirePass const& pass) { return fitting_decimals(job, pass.offset); }),
        std::back_inserter(program.warnings));
    return program;
}

WireSetUps half_programs(WireJob const& job, std::vector<PitchPass> const& passes)
{
    int const spaces = job.faces.teeth, more = spaces - spaces / 2, start = job.wire.start;
    WireProgram const second = set_up_program(job, passes, {2, 2, (start + more) % spaces, spaces / 2, false});
    return {set_up_program(job, passes, {1, 2, start, more, false}), turned_half(second)};
}

}  // namespace hdconj::wedm
