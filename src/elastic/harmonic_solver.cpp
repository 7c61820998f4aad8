// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonic_solver.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <string>
#include <utility>

#include "base/loop_targets.hpp"
#include "hdconj/error.hpp"

namespace hdconj::elastic {
namespace {

/// The rigid motions of harmonic 0 (shift along the axis, turn) and 1 (shift across, tilt) must strain a support.
void require_held(SectionMesh const& mesh, Supports const& supports, int harmonic)
{
    if (!mesh.clamped.empty() || harmonic > 1)
        return;
    Eigen::Matrix2d held = Eigen::Matrix2d::Zero();
    for (Support const& support : supports) {
        Vec2 const at = mesh.nodes[static_cast<std::size_t>(support.node)];
        Eigen::Vector2d moves = Eigen::Vector2d::Zero();
        if (harmonic == 0)
            moves = {support.direction == Direction::axial ? 1.0 : 0.0,
                     support.direction == Direction::tangential ? 1.0 : 0.0};
        else if (support.direction == Direction::radial)
            moves = {1, -at.y() / at.x()};
        else if (support.direction == Direction::axial)
            moves = {0, 1};
        else
            moves = {-1, at.y() / at.x()};
        if (support.stiffness != 0 && harmonic <= support.last_harmonic)
            held += moves * moves.transpose();
    }
    constexpr double rounding = 1e-12;  // of heights over radii
    if (!(held.determinant() > rounding * held.trace() * held.trace()))
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", "harmonic n = " + std::to_string(harmonic),
                             harmonic == 0 ? "the body can move as a whole: it needs a support against shifting along "
                                             "its axis and one against turning about it"
                                           : "the body can move as a whole: it needs a support against shifting across "
                                             "its axis and one against tilting");
}

using Ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;
/// Loads side by side: each row is one unknown.
using LoadRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Solves L D L' x = b for all loads at once, so that each entry of the factor is read once for all of them. For each
/// load the operations and their order are those of Ldlt::solve().
HDCONJ_TARGETS
void solve_in_place(Eigen::SparseMatrix<double> const& lower, double const* diagonal, LoadRows& x)
{
    int const *const begin = lower.outerIndexPtr(), *const row = lower.innerIndexPtr();
    double const* const value = lower.valuePtr();
    Eigen::Index const count = x.rows(), width = x.cols();
    double* const all = x.data();
    auto const subtract = [width](double* from, double factor, double const* what) {
        for (Eigen::Index c = 0; c < width; ++c)
            from[c] -= factor * what[c];
    };
    for (Eigen::Index j = 0; j < count; ++j)
        for (int e = begin[j]; e < begin[j + 1]; ++e)
            if (row[e] > j)
                subtract(all + row[e] * width, value[e], all + j * width);
    for (Eigen::Index j = 0; j < count; ++j)
        for (Eigen::Index c = 0; c < width; ++c)
            all[j * width + c] *= 1 / diagonal[j];
    for (Eigen::Index j = count - 1; j >= 0; --j)
        for (int e = begin[j]; e < begin[j + 1]; ++e)
            if (row[e] > j)
                subtract(all + j * width, value[e], all + row[e] * width);
}

}  // namespace

struct HarmonicSolver::Factors
{
    std::vector<Eigen::Index> place;  ///< of each unknown among the free ones as they are eliminated; -1: fixed
    Eigen::Index free = 0;
    Eigen::SparseMatrix<double> stiffness;  ///< of all unknowns, without springs
    Ldlt ldlt;
};

HarmonicSolver::HarmonicSolver(FourierSolid const& solid, Supports const& supports, int harmonic) : harmonic_(harmonic)
{
    auto factors = std::make_shared<Factors>();
    auto& place = factors->place;
    require_held(solid.mesh(), supports, harmonic);
    place.assign(static_cast<std::size_t>(solid.unknowns()), 0);
    std::vector<double> spring(place.size(), 0);
    for (int node : solid.mesh().clamped)
        for (Direction d : {Direction::radial, Direction::axial, Direction::tangential})
            place[static_cast<std::size_t>(unknown_of(node, d))] = -1;
    for (Support const& support : supports) {
        if (harmonic > support.last_harmonic)
            continue;
        auto const i = static_cast<std::size_t>(unknown_of(support.node, support.direction));
        if (support.stiffness < 0)
            place[i] = -1;
        else
            spring[i] += support.stiffness;
    }
    for (int const i : solid.elimination())
        if (Eigen::Index& p = place[static_cast<std::size_t>(i)]; p >= 0)
            p = factors->free++;

    factors->stiffness = solid.stiffness(harmonic);
    auto const& all = factors->stiffness;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(all.nonZeros() + all.rows()) / 2);
    for (Eigen::Index column = 0; column < all.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(all, column); it; ++it) {
            Eigen::Index const i = place[static_cast<std::size_t>(it.row())],
                               j = place[static_cast<std::size_t>(it.col())];
            if (j < 0 || i < j)
                continue;  // fixed, or said by symmetry
            double const value = it.value() + (it.row() == it.col() ? spring[static_cast<std::size_t>(it.row())] : 0);
            entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
        }
    Eigen::SparseMatrix<double> k(factors->free, factors->free);
    k.setFromTriplets(entries.begin(), entries.end());
    factors->ldlt.compute(k);
    if (factors->ldlt.info() != Eigen::Success || !(factors->ldlt.vectorD().minCoeff() > 0))
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", "harmonic n = " + std::to_string(harmonic),
                             "the stiffness is not positive definite to rounding: walls too thin for their elements, "
                             "or numbers too different in size");
    factors_ = std::move(factors);
}

Eigen::MatrixXd HarmonicSolver::operator()(Eigen::MatrixXd const& loads) const
{
    auto const& place = factors_->place;
    LoadRows solved(factors_->free, loads.cols());
    for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] >= 0)
            solved.row(place[i]) = loads.row(static_cast<Eigen::Index>(i));
    solve_in_place(factors_->ldlt.matrixL().nestedExpression(), factors_->ldlt.vectorD().data(), solved);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(loads.rows(), loads.cols());
    for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] >= 0)
            result.row(static_cast<Eigen::Index>(i)) = solved.row(place[i]);
    return result;
}

Eigen::MatrixXd HarmonicSolver::moved(Eigen::MatrixXd const& given) const
{
    auto const& place = factors_->place;
    Eigen::MatrixXd fixed = given;
    for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] >= 0)
            fixed.row(static_cast<Eigen::Index>(i)).setZero();
    return fixed + (*this)(-(factors_->stiffness * fixed));
}

Eigen::MatrixXd HarmonicSolver::forces(Eigen::MatrixXd const& displacements) const
{
    return factors_->stiffness * displacements;
}

}  // namespace hdconj::elastic
