// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/elastic/complementarity.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/tolerance.hpp"

namespace hdconj {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::string number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

[[noreturn]] void fail(std::string const& cause)
{
    throw NumericalError("contact of elastic bodies", "complementarity problem", cause);
}

/// Columns of a list of contacts only: G f costs their number times that of the gaps.
VectorXd times(Eigen::MatrixXd const& compliance, VectorXd const& force)
{
    VectorXd result = VectorXd::Zero(compliance.rows());
    for (Index j = 0; j < force.size(); ++j)
        if (force[j] != 0)
            result += force[j] * compliance.col(j);
    return result;
}

class Solver
{
  public:
    Solver(Complementarity const& problem, ComplementarityOptions const& options)
        : problem_(problem), options_(options), count_(problem.approach.size()), s_(problem.border.size() > 0 ? options.scalar : 0)
    {
        if (!problem.compliance.allFinite() || !problem.approach.allFinite() || !problem.border.allFinite() || !std::isfinite(problem.total))
            fail("a compliance, an approach or the load is not a number");
        double const load = problem.total;
        if (has_border() && load != 0 && (problem.border * load).maxCoeff() <= 0)
            fail("no contact can carry the load of " + number(load) + ": none acts in its direction");
        if (!has_border() && load != 0)
            fail("a load without a border that carries it");
    }

    ComplementaritySolution operator()()
    {
        if (count_ == 0)
            return {};
        if (options_.first == ContactMethod::active_set)
            if (auto found = active_set(options_.start.empty() ? overlapping() : options_.start))
                return *std::move(found);
        return projected();
    }

  private:
    [[nodiscard]] bool has_border() const { return problem_.border.size() > 0; }
    [[nodiscard]] VectorXd closed_by_s() const { return has_border() ? VectorXd(problem_.border * s_) : VectorXd::Zero(count_); }
    [[nodiscard]] VectorXd gaps(VectorXd const& f) const { return times(problem_.compliance, f) - problem_.approach - closed_by_s(); }
    /// Energy at the s of now: its minimum over f >= 0 is the solution for this s.
    [[nodiscard]] double energy_at_s(VectorXd const& f) const
    {
        return f.dot(times(problem_.compliance, f)) / 2 - f.dot(problem_.approach + closed_by_s());
    }

    /// Forces that close the gaps of @p contacts, no matter their sign; s follows where the border stands on one of them.
    VectorXd close(std::vector<int> const& contacts, bool keep_s)
    {
        ++iterations_;
        VectorXd f = VectorXd::Zero(count_);
        if (contacts.empty())
            return f;
        Eigen::LLT<Eigen::MatrixXd> const llt(problem_.compliance(contacts, contacts));
        if (llt.info() != Eigen::Success)
            fail("the compliance matrix is not positive definite");
        VectorXd const x = llt.solve(problem_.approach(contacts));
        if (!has_border())
        {
            f(contacts) = x;
            return f;
        }
        VectorXd const b = problem_.border(contacts);
        VectorXd const y = llt.solve(b);
        slope_ = b.dot(y);
        if (!keep_s && slope_ > 0)
            s_ = (problem_.total - b.dot(x)) / slope_;
        VectorXd on = x + s_ * y;
        // s b and d may be far larger than what they leave for f: once more for what is missing of T
        if (!keep_s && slope_ > 0)
        {
            double const missing = (problem_.total - b.dot(on)) / slope_;
            on += missing * y;
            s_ += missing;
        }
        f(contacts) = on;
        return f;
    }

    /// s at which the next contact that can carry the load closes.
    [[nodiscard]] double nearest_contact(VectorXd const& gap, int& contact) const
    {
        double best = std::numeric_limits<double>::infinity();
        for (Index i = 0; i < count_; ++i)
            if (problem_.border[i] * direction_ > 0)
            {
                double const step = gap[i] / (problem_.border[i] * direction_);
                if (step < best)
                    best = step, contact = static_cast<int>(i);
            }
        return s_ + direction_ * best;
    }

    [[nodiscard]] bool on_border(std::vector<int> const& contacts) const
    {
        return std::any_of(contacts.begin(), contacts.end(), [this](int i) { return problem_.border[i] != 0; });
    }

