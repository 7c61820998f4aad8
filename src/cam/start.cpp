// SPDX-License-Identifier: GPL-3.0-or-later
#include "start.hpp"

#include <fmt/format.h>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <numbers>
#include <optional>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "hdconj/units.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::cam {
namespace {

constexpr double probe_share = 0x1p-20;    ///< of the displacement: difference quotients of the shooting
constexpr double settled_share = 0x1p-30;  ///< of the displacement: below it only rounding is left to gain
constexpr double touching_turn = 0x1p-30;  ///< rad; flanks that miss each other by less touch on the axis
constexpr int fit_nodes = 40;              ///< of the fit beyond the beginning
constexpr double scan_step = 0.1 * deg;

/// What continues the curve to the axis.
struct AxisFit
{
    int powers = 7;       ///< of the even polynomial: up to x^12
    bool broken = false;  ///< with |x|^3 too
};

/// What a march from a trial state tells of the axis.
struct Trial
{
    MarchedCurve curve;
    EvenPolynomial fit;
    Eigen::Vector2d miss;
};

class Shooting
{
  public:
    Shooting(FlankPair const& pair, CurveRule const& rule, double x1, double major, double reach, double tolerance)
        : pair_(pair), rule_(rule), x1_(x1), major_(major), tolerance_(tolerance)
    {
        double const span = std::min(std::max(2 * x1, 4 * deg), reach);
        for (int i = fit_nodes; i-- > 0;)
            angles_.push_back(x1 + span * (1 + std::cos(std::numbers::pi * (2 * i + 1) / (2.0 * fit_nodes))) / 2);
    }

    /// @param guess  state at x1, and the inclination about which a tangency is looked for
    [[nodiscard]] std::optional<MeshBegin> operator()(MeshPoint const& guess) const
    {
        MeshPoint begin = guess;
        begin.x = x1_;
        std::optional<Trial> now = trial(begin);
        if (!now)
            return std::nullopt;
        double const probe = probe_share * std::abs(major_);
        Eigen::Matrix2d slope;
        std::array<EvenPolynomial, 2> response;
        for (std::size_t i = 0; i < 2; ++i) {
            MeshPoint beside = begin;
            beside.state[i] += probe;
            std::optional<Trial> const other = trial(beside);
            if (!other)
                return std::nullopt;
            slope.col(static_cast<Eigen::Index>(i)) = (other->miss - now->miss) / probe;
            response[i].scale = now->fit.scale;
            response[i].add(1 / probe, other->fit);
            response[i].add(-1 / probe, now->fit);
        }
        constexpr int budget = 12;
        double last = now->miss.norm();
        for (int i = 0; i < budget; ++i) {
            Eigen::Vector2d const correction = slope.fullPivLu().solve(now->miss);
            MeshPoint next = begin;
            next.state[0] -= correction[0];
            next.state[1] -= correction[1];
            std::optional<Trial> better = trial(next);
            if (!better)
                return std::nullopt;
            double const miss = better->miss.norm();
            bool const rounding = last < settled_share * std::abs(major_);
            if (rounding && !(miss < last / 2))
                break;
            begin = next;
            now = std::move(better);
            last = miss;
        }
        if (!(last < settled_share * std::abs(major_)) || now->curve.points.empty())
            return std::nullopt;
        begin.contact = first_contact(begin);
        begin.slope = rule_.slope(rule_.origin(x1_, begin.state), begin.contact.theta);
        MeshBegin result{begin, x1_, 0, now->fit};
        add_shift(result, now->curve, slope, response);
        auto const [first, error] = first_touch(result);
        result.first = first;
        result.first_error = error + std::abs(first_touch(result.shifted(1)).first - first);
        return result;
    }

  private:
    /// Tangential state where the polynomial takes the curve from the axis to @p x.
    [[nodiscard]] double tangential_state(EvenPolynomial const& curve, double x) const
    {
        auto const rate = [&](double at) {
            EvenPolynomial::Value const here = curve(at);
            return rule_.tangential_rate(here.value, here.slope);
        };
        return boost::math::quadrature::gauss<double, 20>::integrate(rate, 0.0, x);
    }

