// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/elastic/fourier_solid.hpp"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hdconj/numeric/error.hpp"

namespace hdconj {
namespace {

using Element = Eigen::Matrix<double, 24, 24, Eigen::RowMajor>;
using Strains = Eigen::Matrix<double, 6, 24>;
using Stresses = Eigen::Matrix<double, 6, 24, Eigen::RowMajor>;

/// k += b^T s. Two of three entries of @p b are zero, and the general product, made for large matrices, would first copy all.
void add_product(Element& k, Strains const& b, Stresses const& s)
{
    for (Eigen::Index c = 0; c < b.cols(); ++c)
        for (Eigen::Index i = 0; i < b.rows(); ++i)
            if (b(i, c) != 0)
                k.row(c) += b(i, c) * s.row(i);
}

/// Abscissa and weight of one Gauss point on [-1, 1].
struct GaussPoint
{
    double at;
    double weight;
};

std::vector<GaussPoint> gauss(Quadrature quadrature)
{
    if (quadrature == Quadrature::reduced)
        return {{-std::sqrt(1.0 / 3), 1}, {std::sqrt(1.0 / 3), 1}};
    return {{-std::sqrt(0.6), 5.0 / 9}, {0, 8.0 / 9}, {std::sqrt(0.6), 5.0 / 9}};
}

Eigen::Index unknown(int node, Direction direction)
{
    return 3 * static_cast<Eigen::Index>(node) + static_cast<Eigen::Index>(direction);
}

/// Nodes that share an element are neighbours: each node's, in increasing order.
std::vector<std::vector<int>> neighbours_of(SectionMesh const& mesh)
{
    std::vector<std::vector<int>> neighbours(mesh.nodes.size());
    for (QuadraticElement const& element : mesh.elements)
        for (int const a : element)
            neighbours[static_cast<std::size_t>(a)].insert(neighbours[static_cast<std::size_t>(a)].end(), element.begin(), element.end());
    for (auto& near : neighbours)
    {
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
    }
    return neighbours;
}

}  // namespace

StrainMatrices strain_matrices(SectionMesh const& mesh, SectionPoint const& point)
{
    QuadraticElement const& element = mesh.elements[point.element];
    auto const n = shape_functions(point.xi, point.eta);
    auto const slope = shape_slopes(point.xi, point.eta);
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();  // row: r, z; column: xi, eta
    double r = 0;
    for (std::size_t a = 0; a < n.size(); ++a)
    {
        Vec2 const& node = mesh.nodes[static_cast<std::size_t>(element[a])];
        jacobian += node * slope[a].transpose();
        r += n[a] * node.x();
    }
    StrainMatrices b;
    b.at_rest.setZero();
    b.per_harmonic.setZero();
    b.radius = r;
    b.jacobian = jacobian(0, 0) * jacobian(1, 1) - jacobian(0, 1) * jacobian(1, 0);
    constexpr Eigen::Index rr = 0, zz = 1, tt = 2, rz = 3, rt = 4, zt = 5;
    for (std::size_t a = 0; a < n.size(); ++a)
    {
        double const by_r = (slope[a].x() * jacobian(1, 1) - slope[a].y() * jacobian(1, 0)) / b.jacobian;
        double const by_z = (slope[a].y() * jacobian(0, 0) - slope[a].x() * jacobian(0, 1)) / b.jacobian;
        double const over_r = n[a] / r;
        auto const u = static_cast<Eigen::Index>(3 * a), w = u + 1, v = u + 2;
        b.at_rest(rr, u) = by_r;
        b.at_rest(zz, w) = by_z;
        b.at_rest(tt, u) = over_r;
        b.at_rest(rz, u) = by_z;
        b.at_rest(rz, w) = by_r;
        b.at_rest(rt, v) = by_r - over_r;
        b.at_rest(zt, v) = by_z;
        b.per_harmonic(tt, v) = over_r;
        b.per_harmonic(rt, u) = -over_r;
        b.per_harmonic(zt, w) = -over_r;
    }
    return b;
}

/// The pattern that all harmonics share, with values 0, and its order of elimination.
void FourierSolid::lay_out()
{
    std::vector<std::vector<int>> const neighbours = neighbours_of(mesh_);
    std::size_t entries = 0;
    for (auto const& near : neighbours)
        entries += 9 * near.size();
    pattern_.resize(unknowns(), unknowns());
    pattern_.reserve(static_cast<Eigen::Index>(entries));
    for (std::size_t node = 0; node < neighbours.size(); ++node)
        for (Eigen::Index d = 0; d < 3; ++d)
        {
            Eigen::Index const column = 3 * static_cast<Eigen::Index>(node) + d;
            pattern_.startVec(column);
            for (int const near : neighbours[node])
                for (Direction const direction : {Direction::radial, Direction::axial, Direction::tangential})
                    pattern_.insertBack(unknown(near, direction), column) = 0;
        }
    pattern_.finalize();
    for (Eigen::VectorXd& values : power_)
        values = Eigen::VectorXd::Zero(pattern_.nonZeros());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(pattern_.selfadjointView<Eigen::Lower>(), order);  // of a pattern that is symmetric: nothing is transposed to make it so
    elimination_.assign(order.indices().begin(), order.indices().end());
}

FourierSolid::FourierSolid(SectionMesh mesh, Quadrature quadrature) : mesh_(std::move(mesh))
{
    lay_out();
    // with four points a single element can be bent into an hourglass for nothing; two elements that share a side cannot
    auto const of_wall = gauss(mesh_.elements.size() == 1 ? Quadrature::full : quadrature);
    // nor does a layer of teeth, which lacks two of the six stresses, do without all points
    auto const of_layer = gauss(Quadrature::full);
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
    {
        StressMatrix const d = mesh_.stress(e);
        std::array<Element, 3> k{Element::Zero(), Element::Zero(), Element::Zero()};
        Element mixed = Element::Zero();
        auto const& points = e < mesh_.wall_elements() ? of_wall : of_layer;
        for (GaussPoint const& x : points)
        {
            for (GaussPoint const& y : points)
            {
                StrainMatrices const b = strain_matrices(mesh_, {e, x.at, y.at});
                // a NaN too is turned
                if (!(b.jacobian > 0 && b.radius > 0))
                    throw NumericalError("elastic cup", "mesh", "an element is turned inside out or reaches the axis; dimensions contradict each other");
                double const weight = x.weight * y.weight * b.jacobian * b.radius;
                StressMatrix const weighted = weight * d;
                Stresses const s0 = weighted.lazyProduct(b.at_rest), s1 = weighted.lazyProduct(b.per_harmonic);
                add_product(k[0], b.at_rest, s0);
                add_product(mixed, b.at_rest, s1);
                add_product(k[2], b.per_harmonic, s1);
            }
        }
        k[1] = mixed + mixed.transpose();
        auto const& nodes = mesh_.elements[e];
        for (std::size_t b = 0; b < nodes.size(); ++b)
        {
            // the three columns of a node have the same rows
            Eigen::Index const column = unknown(nodes[b], Direction::radial);
            int const* const begin = pattern_.innerIndexPtr() + pattern_.outerIndexPtr()[column];
            int const* const end = pattern_.innerIndexPtr() + pattern_.outerIndexPtr()[column + 1];
            for (std::size_t a = 0; a < nodes.size(); ++a)
            {
                Eigen::Index const row = std::lower_bound(begin, end, static_cast<int>(unknown(nodes[a], Direction::radial))) - begin;
                for (Eigen::Index c = 0; c < 3; ++c)
                    for (std::size_t power = 0; power < k.size(); ++power)
                        power_[power].segment<3>(pattern_.outerIndexPtr()[column + c] + row) += k[power].block<3, 1>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b) + c);
            }
        }
    }
}