    [[nodiscard]] ComplementaritySolution solution(VectorXd f, ContactMethod method) const
    {
        ComplementaritySolution result;
        for (Index i = 0; i < count_; ++i)
        {
            if (f[i] > 0)
                result.contacts.push_back(static_cast<int>(i));
            else
                f[i] = 0;
        }
        result.gap = gaps(f);
        result.residual = complementarity_residual(problem_, f, s_);
        result.energy = f.dot(times(problem_.compliance, f)) / 2 - f.dot(problem_.approach);
        result.force = std::move(f);
        result.scalar = s_;
        result.slope = slope_;
        result.iterations = iterations_;
        result.energies = energies_;
        result.method = method;
        return result;
    }

    /// Contacts of f = 0.
    [[nodiscard]] std::vector<int> overlapping() const
    {
        std::vector<int> contacts;
        VectorXd const overlap = problem_.approach + closed_by_s();
        for (Index i = 0; i < count_; ++i)
            if (overlap[i] > 0)
                contacts.push_back(static_cast<int>(i));
        return contacts;
    }

    std::optional<ComplementaritySolution> active_set(std::vector<int> contacts)
    {
        constexpr int patience = 40;   // steps without a lower energy: twice as many as whole solutions take
        constexpr double rounding = 1e-14;  // of forces and gaps, against the largest: less is neither push nor overlap
        std::set<std::vector<int>> seen;
        double least = std::numeric_limits<double>::infinity();
        int waited = 0;
        while (waited < patience && seen.insert(contacts).second)
        {
            direction_ = problem_.total < 0 ? -1 : 1;
            if (has_border() && problem_.total != 0 && !on_border(contacts))
            {
                VectorXd const f = close(contacts, true);
                int contact = -1;
                s_ = nearest_contact(gaps(f), contact);
                contacts.insert(std::lower_bound(contacts.begin(), contacts.end(), contact), contact);
            }
            VectorXd const f = close(contacts, false);
            VectorXd const g = gaps(f);
            double const length = (problem_.approach.cwiseAbs() + closed_by_s().cwiseAbs()).maxCoeff() * rounding;
            double const force = f.cwiseAbs().maxCoeff() * rounding + length / problem_.compliance.diagonal().maxCoeff();
            std::vector<bool> was(static_cast<std::size_t>(count_), false);
            for (int i : contacts)
                was[static_cast<std::size_t>(i)] = true;
            std::vector<int> next;
            bool settled = true;
            for (Index i = 0; i < count_; ++i)
            {
                bool const in = was[static_cast<std::size_t>(i)];
                bool const stays = in ? f[i] >= -force : g[i] < -length;
                settled = settled && stays == in;
                if (stays && (!in || f[i] > 0))
                    next.push_back(static_cast<int>(i));
            }
            if (settled)
            {
                auto result = solution(f, ContactMethod::active_set);
                if (result.residual <= options_.tolerance)
                    return result;
                return std::nullopt;
            }
            contacts = std::move(next);
            VectorXd const pushing = f.cwiseMax(0.0);
            double const energy = energy_at_s(pushing);
            waited = energy < least ? 0 : waited + 1;
            least = std::min(least, energy);
        }
        return std::nullopt;
    }

    /// Minimum of the energy over f >= 0 at the s of now, from @p f. Each step lowers the energy.
    VectorXd projected_at_s(VectorXd f)
    {
        constexpr int most = 10000;
        constexpr int most_halvings = 60;
        constexpr double sufficient = 1e-4;  // share of the decrease that the slope promises (Armijo)
        VectorXd const diagonal = problem_.compliance.diagonal();
        double energy = energy_at_s(f);
        for (int step = 0; step < most; ++step)
        {
            VectorXd const g = gaps(f);
            // forces so small that the next step would end them are held at zero (Bertsekas' guard against jamming)
            double const reach = (f - (f - g.cwiseQuotient(diagonal)).cwiseMax(0.0)).cwiseAbs().maxCoeff();
            double const near = std::min(reach, f.cwiseAbs().maxCoeff() * sufficient);
            std::vector<int> free;
            for (Index i = 0; i < count_; ++i)
                if (!(f[i] <= near && g[i] > 0) && (f[i] > 0 || g[i] < 0))
                    free.push_back(static_cast<int>(i));
            VectorXd direction = VectorXd::Zero(count_);
            if (!free.empty())
                direction = close(free, true);
            for (int i : free)
                direction[i] -= f[i];
            for (Index i = 0; i < count_; ++i)
                if (f[i] > 0 && f[i] <= near && g[i] > 0)
                    direction[i] = -f[i];
            bool lowered = false;
            double length = 1;
            for (int halving = 0; halving < most_halvings; ++halving, length /= 2)
            {
                VectorXd const tried = (f + length * direction).cwiseMax(0.0);
                double const promised = g.dot(f - tried);
                double const reached = energy_at_s(tried);
                if (promised > 0 && energy - reached >= sufficient * promised && reached < energy)
                {
                    f = tried;
                    energy = reached;
                    energies_.push_back(energy);
                    lowered = true;
                    break;
                }
            }
            if (!lowered)
                return f;
        }
        return f;
    }

