// SPDX-License-Identifier: GPL-3.0-or-later
// Two lines that meet: least squares over the two slopes, the bend's place and its height (Hudson, J. Am. Stat. Assoc.
// 61, 1966). Between two neighbouring points a bend leaves both sides their own best lines, as long as those meet
// there; else the best bend of that interval lies at one of its ends: each interval and each point is looked at once.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include "hdconj/load.hpp"

namespace hdconj {
namespace {

/// Points that a line of its own needs, up to the bend: two lie on a line whatever they are.
constexpr std::size_t least_points = 3;

/// Sums over points from which any line through them follows: of twist and torque from their means, so that little
/// cancels.
struct Sums
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    void add(double px, double py)
    {
        n += 1;
        x += px;
        y += py;
        xx += px * px;
        xy += px * py;
        yy += py * py;
    }
    [[nodiscard]] Sums without(Sums const& a) const
    {
        return {n - a.n, x - a.x, y - a.y, xx - a.xx, xy - a.xy, yy - a.yy};
    }
    /// About their own means.
    [[nodiscard]] double spread() const { return xx - x * x / n; }
    [[nodiscard]] double slope() const { return (xy - x * y / n) / spread(); }
    [[nodiscard]] double height(double at) const { return y / n + slope() * (at - x / n); }
    /// Of the line's height there, for points of variance 1.
    [[nodiscard]] double height_variance(double at) const { return 1 / n + std::pow(at - x / n, 2) / spread(); }
    /// About @p at.
    [[nodiscard]] double xx_about(double at) const { return xx - 2 * at * x + at * at * n; }
    [[nodiscard]] double x_about(double at) const { return x - n * at; }
    [[nodiscard]] double xy_about(double at) const { return xy - at * y; }
};

struct Bend
{
    double first = 0, second = 0, twist = 0, torque = 0, squares = std::numeric_limits<double>::infinity();
    std::size_t split = 0;  ///< points of the first line
};

class Curve
{
  public:
    /// @param sign  -1 turns a curve of negative torques round, so that its first stage comes first
    Curve(std::vector<double> const& twist, std::vector<double> const& torque, double sign) : n_(twist.size())
    {
        std::vector<std::size_t> order(n_);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return sign * twist[a] < sign * twist[b]; });
        for (std::size_t i = 0; i < n_; ++i) {
            mean_x_ += sign * twist[i] / static_cast<double>(n_);
            mean_y_ += sign * torque[i] / static_cast<double>(n_);
        }
        sums_.resize(n_ + 1);
        for (std::size_t i = 0; i < n_; ++i) {
            x_.push_back(sign * twist[order[i]] - mean_x_);
            y_.push_back(sign * torque[order[i]] - mean_y_);
            sums_[i + 1] = sums_[i];
            sums_[i + 1].add(x_[i], y_[i]);
        }
    }

    [[nodiscard]] Sums const& all() const { return sums_.back(); }
    [[nodiscard]] double mean_x() const { return mean_x_; }
    [[nodiscard]] double mean_y() const { return mean_y_; }
    [[nodiscard]] Sums low(std::size_t split) const { return sums_[split]; }
    [[nodiscard]] Sums high(std::size_t split) const { return sums_.back().without(sums_[split]); }
    /// Whether lines through that many first and through the other points have slopes.
    [[nodiscard]] bool can_split(std::size_t split) const { return x_[0] < x_[split - 1] && x_[split] < x_[n_ - 1]; }
    /// Whether a bend at @p twist leaves no more points to the second line than it needs.
    [[nodiscard]] bool is_last_place(double twist) const { return twist >= x_[n_ - least_points]; }

    /// Sum of squares left by a line, or by two that meet; summed point by point, since a difference of sums would lose
    /// small ones.
    [[nodiscard]] double squares_of_line() const
    {
        double const slope = all().slope(), height = all().height(0);
        double squares = 0;
        for (std::size_t i = 0; i < n_; ++i)
            squares += std::pow(y_[i] - height - slope * x_[i], 2);
        return squares;
    }
    [[nodiscard]] double squares_of(Bend const& bend) const
    {
        double squares = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            squares +=
                std::pow(y_[i] - bend.torque - (i < bend.split ? bend.first : bend.second) * (x_[i] - bend.twist), 2);
        }
        return squares;
    }

    /// Both sides' own lines, where they meet between the points @p split - 1 and @p split.
    [[nodiscard]] std::optional<Bend> between(std::size_t split) const
    {
        Sums const a = low(split), b = high(split);
        Bend bend{a.slope(), b.slope(), 0, 0, 0, split};
        if (bend.first == bend.second)
            return std::nullopt;
        bend.twist = (b.height(0) - a.height(0)) / (bend.first - bend.second);
        bend.torque = a.height(bend.twist);
        bool const inside = bend.twist >= x_[split - 1] && bend.twist <= x_[split];
        return inside ? std::optional(bend) : std::nullopt;
    }

    /// The best two lines that meet at the twist of point @p at; none where they are not unique.
    [[nodiscard]] std::optional<Bend> at_point(std::size_t at) const
    {
        double const knee = x_[at];
        Sums const a = low(at), b = high(at);
        double const aa = a.xx_about(knee), bb = b.xx_about(knee), ax = a.x_about(knee), bx = b.x_about(knee);
        double const rest = all().n - ax * ax / aa - bx * bx / bb;
        if (!(aa > 0) || !(bb > 0) || !(rest > 0))
            return std::nullopt;
        double const height = (all().y - ax * a.xy_about(knee) / aa - bx * b.xy_about(knee) / bb) / rest;
        return Bend{(a.xy_about(knee) - height * ax) / aa, (b.xy_about(knee) - height * bx) / bb, knee, height, 0, at};
    }

  private:
    std::size_t n_;
    double mean_x_ = 0, mean_y_ = 0;
    std::vector<double> x_, y_;  ///< by growing x
    std::vector<Sums> sums_;
};

