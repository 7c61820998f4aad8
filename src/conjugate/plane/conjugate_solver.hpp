// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of `solve` in one plane, after its motion is known.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/deferred_tasks.hpp"
#include "centred_outline.hpp"
#include "conjugate/space_curve.hpp"
#include "drive/stage_clock.hpp"
#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "records.hpp"

namespace hdconj::conjugate {

/// Contact arcs of all branches in one list, which boundary pieces index.
[[nodiscard]] inline std::vector<envelope::ContactArc> all_arcs(std::vector<envelope::Branch> const& branches)
{
    std::vector<envelope::ContactArc> arcs;
    for (envelope::Branch const& branch : branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    return arcs;
}

/// A tooth space and the arcs that its pieces index.
struct TracedSpace
{
    std::vector<envelope::ContactArc> arcs;
    ToothSpace space;
};

/// Solves one plane: its branches, and from them the tooth space, checked over a full turn.
class ConjugateSolver
{
  public:
    ConjugateSolver(Solution& out, profile::Profile const& tooth, motion::AnyMotion const& motion,
                    drive::StageClock& clock);

    /// All of it, with branches and teeth as results show them. @param given  the tooth before its arcs were set in
    /// motion (avoid_stationary_centres())
    void operator()(profile::Profile const& given);

    /// First half of the work: all that does not depend on the tip circle.
    void find_branches_of_tooth();

    /// The same, from a solver of the same tooth and motion that has found them, whatever its side clearance.
    void take_branches(ConjugateSolver const& other) { branches_ = other.branches_; }

    /// Second half: the boundary down to the tip circle of `out`.geometry, checked over a full turn.
    void find_boundary();

    /// The radius at which the circular spline's teeth would be pointed, with its side clearance: the teeth sweep all
    /// that lies inside it half-way between two spaces. Accuracy: that of the first polygons.
    /// @param tip  of the circular spline, from which on the teeth are looked at [mm]
    [[nodiscard]] double pointed_radius(double tip);

    /// The boundary that was found, as a curve. @param tooth  the one that was solved, kept alive
    [[nodiscard]] ToothSpaceBoundary curve(std::shared_ptr<profile::Profile const> tooth) const;

  private:
    [[nodiscard]] double first_chord() const { return (tooth_.addendum + tooth_.dedendum) * 0x1p-12; }
    [[nodiscard]] bool is_moved() const { return out_.plan.has(Stage::backlash); }
    [[nodiscard]] envelope::AnyEnvelope final_envelope() const;

    /// The branches of the tooth with the side clearance on it; found once.
    [[nodiscard]] std::vector<envelope::Branch> const& moved_branches();

    /// Finds the boundary, and leaves its pieces to be sampled to @p jobs.
    void find_pieces(double chord, DeferredTasks& jobs);

    /// Region, side clearance, outline, root clearance and check, with polygons of the given chord error.
    void assemble(double chord);

    /// The boundary's pieces, ready to be sampled.
    void trace_boundary(double chord);

    void find_sampler(double chord);

    void sample_pieces();

    void join_pieces();

    /// Every outline point against every position of every tooth. A symmetric pair's left half is the image of its
    /// right one.
    void check();

    void publish();

    Solution& out_;
    profile::Profile const& tooth_;
    motion::AnyMotion const& motion_;
    drive::StageClock& clock_;
    envelope::AnyEnvelope base_;
    double pitch_;
    Tolerance tolerance_;
    std::vector<envelope::Branch> branches_;
    std::optional<std::vector<envelope::Branch>> moved_branches_;
    std::optional<envelope::AnyEnvelope> moved_;  ///< of the tooth with the side clearance on it
    TracedSpace final_;
    std::optional<CentredOutlineSampler> sampler_;  ///< of the boundary in final_
    CentredOutline outline_;
    std::optional<ToothOutline> shown_;  ///< for results only, until its points are made beside those of branches
};

/// `solve` for the reverse problem, after the motion is known: the circular spline's tooth given, the flexspline's
/// solved for.
/// @param given   the circular-spline tooth in its own frame
/// @param motion  of the flexspline tooth, any model
void solve_reverse(Solution& out, profile::Profile const& given, motion::AnyMotion const& motion,
                   drive::StageClock& clock);

}  // namespace hdconj::conjugate
