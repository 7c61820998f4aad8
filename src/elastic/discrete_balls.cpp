// SPDX-License-Identifier: GPL-3.0-or-later
#include "discrete_balls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "numeric/dense.hpp"

namespace hdconj::elastic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// cos and sin of all harmonics at an angle, in the order cos 0, cos n, sin n, cos 2n, ...
VectorXd functions(Index terms, int sectors, double phi)
{
    VectorXd value(2 * terms - 1);
    value[0] = 1;
    for (Index k = 1; k < terms; ++k) {
        double const angle = static_cast<double>(k) * sectors * phi;
        value[2 * k - 1] = std::cos(angle);
        value[2 * k] = std::sin(angle);
    }
    return value;
}

/// Two balls hold a ring that may shift unless they face each other: least eigenvalue of the sum of e e' over the
/// directions e of the balls.
bool holds_a_shift(std::vector<double> const& phi)
{
    constexpr double rounding = 1e-9;  // of the squares of sines and cosines, against one
    double cc = 0, cs = 0, ss = 0;
    for (double const angle : phi) {
        cc += std::cos(angle) * std::cos(angle);
        cs += std::cos(angle) * std::sin(angle);
        ss += std::sin(angle) * std::sin(angle);
    }
    return cc * ss - cs * cs > rounding * (cc + ss) * (cc + ss);
}

/// The ring in its functions: coefficients are unknowns, forces their work.
struct RingTerms
{
    VectorXd stiffness;  ///< K, diagonal
    VectorXd held;       ///< p without load
    MatrixXd rise;       ///< E: (contacts, coefficients)
};

RingTerms ring_terms(BearingSurface const& surface, int sectors, BearingContacts const& contacts)
{
    Index const terms = surface.cosine.cols(), size = 2 * terms - 1;
    auto const rows = static_cast<Index>(contacts.phi.size());
    double const part = 2 * std::numbers::pi / sectors;

    // work per coefficient: the mean square of cos and sin is a half
    RingTerms ring{VectorXd(size), VectorXd(size), MatrixXd::Zero(rows, size)};
    std::vector<double> mean(static_cast<std::size_t>(terms));
    for (Index k = 0; k < terms; ++k) {
        double const weight = k == 0 ? part : part / 2;
        mean[static_cast<std::size_t>(k)] = mean_of_cosine(static_cast<double>(k) * sectors, contacts.spread);
        // a ring that shifts bends nothing; what is left of its stiffness is rounding
        double const bends = k == 1 && sectors == 1 ? 0 : weight * surface.reaction_to_lift[k];
        Index const cosine = k == 0 ? 0 : 2 * k - 1;
        ring.stiffness[cosine] = bends;
        ring.held[cosine] = weight * surface.reaction_cosine[k];
        if (k > 0) {
            ring.stiffness[2 * k] = bends;
            ring.held[2 * k] = weight * surface.reaction_sine[k];
        }
    }
    for (Index i = 0; i < rows; ++i) {
        VectorXd const at = functions(terms, sectors, contacts.phi[static_cast<std::size_t>(i)]);
        for (Index k = 0; k < terms; ++k) {
            // Betti: the surface rises by as much as a force on it unloads the balls
            double const lifts = -mean[static_cast<std::size_t>(k)] *
                                 surface.reaction_to_load(k, contacts.z[static_cast<std::size_t>(i)]);
            if (k > 0)
                ring.rise(i, 2 * k - 1) = lifts * at[2 * k - 1];
            ring.rise(i, k == 0 ? 0 : 2 * k) = lifts * at[k == 0 ? 0 : 2 * k];
        }
    }
    return ring;
}

