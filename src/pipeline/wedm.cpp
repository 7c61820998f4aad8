// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/wedm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "hdconj/numeric/error.hpp"
#include "hdconj/profile/builder.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/wedm/checks.hpp"
#include "hdconj/wedm/offset_path.hpp"
#include "hdconj/wedm/passes.hpp"
#include "hdconj/wedm/residual.hpp"
#include "wire_job.hpp"

namespace hdconj {
namespace {

using namespace detail;

/// Parts of the tolerance: chords of the moves, chords of arcs before thinning. The rest is for the outline, of which the tolerance is at least ten times
/// the error (wire_faults.cpp).
constexpr double share_of_moves = 0.8;
constexpr double share_of_arcs = 1.0 / 16;

/// Fewest slices that have one between the faces.
constexpr int with_middle = 3;

/// Wires that are sold: multiples of this, none thinner than that [mm].
constexpr double wire_step = 0.01;
constexpr double thinnest_wire = 0.02;

/// Where the wire of one pass cannot follow, on one pitch.
struct UncutOfPass
{
    std::vector<char> at;             ///< (n) 1: in either face
    std::vector<Residual> residuals;  ///< of space 0
};

void add_runs(WireFaces const& faces, std::vector<double> const& heights, bool upper, UncutOfPass& uncut)
{
    std::vector<Vec2> const& points = upper ? faces.pitch.upper : faces.pitch.lower;
    bool open = false;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        double const height = heights[i + 1];  // one more point before the pitch
        if (height <= 0)
        {
            open = false;
            continue;
        }
        uncut.at[i] = 1;
        bool const meshing = faces.meshing[i] != 0;
        if (!open || uncut.residuals.back().meshing != meshing)
            uncut.residuals.push_back({1, 0, points[i], upper, height, meshing});
        open = true;
        Residual& run = uncut.residuals.back();
        if (height > run.height)
        {
            run.height = height;
            run.where = points[i];
        }
    }
}

/// The edges of a residual, where heights have fallen to the tolerance in both faces but sections between may differ by a point.
void widen(std::vector<char>& at)
{
    std::vector<char> const narrow = at;
    for (std::size_t i = 1; i + 1 < at.size(); ++i)
        at[i] = narrow[i - 1] != 0 || narrow[i] != 0 || narrow[i + 1] != 0 ? 1 : 0;
}

UncutOfPass uncut_of(WireFaces const& faces, PairedPath const& wire, double offset, double tolerance)
{
    UncutOfPass uncut;
    uncut.at.assign(faces.pitch.size(), 0);
    for (bool const upper : {false, true})
    {
        std::vector<Vec2> const& points = upper ? faces.pitch.upper : faces.pitch.lower;
        std::vector<Vec2> const& path = upper ? wire.upper : wire.lower;
        auto const heights = uncut_heights(with_neighbours(points, faces, 1), with_neighbours(path, faces, path.size() - 1), offset, tolerance);
        add_runs(faces, heights, upper, uncut);
    }
    widen(uncut.at);
    return uncut;
}

/// A pass along tooth space 0.
struct PassOnPitch
{
    double offset = 0, stock = 0;
    PairedPath path;          ///< centre of the wire from mid-land to mid-land
    double guide_chord = 0;   ///< error of straight moves at the guides
    UncutOfPass uncut;
};

PairedPath with_ends(WireFaces const& faces)
{
    return {with_neighbours(faces.pitch.lower, faces, 1), with_neighbours(faces.pitch.upper, faces, 1)};
}

std::string in_ascii(std::string const& name)
{
    std::string ascii;
    for (char const c : name)
        ascii += c >= ' ' && c <= '~' ? c : '_';
    return ascii;
}

void throw_failures(WireFailures const& failures)
{
    if (failures.empty())
        return;
    constexpr std::size_t most_told = 20;
    std::string all;
    for (std::size_t i = 0; i < std::min(failures.size(), most_told); ++i)
        all += (i == 0 ? "" : "; ") + failures[i].check + ": " + failures[i].what;
    if (failures.size() > most_told)
        all += "; and " + std::to_string(failures.size() - most_told) + " more";
    throw NumericalError("wedm", std::to_string(failures.size()) + (failures.size() == 1 ? " check failed" : " checks failed"), all);
}

void check_program(Scene const& scene, WireFaces const& faces, std::vector<PassOnPitch> const& passes, WireProgram& program)
{
    WireFailures failures;
    auto const add = [&](WireFailures const& found) { failures.insert(failures.end(), found.begin(), found.end()); };
    add(check_numbers(program));
    add(check_pairing(program));
    throw_failures(failures);  // the others trust them
    add(check_pitches(program));
    throw_failures(failures);
    add(check_crossings(program));
    add(check_sweep(faces, program));
    std::vector<std::vector<char>> residual_at;
    for (PassOnPitch const& pass : passes)
        residual_at.push_back(pass.uncut.at);
    add(check_sections(faces, residual_at, std::max(scene.wedm->surface_limit.value_or(0), scene.wedm->tolerance), program));
    add(check_rulings(program));
    constexpr double no_limit = std::numeric_limits<double>::infinity();
    WireRequest const& wedm = *scene.wedm;
    add(check_machine({wedm.largest_tilt, wedm.largest_travel.value_or(no_limit), wedm.largest_uv_travel.value_or(no_limit)}, program));
    add(check_start(program));
    add(check_untilted(program));
    throw_failures(failures);
}

/// Slices that are not the faces make another part.
void check_slices(Scene const& scene, CircularSplineOutline const& outline)
{
    double const half = thickness_of(scene) / 2;
    bool const differ = tilt_of(scene) != 0 || follows_cone(scene);
    bool const single = outline.outline.size() == 1 && !differ;
    bool const ends = outline.z.size() > 1 && outline.z.size() == outline.outline.size() && std::abs(outline.z.front() + half) <= scene.solver.tolerance
                      && std::abs(outline.z.back() - half) <= scene.solver.tolerance;
    if (!single && !ends)
        throw InputError(fault_at("wedm.thickness", "the outline that was solved has no slices at z = -" + short_number(half) + " and +" + short_number(half) + " mm",
                                  "solve it with [slices] over that width, or let wedm solve it"));
}

void refuse_faults(Scene const& scene)
{
    Faults const faults = check_wedm(scene);
    if (!faults.empty())
        throw InputError(faults);
}

PassOnPitch pass_on_pitch(Scene const& scene, WireFaces const& faces, double wire_diameter, double stock)
{
    WireRequest const& wedm = *scene.wedm;
    WireMachine const machine{thickness_of(scene), wedm.lower_guide, wedm.upper_guide};
    PassOnPitch pass;
    pass.stock = stock;
    pass.offset = wire_diameter / 2 + wedm.spark_gap + stock;
    PairedPath const fine = offset_path(with_ends(faces), pass.offset, share_of_arcs * wedm.tolerance);
    std::vector<std::size_t> const kept = thinned(fine, share_of_moves * wedm.tolerance);
    pass.path = taken(fine, kept);
    pass.guide_chord = guide_chord_error(fine, kept, machine);
    pass.uncut = uncut_of(faces, pass.path, pass.offset, wedm.tolerance);
    return pass;
}

std::vector<PassOnPitch> passes_on_pitch(Scene const& scene, WireFaces const& faces)
{
    WireRequest const& wedm = *scene.wedm;
    std::vector<PassOnPitch> passes;
    for (double const stock : wedm.stock.empty() ? std::vector<double>{0.0} : wedm.stock)
        passes.push_back(pass_on_pitch(scene, faces, wedm.wire_diameter, stock));
    return passes;
}

/// The thickest wire of those sold that leaves no more than the limit; nothing where none does.
std::optional<double> fitting_wire(Scene const& scene, WireFaces const& faces)
{
    WireRequest const& wedm = *scene.wedm;
    Scene thinner = scene;
    for (int k = static_cast<int>(std::ceil(wedm.wire_diameter / wire_step)) - 1; k * wire_step >= thinnest_wire; --k)
    {
        thinner.wedm->wire_diameter = std::min(k * wire_step, wedm.wire_diameter);
        if (thinner.wedm->spark_gap > thinner.wedm->wire_diameter)
            break;
        std::vector<Residual> const left = pass_on_pitch(thinner, faces, thinner.wedm->wire_diameter, 0).uncut.residuals;
        if (std::all_of(left.begin(), left.end(), [&](Residual const& each) { return each.height <= wedm.residual_limit; }))
            return thinner.wedm->wire_diameter;
    }
    return {};
}

/// Of lengths in advice [1/mm].
constexpr double told_per_mm = 1e4;

/// Least distance of what the pass leaves, above the tolerance, from where the flexspline's teeth come without load: that is the circular spline without root
/// clearance. Nothing where they come to it, or where that cannot be told.
std::optional<double> way_of_teeth(Scene const& scene, WireFaces const& faces, PassOnPitch const& pass)
{
    if (faces.external || scene.circular_spline.root_clearance <= 0)
        return {};
    Scene plain = scene;
    plain.circular_spline.root_clearance = 0;
    WireFaces reached;
    try
    {
        reached = wire_faces(solve(wire_scene(plain)).circular_spline, faces.teeth);
    }
    catch (std::runtime_error const&)
    {
        return {};  // the refusal that asks stands without it
    }
    double way = std::numeric_limits<double>::infinity();
    for (bool const upper : {false, true})
    {
        std::vector<Vec2> const& points = upper ? faces.pitch.upper : faces.pitch.lower;
        std::vector<Vec2> const& path = upper ? pass.path.upper : pass.path.lower;
        std::vector<Vec2> const& teeth = upper ? reached.pitch.upper : reached.pitch.lower;
        auto const wire = with_neighbours(path, faces, path.size() - 1);
        auto const line = with_neighbours(points, faces, 1);
        way = std::min(way, way_to_residual(line, uncut_heights(line, wire, pass.offset, scene.wedm->tolerance), with_neighbours(teeth, faces, teeth.size() - 1)));
    }
    double const told = std::floor(way * told_per_mm) / told_per_mm;
    return told > scene.wedm->tolerance ? std::optional(told) : std::nullopt;
}

void refuse_residual(Scene const& scene, WireFaces const& faces, PassOnPitch const& pass, WireProgram const& program)
{
    WireRequest const& wedm = *scene.wedm;
    if (program.figures.residual <= wedm.residual_limit)
        return;
    std::vector<Residual> const& left = pass.uncut.residuals;
    auto const worst = std::max_element(left.begin(), left.end(), [](Residual const& a, Residual const& b) { return a.height < b.height; });
    std::string const place = "(" + std::to_string(worst->where.x()) + ", " + std::to_string(worst->where.y()) + ") mm of the " + (worst->upper ? "upper" : "lower") + " face, "
                              + (worst->meshing ? "on a flank" : "in the root");
    auto const wire = fitting_wire(scene, faces);
    auto const way = way_of_teeth(scene, faces, pass);
    Faults faults{fault_at("wedm.wire_diameter",
                           "wire and gap are too wide to follow the contour: they leave " + short_number(worst->height) + " mm at " + place + " of every tooth space, and residual_limit is "
                               + short_number(wedm.residual_limit) + " mm",
                           (wire ? "write wire_diameter = " + short_number(*wire) + ", a thinner wire that leaves no more than that, or" : std::string("no thinner wire that is sold leaves so little; write"))
                               + " residual_limit = " + short_number(std::ceil(worst->height * told_per_mm) / told_per_mm)
                               + (way ? ": the teeth of the unloaded flexspline stay " + short_number(*way) + " mm clear of what is left" : ""))};
    locate(faults, scene);
    throw InputError(faults);
}

/// The marks, and the points nearest to the axis and farthest from it: radii are told to what the contour was solved to, however few of its points are kept.
std::vector<std::size_t> with_extremes(WireFaces const& faces)
{
    std::vector<std::size_t> keep = faces.marks;
    for (std::vector<Vec2> const* face : {&faces.pitch.lower, &faces.pitch.upper})
    {
        auto const [inner, outer] = std::minmax_element(face->begin(), face->end(), [](Vec2 const& a, Vec2 const& b) { return a.squaredNorm() < b.squaredNorm(); });
        keep.push_back(static_cast<std::size_t>(inner - face->begin()));
        keep.push_back(static_cast<std::size_t>(outer - face->begin()));
    }
    std::sort(keep.begin(), keep.end());
    keep.erase(std::unique(keep.begin(), keep.end()), keep.end());
    return keep;
}

/// What the scene says, and the part; no passes yet.
WireProgram program_of(Scene const& scene, WireFaces const& faces)
{
    WireRequest const& wedm = *scene.wedm;
    WireProgram program;
    program.name = in_ascii(scene.drive.name) + (faces.external ? "-flexspline" : "");
    program.machine = {thickness_of(scene), wedm.lower_guide, wedm.upper_guide};
    program.wire_diameter = wedm.wire_diameter;
    program.spark_gap = wedm.spark_gap;
    program.decimals = wedm.decimals;
    program.tolerance = wedm.tolerance;
    program.start_hole_radius = wedm.start_hole_radius;
    program.teeth = faces.teeth;
    program.external = faces.external;
    bool const differ = faces.pitch.lower != faces.pitch.upper;
    program.surface = !differ ? "" : scene.slices ? scene.slices->surface : "tilted";
    program.contour_error = scene.solver.tolerance;
    program.tilt_kind = differ && tilt_of(scene) != 0 ? scene.tilt->kind : "";
    program.nominal = whole_contour(faces, thinned(faces.pitch, share_of_moves * wedm.tolerance, with_extremes(faces)));
    LargestDistance const taper = constant_taper_error(faces);
    program.figures.constant_taper_error = taper.value;
    program.figures.constant_taper_spread = taper.spread;
    return program;
}

/// The program of one set-up, checked.
WireProgram set_up_program(Scene const& scene, WireFaces const& faces, std::vector<PassOnPitch> const& passes, WireSetUp const& set_up)
{
    WireRequest const& wedm = *scene.wedm;
    WireProgram program = program_of(scene, faces);
    program.set_up = set_up;
    int const start = program.closed() ? wedm.start : set_up.first;
    WireRun run{start, start_hole(faces, start, wedm.lead_in), wedm.overlap, 0, false};
    if (!program.closed())
    {
        run.spaces = set_up.spaces;
        run.end = end_hole(faces, faces.space_in_order(start, set_up.spaces - 1), wedm.lead_in);
    }
    for (std::size_t k = 0; k < passes.size(); ++k)
    {
        run.reversed = wedm.alternating && k % 2 == 1;
        run.stop_before = k == 0 ? wedm.stop_before : 0;
        WirePass pass = wire_pass(passes[k].path, faces, run);
        pass.number = static_cast<int>(k) + 1;
        pass.offset = passes[k].offset;
        pass.stock = passes[k].stock;
        for (int i = 0; i < program.spaces(); ++i)
        {
            int const space = program.closed() ? i : faces.space_in_order(start, i);
            for (Residual residual : passes[k].uncut.residuals)
            {
                residual.pass = pass.number;
                residual.tooth = space;
                residual.where = turned_to(residual.where, space, faces.teeth);
                program.residuals.push_back(residual);
            }
        }
        program.figures.guide_chord = std::max(program.figures.guide_chord, passes[k].guide_chord);
        program.passes.push_back(std::move(pass));
    }
    program.figures = measured(program);
    refuse_residual(scene, faces, passes.back(), program);
    check_program(scene, faces, passes, program);
    program.warnings = skim_warnings(program);
    return program;
}

}  // namespace

