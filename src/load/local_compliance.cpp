// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_compliance.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace hdconj::load {
namespace {

/// Makes the compliance of the strips of one flank positive definite, as that of a body is: the contacts from @p first
/// on, whose couplings are those from @p coupling on. Each coupling takes two strips alone, and strips that are nearer
/// than their width as one. Of three in a row the outer ones may then both be one with the middle one and yet two for
/// each other, which no body is. Every strip gives way by as little more as is missing.
void make_definite(std::size_t first, std::size_t coupling, LocalCompliance& compliance)
{
    constexpr double least = 1e-6;  // eigenvalue, of the largest compliance of a strip
    auto const count = static_cast<Eigen::Index>(compliance.own.size() - first);
    if (coupling == compliance.couplings.size())
        return;
    Eigen::MatrixXd strips =
        Eigen::Map<Eigen::VectorXd const>(compliance.own.data() + first, count).asDiagonal().toDenseMatrix();
    double const largest = strips.diagonal().maxCoeff();
    for (; coupling < compliance.couplings.size(); ++coupling) {
        LocalCompliance::Coupling const& c = compliance.couplings[coupling];
        strips(static_cast<Eigen::Index>(c.second - first), static_cast<Eigen::Index>(c.first - first)) = c.compliance;
    }
    // reads the lower triangle
    double const smallest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(strips, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
    for (std::size_t i = first; i < compliance.own.size(); ++i)
        compliance.own[i] += std::max(0.0, least * largest - smallest);
}

}  // namespace

std::vector<double> LocalCompliance::operator()(std::vector<double> const& force) const
{
    std::vector<double> approach(force.size());
    for (std::size_t i = 0; i < force.size(); ++i)
        approach[i] = offset[i] + own[i] * force[i];
    for (Coupling const& c : couplings) {
        approach[c.first] += c.compliance * force[c.second];
        approach[c.second] += c.compliance * force[c.first];
    }
    return approach;
}

LocalCompliance local_compliance(ElasticDrive const& drive, std::vector<FlankContact> const& contacts,
                                 std::vector<double> const& force)
{
    constexpr double start_load = 1;  // [N/mm] at which a contact without force is linearised
    LocalCompliance result;
    auto const width = [&](FlankContact const& c) { return drive.slice_width[c.slice]; };
    auto const load = [&](std::size_t i) { return force[i] > 0 ? force[i] / width(contacts[i]) : start_load; };
    // The component of a line load along x bends the tooth.
    auto const bending = [&](FlankContact const& a, FlankContact const& b) {
        return drive.bending(a.tooth_y, b.tooth_y) *
               std::sqrt((1 - a.inclination * a.inclination) * (1 - b.inclination * b.inclination));
    };
    auto const same_flank = [](FlankContact const& a, FlankContact const& b) {
        return a.space == b.space && a.flank == b.flank && a.slice == b.slice;
    };
    std::size_t first = 0, coupling = 0;  // of the flank
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        FlankContact const& c = contacts[i];
        if (i > 0 && !same_flank(contacts[i - 1], c)) {
            make_definite(first, coupling, result);
            first = i;
            coupling = result.couplings.size();
        }
        LineContact const line = drive.line_contact(c);
        // The tangent lies below the law: along it a contact without force that stands off would get one.
        bool const carries = force[i] > 0;
        double const q = load(i), indented = carries ? indentation(line, q) : 0,
                     slope = carries ? indentation_slope(line, q) : 0;
        result.own.push_back(((approach(line, q) - indented) / q + slope + bending(c, c)) / width(c));
        result.offset.push_back(indented - slope * q);
        for (std::size_t j = i; j-- > first;) {
            FlankContact const& other = contacts[j];
            if (other.tooth != c.tooth)
                continue;
            // The wider strip decides at which distance two strips merge.
            LineContact const a = drive.line_contact(c), b = drive.line_contact(other);
            double const half = std::max(half_width(a, load(i)), half_width(b, load(j)));
            result.couplings.push_back(
                {j, i,
                 (approach_beside(a, std::abs(c.arc_length - other.arc_length), half) + bending(c, other)) / width(c)});
        }
    }
    make_definite(first, coupling, result);
    return result;
}

}  // namespace hdconj::load
