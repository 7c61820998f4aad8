// SPDX-License-Identifier: GPL-3.0-or-later
// Projected Newton steps (Bertsekas 1982) at one s, within Newton's method for s.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "complementarity_system.hpp"
#include "compliance.hpp"
#include "hdconj/base/tolerance.hpp"

namespace hdconj::numeric {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// Minimum of the energy over f >= 0 at the s of now, from @p f. Each step lowers the energy.
VectorXd projected_at_s(ComplementaritySystem& system, VectorXd f)
{
    constexpr int most = 10000;
    constexpr int most_halvings = 60;
    constexpr double sufficient = 1e-4;  // share of the decrease that the slope promises (Armijo)
    VectorXd const diagonal = diagonal_of(system.problem());
    double energy = system.energy_at_s(f);
    for (int step = 0; step < most; ++step) {
        VectorXd const g = system.gaps(f);
        // forces so small that the next step would end them are held at zero (Bertsekas' guard against jamming)
        double const reach = (f - (f - g.cwiseQuotient(diagonal)).cwiseMax(0.0)).cwiseAbs().maxCoeff();
        double const near = std::min(reach, f.cwiseAbs().maxCoeff() * sufficient);
        std::vector<int> free;
        for (Index i = 0; i < system.count(); ++i)
            if (!(f[i] <= near && g[i] > 0) && (f[i] > 0 || g[i] < 0))
                free.push_back(static_cast<int>(i));
        VectorXd direction = VectorXd::Zero(system.count());
        if (!free.empty())
            direction = system.close(free, true);
        for (int i : free)
            direction[i] -= f[i];
        for (Index i = 0; i < system.count(); ++i)
            if (f[i] > 0 && f[i] <= near && g[i] > 0)
                direction[i] = -f[i];
        bool lowered = false;
        double length = 1;
        for (int halving = 0; halving < most_halvings; ++halving, length /= 2) {
            VectorXd const tried = (f + length * direction).cwiseMax(0.0);
            double const promised = g.dot(f - tried);
            double const reached = system.energy_at_s(tried);
            if (promised > 0 && energy - reached >= sufficient * promised && reached < energy) {
                f = tried;
                energy = reached;
                system.energies.push_back(energy);
                lowered = true;
                break;
            }
        }
        if (!lowered)
            return f;
    }
    return f;
}

}  // namespace

ComplementaritySolution projected(ComplementaritySystem& system, double tolerance)
{
    Complementarity const& problem = system.problem();
    constexpr int most = 1000;
    VectorXd f = VectorXd::Zero(system.count());
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    double residual = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most; ++step) {
        system.energies.clear();
        f = projected_at_s(system, f);
        std::vector<int> contacts;
        for (Index i = 0; i < system.count(); ++i)
            if (f[i] > 0)
                contacts.push_back(static_cast<int>(i));
        double const s = system.s;
        system.close(contacts, false);
        double const asked = system.s;
        // from almost the right contacts the active set has little to do, and its last system gives all digits
        if (auto found = active_set(system, contacts, tolerance)) {
            found->method = ContactMethod::projected;
            return *std::move(found);
        }
        residual = std::min(residual, complementarity_residual(problem, f, s, system.threads()));
        system.s = s;
        if (!system.has_border())
            break;
        double const excess = problem.border.dot(f) - problem.total;
        (excess > 0 ? high : low) = s;
        double const direction = excess > 0 ? -1 : 1;
        if (!contacts.empty() && system.on_border(contacts))
            system.s = asked;
        else {
            // a little beyond the next contact, so that it carries something
            int contact = -1;
            double const next = system.nearest_contact(system.gaps(f), direction, contact);
            if (contact < 0)
                break;
            system.s = next + (next - s) + direction * unit_roundoff * std::abs(next);
            if (system.s == s)
                system.s += direction *
                            std::max(std::abs(s),
                                     problem.approach.cwiseAbs().maxCoeff() / problem.border.cwiseAbs().maxCoeff()) /
                            16;
        }
        if (!(system.s > low && system.s < high))
            system.s = std::isfinite(low) && std::isfinite(high) ? (low + high) / 2 : system.s;
        if (system.s == s)
            break;
    }
    fail_complementarity(
        fmt::format("no forces and gaps were found that fit together: remaining error {:.3g} instead of {:.3g}",
                    residual, tolerance));
}

}  // namespace hdconj::numeric
