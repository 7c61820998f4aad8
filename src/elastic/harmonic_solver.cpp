// SPDX-License-Identifier: GPL-3.0-or-later
#include "harmonic_solver.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/loop_targets.hpp"
#include "hdconj/base/parallel.hpp"
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

/// Of the upper half, which it takes without a copy.
using Ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>;
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

/// What the harmonics with the same fixed unknowns share, and the factors of the last one.
struct HarmonicSolver::Elimination
{
    std::vector<char> fixed;          ///< whether each unknown is
    std::vector<Eigen::Index> place;  ///< of each unknown among the free ones as they are eliminated; -1: fixed
    Eigen::SparseMatrix<double> upper;
    std::vector<int> source;  ///< of each entry of `upper`, among those of the solid's stiffness
    Ldlt ldlt;

    Elimination(FourierSolid const& solid, Eigen::SparseMatrix<double> const& stiffness, std::vector<char> which)
        : fixed(std::move(which)), place(fixed.size(), -1)
    {
        std::vector<int> unknown;
        for (int const i : solid.elimination())
            if (!fixed[static_cast<std::size_t>(i)]) {
                place[static_cast<std::size_t>(i)] = static_cast<Eigen::Index>(unknown.size());
                unknown.push_back(i);
            }
        auto const free = static_cast<Eigen::Index>(unknown.size());
        upper.resize(free, free);
        upper.reserve((stiffness.nonZeros() + stiffness.rows()) / 2);
        source.reserve(static_cast<std::size_t>((stiffness.nonZeros() + stiffness.rows()) / 2));
        std::vector<std::pair<int, int>> column;  // rows and entries of the stiffness
        for (Eigen::Index j = 0; j < free; ++j) {
            int const i = unknown[static_cast<std::size_t>(j)];
            column.clear();
            for (int e = stiffness.outerIndexPtr()[i]; e < stiffness.outerIndexPtr()[i + 1]; ++e)
                if (auto const row = static_cast<int>(place[static_cast<std::size_t>(stiffness.innerIndexPtr()[e])]);
                    row >= 0 && row <= j)
                    column.emplace_back(row, e);
            std::ranges::sort(column);
            upper.startVec(j);
            for (auto const& [row, entry] : column) {
                upper.insertBack(row, j) = 0;
                source.push_back(entry);
            }
        }
        upper.finalize();
        ldlt.analyzePattern(upper);
    }
};

HarmonicSolver::HarmonicSolver(FourierSolid const& solid, Supports const& supports, int harmonic)
    : solid_(&solid), supports_(supports)
{
    factorise(harmonic);
}

HarmonicSolver::~HarmonicSolver() = default;

void HarmonicSolver::factorise(int harmonic)
{
    require_held(solid_->mesh(), supports_, harmonic);
    harmonic_ = harmonic;
    auto const unknowns = static_cast<std::size_t>(solid_->unknowns());
    std::vector<char> fixed(unknowns, 0);
    std::vector<double> spring(unknowns, 0);
    for (int node : solid_->mesh().clamped)
        for (Direction d : {Direction::radial, Direction::axial, Direction::tangential})
            fixed[static_cast<std::size_t>(unknown_of(node, d))] = 1;
    for (Support const& support : supports_) {
        if (harmonic > support.last_harmonic)
            continue;
        auto const i = static_cast<std::size_t>(unknown_of(support.node, support.direction));
        if (support.stiffness < 0)
            fixed[i] = 1;
        else
            spring[i] += support.stiffness;
    }
    stiffness_ = solid_->stiffness(harmonic);
    if (!elimination_ || elimination_->fixed != fixed)
        elimination_ = std::make_unique<Elimination>(*solid_, stiffness_, std::move(fixed));
    auto& [none, place, upper, source, ldlt] = *elimination_;
    for (std::size_t e = 0; e < source.size(); ++e)
        upper.valuePtr()[e] = stiffness_.valuePtr()[source[e]];
    for (std::size_t i = 0; i < unknowns; ++i)
        if (spring[i] != 0 && place[i] >= 0)
            upper.coeffRef(place[i], place[i]) += spring[i];
    ldlt.factorize(upper);
    if (ldlt.info() != Eigen::Success || !(ldlt.vectorD().minCoeff() > 0))
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", "harmonic n = " + std::to_string(harmonic),
                             "the stiffness is not positive definite to rounding: walls too thin for their elements, "
                             "or numbers too different in size");
}

Eigen::MatrixXd HarmonicSolver::operator()(Eigen::MatrixXd const& loads) const
{
    auto const& [fixed, place, upper, source, ldlt] = *elimination_;
    LoadRows solved(upper.rows(), loads.cols());
    for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] >= 0)
            solved.row(place[i]) = loads.row(static_cast<Eigen::Index>(i));
    solve_in_place(ldlt.matrixL().nestedExpression(), ldlt.vectorD().data(), solved);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(loads.rows(), loads.cols());
    for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] >= 0)
            result.row(static_cast<Eigen::Index>(i)) = solved.row(place[i]);
    return result;
}

Eigen::MatrixXd HarmonicSolver::moved(Eigen::MatrixXd const& given) const
{
    Eigen::MatrixXd fixed = given;
    for (std::size_t i = 0; i < elimination_->fixed.size(); ++i)
        if (!elimination_->fixed[i])
            fixed.row(static_cast<Eigen::Index>(i)).setZero();
    return fixed + (*this)(-(stiffness_ * fixed));
}

Eigen::RowVectorXd HarmonicSolver::force_on(Eigen::Index at, Eigen::MatrixXd const& displacements) const
{
    return stiffness_.col(at).transpose() * displacements;  // the stiffness is symmetric
}

void for_each_harmonic(FourierSolid const& solid, Supports const& supports, std::vector<int> const& harmonics,
                       int threads, std::function<void(std::size_t, HarmonicSolver const&)> const& use)
{
    std::size_t const shares = std::min(harmonics.size(), static_cast<std::size_t>(thread_count(threads)));
    parallel_for(shares, threads, 1, [&](std::size_t share) {
        std::optional<HarmonicSolver> solver;
        for (std::size_t i = share; i < harmonics.size(); i += shares) {
            if (solver)
                solver->factorise(harmonics[i]);
            else
                solver.emplace(solid, supports, harmonics[i]);
            use(i, *solver);
        }
    });
}

}  // namespace hdconj::elastic