Bend best_bend(Curve const& curve, std::size_t points)
{
    Bend best;
    auto const consider = [&](std::optional<Bend> bend) {
        if (bend) {
            bend->squares = curve.squares_of(*bend);
            best = bend->squares < best.squares ? *bend : best;
        }
    };
    for (std::size_t split = least_points - 1; split + least_points <= points; ++split) {
        if (!curve.can_split(split))
            continue;
        if (split >= least_points)
            consider(curve.between(split));
        consider(curve.at_point(split));
    }
    return best;
}

/// Whether a bend explains more than chance would of points about one line. For one split the ratio of the sums of
/// squares has P(ratio < q) = q^((N-4)/2) (F distribution with 2 and N-4 degrees of freedom, in closed form); over all
/// splits no more than their number times that.
bool is_bent(double squares_of_line, double squares_of_bend, std::size_t points)
{
    constexpr double chance = 0.01;  // that a straight line with noise is called bent
    double const splits = static_cast<double>(points - 2 * least_points + 2);
    return splits * std::pow(squares_of_bend / squares_of_line, (static_cast<double>(points) - 4) / 2) < chance;
}

}  // namespace

StiffnessStages stiffness_stages(std::vector<double> const& twist, std::vector<double> const& torque)
{
    if (twist.size() != torque.size())
        throw std::logic_error("a torque-twist curve with more torques than twists, or fewer");
    StiffnessStages stages;
    std::size_t const points = twist.size();
    auto const [least, most] = std::minmax_element(twist.begin(), twist.end());
    if (points < 2 || !(*least < *most))
        return stages;
    double const largest =
        *std::max_element(torque.begin(), torque.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    double const sign = largest < 0 ? -1 : 1;
    Curve const curve(twist, torque, sign);
    Sums const all = curve.all();
    double const count = static_cast<double>(points);
    double const squares = curve.squares_of_line();
    stages.first = stages.second = all.slope();
    stages.first_error = stages.second_error = points > 2 ? std::sqrt(squares / (count - 2) / all.spread()) : 0;
    stages.rms = std::sqrt(squares / count);
    stages.knee_twist = stages.first == 0 ? 0 : sign * (curve.mean_x() - curve.mean_y() / stages.first);
    constexpr double rounding = 1e-12;  // of the largest torque: below that, points lie on one line
    if (points < 2 * least_points || stages.rms <= rounding * std::abs(largest))
        return stages;
    Bend const bend = best_bend(curve, points);
    if (!std::isfinite(bend.squares) || !is_bent(squares, bend.squares, points))
        return stages;
    // The bend's place and height go with the intercepts of two separate lines, so that errors are those of these: of
    // the slopes, and of T_k = (C2 L1 - C1 L2)/(C2 - C1) where L1 and L2 are the heights of the lines at the bend.
    double const variance = bend.squares / (count - 4);
    Sums const low = curve.low(bend.split), high = curve.high(bend.split);
    stages.first = bend.first;
    stages.second = bend.second;
    stages.first_error = std::sqrt(variance / low.spread());
    stages.second_error = std::sqrt(variance / high.spread());
    double const low_height = std::sqrt(variance * low.height_variance(bend.twist));
    double const high_height = std::sqrt(variance * high.height_variance(bend.twist));
    double const slopes = std::abs(bend.second - bend.first);
    stages.knee_error = std::hypot(bend.second * low_height, bend.first * high_height) / slopes;
    stages.knee_twist_error = std::hypot(low_height, high_height) / slopes;
    stages.knee = sign * (curve.mean_y() + bend.torque);
    stages.knee_twist = sign * (curve.mean_x() + bend.twist);
    // Where the lines fit best with the bend at its first or last place, the true one may lie beyond, and one stage
    // would have fewer points than a line needs.
    constexpr double unknown = std::numeric_limits<double>::infinity();
    bool const held_low = bend.split < least_points, held_high = curve.is_last_place(bend.twist);
    if (held_low || held_high) {
        (held_low ? stages.first_error : stages.second_error) = unknown;
        stages.knee_error = stages.knee_twist_error = unknown;
    }
    stages.rms = std::sqrt(bend.squares / count);
    stages.found = true;
    return stages;
}

}  // namespace hdconj
