// SPDX-License-Identifier: GPL-3.0-or-later
// Unilateral contact: forces that push only, gaps that do not close further than to zero.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "columns_on_demand.hpp"

namespace hdconj::numeric {

/// Find f >= 0 and, with a border, the scalar s such that
///
///   g = G f - d - b s >= 0,   f . g = 0,   b . f = T.
///
/// The same as: min 1/2 f'G f - d'f over f >= 0, b . f = T, whose multiplier is s. In a contact problem f are forces
/// [N], g gaps [mm], d the approach of the undeformed bodies (positive: they would overlap), s a rigid motion that
/// closes gap i by b_i s, and T the load on it. Domain: G symmetric positive definite.
struct Complementarity
{
    Eigen::MatrixXd compliance;                          ///< G, or its block of the last contacts
    Eigen::VectorXd approach;                            ///< d
    Eigen::VectorXd border;                              ///< b; empty: none, and no s
    double total = 0;                                    ///< T
    std::shared_ptr<ColumnsOnDemand> leading = nullptr;  ///< the rest of G; null: there is none
    /// A block that many problems have in common, in place of `compliance`; made by shared_compliance(). Null: none.
    std::shared_ptr<Eigen::MatrixXd const> shared = nullptr;
    /// E: what springs that yield add to G, which is E'E. A row for each spring, a column for each of the last
    /// contacts. Empty: no spring yields.
    Eigen::MatrixXd yielding = {};

    /// The block of the last contacts, without E'E.
    [[nodiscard]] Eigen::MatrixXd const& block() const { return shared ? *shared : compliance; }
};

/// How a solution was found.
enum class ContactMethod
{
    active_set,  ///< primal-dual active set (semismooth Newton; Hintermueller, Ito and Kunisch 2002)
    projected    ///< projected Newton (Bertsekas 1982), within Newton's method for s
};

/// Largest residual of a solution: relative to the largest force and gap; grids of contacts reach 1e-13.
inline constexpr double contact_tolerance = 1e-10;  // relative

/// What the solver may do.
struct ComplementarityOptions
{
    ContactMethod first = ContactMethod::active_set;  ///< `projected`: at once
    double tolerance = contact_tolerance;             ///< largest residual
    std::vector<int> start = {};  ///< contacts to begin with, of a neighbouring problem; empty: those of f = 0
    double scalar = 0;            ///< s to begin with
    int threads = 1;
};

struct ComplementaritySolution
{
    Eigen::VectorXd force;      ///< f
    Eigen::VectorXd gap;        ///< g
    double scalar = 0;          ///< s; where no force stands on the border, any one that fits
    double slope = 0;           ///< d(b . f)/ds with these contacts; 0: no border, or none of them on it
    std::vector<int> contacts;  ///< f > 0
    int iterations = 0;         ///< systems solved
    /// Largest of -f and |b . f - T|/|b| against the largest f, -g against the largest of |d|, |b s| and |G f|, and
    /// min(f, g) in both scales.
    double residual = 0;
    double energy = 0;             ///< 1/2 f'G f - d'f [N mm]
    std::vector<double> energies;  ///< of the projected method, each step of each s; they do not rise at one s
    ContactMethod method = ContactMethod::active_set;
};

/// The primal-dual active set takes some twenty systems for thousands of unknowns but may cycle, for some positive
/// definite G; sets that return, or an energy that has not fallen for long, hand over to the projected method, whose
/// energy falls in each step.
/// @throws NumericalError with the residual where neither reaches the tolerance (G not positive definite, or too
/// ill-conditioned), and
///                        where no force can make T (no b of its sign)
[[nodiscard]] ComplementaritySolution solve_complementarity(Complementarity const& problem,
                                                            ComplementarityOptions const& options = {});

/// The residual of ComplementaritySolution, of any f and s.
[[nodiscard]] double complementarity_residual(Complementarity const& problem, Eigen::VectorXd const& force,
                                              double scalar, int threads = 1);

}  // namespace hdconj::numeric