    /// What other fits of the solution @p curve beyond x1 change, together and with a factor of safety. Of splines of
    /// rows 1 to 15 degrees apart the fit then errs by less.
    /// @param slope     of the miss with the states
    /// @param response  of the fit to the states
    void add_shift(MeshBegin& begin, MarchedCurve const& curve, Eigen::Matrix2d const& slope,
                   std::array<EvenPolynomial, 2> const& response) const
    {
        constexpr double safety = 2;
        begin.to_axis_shift.scale = begin.to_axis.scale;
        for (AxisFit const other : {AxisFit{7, true}, AxisFit{6, false}}) {
            Trial fitted = trial_of(curve, begin.point, other);
            Eigen::Vector2d const change = -slope.fullPivLu().solve(fitted.miss);
            bool const against = change[0] * begin.shift[0] + change[1] * begin.shift[1] < 0;
            double const factor = against ? -safety : safety;
            fitted.fit.add(-1, begin.to_axis);
            for (std::size_t i = 0; i < 2; ++i) {
                double const moved = change[static_cast<Eigen::Index>(i)];
                begin.shift[i] += factor * moved;
                fitted.fit.add(moved, response[i]);
            }
            begin.to_axis_shift.add(factor, fitted.fit);
        }
    }

    /// Bisects for the angle at which the flanks begin to touch. The curve of the search may have had them begin later.
    /// @returns it and its error
    [[nodiscard]] std::pair<double, double> first_touch(MeshBegin const& begin) const
    {
        auto const touches = [&](double x) {
            EvenPolynomial::Value const at = begin.to_axis(x);
            ToothOrigin const origin = rule_.origin(x, {at.value, tangential_state(begin.to_axis, x)});
            return !pair_.tangencies(origin, rule_.theta(origin, at.slope)).empty();
        };
        double low = std::max(x1_ - scan_step, 0.0), high = x1_;
        while (low > 0 && touches(low)) {
            high = low;
            low = std::max(low - scan_step, 0.0);
        }
        constexpr int halvings = 24;
        for (int i = 0; i < halvings; ++i) {
            double const middle = (low + high) / 2;
            (touches(middle) ? high : low) = middle;
        }
        return {high, high - low};
    }

    [[nodiscard]] Tangency first_contact(MeshPoint const& point) const
    {
        MarchedCurve const here = march(pair_, rule_, point, {}, tolerance_);
        return here.last.contact;
    }

    [[nodiscard]] std::optional<Trial> trial(MeshPoint const& begin) const
    {
        MarchedCurve curve = march(pair_, rule_, begin, angles_, tolerance_);
        if (curve.lost || curve.points.size() != angles_.size())
            return std::nullopt;
        Trial result = trial_of(curve, begin, {});
        result.curve = std::move(curve);
        return result;
    }

    /// Of @p curve, which stays where it is.
    [[nodiscard]] Trial trial_of(MarchedCurve const& curve, MeshPoint const& begin, AxisFit const& kind) const
    {
        Trial result;
        Eigen::MatrixXd matrix(fit_nodes, kind.powers + (kind.broken ? 1 : 0));
        Eigen::VectorXd right(fit_nodes);
        result.fit.scale = angles_.back();
        for (int i = 0; i < fit_nodes; ++i) {
            MeshPoint const& at = curve.points[static_cast<std::size_t>(i)];
            double const s = at.x / result.fit.scale;
            for (int j = 0; j < kind.powers; ++j)
                matrix(i, j) = j == 0 ? 1 : matrix(i, j - 1) * s * s;
            if (kind.broken)
                matrix(i, kind.powers) = s * s * s;
            right[i] = at.state[0] - major_;
        }
        Eigen::VectorXd const fit = numeric::LeastSquares(matrix).solve(right);
        result.fit.coefficients.assign(fit.data(), fit.data() + kind.powers);
        result.fit.coefficients.front() += major_;
        result.fit.cubic = kind.broken ? fit[kind.powers] : 0;
        double const state = tangential_state(result.fit, x1_);
        result.miss = {fit[0], state - begin.state[1]};
        return result;
    }

