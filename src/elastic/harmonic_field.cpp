// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonic_field.hpp"

#include <cmath>
#include <numbers>

#include "hdconj/base/parallel.hpp"

namespace hdconj::elastic {

using Eigen::Index;

HarmonicField harmonic_field(UnitFields const& unit, Eigen::MatrixXd const& even, Eigen::MatrixXd const& odd,
                             int threads)
{
    auto const terms = static_cast<Index>(unit.harmonics.size());
    Index const unknowns = unit.moved.empty() ? 0 : unit.moved.front().rows();
    HarmonicField field{unit.harmonics, Eigen::MatrixXd(unknowns, terms), Eigen::MatrixXd(unknowns, terms)};
    constexpr std::size_t grain = 8;
    parallel_for(unit.harmonics.size(), threads, grain, [&](std::size_t i) {
        auto const k = static_cast<Index>(i);
        field.even.col(k) = unit.moved[i] * even.col(k);
        field.odd.col(k) = unit.moved[i] * odd.col(k);
    });
    return field;
}

PointAmplitudes amplitudes_at(SectionMesh const& mesh, HarmonicField const& field, SectionPoint const& place)
{
    auto const n = shape_functions(place.xi, place.eta);
    QuadraticElement const& element = mesh.elements[place.element];
    PointAmplitudes at{Eigen::Matrix3Xd::Zero(3, field.even.cols()), Eigen::Matrix3Xd::Zero(3, field.even.cols())};
    for (std::size_t a = 0; a < n.size(); ++a) {
        Index const row = 3 * static_cast<Index>(element[a]);
        at.even += n[a] * field.even.middleRows<3>(row);
        at.odd += n[a] * field.odd.middleRows<3>(row);
    }
    return at;
}

namespace {

Eigen::Vector3d displaced(PointAmplitudes const& at, HarmonicField const& field, double phi)
{
    Eigen::Vector3d u = Eigen::Vector3d::Zero();
    for (Index k = 0; k < at.even.cols(); ++k) {
        double const angle = field.harmonics[static_cast<std::size_t>(k)] * phi;
        double const c = std::cos(angle), s = std::sin(angle);
        u.head<2>() += at.even.col(k).head<2>() * c + at.odd.col(k).head<2>() * s;
        u[2] += at.even(2, k) * s - at.odd(2, k) * c;
    }
    return u;
}

}  // namespace

std::vector<double> even_angles(int count, int sectors)
{
    std::vector<double> phi;
    for (int i = 0; i < count; ++i)
        phi.push_back(2 * std::numbers::pi * i / (sectors * count));
    return phi;
}

Eigen::Matrix3Xd displacements_at(SectionMesh const& mesh, HarmonicField const& field, SectionPoint const& place,
                                  HarmonicWaves const& waves)
{
    PointAmplitudes const at = amplitudes_at(mesh, field, place);
    Eigen::Matrix3Xd u(3, waves.cosine.cols());
    u.topRows<2>().noalias() = at.even.topRows<2>() * waves.cosine + at.odd.topRows<2>() * waves.sine;
    u.bottomRows<1>().noalias() = at.even.bottomRows<1>() * waves.sine - at.odd.bottomRows<1>() * waves.cosine;
    return u;
}

Eigen::Vector3d displacement_at(SectionMesh const& mesh, HarmonicField const& field, SectionPoint const& place,
                                double phi)
{
    return displaced(amplitudes_at(mesh, field, place), field, phi);
}

Eigen::Vector3d node_displacement(HarmonicField const& field, int node, double phi)
{
    auto const row = 3 * static_cast<Index>(node);
    return displaced({field.even.middleRows<3>(row), field.odd.middleRows<3>(row)}, field, phi);
}

namespace {

/// Stress amplitudes of each harmonic: rr, zz, tt, rz with cos, rt, zt with sin in the even family.
struct StressAmplitudes
{
    Eigen::Matrix<double, 6, Eigen::Dynamic> even;
    Eigen::Matrix<double, 6, Eigen::Dynamic> odd;
};

StressAmplitudes stress_amplitudes(SectionMesh const& mesh, HarmonicField const& field, SectionPoint const& place)
{
    StrainMatrices const b = strain_matrices(mesh, place);
    StressMatrix const d = mesh.stress(place.element);
    QuadraticElement const& element = mesh.elements[place.element];
    auto const terms = field.even.cols();
    StressAmplitudes at{Eigen::Matrix<double, 6, Eigen::Dynamic>(6, terms),
                        Eigen::Matrix<double, 6, Eigen::Dynamic>(6, terms)};
    Eigen::Matrix<double, 24, 1> even, odd;
    for (Index k = 0; k < terms; ++k) {
        for (std::size_t a = 0; a < element.size(); ++a) {
            Index const row = 3 * static_cast<Index>(element[a]);
            even.segment<3>(static_cast<Index>(3 * a)) = field.even.block<3, 1>(row, k);
            odd.segment<3>(static_cast<Index>(3 * a)) = field.odd.block<3, 1>(row, k);
        }
        Eigen::Matrix<double, 6, 24> const strain =
            b.at_rest + field.harmonics[static_cast<std::size_t>(k)] * b.per_harmonic;
        at.even.col(k) = d * (strain * even);
        at.odd.col(k) = d * (strain * odd);
    }
    return at;
}

Stress stress_of(StressAmplitudes const& at, HarmonicField const& field, double phi)
{
    Stress stress = Stress::Zero();
    for (Index k = 0; k < at.even.cols(); ++k) {
        double const angle = field.harmonics[static_cast<std::size_t>(k)] * phi;
        double const c = std::cos(angle), s = std::sin(angle);
        stress.head<4>() += at.even.col(k).head<4>() * c + at.odd.col(k).head<4>() * s;
        stress.tail<2>() += at.even.col(k).tail<2>() * s - at.odd.col(k).tail<2>() * c;
    }
    return stress;
}

}  // namespace

Stress stress_at(SectionMesh const& mesh, HarmonicField const& field, SectionPoint const& place, double phi)
{
    return stress_of(stress_amplitudes(mesh, field, place), field, phi);
}

double von_mises(Stress const& s)
{
    double const normal = (s[0] - s[1]) * (s[0] - s[1]) + (s[1] - s[2]) * (s[1] - s[2]) + (s[2] - s[0]) * (s[2] - s[0]);
    return std::sqrt(normal / 2 + 3 * s.tail<3>().squaredNorm());
}

std::vector<SectionPoint> gauss_points(SectionMesh const& mesh)
{
    double const g = std::sqrt(1.0 / 3);
    std::vector<SectionPoint> points;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (double const eta : {-g, g})
            for (double const xi : {-g, g})
                points.push_back({e, xi, eta});
    return points;
}

Eigen::MatrixXd gauss_stress(SectionMesh const& mesh, HarmonicField const& field, std::vector<double> const& phi,
                             int threads)
{
    std::vector<SectionPoint> const points = gauss_points(mesh);
    Eigen::MatrixXd result(static_cast<Index>(phi.size()), static_cast<Index>(points.size()));
    HarmonicWaves const waves(field.harmonics, phi, threads);
    constexpr std::size_t worth_a_thread = 64;
    parallel_for(points.size(), threads, worth_a_thread, [&](std::size_t i) {
        StressAmplitudes const at = stress_amplitudes(mesh, field, points[i]);
        Eigen::Matrix<double, 6, Eigen::Dynamic> stress(6, result.rows());
        stress.topRows<4>().noalias() = at.even.topRows<4>() * waves.cosine + at.odd.topRows<4>() * waves.sine;
        stress.bottomRows<2>().noalias() = at.even.bottomRows<2>() * waves.sine - at.odd.bottomRows<2>() * waves.cosine;
        for (Index j = 0; j < result.rows(); ++j)
            result(j, static_cast<Index>(i)) = von_mises(stress.col(j));
    });
    return result.transpose();
}

StressPeak stress_peak(SectionMesh const& mesh, HarmonicField const& field, std::vector<double> const& phi, int threads)
{
    Eigen::MatrixXd const all = gauss_stress(mesh, field, phi, threads);
    if (all.size() == 0)
        return {};
    Index point = 0, angle = 0;
    double const largest = all.maxCoeff(&point, &angle);
    return {largest, position(mesh, gauss_points(mesh)[static_cast<std::size_t>(point)]),
            phi[static_cast<std::size_t>(angle)]};
}

}  // namespace hdconj::elastic
