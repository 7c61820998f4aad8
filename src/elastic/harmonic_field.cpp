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

/// Weights of the four reduced Gauss points of an element at (xi, eta).
std::array<double, 4> gauss_weights(Vec2 const& at)
{
    double const x = std::sqrt(3.0) * at.x(), y = std::sqrt(3.0) * at.y();
    return {(1 - x) * (1 - y) / 4, (1 + x) * (1 - y) / 4, (1 - x) * (1 + y) / 4, (1 + x) * (1 + y) / 4};
}

}  // namespace

double von_mises(Stress const& s)
{
    double const normal = (s[0] - s[1]) * (s[0] - s[1]) + (s[1] - s[2]) * (s[1] - s[2]) + (s[2] - s[0]) * (s[2] - s[0]);
    return std::sqrt(normal / 2 + 3 * s.tail<3>().squaredNorm());
}

Eigen::MatrixXd recovered_stress(SectionMesh const& mesh, HarmonicField const& field, std::vector<Vec2> const& places,
                                 std::vector<double> const& phi, int threads)
{
    double const g = std::sqrt(1.0 / 3);
    auto const count = static_cast<Index>(places.size()), angles = static_cast<Index>(phi.size());
    Eigen::MatrixXd result(angles, count * static_cast<Index>(mesh.elements.size()));
    HarmonicWaves const waves(field.harmonics, phi, threads);
    constexpr std::size_t worth_a_thread = 16;
    parallel_for(mesh.elements.size(), threads, worth_a_thread, [&](std::size_t e) {
        std::array<StressAmplitudes, 4> const gauss{
            stress_amplitudes(mesh, field, {e, -g, -g}), stress_amplitudes(mesh, field, {e, g, -g}),
            stress_amplitudes(mesh, field, {e, -g, g}), stress_amplitudes(mesh, field, {e, g, g})};
        for (std::size_t p = 0; p < places.size(); ++p) {
            std::array<double, 4> const weight = gauss_weights(places[p]);
            StressAmplitudes at{weight[0] * gauss[0].even, weight[0] * gauss[0].odd};
            for (std::size_t i = 1; i < gauss.size(); ++i) {
                at.even += weight[i] * gauss[i].even;
                at.odd += weight[i] * gauss[i].odd;
            }
            Eigen::Matrix<double, 6, Eigen::Dynamic> stress(6, angles);
            stress.topRows<4>().noalias() = at.even.topRows<4>() * waves.cosine + at.odd.topRows<4>() * waves.sine;
            stress.bottomRows<2>().noalias() =
                at.even.bottomRows<2>() * waves.sine - at.odd.bottomRows<2>() * waves.cosine;
            for (Index j = 0; j < angles; ++j)
                result(j, count * static_cast<Index>(e) + static_cast<Index>(p)) = von_mises(stress.col(j));
        }
    });
    return result.transpose();
}

StressPeak stress_peak(SectionMesh const& mesh, HarmonicField const& field, std::vector<double> const& phi,
                       Seat const& seat, int threads)
{
    double const g = std::sqrt(1.0 / 3);
    std::vector<Vec2> const places{{-1, -g}, {1, -g}, {-1, g}, {1, g}};
    Eigen::MatrixXd const all = recovered_stress(mesh, field, places, phi, threads);
    auto const counts = [&](SectionPoint const& point) {
        if (point.element >= mesh.wall_elements())
            return true;
        auto const layers = static_cast<std::size_t>(mesh.layers);
        if (point.xi > 0)
            return point.element % layers + 1 == layers;
        return point.element % layers == 0 && !seat.covers(position(mesh, point).y());
    };
    StressPeak peak;
    for (Index row = 0; row < all.rows(); ++row) {
        auto const point = static_cast<std::size_t>(row);
        Vec2 const& at = places[point % places.size()];
        SectionPoint const place{point / places.size(), at.x(), at.y()};
        Index angle = 0;
        double const largest = all.row(row).maxCoeff(&angle);
        if (largest > peak.stress && counts(place))
            peak = {largest, place, phi[static_cast<std::size_t>(angle)]};
    }
    return peak;
}

}  // namespace hdconj::elastic
