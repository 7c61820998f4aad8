// SPDX-License-Identifier: GPL-3.0-or-later
#include "loaded_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "conjugate/plane/plane_motion.hpp"
#include "drive/end_shift.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "load/elastic_drive.hpp"
#include "wavegen/length_kept.hpp"

namespace hdconj::load {
namespace {

/// Series of w and v as MaterialMotion takes them.
wavegen::MaterialDisplacement displacement_of(ElasticDrive const& drive, std::vector<double> const& w,
                                              std::vector<double> const& v, double r_m)
{
    wavegen::MaterialDisplacement result;
    result.waves = drive.response->sectors();
    std::size_t const count = drive.response->harmonics().size();
    for (std::size_t k = 0; k < count; ++k)
        result.harmonics.push_back({w[2 * k], w[2 * k + 1], v[2 * k], v[2 * k + 1]});
    return wavegen::length_kept(std::move(result), r_m);
}

/// A slice of a tooth and where it has moved to along the axis.
struct MovedSlice
{
    Pose pose;
    double place = 0;  ///< [mm]
    double slope = 0;  ///< d place/dphi [mm/rad]
};

/// Number of slices from one of the four that section() joins to the next. A section comes from a place on the wall
/// that lies u_z away along the axis. If the four slices were closer together than that, the cubic through them would
/// have to be continued far beyond the last slice. It would magnify the local deformation that a force makes at its own
/// slice, the more the finer the slices are. So they are four times end_shift() apart, but at most a quarter of the
/// width.
std::size_t slices_apart(contact::ContactContext const& context, std::vector<double> const& z)
{
    constexpr double multiple = 4;
    double const moved = drive::end_shift(context.geometry.r_m, std::abs(context.shape(0).w),
                                          context.scene.wave_generator.waves, context.scene.flexspline.cup->length);
    std::size_t const spaces = z.size() - 1, most = std::max<std::size_t>(1, spaces / 4);
    double const wanted = std::round(multiple * moved * static_cast<double>(spaces) / (z.back() - z.front()));
    return std::clamp<std::size_t>(static_cast<std::size_t>(wanted), 1, most);
}

/// The section of the tooth by the plane of the slice @p k at @p z. It lies on the cubic through this slice and three
/// others on both sides of the plane, @p apart from each other; near the ends, and where there are fewer slices, on
/// what there is. The tooth stands normal to the section curve. Where u_z changes along phi, that curve turns against
/// those of the slices, because the wall leans (SectionPoses). Domain: at least two slices; @p apart is 1, or at most a
/// quarter of the spaces between them.
Pose section(std::vector<MovedSlice> const& tooth, std::size_t k, double z, std::size_t apart, double r_m)
{
    std::size_t const slices = tooth.size(), window = std::min<std::size_t>(4, slices), others = window - 1;
    std::size_t const room_below = k / apart, room_above = (slices - 1 - k) / apart;
    std::size_t const usual_below = tooth[k].place <= z ? window / 2 - 1 : window / 2;
    std::size_t const below = std::clamp(usual_below, others - std::min(room_above, others), room_below);
    std::size_t const first = k - apart * below;
    std::size_t const end = first + window * apart;
    Pose p{0, 0, Vec2::Zero()};
    Vec2 lean = Vec2::Zero();  // d origin/dz
    double slope = 0;
    for (std::size_t j = first; j < end; j += apart) {
        double weight = 1, change = 0;
        for (std::size_t i = first; i < end; i += apart) {
            if (i == j)
                continue;
            double const width = tooth[j].place - tooth[i].place;
            change = (change * (z - tooth[i].place) + weight) / width;
            weight *= (z - tooth[i].place) / width;
        }
        p.origin += weight * tooth[j].pose.origin;
        p.cosine += weight * tooth[j].pose.cosine;
        p.sine += weight * tooth[j].pose.sine;
        lean += change * tooth[j].pose.origin;
        slope += weight * tooth[j].slope;
    }
    Vec2 const tangent = r_m * p.rotate({1, 0});
    Vec2 const turned = tangent - slope * lean;
    double const angle = std::atan2(p.sine, p.cosine) - std::atan2(cross(tangent, turned), tangent.dot(turned));
    return {std::cos(angle), std::sin(angle), p.origin};
}

}  // namespace

LoadedShape loaded_shape(contact::ContactContext const& context, ElasticDrive const& drive,
                         Eigen::MatrixXd const& forces)
{
    LoadedShape shape;
    shape.series = displacements(drive, forces, context.threads);
    shape.places = tooth_poses(context, drive, shape.series, drive.phase);
    return shape;
}

contact::ToothPoses tooth_poses(contact::ContactContext const& context, ElasticDrive const& drive,
                                std::vector<std::vector<double>> const& series, double phase)
{
    double const r_m = context.geometry.r_m;
    std::size_t const slices = drive.stations.slices;
    std::vector<std::optional<motion::MaterialMotion>> motions(slices);
    parallel_for(slices, context.threads, 2, [&](std::size_t k) {
        motions[k].emplace(
            displacement_of(drive, series[drive.stations.radial(k)], series[drive.stations.tangential(k)], r_m), r_m,
            conjugate::tooth_ratio(context.scene));
    });
    std::array<int, 2> const needed =
        contact::teeth_needed(context.scene.drive.flexspline_teeth, context.scene.drive.circular_spline_teeth, phase);
    auto const teeth = static_cast<std::size_t>(needed[1] - needed[0] + 1);
    contact::ToothPoses places{needed[0], slices, std::vector<Pose>(teeth * slices)};
    std::vector<double> const& z = drive.slice_z;
    std::size_t const apart = slices < 2 ? 0 : slices_apart(context, z);
    constexpr std::size_t grain = 32;
    parallel_for(teeth, context.threads, grain, [&](std::size_t i) {
        double const phi =
            2 * std::numbers::pi * (needed[0] + static_cast<int>(i)) / context.scene.drive.flexspline_teeth + phase;
        std::vector<MovedSlice> tooth(slices);
        SeriesPlace const at(drive, phi);
        for (std::size_t k = 0; k < slices; ++k) {
            SeriesValue const along = at(series[drive.stations.axial(k)]);
            tooth[k] = {motions[k]->pose(phi), z[k] + along.value, along.slope};
        }
        for (std::size_t k = 0; k < slices; ++k)
            places.pose[i * slices + k] = slices < 2 ? tooth[k].pose : section(tooth, k, z[k], apart, r_m);
    });
    return places;
}

LoadedTeeth loaded_teeth(contact::ContactContext const& context, ElasticDrive const& drive, LoadedShape const& shape,
                         double turn)
{
    LoadedTeeth teeth;
    teeth.turn = turn;
    teeth.z = drive.slice_z;
    int const count = context.scene.drive.flexspline_teeth;
    double const ratio = conjugate::tooth_ratio(context.scene);
    for (int i = shape.places.first; i < shape.places.first + count; ++i) {
        double const phi = 2 * std::numbers::pi * i / count + drive.phase, space = ratio * phi;
        teeth.phi.push_back(phi);
        for (std::size_t k = 0; k < shape.places.slices; ++k) {
            Pose const& pose = shape.places.at(i, k);
            teeth.origin.push_back(turned_clockwise(pose.origin, space));
            teeth.lean.push_back(std::atan2(pose.sine, pose.cosine) + space);
        }
    }
    return teeth;
}

double normal_displacement(ElasticDrive const& drive, LoadedShape const& shape, FlankContact const& c)
{
    double const phi = 2 * std::numbers::pi * c.tooth / drive.flexspline_teeth + drive.phase;
    SeriesPlace const place(drive, phi);
    auto const at = [&](std::size_t station) { return place(shape.series[station]).value; };
    return c.c_r * at(drive.stations.radial(c.slice)) + c.c_t * at(drive.stations.tangential(c.slice)) +
           c.c_turn * at(drive.stations.turn(c.slice));
}

}  // namespace hdconj::load
