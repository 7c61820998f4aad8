// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball_line.hpp"

#include <cstddef>
#include <numbers>

#include "bearing.hpp"
#include "hdconj/base/parallel.hpp"

namespace hdconj::elastic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

BallLine ball_line(BearingSurface const& surface, int waves, BearingContacts const& contacts, int points, bool mirrored,
                   int threads)
{
    if (!surface.compliance)
        refuse_bearing("balls", "a rigid bearing has no balls");
    if (points < 2 || points % 2 != 0 || points / 2 >= static_cast<int>(surface.cosine.cols()))
        refuse_bearing("balls",
                       "its points must be an even number, and no more than the harmonics of the ring can tell apart");
    int const terms = points / 2 + 1;
    auto const count = static_cast<Index>(mirrored ? terms : points), rows = static_cast<Index>(contacts.phi.size());
    double const arc = 2 * std::numbers::pi / (waves * points);
    BallLine line;
    for (Index m = 0; m < count; ++m)
        line.phi.push_back(arc * static_cast<double>(m));
    line.held = VectorXd::Zero(count);
    line.stiffness = MatrixXd::Zero(count, count);
    line.lift = MatrixXd::Zero(rows, count);
    // values at the points <-> coefficients; a mirrored point stands for two, one on a mirror plane for itself
    VectorXd share = VectorXd::Ones(count);
    if (mirrored)
        share[0] = share[count - 1] = 0.5;
    MatrixXd cosine = MatrixXd::Zero(count, terms), sine = MatrixXd::Zero(count, terms);
    VectorXd rise(terms), mean(terms);
    for (int k = 0; k < terms; ++k) {
        auto const column = static_cast<Index>(k);
        bool const alternating = 2 * k == points;
        double const n = static_cast<double>(k) * waves;
        double const coefficient = (mirrored ? 2.0 : 1.0) * (k == 0 || alternating ? 1.0 : 2.0) / points;
        // of an amplitude at a point: the work of +-1 at the points is twice that of the cosine through them
        double const felt = alternating ? 0.5 : 1.0;
        for (Index m = 0; m < count; ++m) {
            double const angle = n * line.phi[static_cast<std::size_t>(m)];
            cosine(m, column) = share[m] * std::cos(angle);
            sine(m, column) = mirrored || alternating ? 0 : share[m] * std::sin(angle);
        }
        line.held +=
            arc * felt *
            (surface.reaction_cosine[column] * cosine.col(column) + surface.reaction_sine[column] * sine.col(column));
        rise[column] = arc * felt * coefficient * surface.reaction_to_lift[column];
        mean[column] = coefficient * mean_of_cosine(n, contacts.spread);
    }
    constexpr std::size_t points_worth_a_thread = 16, rows_worth_a_thread = 64;
    parallel_for(static_cast<std::size_t>(count), threads, points_worth_a_thread, [&](std::size_t point) {
        auto const m = static_cast<Index>(point);
        for (Index k = 0; k < terms; ++k)
            line.stiffness.col(m) += rise[k] * (cosine(m, k) * cosine.col(k) + sine(m, k) * sine.col(k));
    });
    parallel_for(static_cast<std::size_t>(rows), threads, rows_worth_a_thread, [&](std::size_t row) {
        VectorXd lift = VectorXd::Zero(count);
        for (Index k = 0; k < terms; ++k) {
            double const angle = static_cast<double>(k) * waves * contacts.phi[row];
            // Betti: the surface rises by as much as a force on it unloads the balls
            double const risen = -mean[k] * surface.reaction_to_load(k, contacts.z[row]);
            lift += risen * (std::cos(angle) * cosine.col(k) + std::sin(angle) * sine.col(k));
        }
        line.lift.row(static_cast<Index>(row)) = lift.transpose();
    });
    return line;
}

}  // namespace hdconj::elastic