Eigen::SparseMatrix<double> FourierSolid::stiffness(int harmonic) const
{
    double const n = harmonic;
    Eigen::SparseMatrix<double> sum = pattern_;
    Eigen::Map<Eigen::VectorXd>(sum.valuePtr(), sum.nonZeros()) = power_[0] + n * power_[1] + (n * n) * power_[2];
    return sum;
}

namespace {

/// The rigid motions of harmonic 0 (shift along the axis, turn) and 1 (shift across, tilt) must strain a support.
void require_held(SectionMesh const& mesh, Supports const& supports, int harmonic)
{
    if (!mesh.clamped.empty() || harmonic > 1)
        return;
    Eigen::Matrix2d held = Eigen::Matrix2d::Zero();
    for (Support const& support : supports)
    {
        Vec2 const at = mesh.nodes[static_cast<std::size_t>(support.node)];
        Eigen::Vector2d moves = Eigen::Vector2d::Zero();
        if (harmonic == 0)
            moves = {support.direction == Direction::axial ? 1.0 : 0.0, support.direction == Direction::tangential ? 1.0 : 0.0};
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
        throw NumericalError("elastic cup", "harmonic n = " + std::to_string(harmonic),
                             harmonic == 0 ? "the body can move as a whole: it needs a support against shifting along its axis and one against turning about it"
                                           : "the body can move as a whole: it needs a support against shifting across its axis and one against tilting");
}

}  // namespace

struct HarmonicSolver::Factors
{
    std::vector<Eigen::Index> place;  ///< of each unknown among the free ones, in the order of their elimination; -1: fixed
    Eigen::Index free = 0;
    Eigen::SparseMatrix<double> stiffness;  ///< of all unknowns, without springs
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt;
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
            place[static_cast<std::size_t>(unknown(node, d))] = -1;
    for (Support const& support : supports)
    {
        if (harmonic > support.last_harmonic)
            continue;
        auto const i = static_cast<std::size_t>(unknown(support.node, support.direction));
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
        for (Eigen::SparseMatrix<double>::InnerIterator it(all, column); it; ++it)
        {
            Eigen::Index const i = place[static_cast<std::size_t>(it.row())], j = place[static_cast<std::size_t>(it.col())];
            if (j < 0 || i < j)
                continue;  // fixed, or said by symmetry
            double const value = it.value() + (it.row() == it.col() ? spring[static_cast<std::size_t>(it.row())] : 0);
            entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
        }
    Eigen::SparseMatrix<double> k(factors->free, factors->free);
    k.setFromTriplets(entries.begin(), entries.end());
    factors->ldlt.compute(k);
    if (factors->ldlt.info() != Eigen::Success || !(factors->ldlt.vectorD().minCoeff() > 0))
        throw NumericalError("elastic cup", "harmonic n = " + std::to_string(harmonic),
                             "the stiffness is not positive definite to rounding: walls too thin for their elements, or numbers too different in size");
    factors_ = std::move(factors);
}

Eigen::MatrixXd HarmonicSolver::operator()(Eigen::MatrixXd const& loads) const
{
    auto const& place = factors_->place;
    Eigen::MatrixXd reduced(factors_->free, loads.cols());
    for (std::size_t i = 0; i < place.size(); ++i)
        if (place[i] >= 0)
            reduced.row(place[i]) = loads.row(static_cast<Eigen::Index>(i));
    Eigen::MatrixXd const solved = factors_->ldlt.solve(reduced);
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

}  // namespace hdconj
