// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/wedm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "hdconj/numeric/error.hpp"
#include "hdconj/profile/builder.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/wedm/checks.hpp"
#include "hdconj/wedm/offset_path.hpp"
#include "hdconj/wedm/passes.hpp"
#include "hdconj/wedm/residual.hpp"

namespace hdconj {
namespace {

/// Parts of the tolerance: chords of the moves, chords of arcs before thinning. The rest is for the outline, of which the tolerance is at least ten times
/// the error (cross_faults.cpp).
constexpr double share_of_moves = 0.8;
constexpr double share_of_arcs = 1.0 / 16;

/// Fewest slices that have one between the faces.
constexpr int with_middle = 3;

/// A draft deeper than the radius of a corner folds the outline back there: that loop is no part of the face.
void trim(WireFaces& faces)
{
    TrimmedPath const trimmed = without_loops(faces.pitch);
    if (trimmed.path.size() == faces.pitch.size())
        return;
    std::vector<char> meshing;
    for (double const at : trimmed.at)
        meshing.push_back(at < 0 ? 0 : faces.meshing[static_cast<std::size_t>(at)]);  // where it was folded there is no flank
    for (SectionBetween& between : faces.between)
    {
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < trimmed.at.size(); ++i)
        {
            // loops between the faces are no longer than those of the faces, and their corner lies on the ruling that joins those
            Vec2 const ruling = trimmed.path.lower[i] + between.share * (trimmed.path.upper[i] - trimmed.path.lower[i]);
            points.push_back(trimmed.at[i] < 0 ? ruling : between.points[static_cast<std::size_t>(trimmed.at[i])]);
        }
        between.points = std::move(points);
    }
    for (std::size_t& mark : faces.marks)
    {
        // a mark in the loop becomes its corner
        std::size_t i = 0;
        while (i + 1 < trimmed.at.size() && !(trimmed.at[i] >= static_cast<double>(mark)))
            ++i;
        while (i > 0 && trimmed.at[i] > static_cast<double>(mark) && trimmed.at[i - 1] < 0)
            --i;
        mark = i;
    }
    faces.marks.erase(std::unique(faces.marks.begin(), faces.marks.end()), faces.marks.end());
    faces.meshing = std::move(meshing);
    faces.pitch = trimmed.path;
}

Fault fault_at(std::string path, std::string reason, std::string remedy)
{
    return {std::move(path), 0, "", std::move(reason), std::move(remedy)};
}

double thickness_of(Scene const& scene)
{
    return scene.wedm->thickness.value_or(scene.circular_spline.width.value_or(0));
}

double tilt_of(Scene const& scene)
{
    return scene.tilt ? scene.tilt->angle : 0;
}

bool follows_cone(Scene const& scene)
{
    return scene.coning && scene.slices && scene.slices->count > 1 && scene.slices->surface != "tilted";
}

double pitch_radius(Scene const& scene)
{
    return scene.drive.module * scene.drive.circular_spline_teeth / 2;
}

void check_wire(Scene const& scene, Faults& faults)
{
    WireRequest const& wedm = *scene.wedm;
    double const width = wedm.wire_diameter + 2 * wedm.spark_gap;
    double const pitch = std::numbers::pi * scene.drive.module;
    if (width >= pitch)
        faults.push_back(fault_at("wedm.wire_diameter", "wire and gap cut a slot of " + short_number(width) + " mm, and a whole pitch of the teeth is " + short_number(pitch) + " mm",
                                  "write a wire that fits into a tooth space, far thinner than half a pitch"));
    if (!wedm.stock.empty() && wedm.stock.front() > scene.drive.module)
        faults.push_back(fault_at("wedm.passes", "a stock of " + short_number(wedm.stock.front()) + " mm is more than one module and leaves no tooth space",
                                  "write a small part of the module " + short_number(scene.drive.module)));
    if (wedm.tolerance < 10 * scene.solver.tolerance)
        faults.push_back(fault_at("wedm.tolerance", "the outline itself is known to " + short_number(scene.solver.tolerance) + " mm only (solver.tolerance)",
                                  "write at least " + short_number(10 * scene.solver.tolerance) + ", or a smaller solver.tolerance"));
    if (wedm.tolerance > scene.drive.module / 10)
        faults.push_back(fault_at("wedm.tolerance", "above a tenth of the module says nothing about a tooth",
                                  "write at most " + short_number(scene.drive.module / 10) + ", such as 0.0005"));
}

void check_workpiece(Scene const& scene, Faults& faults)
{
    WireRequest const& wedm = *scene.wedm;
    double const width = scene.circular_spline.width.value_or(0);
    if (thickness_of(scene) <= 0)
        faults.push_back({"wedm.thickness", wedm.line, "", "this key is missing, and circular_spline.width does not tell it either",
                          "write thickness = 7.0, a length in mm"});
    if (wedm.thickness && *wedm.thickness < width)
        faults.push_back(fault_at("wedm.thickness", "the toothing is wider: circular_spline.width = " + short_number(width) + " mm",
                                  "write at least that width, or remove the key"));
    if (follows_cone(scene) && thickness_of(scene) / 2 >= scene.coning->bottom_to_middle.value_or(0) - scene.coning->apex_height)
        faults.push_back(fault_at(wedm.thickness ? "wedm.thickness" : "circular_spline.width", "the workpiece would reach behind the apex of the cone",
                                  "write a smaller thickness"));
    if (scene.is_reverse())
        faults.push_back(fault_at("circular_spline.profile", "the wire cuts the circular spline that is solved for, but its tooth is given",
                                  "give [flexspline.profile] in place of [circular_spline.profile]"));
}

void check_set_up(Scene const& scene, Faults& faults)
{
    WireRequest const& wedm = *scene.wedm;
    double const radius = pitch_radius(scene);
    if (wedm.lead_in > radius)
        faults.push_back(fault_at("wedm.lead_in", "the lead-in would begin beyond the middle of the bore", "write at most " + short_number(radius) + ", such as 3.0"));
    if (wedm.start >= scene.drive.circular_spline_teeth)
        faults.push_back(fault_at("wedm.start", "there are " + std::to_string(scene.drive.circular_spline_teeth) + " tooth spaces, counted from 0",
                                  "write a whole number from 0 to " + std::to_string(scene.drive.circular_spline_teeth - 1)));
    for (auto const& [path, length] : {std::pair("wedm.overlap", wedm.overlap), std::pair("wedm.stop_before", wedm.stop_before)})
        if (length > std::numbers::pi * radius)
            faults.push_back(fault_at(path, "is more than half the way around the part", "write a few mm at most"));
    if (std::abs(tilt_of(scene)) > wedm.largest_tilt)
        faults.push_back(fault_at("tilt.angle_deg", "the machine tilts its wire by " + short_number(wedm.largest_tilt / rad_per_deg) + " degrees at most (wedm.largest_tilt_deg)",
                                  "write a smaller angle, or the limit of a machine that can"));
}

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

UncutOfPass uncut_of(WireFaces const& faces, PairedPath const& wire, WirePass const& pass, double tolerance)
{
    UncutOfPass uncut;
    uncut.at.assign(faces.pitch.size(), 0);
    for (bool const upper : {false, true})
    {
        std::vector<Vec2> const& points = upper ? faces.pitch.upper : faces.pitch.lower;
        std::vector<Vec2> const& path = upper ? wire.upper : wire.lower;
        auto const heights = uncut_heights(with_neighbours(points, faces.teeth, 1), with_neighbours(path, faces.teeth, path.size() - 1), pass.offset, pass.stock,
                                           tolerance);
        add_runs(faces, heights, upper, uncut);
    }
    widen(uncut.at);
    return uncut;
}

PairedPath with_ends(PairedPath const& pitch, int teeth)
{
    return {with_neighbours(pitch.lower, teeth, 1), with_neighbours(pitch.upper, teeth, 1)};
}

void take_radii(WireFaces const& faces, WireFigures& figures)
{
    auto const radii = [](std::vector<Vec2> const& points, double& tip, double& root) {
        tip = std::numeric_limits<double>::infinity();
        for (Vec2 const& p : points)
        {
            tip = std::min(tip, p.norm());
            root = std::max(root, p.norm());
        }
    };
    radii(faces.pitch.lower, figures.lower_tip, figures.lower_root);
    radii(faces.pitch.upper, figures.upper_tip, figures.upper_root);
    for (std::size_t i = 0; i < faces.pitch.size(); ++i)
        figures.face_shift = std::max(figures.face_shift, (faces.pitch.upper[i] - faces.pitch.lower[i]).norm());
    figures.constant_taper_error = constant_taper_error(faces);
}

void refuse_residual(Scene const& scene, WireProgram const& program)
{
    WireRequest const& wedm = *scene.wedm;
    if (program.figures.residual <= wedm.residual_limit)
        return;
    int const last = program.passes.back().number;
    auto const worst = std::max_element(program.residuals.begin(), program.residuals.end(), [&](Residual const& a, Residual const& b) {
        return (a.pass == last ? a.height : 0) < (b.pass == last ? b.height : 0);
    });
    std::string const place = "(" + std::to_string(worst->where.x()) + ", " + std::to_string(worst->where.y()) + ") mm of the " + (worst->upper ? "upper" : "lower") + " face, "
                              + (worst->meshing ? "on a flank" : "in the root");
    Faults faults{fault_at("wedm.wire_diameter",
                           "wire and gap are too wide to follow the contour: they leave " + short_number(worst->height) + " mm at " + place + " of every tooth space, and residual_limit is "
                               + short_number(wedm.residual_limit) + " mm",
                           "write a thinner wire, a larger residual_limit, or give the root room with circular_spline.root_clearance")};
    locate(faults, scene);
    throw InputError(faults);
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

void check_program(Scene const& scene, WireFaces const& faces, std::vector<std::vector<char>> const& residual_at, WireProgram& program)
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
    add(check_sections(faces, residual_at, std::max(scene.wedm->surface_limit.value_or(0), scene.wedm->tolerance), program));
    add(check_rulings(program));
    add(check_machine(scene.wedm->largest_tilt, scene.wedm->largest_travel.value_or(std::numeric_limits<double>::infinity()), program));
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

}  // namespace

Faults check_wedm(Scene const& scene)
{
    Faults faults;
    if (!scene.wedm)
        return {{"wedm", 0, "", "this table is missing: it states wire and gap, which are never assumed", "write the line [wedm] and below it wire_diameter = 0.10 and spark_gap = 0.006"}};
    check_wire(scene, faults);
    check_workpiece(scene, faults);
    check_set_up(scene, faults);
    locate(faults, scene);
    return faults;
}

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

WireFaces wire_faces(CircularSplineOutline const& outline, int teeth)
{
    WireFaces faces;
    faces.teeth = teeth;
    auto const reversed = [](std::vector<Vec2> const& points) { return std::vector<Vec2>(points.rbegin(), points.rend()); };
    faces.pitch = {reversed(outline.outline.front()), reversed(outline.outline.back())};
    std::size_t const last = faces.pitch.size() - 1;
    for (auto mark = outline.landmarks.rbegin(); mark != outline.landmarks.rend(); ++mark)
        faces.marks.push_back(last - static_cast<std::size_t>(*mark));
    faces.meshing.assign(faces.pitch.size(), 0);
    // marks: land corner, flank end, middle, flank end, land corner
    if (faces.marks.size() == 5)
        for (std::size_t i = 0; i <= last; ++i)
            faces.meshing[i] = (i >= faces.marks[0] && i <= faces.marks[1]) || (i >= faces.marks[3] && i <= faces.marks[4]) ? 1 : 0;
    else
        throw NumericalError("wedm", "outline", "has no land corners and flank ends");
    for (std::size_t k = 1; k + 1 < outline.outline.size(); ++k)
        faces.between.push_back({(outline.z[k] - outline.z.front()) / (outline.z.back() - outline.z.front()), reversed(outline.outline[k])});
    trim(faces);
    return faces;
}

WireProgram wire_program(Scene const& scene, StageObserver const& on_stage)
{
    Faults const faults = check_wedm(scene);
    if (!faults.empty())
        throw InputError(faults);
    return wire_program(scene, solve(wire_scene(scene), on_stage).circular_spline);
}

WireProgram wire_program(Scene const& scene, CircularSplineOutline const& outline)
{
    Faults const faults = check_wedm(scene);
    if (!faults.empty())
        throw InputError(faults);
    check_slices(scene, outline);
    WireRequest const& wedm = *scene.wedm;
    WireFaces const faces = wire_faces(outline, scene.drive.circular_spline_teeth);
    WireProgram program;
    program.name = in_ascii(scene.drive.name);
    program.machine = {thickness_of(scene), wedm.lower_guide, wedm.upper_guide};
    program.wire_diameter = wedm.wire_diameter;
    program.spark_gap = wedm.spark_gap;
    program.decimals = wedm.decimals;
    program.tolerance = wedm.tolerance;
    program.start_hole_radius = wedm.start_hole_radius;
    program.teeth = faces.teeth;
    bool const differ = faces.pitch.lower != faces.pitch.upper;
    program.surface = !differ ? "" : scene.slices ? scene.slices->surface : "tilted";
    program.tilt_kind = differ && tilt_of(scene) != 0 ? scene.tilt->kind : "";
    program.nominal = whole_contour(faces, thinned(faces.pitch, share_of_moves * wedm.tolerance, faces.marks));
    take_radii(faces, program.figures);

    WireRun run{wedm.start, start_hole(faces, wedm.start, wedm.lead_in), wedm.overlap, 0, false};
    PairedPath const with_guards = with_ends(faces.pitch, faces.teeth);
    std::vector<double> const stocks = wedm.stock.empty() ? std::vector<double>{0.0} : wedm.stock;
    std::vector<std::vector<char>> residual_at;
    for (std::size_t k = 0; k < stocks.size(); ++k)
    {
        double const offset = wedm.wire_diameter / 2 + wedm.spark_gap + stocks[k];
        PairedPath const fine = offset_path(with_guards, offset, share_of_arcs * wedm.tolerance);
        std::vector<std::size_t> const kept = thinned(fine, share_of_moves * wedm.tolerance);
        PairedPath const path = taken(fine, kept);
        program.figures.guide_chord = std::max(program.figures.guide_chord, guide_chord_error(fine, kept, program.machine));
        run.reversed = wedm.alternating && k % 2 == 1;
        run.stop_before = k == 0 ? wedm.stop_before : 0;
        WirePass pass = wire_pass(path, faces.teeth, run);
        pass.number = static_cast<int>(k) + 1;
        pass.offset = offset;
        pass.stock = stocks[k];
        UncutOfPass uncut = uncut_of(faces, path, pass, wedm.tolerance);
        for (int space = 0; space < faces.teeth; ++space)
        {
            for (Residual residual : uncut.residuals)
            {
                residual.pass = pass.number;
                residual.tooth = space;
                residual.where = turned_to(residual.where, space, faces.teeth);
                program.residuals.push_back(residual);
            }
        }
        residual_at.push_back(std::move(uncut.at));
        if (k + 1 == stocks.size())
        {
            for (Residual const& residual : uncut.residuals)
            {
                program.figures.residual = std::max(program.figures.residual, residual.height);
                program.figures.meshing_residual = std::max(program.figures.meshing_residual, residual.meshing ? residual.height : 0);
            }
        }
        program.passes.push_back(std::move(pass));
    }
    refuse_residual(scene, program);
    check_program(scene, faces, residual_at, program);
    return program;
}

}  // namespace hdconj
