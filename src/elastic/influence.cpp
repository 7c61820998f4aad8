// SPDX-License-Identifier: GPL-3.0-or-later
#include "influence.hpp"

#include <Eigen/SparseCore>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "hdconj/base/parallel.hpp"
#include "kept_results.hpp"

namespace hdconj::elastic {
namespace {

/// Whether a component goes with sin n phi.
bool is_odd(Direction direction)
{
    return direction == Direction::tangential;
}

/// Factor of the compliance of harmonic n: c_n, times the number of forces that answer; 0 where they cancel.
double weight(int n, Repetition const& repetition)
{
    if (n % repetition.waves != 0)
        return 0;
    return (n == 0 ? 1 / (2 * std::numbers::pi) : 1 / std::numbers::pi) * repetition.waves;
}

HarmonicWaves waves_at(std::vector<InfluencePoint> const& points, std::vector<int> const& harmonics, int threads)
{
    std::vector<double> phi;
    for (InfluencePoint const& point : points)
        phi.push_back(point.phi);
    return {harmonics, phi, threads};
}

}  // namespace

HarmonicWaves::HarmonicWaves(std::vector<int> const& harmonics, std::vector<double> const& phi, int threads)
    : cosine(static_cast<Eigen::Index>(harmonics.size()), static_cast<Eigen::Index>(phi.size())),
      sine(cosine.rows(), cosine.cols())
{
    constexpr std::size_t worth_a_thread = 32;
    parallel_for(phi.size(), threads, worth_a_thread, [&](std::size_t i) {
        for (Eigen::Index k = 0; k < cosine.rows(); ++k) {
            double const angle = harmonics[static_cast<std::size_t>(k)] * phi[i];
            cosine(k, static_cast<Eigen::Index>(i)) = std::cos(angle);
            sine(k, static_cast<Eigen::Index>(i)) = std::sin(angle);
        }
    });
}

std::vector<int> harmonics_of(int waves, int highest)
{
    std::vector<int> harmonics;
    for (int n = 0; n <= highest; n += waves)
        harmonics.push_back(n);
    return harmonics;
}

Influence::Influence(std::vector<Direction> directions, std::vector<int> harmonics,
                     std::vector<Eigen::MatrixXd> compliance)
    : directions_(std::move(directions)), harmonics_(std::move(harmonics)), compliance_(std::move(compliance))
{
    if (harmonics_.size() != compliance_.size())
        throw std::invalid_argument("Influence: one matrix for each harmonic");
}

double Influence::operator()(InfluencePoint const& at, InfluencePoint const& load, Repetition const& repetition) const
{
    return matrix({at}, {load}, repetition)(0, 0);
}

Eigen::MatrixXd Influence::matrix(std::vector<InfluencePoint> const& points, Repetition const& repetition,
                                  int threads) const
{
    Eigen::MatrixXd all = matrix(points, points, repetition, threads);
    // sums in another order differ by rounding
    all.triangularView<Eigen::StrictlyLower>() = all.transpose();
    return all;
}

Eigen::MatrixXd Influence::matrix(std::vector<InfluencePoint> const& at, std::vector<InfluencePoint> const& loads,
                                  Repetition const& repetition, int threads) const
{
    auto const rows = static_cast<Eigen::Index>(at.size()), columns = static_cast<Eigen::Index>(loads.size());
    auto const terms = static_cast<Eigen::Index>(harmonics_.size());
    HarmonicWaves const to = waves_at(at, harmonics_, threads),
                        from = &loads == &at ? to : waves_at(loads, harmonics_, threads);
    // column of each pair of stations: the weighted compliances, harmonic by harmonic
    auto const count = static_cast<Eigen::Index>(stations());
    Eigen::MatrixXd pairs(terms, count * count);
    for (Eigen::Index k = 0; k < terms; ++k) {
        double const c = weight(harmonics_[static_cast<std::size_t>(k)], repetition);
        for (Eigen::Index a = 0; a < count; ++a)
            for (Eigen::Index b = 0; b < count; ++b)
                pairs(k, a * count + b) = c * compliance_[static_cast<std::size_t>(k)](a, b);
    }
    Eigen::MatrixXd result(columns, rows);
    constexpr std::size_t worth_a_thread = 8;
    parallel_for(at.size(), threads, worth_a_thread, [&](std::size_t i) {
        auto const row = static_cast<Eigen::Index>(i);
        auto const a = static_cast<Eigen::Index>(at[i].station);
        bool const odd = is_odd(directions_[at[i].station]);
        auto const c = to.cosine.col(row).array(), s = to.sine.col(row).array();
        for (Eigen::Index column = 0; column < columns; ++column) {
            auto const station = loads[static_cast<std::size_t>(column)].station;
            auto const pair = pairs.col(a * count + static_cast<Eigen::Index>(station)).array();
            auto const cl = from.cosine.col(column).array(), sl = from.sine.col(column).array();
            bool const odd_load = is_odd(directions_[station]);
            // h = f(n phi) F(n phi') + g(n phi) G(n phi'); a mirrored force doubles the first term and cancels the
            // second
            double first = 0, second = 0;
            if (!odd && !odd_load)
                first = (pair * c * cl).sum(), second = repetition.mirrored ? 0 : (pair * s * sl).sum();
            else if (odd && odd_load)
                first = (pair * s * sl).sum(), second = repetition.mirrored ? 0 : (pair * c * cl).sum();
            else if (odd)
                first = (pair * s * cl).sum(), second = repetition.mirrored ? 0 : -(pair * c * sl).sum();
            else
                first = (pair * c * sl).sum(), second = repetition.mirrored ? 0 : -(pair * s * cl).sum();
            result(column, row) = repetition.mirrored ? 2 * first : first + second;
        }
    });
    return result.transpose();
}

Eigen::MatrixXd station_shares(FourierSolid const& solid, std::vector<Station> const& stations)
{
    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(solid.unknowns(), static_cast<Eigen::Index>(stations.size()));
    for (std::size_t b = 0; b < stations.size(); ++b) {
        auto const n = shape_functions(stations[b].place.xi, stations[b].place.eta);
        auto const& nodes = solid.mesh().elements[stations[b].place.element];
        for (std::size_t a = 0; a < n.size(); ++a)
            shares(3 * static_cast<Eigen::Index>(nodes[a]) + static_cast<Eigen::Index>(stations[b].direction),
                   static_cast<Eigen::Index>(b)) = n[a];
    }
    return shares;
}

std::shared_ptr<UnitFields const> unit_fields(FourierSolid const& solid, Supports const& supports,
                                              std::vector<Station> const& stations, std::vector<int> const& harmonics,
                                              int threads)
{
    auto const depends_on = [&](Dependencies& dependencies) {
        dependencies.add(solid);
        dependencies.add(supports);
        dependencies.add(stations);
        dependencies.add(harmonics);
    };
    return kept_or_made<UnitFields>(depends_on, [&] {
        Eigen::MatrixXd const shares = station_shares(solid, stations);
        UnitFields result{harmonics, std::vector<Eigen::MatrixXd>(harmonics.size())};
        for_each_harmonic(solid, supports, harmonics, threads,
                          [&](std::size_t i, HarmonicSolver const& solve) { result.moved[i] = solve(shares); });
        return result;
    });
}

Influence influence_of_fields(FourierSolid const& solid, UnitFields const& unit, std::vector<Station> const& stations,
                              int threads)
{
    std::vector<Direction> directions;
    for (Station const& station : stations)
        directions.push_back(station.direction);
    // a station is felt at the nodes of one element
    Eigen::SparseMatrix<double, Eigen::RowMajor> const felt = station_shares(solid, stations).transpose().sparseView();
    std::vector<Eigen::MatrixXd> compliance(unit.harmonics.size());
    constexpr std::size_t worth_a_thread = 16;
    parallel_for(compliance.size(), threads, worth_a_thread, [&](std::size_t i) {
        Eigen::MatrixXd const s = felt * unit.moved[i];
        compliance[i] = (s + s.transpose()) / 2;
    });
    return {std::move(directions), unit.harmonics, std::move(compliance)};
}

Influence influence(FourierSolid const& solid, Supports const& supports, std::vector<Station> const& stations,
                    std::vector<int> const& harmonics, int threads)
{
    return influence_of_fields(solid, *unit_fields(solid, supports, stations, harmonics, threads), stations, threads);
}

}  // namespace hdconj::elastic