    ComplementaritySolution projected()
    {
        constexpr int most = 1000;
        VectorXd f = VectorXd::Zero(count_);
        double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
        double residual = std::numeric_limits<double>::infinity();
        for (int step = 0; step < most; ++step)
        {
            energies_.clear();
            f = projected_at_s(f);
            std::vector<int> contacts;
            for (Index i = 0; i < count_; ++i)
                if (f[i] > 0)
                    contacts.push_back(static_cast<int>(i));
            double const s = s_;
            close(contacts, false);
            double const asked = s_;
            // from almost the right contacts the active set has little to do, and its last system gives all digits
            if (auto found = active_set(contacts))
            {
                found->method = ContactMethod::projected;
                return *std::move(found);
            }
            residual = std::min(residual, complementarity_residual(problem_, f, s));
            s_ = s;
            if (!has_border())
                break;
            double const excess = problem_.border.dot(f) - problem_.total;
            (excess > 0 ? high : low) = s;
            direction_ = excess > 0 ? -1 : 1;
            if (!contacts.empty() && on_border(contacts))
                s_ = asked;
            else
            {
                // a little beyond the next contact, so that it carries something
                int contact = -1;
                double const next = nearest_contact(gaps(f), contact);
                if (contact < 0)
                    break;
                s_ = next + (next - s) + direction_ * unit_roundoff * std::abs(next);
                if (s_ == s)
                    s_ += direction_ * std::max(std::abs(s), problem_.approach.cwiseAbs().maxCoeff() / problem_.border.cwiseAbs().maxCoeff()) / 16;
            }
            if (!(s_ > low && s_ < high))
                s_ = std::isfinite(low) && std::isfinite(high) ? (low + high) / 2 : s_;
            if (s_ == s)
                break;
        }
        fail("no forces and gaps were found that fit together: residual " + number(residual) + " instead of " + number(options_.tolerance));
    }

    Complementarity const& problem_;
    ComplementarityOptions const& options_;
    Index count_;
    double s_;
    double slope_ = 0;      ///< d(b . f)/ds of the last contacts
    double direction_ = 1;  ///< in which s has to go
    int iterations_ = 0;
    std::vector<double> energies_;
};

}  // namespace

double complementarity_residual(Complementarity const& problem, VectorXd const& force, double scalar)
{
    if (force.size() == 0)
        return 0;
    bool const bordered = problem.border.size() > 0;
    VectorXd const elastic = times(problem.compliance, force);
    VectorXd rigid = problem.approach;
    if (bordered)
        rigid += problem.border * scalar;
    VectorXd const gap = elastic - rigid;
    double largest_force = force.cwiseAbs().maxCoeff();
    double largest_gap = std::max({problem.approach.cwiseAbs().maxCoeff(), rigid.cwiseAbs().maxCoeff(), elastic.cwiseAbs().maxCoeff()});
    if (bordered)
        largest_force = std::max(largest_force, std::abs(problem.total) / problem.border.norm());
    largest_force = largest_force > 0 ? largest_force : 1;
    largest_gap = largest_gap > 0 ? largest_gap : 1;
    double residual = 0;
    for (Index i = 0; i < force.size(); ++i)
    {
        double const f = force[i] / largest_force, g = gap[i] / largest_gap;
        residual = std::max(residual, std::abs(std::min(f, g)));
    }
    if (bordered)
        residual = std::max(residual, std::abs(problem.border.dot(force) - problem.total) / (problem.border.norm() * largest_force));
    return residual;
}

ComplementaritySolution solve_complementarity(Complementarity const& problem, ComplementarityOptions const& options)
{
    return Solver(problem, options)();
}

}  // namespace hdconj
