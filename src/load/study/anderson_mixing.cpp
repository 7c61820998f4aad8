// SPDX-License-Identifier: GPL-3.0-or-later
#include "anderson_mixing.hpp"

#include <cstddef>

#include "load/elastic_drive.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::load {

Eigen::VectorXd displacement_change(LoadProblem const& problem, LoadedShape const& shape, double turn_of_shape,
                                    Eigen::MatrixXd const& forces, double turn)
{
    std::vector<std::vector<double>> const series = displacements(problem.drive, forces, problem.context.threads);
    Eigen::VectorXd change(static_cast<Eigen::Index>(series.size() * series.front().size()) + 1);
    Eigen::Index i = 0;
    for (std::size_t station = 0; station < series.size(); ++station) {
        double const scale = station >= problem.drive.stations.turn(0) ? problem.context.scene.drive.module : 1;
        for (std::size_t k = 0; k < series[station].size(); ++k)
            change[i++] = scale * (series[station][k] - shape.series[station][k]);
    }
    change[i] = (turn - turn_of_shape) * problem.context.geometry.r_m;
    return change;
}

void anderson_mix(std::vector<MixingStep> const& history, LoadedDrive& now)
{
    auto const others = static_cast<Eigen::Index>(history.size() - 1);
    if (others == 0)
        return;
    Eigen::VectorXd const& last = history.back().change;
    Eigen::MatrixXd differences(last.size(), others);
    for (Eigen::Index i = 0; i < others; ++i) {
        auto const k = static_cast<std::size_t>(i);
        differences.col(i) = history[k + 1].change - history[k].change;
    }
    Eigen::VectorXd const weight = numeric::LeastSquares(differences).solve(last);
    for (Eigen::Index i = 0; i < others; ++i) {
        auto const k = static_cast<std::size_t>(i);
        now.forces -= weight[i] * (history[k + 1].forces - history[k].forces);
        now.state.turn -= weight[i] * (history[k + 1].turn - history[k].turn);
    }
}

}  // namespace hdconj::load
