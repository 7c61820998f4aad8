// SPDX-License-Identifier: GPL-3.0-or-later
// A complementarity problem with the scalar s of its border, and what both methods ask of it; private to src/elastic.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "complementarity.hpp"

namespace hdconj::numeric {

/// Forces f, gaps g = G f - d - b s, and s: what a method has reached so far.
class ComplementaritySystem
{
  public:
    /// @throws NumericalError for a problem that is not finite, or whose load nothing can carry
    ComplementaritySystem(Complementarity const& problem, double scalar, int threads);

    [[nodiscard]] Complementarity const& problem() const { return problem_; }
    [[nodiscard]] Eigen::Index count() const { return count_; }
    [[nodiscard]] int threads() const { return threads_; }
    [[nodiscard]] bool has_border() const { return problem_.border.size() > 0; }
    [[nodiscard]] bool on_border(std::vector<int> const& contacts) const;
    /// b s
    [[nodiscard]] Eigen::VectorXd closed_by_s() const
    {
        return has_border() ? Eigen::VectorXd(problem_.border * s) : Eigen::VectorXd::Zero(count_);
    }
    [[nodiscard]] Eigen::VectorXd gaps(Eigen::VectorXd const& f) const;
    /// Energy at the s of now: its minimum over f >= 0 is the solution for this s.
    [[nodiscard]] double energy_at_s(Eigen::VectorXd const& f) const;
    /// Contacts of f = 0.
    [[nodiscard]] std::vector<int> overlapping() const;
    /// s at which the next @p contact that can carry the load closes when s moves in @p direction; where there is none,
    /// @p contact stays what it is.
    [[nodiscard]] double nearest_contact(Eigen::VectorXd const& gap, double direction, int& contact) const;
    /// Forces that close the gaps of @p contacts, no matter their sign; s follows where the border stands on one of
    /// them.
    Eigen::VectorXd close(std::vector<int> const& contacts, bool keep_s);
    [[nodiscard]] ComplementaritySolution solution(Eigen::VectorXd f, ContactMethod method) const;

    double s;
    std::vector<double> energies;  ///< of the projected method's steps

  private:
    Complementarity const& problem_;
    Eigen::Index count_;
    int threads_;
    double slope_ = 0;  ///< d(b . f)/ds of the last contacts
    int iterations_ = 0;
};

/// From @p contacts on: all wrong ones change in each step. Nothing where that comes to no end.
[[nodiscard]] std::optional<ComplementaritySolution> active_set(ComplementaritySystem& system,
                                                                std::vector<int> contacts, double tolerance);

/// Steps that each lower the energy at one s, and s by the load: slower, for where the active set comes to no end.
/// @throws NumericalError where rounding leaves more than @p tolerance
[[nodiscard]] ComplementaritySolution projected(ComplementaritySystem& system, double tolerance);

/// complementarity_residual() where G f is known.
[[nodiscard]] double residual_of(Complementarity const& problem, Eigen::VectorXd const& force,
                                 Eigen::VectorXd const& elastic, double scalar);

[[noreturn]] void fail_complementarity(std::string const& cause);

}  // namespace hdconj::numeric
