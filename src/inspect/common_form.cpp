// SPDX-License-Identifier: GPL-3.0-or-later
#include "common_form.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/least_squares.hpp"

namespace hdconj::inspect {
namespace {

constexpr int rounds = 8;               // of parabolas and form in turn
constexpr std::size_t most_needed = 7;  // points of a group: enough for a median

/// A point of a run in the order of all points of the side.
struct Place
{
    double xi;
    std::size_t run, point;
};

std::vector<Place> sorted_places(std::vector<FlankRun> const& side)
{
    std::vector<Place> places;
    for (std::size_t k = 0; k < side.size(); ++k)
        for (std::size_t i = 0; i < side[k].xi.size(); ++i)
            places.push_back({side[k].xi[i], k, i});
    std::ranges::stable_sort(places, {}, &Place::xi);
    return places;
}

/// Weights of points that are off by @p remainders, 1 up to one and a half times the median, or up to rounding.
Eigen::VectorXd huber_weights(Eigen::VectorXd const& remainders, double median)
{
    constexpr double rounding = 1e-9;  // mm
    double const usual = std::max(1.5 * median, rounding);
    return remainders.unaryExpr([&](double r) { return usual / std::max(usual, std::abs(r)); });
}

/// Where each group ends: it has enough points, and the next point is further from its middle than an eighth of the
/// mean distance between neighbours on a flank, so that points which all flanks have at one place are one group.
std::vector<std::size_t> ends_of_groups(std::vector<Place> const& places, std::size_t flanks)
{
    std::size_t const least = std::min(flanks, most_needed);
    double const apart =
        (places.back().xi - places.front().xi) * static_cast<double>(flanks) / (8 * static_cast<double>(places.size()));
    std::vector<std::size_t> ends;
    std::size_t first = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (i - first >= least && places[i].xi - places[(first + i) / 2].xi > apart && places.size() - i >= least) {
            ends.push_back(i);
            first = i;
        }
    ends.push_back(places.size());
    return ends;
}

/// The middle one of some values, of two middle ones the smaller in size; 0 of none.
double median(std::vector<double> values)
{
    if (values.empty())
        return 0;
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1)
        return *middle;
    double const below = *std::max_element(values.begin(), middle);
    return std::abs(below) < std::abs(*middle) ? below : *middle;
}

}  // namespace

RunParabola::RunParabola(std::vector<double> const& xi, std::vector<double> const& values)
    : RunParabola(xi, values, Eigen::VectorXd::Ones(static_cast<Eigen::Index>(xi.size())))
{
}

RunParabola::RunParabola(std::vector<double> const& xi, std::vector<double> const& values,
                         Eigen::VectorXd const& weights)
    : basis_(static_cast<Eigen::Index>(xi.size()), 3), weights_(weights)
{
    for (Eigen::Index i = 0; i < basis_.rows(); ++i) {
        double const x = xi[static_cast<std::size_t>(i)];
        basis_.row(i) << 1, x, x * x;
    }
    Eigen::VectorXd const root = weights.cwiseSqrt(), value = Eigen::VectorXd::Map(values.data(), basis_.rows());
    Eigen::MatrixXd const weighted = root.asDiagonal() * basis_;
    covariance_ = numeric::covariance(weighted);
    remainder_ = value - basis_ * numeric::LeastSquares(weighted).solve(Eigen::VectorXd(root.cwiseProduct(value)));
}

double RunParabola::off(std::size_t i) const
{
    return std::abs(remainder(i)) / std::sqrt(std::max(least_share, share(i, i)));
}

CommonForm::CommonForm(std::vector<FlankRun> const& side)
{
    if (side.size() < fewest_flanks)
        return;
    std::vector<Place> const places = sorted_places(side);
    std::vector<std::size_t> const ends = ends_of_groups(places, side.size());
    std::vector<RunParabola> parabolas;
    for (int round = 0; round <= rounds; ++round) {
        std::vector<RunParabola> const before = std::exchange(parabolas, {});
        double const usual = median(spread_);
        for (std::size_t k = 0; k < side.size(); ++k)
            if (round == 0)
                parabolas.emplace_back(side[k].xi, without(side[k]));
            else
                parabolas.emplace_back(side[k].xi, without(side[k]), huber_weights(before[k].remainders(), usual));
        std::vector<double> next, xi, spread;
        for (std::size_t group = 0, first = 0; group < ends.size(); first = ends[group++]) {
            std::vector<double> x, value, off;
            for (std::size_t i = first; i < ends[group]; ++i) {
                Place const& at = places[i];
                x.push_back(at.xi);
                value.push_back(parabolas[at.run].remainder(at.point) + (*this)(at.xi));
                off.push_back(parabolas[at.run].off(at.point));
            }
            xi.push_back(median(x));
            next.push_back(median(value));
            spread.push_back(median(off));
        }
        spread_ = spread;
        xi_ = xi;
        if (round < rounds)
            form_ = next;
    }
}

double CommonForm::operator()(double xi) const
{
    if (form_.empty())
        return 0;
    if (form_.size() == 1)
        return form_[0];
    auto const above = std::upper_bound(xi_.begin() + 1, xi_.end() - 1, xi);
    auto const i = static_cast<std::size_t>(above - xi_.begin());
    return form_[i - 1] + (xi - xi_[i - 1]) * (form_[i] - form_[i - 1]) / (xi_[i] - xi_[i - 1]);
}

double CommonForm::spread(double xi) const
{
    if (spread_.empty())
        return 0;
    auto const above = std::upper_bound(xi_.begin(), xi_.end(), xi);
    auto const i = static_cast<std::size_t>(above - xi_.begin());
    return std::max(spread_[std::min(i, spread_.size() - 1)], spread_[i > 0 ? i - 1 : 0]);
}

double CommonForm::bend(double xi) const
{
    std::size_t const n = form_.size();
    if (n < 3)
        return 0;
    auto const above = std::upper_bound(xi_.begin(), xi_.end(), xi);
    auto next = static_cast<std::size_t>(above - xi_.begin());
    if (next == n || (next > 0 && xi - xi_[next - 1] < xi_[next] - xi))
        --next;
    std::size_t const i = std::clamp<std::size_t>(next, 1, n - 2);
    double const kink =
        (form_[i + 1] - form_[i]) / (xi_[i + 1] - xi_[i]) - (form_[i] - form_[i - 1]) / (xi_[i] - xi_[i - 1]);
    return std::abs(kink * (xi - xi_[next]));
}

std::vector<double> CommonForm::without(FlankRun const& run) const
{
    std::vector<double> left;
    for (std::size_t i = 0; i < run.xi.size(); ++i)
        left.push_back(run.deviation[i] - (*this)(run.xi[i]));
    return left;
}

}  // namespace hdconj::inspect
