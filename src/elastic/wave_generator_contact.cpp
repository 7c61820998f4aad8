// SPDX-License-Identifier: GPL-3.0-or-later
#include "wave_generator_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ball_line.hpp"

namespace hdconj::elastic {
namespace {

using Eigen::Index;

/// Fourier coefficients [N/rad] of the forces at the points and all that they stand for.
void set_loads(WaveGeneratorContact& out, std::vector<int> const& harmonics, int waves, bool mirrored)
{
    auto const terms = static_cast<Index>(harmonics.size());
    auto const circles = static_cast<Index>(out.z.size());
    out.load_cosine = out.load_sine = Eigen::MatrixXd::Zero(circles, terms);
    for (Index k = 0; k < terms; ++k) {
        int const n = harmonics[static_cast<std::size_t>(k)];
        double const weight = waves * (mirrored ? 2 : 1) / (std::numbers::pi * (n == 0 ? 2 : 1));
        for (Index i = 0; i < out.force.rows(); ++i) {
            double const angle = n * out.phi[static_cast<std::size_t>(i)];
            out.load_cosine.col(k) += weight * std::cos(angle) * out.force.row(i).transpose();
            if (!mirrored)
                out.load_sine.col(k) += weight * std::sin(angle) * out.force.row(i).transpose();
        }
    }
}

/// Displacements of the stations after the first `circles` ones, on which the loads act.
DisplacementSeries displaced(WaveGeneratorContact const& out, Influence const& cup, int waves)
{
    auto const circles = static_cast<Index>(out.z.size());
    auto const stations = static_cast<Index>(cup.stations()) - circles;
    auto const terms = static_cast<Index>(cup.harmonics().size());
    DisplacementSeries series{waves, Eigen::MatrixXd::Zero(stations, terms), Eigen::MatrixXd::Zero(stations, terms)};
    for (Index k = 0; k < terms; ++k) {
        auto const& c = cup.compliance(static_cast<std::size_t>(k));
        Eigen::VectorXd const even = c.bottomLeftCorner(stations, circles) * out.load_cosine.col(k);
        Eigen::VectorXd const odd = c.bottomLeftCorner(stations, circles) * out.load_sine.col(k);
        for (Index a = 0; a < stations; ++a) {
            // loads q cos n phi move the wall by V sin n phi along its circumference, loads q sin n phi by -V cos n phi
            bool const tangential = cup.direction(static_cast<std::size_t>(a + circles)) == Direction::tangential;
            series.cosine(a, k) = tangential ? -odd[a] : even[a];
            series.sine(a, k) = tangential ? even[a] : odd[a];
        }
    }
    return series;
}

/// How far the unloaded bearing reaches beyond the cup's inner surface at every contact [mm].
Eigen::VectorXd approach_of(BearingSurface const& surface, int waves, std::vector<double> const& phi)
{
    auto const circles = static_cast<Index>(surface.z.size());
    Eigen::VectorXd approach(static_cast<Index>(phi.size()) * circles);
    for (std::size_t i = 0; i < phi.size(); ++i) {
        Eigen::VectorXd cosine(surface.cosine.cols()), sine(surface.cosine.cols());
        for (Index k = 0; k < cosine.size(); ++k) {
            double const angle = static_cast<double>(k) * waves * phi[i];
            cosine[k] = std::cos(angle);
            sine[k] = std::sin(angle);
        }
        approach.segment(static_cast<Index>(i) * circles, circles) = surface.cosine * cosine + surface.sine * sine;
    }
    return approach;
}

/// The contacts of an elastic bearing, and the forces and gaps of its balls into @p out.
/// @param half  points of the line of balls in half a lobe
numeric::ComplementaritySolution solve_on_ring(numeric::Complementarity& contact, BearingSurface const& surface,
                                               std::vector<InfluencePoint> const& points, Repetition const& repetition,
                                               int half, numeric::ComplementarityOptions const& options,
                                               WaveGeneratorContact& out)
{
    BearingContacts places;
    for (InfluencePoint const& point : points) {
        places.phi.push_back(point.phi);
        places.z.push_back(static_cast<Index>(point.station));
    }
    bool const mirrored = repetition.mirrored;
    BallLine const line = ball_line(surface, repetition.waves, places, 2 * half, mirrored, options.threads);
    BallContact balls = solve_on_balls(contact, 0, line, options);
    // a force on a mirror plane stands for two at the same point
    if (mirrored)
        for (Index const m : {Index(0), balls.force.size() - 1})
            balls.force[m] *= 2;
    out.ball_phi = line.phi;
    out.ball_force.assign(balls.force.begin(), balls.force.end());
    out.ball_gap.assign(balls.gap.begin(), balls.gap.end());
    return std::move(balls.contacts);
}

}  // namespace

double DisplacementSeries::at(std::size_t station, double phi) const
{
    auto const a = static_cast<Index>(station);
    double sum = 0;
    for (Index k = 0; k < cosine.cols(); ++k) {
        double const angle = static_cast<double>(k) * waves * phi;
        sum += cosine(a, k) * std::cos(angle) + sine(a, k) * std::sin(angle);
    }
    return sum;
}

WaveGeneratorContact solve_wave_generator(FourierSolid const& cup, double inner_radius, Bearing const& bearing,
                                          CamSeries const& cam, int across, std::vector<Station> const& stations,
                                          int threads)
{
    int const half = static_cast<int>(cam.cosine.size()) - 1;
    int const waves = cam.waves;
    WaveGeneratorContact out;
    out.z = bearing_circles(bearing, across);
    BearingSurface const surface = bearing_surface(bearing, inner_radius, cam, out.z, threads);
    std::vector<Station> all;
    for (double const z : out.z)
        all.push_back(wall_station(cup.mesh(), z, 0, Direction::radial));
    all.insert(all.end(), stations.begin(), stations.end());
    std::vector<int> const harmonics = harmonics_of(waves, half * waves);
    out.unit = unit_fields(cup, {}, all, harmonics, threads);
    Influence const wall = influence_of_fields(cup, *out.unit, all, threads);

    bool const mirrored = cam.even;
    for (int j = 0; j < (mirrored ? half + 1 : 2 * half); ++j)
        out.phi.push_back(std::numbers::pi * j / (half * waves));
    std::vector<InfluencePoint> points;
    for (double const phi : out.phi)
        for (std::size_t j = 0; j < out.z.size(); ++j)
            points.push_back({j, phi});
    Repetition const repetition{waves, mirrored};
    numeric::Complementarity contact;
    contact.compliance = wall.matrix(points, repetition, threads);
    if (surface.compliance)
        contact.compliance += surface.compliance->matrix(points, repetition, threads);
    contact.approach = approach_of(surface, waves, out.phi);
    numeric::ComplementarityOptions const options{.threads = threads};
    numeric::ComplementaritySolution solved =
        surface.compliance ? solve_on_ring(contact, surface, points, repetition, half, options, out)
                           : numeric::solve_complementarity(contact, options);
    auto const circles = static_cast<Index>(out.z.size()), angles = static_cast<Index>(out.phi.size());
    out.iterations = solved.iterations;
    out.residual = solved.residual;
    out.method = solved.method;
    out.force = Eigen::Map<Eigen::MatrixXd>(solved.force.data(), circles, angles).transpose();
    out.gap = Eigen::Map<Eigen::MatrixXd>(solved.gap.data(), circles, angles).transpose();
    out.total_force = waves * (mirrored ? 2 : 1) * out.force.sum();
    set_loads(out, harmonics, waves, mirrored);
    out.displacement = displaced(out, wall, waves);
    if (mirrored) {
        out.force.row(0) *= 2;
        out.force.row(angles - 1) *= 2;
    }
    return out;
}

}  // namespace hdconj::elastic