/// Inverse of [K, -B'; -B, -1/k], from loads and gaps of the ring to its shape and the forces of the balls.
MatrixXd inverse_system(VectorXd const& ring, int sectors, std::vector<double> const& phi,
                        std::optional<double> stiffness)
{
    Index const size = ring.size(), terms = (size + 1) / 2;
    auto const count = static_cast<Index>(phi.size());
    // unknowns in scales in which all stiffnesses are about 1
    double least = ring[0];
    for (Index i = 0; i < size; ++i)
        least = ring[i] > 0 ? std::min(least, ring[i]) : least;
    VectorXd const scale = ring.cwiseMax(least).cwiseSqrt().cwiseInverse();
    MatrixXd system = MatrixXd::Zero(size + count, size + count);
    VectorXd force_scale(count);
    for (Index i = 0; i < size; ++i)
        system(i, i) = ring[i] * scale[i] * scale[i];
    for (Index b = 0; b < count; ++b) {
        VectorXd const at = functions(terms, sectors, phi[static_cast<std::size_t>(b)]).cwiseProduct(scale);
        force_scale[b] = 1 / at.norm();
        system.block(0, size + b, size, 1) = -force_scale[b] * at;
        system.block(size + b, 0, 1, size) = -force_scale[b] * at.transpose();
        system(size + b, size + b) = stiffness ? -force_scale[b] * force_scale[b] / *stiffness : 0;
    }
    numeric::LU const factors(system);
    MatrixXd const scaled = factors.is_singular() ? MatrixXd() : factors.inverse();
    auto const norm = [](MatrixXd const& a) { return a.cwiseAbs().colwise().sum().maxCoeff(); };
    constexpr double rounding = 1e-13;  // 1/condition at which no digit of a force would be left
    if (factors.is_singular() || !(1 > rounding * norm(system) * norm(scaled)))
        refuse_bearing("balls", "they stand too close to each other for the harmonics of the ring");
    VectorXd all(size + count);
    all << scale, force_scale;
    MatrixXd const inverse = all.asDiagonal() * scaled * all.asDiagonal();
    return (inverse + inverse.transpose()) / 2;
}

}  // namespace

std::vector<double> ball_angles(int count, int sectors, double phase)
{
    std::vector<double> phi;
    for (int i = 0; i < count / sectors; ++i)
        phi.push_back(phase + 2 * std::numbers::pi * i / count);
    return phi;
}

DiscreteBalls discrete_balls(BearingSurface const& surface, int sectors, BearingContacts const& contacts,
                             std::vector<double> const& phi, std::optional<double> stiffness)
{
    if (!surface.compliance)
        refuse_bearing("balls", "a rigid bearing has none");
    Index const terms = surface.cosine.cols(), size = 2 * terms - 1;
    auto const count = static_cast<Index>(phi.size());
    if (count == 0)
        refuse_bearing("balls", "none touches the ring");
    if (!stiffness && count > size)
        refuse_bearing("balls",
                       std::to_string(count * sectors) + " are more than the harmonics of the ring tell apart, " +
                           std::to_string(size * sectors) + ": leave the number out for a continuous row of balls");
    if (sectors == 1 && !holds_a_shift(phi))
        refuse_bearing(
            "balls",
            "the ring may move as a whole: one ball does not hold it, nor do two that face each other; write three or "
            "more");
    RingTerms const ring = ring_terms(surface, sectors, contacts);
    MatrixXd const inverse = inverse_system(ring.stiffness, sectors, phi, stiffness);
    auto const shape = inverse.topLeftCorner(size, size);
    auto const mixed = inverse.topRightCorner(size, count);

    DiscreteBalls result;
    result.balls.phi = phi;
    result.balls.held = -mixed.transpose() * ring.held;
    result.balls.stiffness = -inverse.bottomRightCorner(count, count);
    result.balls.lift = -ring.rise * mixed;
    MatrixXd const eased = ring.rise * shape;
    result.between = eased * ring.rise.transpose();
    result.between = (result.between + result.between.transpose()).eval() / 2;
    result.sag = eased * ring.held;
    return result;
}

}  // namespace hdconj::elastic
