// SPDX-License-Identifier: GPL-3.0-or-later
#include "fourier_solid.hpp"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hdconj/error.hpp"

namespace hdconj::elastic {
namespace {

using Element = Eigen::Matrix<double, 24, 24, Eigen::RowMajor>;
using Strains = Eigen::Matrix<double, 6, 24>;
using Stresses = Eigen::Matrix<double, 6, 24, Eigen::RowMajor>;

/// k += b^T s. Two of three entries of @p b are zero, and the general product, made for large matrices, would first
/// copy all.
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

/// Nodes that share an element are neighbours: each node's, in increasing order.
std::vector<std::vector<int>> neighbours_of(SectionMesh const& mesh)
{
    std::vector<std::vector<int>> neighbours(mesh.nodes.size());
    for (QuadraticElement const& element : mesh.elements)
        for (int const a : element)
            neighbours[static_cast<std::size_t>(a)].insert(neighbours[static_cast<std::size_t>(a)].end(),
                                                           element.begin(), element.end());
    for (auto& near : neighbours) {
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
    for (std::size_t a = 0; a < n.size(); ++a) {
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
    for (std::size_t a = 0; a < n.size(); ++a) {
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

namespace {

/// The pattern that the stiffness of all harmonics shares, with values 0.
Eigen::SparseMatrix<double> stiffness_pattern(SectionMesh const& mesh)
{
    std::vector<std::vector<int>> const neighbours = neighbours_of(mesh);
    auto const unknowns = static_cast<Eigen::Index>(3 * mesh.nodes.size());
    std::size_t entries = 0;
    for (auto const& near : neighbours)
        entries += 9 * near.size();
    Eigen::SparseMatrix<double> pattern(unknowns, unknowns);
    pattern.reserve(static_cast<Eigen::Index>(entries));
    for (std::size_t node = 0; node < neighbours.size(); ++node)
        for (Eigen::Index d = 0; d < 3; ++d) {
            Eigen::Index const column = 3 * static_cast<Eigen::Index>(node) + d;
            pattern.startVec(column);
            for (int const near : neighbours[node])
                for (Direction const direction : {Direction::radial, Direction::axial, Direction::tangential})
                    pattern.insertBack(unknown_of(near, direction), column) = 0;
        }
    pattern.finalize();
    return pattern;
}

/// Order of elimination by minimum degree.
std::vector<int> elimination_order(Eigen::SparseMatrix<double> const& pattern)
{
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    // The pattern is symmetric: its lower half says all, and nothing is transposed.
    Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
    return {order.indices().begin(), order.indices().end()};
}

/// Stiffness of one element: parts that go with the powers 0, 1 and 2 of the harmonic.
using ElementStiffness = std::array<Element, 3>;

ElementStiffness element_stiffness(SectionMesh const& mesh, std::size_t e, std::vector<GaussPoint> const& points)
{
    StressMatrix const d = mesh.stress(e);
    ElementStiffness k{Element::Zero(), Element::Zero(), Element::Zero()};
    Element mixed = Element::Zero();
    for (GaussPoint const& x : points)
        for (GaussPoint const& y : points) {
            StrainMatrices const b = strain_matrices(mesh, {e, x.at, y.at});
            // a NaN too is refused
            if (!(b.jacobian > 0 && b.radius > 0))
                throw NumericalError(
                    ErrorCode::unsuitable_body, "elastic cup", "mesh",
                    "an element is turned inside out or reaches the axis; dimensions contradict each other");
            double const weight = x.weight * y.weight * b.jacobian * b.radius;
            StressMatrix const weighted = weight * d;
            Stresses const s0 = weighted.lazyProduct(b.at_rest), s1 = weighted.lazyProduct(b.per_harmonic);
            add_product(k[0], b.at_rest, s0);
            add_product(mixed, b.at_rest, s1);
            add_product(k[2], b.per_harmonic, s1);
        }
    k[1] = mixed + mixed.transpose();
    return k;
}

/// Adds an element to the values of the pattern.
void assemble(QuadraticElement const& nodes, ElementStiffness const& k, Eigen::SparseMatrix<double> const& pattern,
              std::array<Eigen::VectorXd, 3>& values)
{
    int const *const outer = pattern.outerIndexPtr(), *const inner = pattern.innerIndexPtr();
    for (std::size_t b = 0; b < nodes.size(); ++b) {
        // The three columns of a node have the same rows.
        Eigen::Index const column = unknown_of(nodes[b], Direction::radial);
        int const *const begin = inner + outer[column], *const end = inner + outer[column + 1];
        for (std::size_t a = 0; a < nodes.size(); ++a) {
            Eigen::Index const row =
                std::lower_bound(begin, end, static_cast<int>(unknown_of(nodes[a], Direction::radial))) - begin;
            for (Eigen::Index c = 0; c < 3; ++c)
                for (std::size_t power = 0; power < k.size(); ++power)
                    values[power].segment<3>(outer[column + c] + row) +=
                        k[power].block<3, 1>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b) + c);
        }
    }
}

}  // namespace

FourierSolid::FourierSolid(SectionMesh mesh, Quadrature quadrature)
    : mesh_(std::move(mesh)),
      quadrature_(quadrature),
      pattern_(stiffness_pattern(mesh_)),
      elimination_(elimination_order(pattern_))
{
    for (Eigen::VectorXd& values : power_)
        values = Eigen::VectorXd::Zero(pattern_.nonZeros());
    // With four points a single element can be bent into an hourglass without energy; two that share a side cannot.
    auto const of_wall = gauss(mesh_.elements.size() == 1 ? Quadrature::full : quadrature);
    // A layer of teeth lacks two of the six stresses, and needs all points too.
    auto const of_layer = gauss(Quadrature::full);
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
        assemble(mesh_.elements[e], element_stiffness(mesh_, e, e < mesh_.wall_elements() ? of_wall : of_layer),
                 pattern_, power_);
}

Eigen::SparseMatrix<double> FourierSolid::stiffness(int harmonic) const
{
    double const n = harmonic;
    Eigen::SparseMatrix<double> sum = pattern_;
    Eigen::Map<Eigen::VectorXd>(sum.valuePtr(), sum.nonZeros()) = power_[0] + n * power_[1] + (n * n) * power_[2];
    return sum;
}

}  // namespace hdconj::elastic
