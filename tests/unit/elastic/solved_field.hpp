// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The second path to the field of a body under loads: each harmonic solved with them.
#pragma once

#include <vector>

#include "elastic/harmonic_field.hpp"

namespace hdconj::test {

/// The field under @p even and @p odd, as harmonic_field() takes them.
inline elastic::HarmonicField solved_field(elastic::FourierSolid const& solid, elastic::Supports const& supports,
                                           std::vector<elastic::Station> const& stations,
                                           std::vector<int> const& harmonics, Eigen::MatrixXd const& even,
                                           Eigen::MatrixXd const& odd)
{
    Eigen::MatrixXd const shares = elastic::station_shares(solid, stations);
    auto const terms = static_cast<Eigen::Index>(harmonics.size());
    elastic::HarmonicField field{harmonics, Eigen::MatrixXd(solid.unknowns(), terms),
                                 Eigen::MatrixXd(solid.unknowns(), terms)};
    elastic::for_each_harmonic(solid, supports, harmonics, 1, [&](std::size_t i, elastic::HarmonicSolver const& solve) {
        auto const k = static_cast<Eigen::Index>(i);
        Eigen::MatrixXd loads(solid.unknowns(), 2);
        loads.col(0) = shares * even.col(k);
        loads.col(1) = shares * odd.col(k);
        Eigen::MatrixXd const moved = solve(loads);
        field.even.col(k) = moved.col(0);
        field.odd.col(k) = moved.col(1);
    });
    return field;
}

}  // namespace hdconj::test
