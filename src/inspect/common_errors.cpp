// SPDX-License-Identifier: GPL-3.0-or-later
#include "common_errors.hpp"

namespace hdconj::inspect {
namespace {

constexpr double least_bend = 0.02;  // of the pivots: points over some quarter of the flanks
constexpr int side_terms = CommonErrors::terms / 2;

/// Rise and square of xi on one side, without the part that a turn of the side makes.
Eigen::MatrixXd bends_of(Eigen::MatrixXd const& raw, int first)
{
    Eigen::MatrixXd mix = Eigen::MatrixXd::Zero(CommonErrors::terms, side_terms - 1);
    auto const turn = raw.col(first);
    for (int k = 1; k < side_terms; ++k) {
        mix(first + k, k - 1) = 1;
        mix(first, k - 1) = -turn.dot(raw.col(first + k)) / turn.squaredNorm();
    }
    return mix;
}

}  // namespace

CommonErrors::CommonErrors(std::vector<PointView> const& views, NominalPart const& part, CommonErrorsKnown known)
    : raw_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(views.size()), terms)), mix_(terms, 0)
{
    double const radius = part.planes.front().reference_radius;
    for (std::size_t i = 0; i < views.size(); ++i) {
        PointView const& view = views[i];
        NominalFlank const& flank = part.planes[view.plane].flank(view.right);
        double const xi = 2 * flank.arc_length(view.foot) / flank.length() - 1;
        raw_.row(static_cast<Eigen::Index>(i)).segment<side_terms>(view.right ? side_terms : 0)
            << view.by_turn() / radius,
            xi, xi * xi;
    }
    bool const left = !raw_.col(0).isZero(0), right = !raw_.col(side_terms).isZero(0);
    has_excess_ = left && right && known != CommonErrorsKnown::none;
    Eigen::VectorXd excess = Eigen::VectorXd::Zero(terms);
    excess[0] = -1;
    excess[side_terms] = 1;
    Eigen::MatrixXd all(terms, (has_excess_ ? 1 : 0) + (side_terms - 1) * ((left ? 1 : 0) + (right ? 1 : 0)));
    if (has_excess_)
        all.col(0) = excess;
    if (left)
        all.middleCols(has_excess_ ? 1 : 0, side_terms - 1) = bends_of(raw_, 0);
    if (right)
        all.rightCols(side_terms - 1) = bends_of(raw_, side_terms);
    if (known == CommonErrorsKnown::all && all.cols() > 0 && raw_.rows() >= all.cols() &&
        numeric::LeastSquares(raw_ * all, least_bend).rank() == all.cols())
        mix_ = all;
    else if (has_excess_)
        mix_ = excess;
    if (mix_.cols() > 0)
        fit_.emplace(raw_ * mix_);
}

Eigen::MatrixXd CommonErrors::explained(Eigen::MatrixXd const& columns) const
{
    return fit_ ? Eigen::MatrixXd(mix_ * fit_->solve(columns)) : Eigen::MatrixXd::Zero(terms, columns.cols());
}

Eigen::MatrixXd CommonErrors::without(Eigen::MatrixXd const& columns) const
{
    return columns - raw_ * explained(columns);
}

double CommonErrors::excess(Eigen::VectorXd const& deviations) const
{
    return has_excess_ ? fit_->solve(deviations)[0] : 0;
}

}  // namespace hdconj::inspect
