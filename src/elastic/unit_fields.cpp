// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit_fields.hpp"

#include <Eigen/SparseCore>

#include <utility>

#include "hdconj/base/parallel.hpp"

namespace hdconj::elastic {

using Eigen::Index;

UnitFields unit_fields(FourierSolid const& solid, Supports const& supports, std::vector<Station> const& stations,
                       std::vector<int> const& harmonics, int threads)
{
    Eigen::MatrixXd const shares = station_shares(solid, stations);
    UnitFields result{harmonics, std::vector<Eigen::MatrixXd>(harmonics.size())};
    parallel_for(harmonics.size(), threads, 1,
                 [&](std::size_t i) { result.moved[i] = HarmonicSolver(solid, supports, harmonics[i])(shares); });
    return result;
}

Influence influence(FourierSolid const& solid, UnitFields const& unit, std::vector<Station> const& stations,
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

}  // namespace hdconj::elastic
