// SPDX-License-Identifier: GPL-3.0-or-later
// What most flanks of a side have in common beside their parabolas, as relief at the tip or material left at the root.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace hdconj::inspect {

/// Deviations along one flank by rising xi, -1 at its root end and 1 at its tip end.
struct FlankRun
{
    std::vector<double> xi, deviation;
};

/// A parabola of weighted least squares through values along a flank, and what it leaves of them.
class RunParabola
{
  public:
    /// A smaller share is rounding: the value alone fixes the parabola, which meets it.
    static constexpr double least_share = 1e-9;

    RunParabola(std::vector<double> const& xi, std::vector<double> const& values, Eigen::VectorXd const& weights);
    /// With equal weights.
    RunParabola(std::vector<double> const& xi, std::vector<double> const& values);

    [[nodiscard]] Eigen::VectorXd const& remainders() const { return remainder_; }
    [[nodiscard]] double remainder(std::size_t i) const { return remainder_[static_cast<Eigen::Index>(i)]; }
    /// Element of the matrix that takes values to remainders: 1 - leverage where @p i is @p j.
    [[nodiscard]] double share(std::size_t i, std::size_t j) const
    {
        auto const a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
        return (i == j ? 1.0 : 0.0) - basis_.row(a).dot(covariance_ * basis_.row(b).transpose()) * weights_[b];
    }
    /// How far value @p i lies off the parabola through the others, over what that is of noise of deviation 1.
    [[nodiscard]] double off(std::size_t i) const;

  private:
    Eigen::MatrixX3d basis_;
    Eigen::VectorXd weights_;
    Eigen::Matrix3d covariance_;
    Eigen::VectorXd remainder_;
};

/// The form that most flanks of one side share, and how far the flanks differ from it.
///
/// The flanks have parabolas of their own. What these leave is put together by xi in groups of neighbouring points,
/// about as many as there are flanks. A straight line joins the medians of the groups. Parabolas and form are found in
/// turn; points that lie far off weigh less in the parabolas (Huber 1964). A single flank has no form in common with
/// others: it is 0 then.
class CommonForm
{
  public:
    static constexpr std::size_t fewest_flanks = 2;

    explicit CommonForm(std::vector<FlankRun> const& side);

    /// Whether there are enough flanks.
    [[nodiscard]] bool known() const { return !form_.empty(); }
    [[nodiscard]] double operator()(double xi) const;
    /// Median of what points near @p xi lie off the parabolas of their flanks, as RunParabola::off().
    [[nodiscard]] double spread(double xi) const;
    /// How far the line between the groups may miss a smooth form at @p xi: its change of slope at the next group, over
    /// the distance from there.
    [[nodiscard]] double bend(double xi) const;
    /// The run without the form.
    [[nodiscard]] std::vector<double> without(FlankRun const& run) const;

  private:
    std::vector<double> xi_, form_, spread_;  ///< of the groups
};

}  // namespace hdconj::inspect
