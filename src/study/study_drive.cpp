// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "given_contact.hpp"
#include "hdconj/conjugate/outline.hpp"
#include "hdconj/contact/full_turn.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/envelope/rest.hpp"
#include "hdconj/envelope/sample.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/pipeline/solve.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/number_pairs.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"

namespace hdconj::detail {
namespace {

Profile tooth_of(Scene const& scene)
{
    int const difference = scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth;
    bool const reverse = scene.is_reverse();
    Faults faults;
    Profile tooth = build_profile(scene.given_profile(),
                                  {scene.drive.module, reverse ? scene.drive.circular_spline_teeth : scene.drive.flexspline_teeth, reverse ? 0 : scene.flexspline.wall,
                                   reverse ? 0 : scene.flexspline.neutral_offset, scene.folder.string(), reverse, difference, scene.wave_generator.waves},
                                  faults);
    if (!faults.empty())
        throw InputError(faults);
    return tooth;
}

GivenShape given_shape(std::string const& family)
{
    static std::map<std::string, GivenShape, std::less<>> const all = {
        {"cosine", GivenShape::cosine},           {"ellipse", GivenShape::ellipse},   {"ring-on-cosine-cam", GivenShape::ring_on_cosine_cam},
        {"four-roller", GivenShape::four_roller}, {"two-disc", GivenShape::two_disc}, {"table", GivenShape::table}};
    auto const found = all.find(family);
    if (found == all.end())
        throw NumericalError("reference", "wave generator \"" + family + "\"", "has no reference in 50 digits");
    return found->second;
}

/// The rows of a table, without the one that closes the wave.
std::vector<std::array<double, 2>> rows_of(Scene const& scene)
{
    Faults faults;
    NumberPairs const table = read_number_pairs(scene.wave_generator.shape, "file", scene.folder.string(), {ColumnQuantity::angle, ColumnQuantity::length}, "angle in degrees, radial displacement in mm", faults);
    if (!faults.empty())
        throw InputError(faults);
    std::vector<std::array<double, 2>> rows;
    constexpr double typed = 1e-9;   // degrees, as the program reads it
    for (NumberPair const& row : table.rows)
        if (rows.empty() || row.value[0] - rows.front()[0] < 360.0 / scene.wave_generator.waves - typed)
            rows.push_back(row.value);
    return rows;
}

/// The flexspline tooth's motion.
StudyMotion motion_of(StudyDrive& drive, double ratio)
{
    double const r_m = drive.geometry.r_m;
    switch (drive.scene.solver.kinematics)
    {
    case Kinematics::first_order: return StudyMotion(FirstOrderMotion<AnyWaveShape>(drive.shape, r_m, ratio));
    case Kinematics::material: return StudyMotion(MaterialMotion(inextensional_mode(drive.shape), r_m, ratio));
    case Kinematics::exact: break;
    }
    drive.exact = std::make_shared<StudyExactMotion const>(NeutralCurve<AnyWaveShape>(drive.shape, r_m), ratio);
    return StudyMotion(*drive.exact);
}

/// Adds the contact arcs of tooth @p which.
void add_arcs(StudyDrive& drive, std::size_t which)
{
    BranchSet const set = find_branches(Envelope<StudyMotion>(drive.tooth, drive.motions[which], drive.offset), 1);
    drive.branches += set.branches.size();
    for (Branch const& branch : set.branches)
        drive.arcs.insert(drive.arcs.end(), branch.arcs.begin(), branch.arcs.end());
}

int pitches_of_lobe(Scene const& scene)
{
    return (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth) / scene.wave_generator.waves;
}

/// Has the pieces of the boundary found by polygons of ever smaller chords, until no tooth enters them over a full turn: coarse polygons pass over stretches that stand out by less than their chord.
/// @throws NumericalError where they never do
template<class Clearance, class Find>
void until_clear(StudyDrive const& drive, Clearance const& clearance, Find const& find)
{
    double chord = drive.height() * 0x1p-16;
    double const sampled = drive.height() * 0x1p-22, allowed = drive.height() * 0x1p-34;
    constexpr int attempts = 4;
    for (int attempt = 0; attempt < attempts; ++attempt, chord /= 64)
    {
        find(chord);
        double least = std::numeric_limits<double>::infinity();
        for (BoundaryPiece const& piece : drive.pieces)
        {
            if (piece.arc < 0)
                continue;
            std::vector<Vec2> points;
            for (EnvelopePoint const& e : sample_arc(drive.envelope(piece), drive.arc(piece), piece.begin, piece.end, sampled, 1).points)
                points.push_back(drive.reverse() ? e.p : drive.placed(piece, e.p));
            std::vector<TurnMinimum> minima(points.size());
            clearance(points, nullptr, minima);
            for (TurnMinimum const& each : minima)
                least = std::min(least, each.distance);
        }
        if (least >= drive.offset - allowed)
            return;
    }
    throw NumericalError("reference", "boundary", "teeth enter it however fine its pieces are looked for");
}

void find_tooth_space(StudyDrive& drive)
{
    add_arcs(drive, 0);
    double const scale = drive.geometry.r_m + drive.geometry.w0 + drive.tooth.pitch_line + drive.tooth.addendum;
    Tolerance const tolerance{scale * 0x1p-44, scale};
    Envelope<StudyMotion> const envelope(drive.tooth, drive.motion(), drive.offset);
    FullTurnClearance<StudyMotion> const clearance(drive.tooth, drive.motion(), drive.pitch, pitches_of_lobe(drive.scene));
    until_clear(drive, clearance, [&](double chord) {
        drive.pieces = ToothSpaceFinder<StudyMotion>(envelope, drive.arcs, drive.geometry.circular_spline_inner_radius, drive.scene.drive.circular_spline_teeth,
                                                     tolerance, chord)()
                           .pieces;
    });
}

/// The circular-spline teeth that pass the flexspline tooth's centre line in a lobe, as it sees them.
void see_from_flexspline(StudyDrive& drive)
{
    PairGeometry const& g = drive.geometry;
    drive.seat_radius = g.circular_spline_inner_radius + drive.tooth.addendum + drive.tooth.pitch_line;
    drive.limits.tip = g.pitch_line + g.addendum;
    drive.limits.root = g.pitch_line - g.dedendum;
    drive.limits.half_width = std::numbers::pi / drive.scene.drive.flexspline_teeth * (g.r_m + drive.limits.root);
    drive.flexspline = drive.motions;
    drive.motions.clear();
    int const beside = (pitches_of_lobe(drive.scene) - 1) / 2;
    for (int number = -beside; number <= 1 + beside; ++number)
    {
        drive.numbers.push_back(number);
        drive.motions.push_back(drive.flexspline.front().seen_from_flexspline(number, drive.pitch, drive.seat_radius));
    }
}

/// The flexspline tooth that they leave.
void find_tooth_body(StudyDrive& drive)
{
    std::vector<SweptTooth<StudyMotion>> teeth;
    std::vector<int> first_arc;
    for (std::size_t j = 0; j < drive.motions.size(); ++j)
    {
        std::size_t const before = drive.arcs.size();
        first_arc.push_back(static_cast<int>(before));
        add_arcs(drive, j);
        teeth.push_back({Envelope<StudyMotion>(drive.tooth, drive.motions[j], drive.offset),
                         std::vector<ContactArc>(drive.arcs.begin() + static_cast<std::ptrdiff_t>(before), drive.arcs.end())});
    }
    Tolerance const tolerance{drive.seat_radius * 0x1p-44, drive.seat_radius};
    auto const numbered = [&](BoundaryPiece piece) {
        piece.arc += first_arc[static_cast<std::size_t>(piece.copy)];
        return piece;
    };
    ReverseFullTurnClearance<StudyMotion> const clearance(drive.tooth, drive.flexspline.front(), drive.pitch, drive.seat_radius, pitches_of_lobe(drive.scene));
    until_clear(drive, clearance, [&](double chord) {
        ToothBody const body = ToothBodyFinder<StudyMotion>(teeth, drive.limits, tolerance, chord)();
        drive.pieces.assign(1, {});
        for (auto piece = body.left.rbegin(); piece != body.left.rend(); ++piece)
        {
            drive.pieces.push_back(numbered(*piece));
            std::swap(drive.pieces.back().begin, drive.pieces.back().end);
        }
        drive.pieces.emplace_back();
        for (BoundaryPiece const& piece : body.right)
            drive.pieces.push_back(numbered(piece));
        drive.pieces.emplace_back();
    });
}

}  // namespace

GivenNumbers StudyDrive::given() const
{
    FamilyChoice const& choice = scene.wave_generator.shape;
    GivenNumbers numbers_given{given_shape(choice.family), geometry.w0, scene.wave_generator.waves, geometry.r_m, choice.number_or("ring_thickness", 0), 0, {},
                               scene.drive.flexspline_teeth, scene.drive.circular_spline_teeth, scene.solver.kinematics};
    switch (numbers_given.shape)
    {
    case GivenShape::four_roller: numbers_given.angle_deg = choice.number_or("roller_angle_deg", 0); break;
    case GivenShape::two_disc: numbers_given.angle_deg = choice.number_or("wrap_angle_deg", 0); break;
    case GivenShape::table: numbers_given.rows = rows_of(scene); break;
    default: break;
    }
    return numbers_given;
}

bool StudyDrive::is_flank(BoundaryPiece const& piece) const
{
    if (piece.arc < 0)
        return false;
    int const made_by = arc(piece).piece;
    return !tooth.pieces[static_cast<std::size_t>(made_by)].corner && !is_tip(tooth, made_by);
}

Vec2 StudyDrive::placed(BoundaryPiece const& piece, Vec2 const& p) const
{
    if (reverse())
        return p - Vec2(0, geometry.pitch_line);
    return piece.copy == 0 ? p : turned_clockwise(p, piece.copy * pitch);
}

StudyDrive drive_parts(Scene const& scene)
{
    Scene coarse = scene;
    coarse.solver.tolerance = (scene.drive.module) * 0x1p-10;
    StudyDrive drive;
    drive.scene = scene;
    drive.geometry = solve(coarse).geometry;
    drive.pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth;
    drive.offset = scene.circular_spline.backlash_offset;
    Faults faults;
    drive.shape = build_wave_shape(scene.wave_generator.shape, {drive.geometry.r_m, scene.wave_generator.waves, scene.folder.string()}, faults);
    if (!faults.empty())
        throw InputError(faults);
    drive.motions.push_back(motion_of(drive, static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth));
    drive.tooth = tooth_of(scene);
    if (drive.reverse())
        see_from_flexspline(drive);
    else
        drive.tooth = clear_of_rest(std::move(drive.tooth), drive.motion());
    return drive;
}

StudyDrive study_drive(Scene const& scene)
{
    StudyDrive drive = drive_parts(scene);
    if (drive.reverse())
        find_tooth_body(drive);
    else
        find_tooth_space(drive);
    return drive;
}

std::vector<double> fold_angles(StudyMotion const& motion, std::vector<CurvePiece> const& pieces)
{
    Profile flank;
    flank.segment_names = {"flank"};
    for (CurvePiece const& piece : pieces)
        flank.pieces.push_back({piece, 0, 0, 1, false});
    std::vector<double> angles;
    for (Branch const& branch : find_branches(Envelope<StudyMotion>(flank, motion, 0), 1).branches)
    {
        for (ContactArc const& arc : branch.arcs)
        {
            if (arc.begins == BranchEnd::double_root)
                angles.push_back(arc.u_begin);
            if (arc.ends == BranchEnd::double_root)
                angles.push_back(arc.u_end);
        }
    }
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

}  // namespace hdconj::detail
