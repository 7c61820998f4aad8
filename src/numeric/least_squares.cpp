// SPDX-License-Identifier: GPL-3.0-or-later
#include "least_squares.hpp"

#include "dense.hpp"

namespace hdconj::numeric {

using Eigen::MatrixXd;
using Eigen::VectorXd;

LeastSquares::LeastSquares(MatrixXd const& a) : qr_(a) {}

LeastSquares::LeastSquares(MatrixXd const& a, double threshold) : qr_(a)
{
    qr_.setThreshold(threshold);
}

VectorXd LeastSquares::solve(VectorXd const& b) const
{
    return qr_.solve(b);
}

MatrixXd LeastSquares::solve(MatrixXd const& b) const
{
    return qr_.solve(b);
}

MatrixXd covariance(MatrixXd const& a)
{
    return LU(a.transpose() * a).inverse();
}

}  // namespace hdconj::numeric
