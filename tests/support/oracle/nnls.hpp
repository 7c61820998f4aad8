// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Non-negative least squares by Lawson and Hanson (1974): the least of 1/2 f'G f - d'f over f >= 0 by a path of its
/// own.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <vector>

namespace hdconj::test {

/// Minimises |L'f - L^-1 d| with G = L L', by orthogonal factorisations of columns of L'.
inline Eigen::VectorXd nnls(Eigen::MatrixXd const& g, Eigen::VectorXd const& d)
{
    using Eigen::Index;
    Eigen::LLT<Eigen::MatrixXd> const llt(g);
    Eigen::MatrixXd const a = llt.matrixU();
    Eigen::VectorXd const right = llt.matrixL().solve(d);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(d.size());
    std::vector<int> passive;
    auto const solved = [&] {
        return Eigen::VectorXd(Eigen::MatrixXd(a(Eigen::all, passive)).colPivHouseholderQr().solve(right));
    };
    for (;;) {
        Eigen::VectorXd slope = a.transpose() * (right - a * x);
        for (int i : passive)
            slope[i] = 0;
        Index best = 0;
        double const enough = 1e-13 * d.cwiseAbs().maxCoeff();
        if (slope.maxCoeff(&best) <= enough)
            return x;
        passive.push_back(static_cast<int>(best));
        for (;;) {
            Eigen::VectorXd const z = solved();
            double step = 1;
            for (std::size_t i = 0; i < passive.size(); ++i)
                if (auto const k = static_cast<Index>(i); z[k] <= 0)
                    step = std::min(step, x[passive[i]] / (x[passive[i]] - z[k]));
            for (std::size_t i = 0; i < passive.size(); ++i)
                x[passive[i]] += step * (z[static_cast<Index>(i)] - x[passive[i]]);
            if (step >= 1)
                break;
            std::vector<int> left;
            double const none = 1e-15 * x.cwiseAbs().maxCoeff();
            for (int i : passive)
                if (x[i] > none)
                    left.push_back(i);
                else
                    x[i] = 0;
            passive = left;
        }
    }
}

}  // namespace hdconj::test