    FlankPair const& pair_;
    CurveRule rule_;
    double x1_, major_, tolerance_;
    std::vector<double> angles_;
};

/// A cosine through the displacement on the axis, for a first look.
MeshPoint cosine_point(CurveRule const& rule, int waves, double major, double x)
{
    double const n = waves;
    double const along = major * std::sin(n * x) / n;
    MeshPoint point{x, {major * std::cos(n * x), rule.exact ? along : -along}, -n * major * std::sin(n * x), {}};
    point.contact.theta = rule.theta(rule.origin(x, point.state), point.slope);
    return point;
}

}  // namespace

MeshBegin MeshBegin::shifted(double share) const
{
    MeshBegin moved = *this;
    for (std::size_t i = 0; i < shift.size(); ++i)
        moved.point.state[i] += share * shift[i];
    moved.to_axis.add(share, to_axis_shift);
    return moved;
}

MeshBegin mesh_begin(FlankPair const& pair, CurveRule const& rule, int waves, double major, double reach,
                     double tolerance)
{
    MeshPoint const axis{0, {major, 0}, 0, {}};
    std::vector<Tangency> const on_axis = pair.tangencies(rule.origin(0, axis.state), 0);
    double const same = touching_turn;
    if (!on_axis.empty() && on_axis.front().theta < -same)
        throw NumericalError(
            ErrorCode::interference, "neutral curve", "major axis",
            fmt::format("with a displacement of {:.6g} mm there, the flanks overlap by about {:.3g} mm", major,
                        -on_axis.front().theta * on_axis.front().lever),
            "write a smaller wave_generator.major_displacement, or leave it out");
    if (!on_axis.empty() && on_axis.front().theta < same) {
        MeshPoint begin = axis;
        begin.contact = on_axis.front();
        begin.slope = rule.slope(rule.origin(0, axis.state), begin.contact.theta);
        return {begin, 0, 0, {}};
    }
    bool bent = false;
    for (double x = scan_step; x < reach; x += scan_step) {
        MeshPoint const guess = cosine_point(rule, waves, major, x);
        if (pair.tangencies(rule.origin(x, guess.state), guess.contact.theta).empty())
            continue;
        auto const begin = Shooting(pair, rule, x, major, reach, tolerance)(guess);
        if (begin && BendingLimit(rule, waves, major).keeps(begin->to_axis))
            return *begin;
        bent = bent || begin;
    }
    throw NumericalError(
        ErrorCode::no_contact, "neutral curve", fmt::format("0 to {:.3g} deg from the major axis", to_deg(reach)),
        bent ? fmt::format(
                   "with a displacement of {:.6g} mm on the major axis, each curve that is symmetric about it and "
                   "lets the flanks touch would be hollow there, or bent more than {:g} times as a cosine of "
                   "that displacement",
                   major, most_bending)
             : fmt::format("with a displacement of {:.6g} mm on the major axis, no curve is symmetric about it and "
                           "lets the flanks touch: they stop touching before the mesh begins",
                           major),
        "write another wave_generator.major_displacement, or teeth that reach deeper into each other");
}

double deepest_displacement(FlankPair const& pair, CurveRule const& rule, double deepest)
{
    auto const turn = [&](double w) {
        std::vector<Tangency> const found = pair.tangencies({rule.r_m, w, 0}, 0);
        return found.empty() ? 1.0 : found.front().theta;
    };
    double const at_deepest = turn(deepest);
    if (at_deepest >= 0)
        return deepest;
    // withdraw until the flanks are apart
    double low = deepest;
    double const back = pair.inner().length() / 64;
    while (turn(low) < 0 && low > deepest - 2 * pair.inner().length())
        low -= back;
    if (turn(low) >= 1)
        return deepest;
    numeric::BracketedRoot const root = numeric::bracketed_root(turn, low, low + back);
    return root.found ? root.x : deepest;
}

}  // namespace hdconj::cam