Scene wire_scene(Scene const& scene)
{
    Scene wanted = scene;
    wanted.contact.reset();
    wanted.circular_spline.width = thickness_of(scene);
    bool const differ = tilt_of(scene) != 0 || follows_cone(scene);
    if (!differ)
    {
        // "auto" looks at the slices
        if (!scene.circular_spline.automatic_backlash)
            wanted.slices.reset();
        return wanted;
    }
    if (!wanted.slices)
        wanted.slices = Slices{with_middle, "tilted", 0};
    bool const keeps = wanted.slices->surface == "per-slice" || scene.circular_spline.automatic_backlash;
    wanted.slices->count = keeps ? std::max(with_middle, wanted.slices->count) : with_middle;
    return wanted;
}

WireProgram wire_program(Scene const& scene, StageObserver const& on_stage)
{
    refuse_faults(scene);
    Solution const solution = solve(wire_scene(scene), on_stage);
    WireProgram program = wire_program(scene, solution.circular_spline);
    program.cup_error = solution.error.cup;
    program.contour_error += solution.error.side_clearance;
    return program;
}

WireProgram wire_program(Scene const& scene, CircularSplineOutline const& outline)
{
    refuse_faults(scene);
    check_slices(scene, outline);
    WireFaces const faces = wire_faces(outline, scene.drive.circular_spline_teeth);
    return set_up_program(scene, faces, passes_on_pitch(scene, faces), {});
}

WireSetUps wire_set_ups(Scene const& scene, StageObserver const& on_stage)
{
    refuse_faults(scene);
    if (!cuts_flexspline(scene))
        return {wire_program(scene, on_stage)};
    WireFaces const faces = flexspline_faces(scene, on_stage);
    auto const passes = passes_on_pitch(scene, faces);
    int const more_than_half = faces.teeth - faces.teeth / 2;
    int const start = scene.wedm->start;
    WireProgram const second = set_up_program(scene, faces, passes, {2, 2, (start + more_than_half) % faces.teeth, faces.teeth / 2, false});
    return {set_up_program(scene, faces, passes, {1, 2, start, more_than_half, false}), turned_half(second)};
}

}  // namespace hdconj
