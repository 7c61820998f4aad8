// SPDX-License-Identifier: GPL-3.0-or-later
#include "bent_cup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "hdconj/error.hpp"
#include "kept_results.hpp"

namespace hdconj::elastic {
using Eigen::Index;

BentCup::BentCup(CupSection const& section, Bearing const& bearing, CamSeries const& cam, int circles, int threads,
                 int layers)
    : section_(section),
      bearing_(bearing),
      cam_(cam),
      solid_(section_mesh(section, in_layers(contact_mesh_size(section, bearing.width, circles), section, layers))),
      contact_(solve_wave_generator(solid_, section.inner_radius, bearing, cam, circles, {}, threads)),
      field_(harmonic_field(*contact_.unit, contact_.load_cosine, contact_.load_sine, threads))
{
    contact_.unit.reset();
}

std::shared_ptr<BentCup const> solved_cup(CupSection const& section, Bearing const& bearing, CamSeries const& cam,
                                          BentCupGrid const& grid, int threads)
{
    auto const depends_on = [&](Dependencies& dependencies) {
        dependencies.add(section);
        dependencies.add(bearing);
        dependencies.add(cam);
        dependencies.add(grid.circles);
        dependencies.add(grid.layers);
    };
    return kept_or_made<BentCup>(depends_on,
                                 [&] { return BentCup(section, bearing, cam, grid.circles, threads, grid.layers); });
}

SectionPoint BentCup::place(double z, double radius) const
{
    double const inner = section_.inner_radius;
    double const wall = position(solid_.mesh(), wall_point(solid_.mesh(), z, 1)).x() - inner;
    double const depth = (radius - inner) / wall;
    constexpr double rounding = 1e-9;  // of a radius made of other lengths
    if (!(depth > -rounding && depth < 1 + rounding))
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", "height " + std::to_string(z) + " mm",
                             "the wall here does not reach the radius of the neutral layer, " + std::to_string(radius) +
                                 " mm: the teeth must end where their ring does");
    return wall_point(solid_.mesh(), z, std::clamp(depth, 0.0, 1.0));
}

wavegen::MaterialDisplacement BentCup::displacement(double z, double radius) const
{
    PointAmplitudes const at = amplitudes_at(solid_.mesh(), field_, place(z, radius));
    wavegen::MaterialDisplacement result{cam_.waves, {}};
    for (Index k = 0; k < at.even.cols(); ++k)
        result.harmonics.push_back({at.even(0, k), at.odd(0, k), -at.odd(2, k), at.even(2, k)});
    // -0 is no sine: what is symmetric stays so
    wavegen::drop_empty_tail(result);
    return result;
}

wavegen::MaterialDisplacement BentCup::axial_displacement(double z, double radius) const
{
    PointAmplitudes const at = amplitudes_at(solid_.mesh(), field_, place(z, radius));
    wavegen::MaterialDisplacement result{cam_.waves, {}};
    for (Index k = 0; k < at.even.cols(); ++k)
        result.harmonics.push_back({at.even(1, k), at.odd(1, k), 0, 0});
    return result;
}

AxialMove BentCup::axial(double z, double radius, double phi) const
{
    auto const move = [&](double height, bool slope) {
        PointAmplitudes const at = amplitudes_at(solid_.mesh(), field_, place(height, radius));
        double sum = 0;
        for (Index k = 0; k < at.even.cols(); ++k) {
            double const n = field_.harmonics[static_cast<std::size_t>(k)];
            double const c = std::cos(n * phi), s = std::sin(n * phi);
            sum += slope ? n * (at.odd(1, k) * c - at.even(1, k) * s) : at.even(1, k) * c + at.odd(1, k) * s;
        }
        return sum;
    };
    constexpr double step = 0.01;  // [mm], a small part of an element: u_z is nearly constant along the wall
    return {move(z, false), move(z, true), (move(z + step, false) - move(z - step, false)) / (2 * step)};
}

double BentCup::coning(double phi) const
{
    return std::atan(wall_slope(solid_.mesh(), field_, section_.ring_begin, section_.ring_end, phi));
}

double wall_slope(SectionMesh const& mesh, HarmonicField const& field, double begin, double end, double phi)
{
    constexpr int intervals = 32;
    double top = 0, bottom = 0;
    for (int i = 0; i <= intervals; ++i) {
        double const t = static_cast<double>(i) / intervals - 0.5;
        double const z = (begin + end) / 2 + t * (end - begin);
        top += t * displacement_at(mesh, field, wall_point(mesh, z, 0), phi)[0];
        bottom += t * t;
    }
    return top / bottom / (end - begin);
}

namespace {

constexpr int compared_angles = 128;  // of a lobe

}  // namespace

BentCupError distance_between(BentCup const& cup, BentCup const& other, std::vector<double> const& z, double radius)
{
    BentCupError distance;
    for (double const height : z) {
        wavegen::MaterialDisplacement const a = cup.displacement(height, radius),
                                            b = other.displacement(height, radius);
        for (double const phi : even_angles(compared_angles, a.waves)) {
            wavegen::PointDisplacement const p = wavegen::displacement_at(a, phi), q = wavegen::displacement_at(b, phi);
            distance.displacement = std::max(distance.displacement, std::hypot(p.w[0] - q.w[0], p.v[0] - q.v[0]));
        }
    }
    distance.coning_major = std::abs(cup.coning(0) - other.coning(0));
    distance.force = std::abs(cup.contact().total_force - other.contact().total_force);
    return distance;
}

BentCupError bent_cup_error(BentCup const& cup, BentCup const& other, std::vector<double> const& z, double radius)
{
    // the pressure at a bearing's edge is singular, and what it adds up to is of order one half in the grid: of two
    // grids the finer one is off by 1/(sqrt 2 - 1) times their distance
    double const safety = 3 / (std::numbers::sqrt2 - 1);
    BentCupError const distance = distance_between(cup, other, z, radius);
    double moved = 0;
    for (double const height : z) {
        wavegen::MaterialDisplacement const a = cup.displacement(height, radius);
        for (double const phi : even_angles(compared_angles, a.waves))
            moved = std::max(moved,
                             std::hypot(wavegen::displacement_at(a, phi).w[0], wavegen::displacement_at(a, phi).v[0]));
    }
    double const coning = std::abs(cup.coning(0)), force = cup.contact().total_force;
    // two grids may agree in one figure by chance: none is known better than the middle one, relative to its size
    auto const relative = [](double off, double size) { return size > 0 ? off / size : 0; };
    std::array<double, 3> shares = {relative(distance.displacement, moved), relative(distance.coning_major, coning),
                                    relative(distance.force, force)};
    std::sort(shares.begin(), shares.end());
    double const least = shares[1];
    return {safety * std::max(distance.displacement, least * moved),
            safety * std::max(distance.coning_major, least * coning), safety * std::max(distance.force, least * force)};
}

BentCupGrid discretised_otherwise(BentCupGrid const& grid)
{
    constexpr int fewest_angles = 8, fewest_circles = 2;
    return {std::max(std::min(grid.angles, fewest_angles), grid.angles / 4 * 2),
            std::max(std::min(grid.circles, fewest_circles), (grid.circles + 1) / 2), 2 * grid.layers};
}

}  // namespace hdconj::elastic
