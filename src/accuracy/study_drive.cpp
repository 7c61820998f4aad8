// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_drive.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "conjugate/plane/plane_motion.hpp"
#include "drive/drive.hpp"
#include "hdconj/envelope/avoid_stationary_centres.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/error.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/scene/number_pairs.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"

namespace hdconj::accuracy {
namespace {

ReferenceShape given_shape(std::string const& family)
{
    static std::map<std::string, ReferenceShape, std::less<>> const all = {
        {"cosine", ReferenceShape::cosine},
        {"ellipse", ReferenceShape::ellipse},
        {"ring-on-cosine-cam", ReferenceShape::ring_on_cosine_cam},
        {"four-roller", ReferenceShape::four_roller},
        {"two-disc", ReferenceShape::two_disc},
        {"table", ReferenceShape::table}};
    auto const found = all.find(family);
    if (found == all.end())
        throw NumericalError(ErrorCode::no_reference, "reference", "wave generator \"" + family + "\"",
                             "has no reference in 50 digits");
    return found->second;
}

/// The rows of a table, without the one that closes the wave.
std::vector<std::array<double, 2>> rows_of(Scene const& scene)
{
    Faults faults;
    scene::NumberPairs const table =
        scene::read_number_pairs(scene.wave_generator.shape, "file", scene.folder.string(),
                                 {scene::ColumnQuantity::angle, scene::ColumnQuantity::length},
                                 "angle in degrees, radial displacement in mm", faults);
    throw_if_any(faults);
    std::vector<std::array<double, 2>> rows;
    constexpr double typed = 1e-9;  // degrees, as the program reads it
    for (scene::NumberPair const& row : table.rows)
        if (rows.empty() || row.value[0] - rows.front()[0] < 360.0 / scene.wave_generator.waves - typed)
            rows.push_back(row.value);
    return rows;
}

/// The flexspline tooth's motion.
motion::AnyMotion motion_of(StudyDrive const& drive, double ratio)
{
    double const r_m = drive.geometry.r_m;
    Kinematics const model = drive.scene.solver.kinematics;
    if (model == Kinematics::first_order)
        return motion::AnyMotion::owning(motion::FirstOrderMotion<wavegen::AnyWaveShape>(drive.shape, r_m, ratio));
    if (model == Kinematics::material)
        return motion::AnyMotion::owning(motion::MaterialMotion(wavegen::inextensional_mode(drive.shape), r_m, ratio));
    motion::ExactMotion<wavegen::AnyWaveShape> exact(wavegen::NeutralCurve<wavegen::AnyWaveShape>(drive.shape, r_m),
                                                     ratio);
    auto const closed_form = motion::cosine_form(exact);
    return motion::AnyMotion::owning(std::move(exact), closed_form);
}

/// The circular-spline teeth that pass the flexspline tooth's centre line in a lobe, as it sees them.
void see_from_flexspline(StudyDrive& drive)
{
    PairGeometry const& g = drive.geometry;
    drive.seat_radius = drive::given_tooth_seat(g, drive.tooth);
    drive.limits.tip = g.pitch_line + g.addendum;
    drive.limits.root = g.pitch_line - g.dedendum;
    drive.limits.addendum = g.addendum;
    drive.limits.half_width = std::numbers::pi / drive.scene.drive.flexspline_teeth * (g.r_m + drive.limits.root);
    drive.flexspline = drive.motions;
    drive.motions.clear();
    int const beside = (drive::pitches_per_lobe(drive.scene) - 1) / 2;
    for (int number = -beside; number <= 1 + beside; ++number) {
        drive.numbers.push_back(number);
        drive.motions.push_back(
            motion::seen_from_flexspline(drive.flexspline.front(), number, drive.pitch, drive.seat_radius));
    }
}

}  // namespace

ReferenceNumbers StudyDrive::given() const
{
    scene::FamilyChoice const& choice = scene.wave_generator.shape;
    ReferenceNumbers numbers_given{given_shape(choice.family),
                                   geometry.w0,
                                   scene.wave_generator.waves,
                                   geometry.r_m,
                                   choice.number_or("ring_thickness", 0),
                                   0,
                                   {},
                                   scene.drive.flexspline_teeth,
                                   scene.drive.circular_spline_teeth,
                                   scene.solver.kinematics};
    if (numbers_given.shape == ReferenceShape::four_roller)
        numbers_given.angle_deg = choice.number_or("roller_angle_deg", 0);
    else if (numbers_given.shape == ReferenceShape::two_disc)
        numbers_given.angle_deg = choice.number_or("wrap_angle_deg", 0);
    else if (numbers_given.shape == ReferenceShape::table)
        numbers_given.rows = rows_of(scene);
    return numbers_given;
}

bool StudyDrive::is_flank(conjugate::BoundaryPiece const& piece) const
{
    if (piece.arc < 0)
        return false;
    int const made_by = arc(piece).piece;
    return !tooth.pieces[static_cast<std::size_t>(made_by)].corner && !profile::is_tip(tooth, made_by);
}

Vec2 StudyDrive::placed(conjugate::BoundaryPiece const& piece, Vec2 const& p) const
{
    if (reverse())
        return p - Vec2(0, geometry.pitch_line);
    return piece.copy == 0 ? p : turned_clockwise(p, piece.copy * pitch);
}

StudyDrive drive_parts(Scene const& scene)
{
    Scene coarse = scene;
    coarse.solver.tolerance = scene.drive.module * 0x1p-10;
    StudyDrive drive;
    drive.scene = scene;
    drive.geometry = solve(coarse).geometry;
    drive.pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth;
    drive.offset = scene.circular_spline.backlash_offset;
    Faults faults;
    drive.tooth = drive::given_tooth(scene, faults);
    drive.shape = drive::wave_shape(scene, drive.tooth, faults);
    throw_if_any(faults);
    drive.motions.push_back(motion_of(drive, conjugate::tooth_ratio(scene)));
    if (drive.reverse())
        see_from_flexspline(drive);
    else
        drive.tooth = envelope::avoid_stationary_centres(std::move(drive.tooth), drive.motion());
    return drive;
}

StudyDrive study_drive(Scene const& scene)
{
    StudyDrive drive = drive_parts(scene);
    find_boundary(drive);
    return drive;
}

std::vector<double> fold_angles(motion::AnyMotion const& motion, std::vector<profile::CurvePiece> const& pieces)
{
    profile::Profile flank;
    flank.segment_names = {"flank"};
    for (profile::CurvePiece const& piece : pieces)
        flank.pieces.push_back({piece, 0, 0, 1, false});
    std::vector<double> angles;
    for (envelope::Branch const& branch :
         envelope::find_branches(envelope::AnyEnvelope(flank, motion, 0), 1).branches) {
        for (envelope::ContactArc const& arc : branch.arcs) {
            if (arc.begins == envelope::BranchEnd::double_root)
                angles.push_back(arc.u_begin);
            if (arc.ends == envelope::BranchEnd::double_root)
                angles.push_back(arc.u_end);
        }
    }
    std::sort(angles.begin(), angles.end());
    angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
    return angles;
}

}  // namespace hdconj::accuracy
