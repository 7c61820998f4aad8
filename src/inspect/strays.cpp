// SPDX-License-Identifier: GPL-3.0-or-later
#include "strays.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "flank_fit.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::inspect {
namespace {

/// Further off than so many standard deviations is no noise: once in 2e6 points.
constexpr double no_noise = 5;
/// A jump against the neighbours, where other flanks have told already that the point is odd: once in 2000 points.
constexpr double odd_jump = 3.5;
constexpr double median_of_normal = 0.6745;  // of the size of a normal variable, in standard deviations
/// Below this no point is called a stray [mm]: finer than any probe repeats.
constexpr double least_stray = 2e-3;

/// What the values differ by from the line through both neighbours, in standard deviations of noise of deviation 1.
void add_jumps(std::vector<double> const& xi, std::vector<double> const& value, std::vector<double>& jumps)
{
    for (std::size_t i = 1; i + 1 < xi.size(); ++i) {
        double const wide = xi[i + 1] - xi[i - 1];
        double const after = wide > 0 ? (xi[i] - xi[i - 1]) / wide : 0.5, before = 1 - after;
        jumps.push_back(std::abs(value[i] - before * value[i - 1] - after * value[i + 1]) /
                        std::sqrt(1 + before * before + after * after));
    }
}

/// Standard deviation of noise that makes @p jumps, as the median tells that is left without so many @p strays;
/// 0 of no jumps.
double deviation_of(std::vector<double> jumps, std::size_t strays)
{
    if (jumps.empty())
        return 0;
    std::size_t const of_strays = 3 * strays;
    auto const middle =
        jumps.begin() + static_cast<std::ptrdiff_t>(jumps.size() > of_strays ? (jumps.size() - of_strays) / 2 : 0);
    std::ranges::nth_element(jumps, middle);
    return *middle / median_of_normal;
}

/// One flank under test: its points that are left, and what they are measured by.
struct Tested
{
    std::vector<double> xi, value;   ///< value without the common form
    std::vector<double> spread;      ///< standard deviation of what flanks do at the place of each point
    std::vector<double> bend;        ///< that the common form may have there beyond what is known of it
    std::vector<std::size_t> index;  ///< in the run
    double noise = 0;                ///< standard deviation
    bool alone = false;              ///< whether no other flanks tell what is odd

    void erase(std::size_t i)
    {
        auto const at = static_cast<std::ptrdiff_t>(i);
        xi.erase(xi.begin() + at);
        value.erase(value.begin() + at);
        spread.erase(spread.begin() + at);
        bend.erase(bend.begin() + at);
        index.erase(index.begin() + at);
    }
};

/// One point or two that may be strays together.
struct Suspects
{
    std::vector<std::size_t> points;
    double score;
};

/// By how much noise aside the flank may jump at @p x if it goes on to bend as at the three points next to it.
double bend_beside(Tested const& flank, std::array<std::size_t, 3> const& next, double x)
{
    constexpr double as_much = 4, certain = 2;
    double const x0 = flank.xi[next[0]], x1 = flank.xi[next[1]], x2 = flank.xi[next[2]];
    std::array<double, 3> const weight{1 / ((x0 - x1) * (x0 - x2)), 1 / ((x1 - x0) * (x1 - x2)),
                                       1 / ((x2 - x0) * (x2 - x1))};
    double bend = 0, squares = 0;
    for (std::size_t k = 0; k < weight.size(); ++k) {
        bend += weight[k] * flank.value[next[k]];
        squares += weight[k] * weight[k];
    }
    double const sure = std::abs(bend) - certain * flank.noise * std::sqrt(squares);
    return sure > 0 ? as_much * sure * std::abs((x - x0) * (x - x1)) : 0;
}

/// What a parabola through some points tells of the value at another: how far that is off, and the standard deviation
/// of this for noise of deviation 1.
struct Jump
{
    double off, deviation;
};
Jump jump_of(Tested const& flank, std::size_t i, std::vector<std::size_t> const& others)
{
    Eigen::MatrixX3d basis(static_cast<Eigen::Index>(others.size()), 3);
    Eigen::VectorXd value(basis.rows());
    for (Eigen::Index k = 0; k < basis.rows(); ++k) {
        std::size_t const at = others[static_cast<std::size_t>(k)];
        double const x = flank.xi[at] - flank.xi[i];
        basis.row(k) << 1, x, x * x;
        value[k] = flank.value[at];
    }
    return {flank.value[i] - numeric::LeastSquares(basis).solve(value)[0],
            std::sqrt(1 + numeric::covariance(basis)(0, 0))};
}

/// Whether the point @p next to an end departs, as far as noise tells, to the side of @p off: the end then goes on.
/// @param beyond  the points on from there
bool leads_to_end(Tested const& flank, std::size_t next, std::vector<std::size_t> const& beyond, double off)
{
    constexpr double likely = 1;  // standard deviations
    Jump const jump = jump_of(flank, next, beyond);
    return jump.off * off > 0 && std::abs(jump.off) > likely * flank.noise * jump.deviation;
}

/// Whether point @p i jumps against those beside it that are no suspects.
bool jumps_from_neighbours(Tested const& flank, std::size_t i, std::vector<std::size_t> const& suspects)
{
    constexpr std::size_t half = 3, all = 2 * half;
    auto const suspect = [&](std::size_t k) { return std::ranges::find(suspects, k) != suspects.end(); };
    std::vector<std::size_t> before, after;  // nearest first
    for (std::size_t k = i; k-- > 0 && before.size() <= all;)
        if (!suspect(k))
            before.push_back(k);
    for (std::size_t k = i + 1; k < flank.xi.size() && after.size() <= all; ++k)
        if (!suspect(k))
            after.push_back(k);
    bool const end = before.empty() || after.empty();
    auto const above = [&](std::size_t k) { return flank.value[i] > flank.value[k]; };
    if (!end && above(before[0]) != above(after[0]))
        return false;
    double bend = std::numeric_limits<double>::infinity();  // of the straighter side: in the other one strays may stand
    for (auto const* side : {&before, &after})
        if (side->size() >= half)
            bend = std::min(bend, bend_beside(flank, {(*side)[0], (*side)[1], (*side)[2]}, flank.xi[i]));
    bend = std::isfinite(bend) ? bend : 0;
    std::size_t const from_after = std::min(after.size(), all - std::min(before.size(), half)),
                      from_before = std::min(before.size(), all - from_after);
    std::vector<std::size_t> beside(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(from_before));
    beside.insert(beside.end(), after.begin(), after.begin() + static_cast<std::ptrdiff_t>(from_after));
    Jump const jump = jump_of(flank, i, beside);
    if (end && flank.alone) {
        std::vector<std::size_t> const& inward = before.empty() ? after : before;
        if (suspects.size() > 1 || inward.size() <= half ||
            leads_to_end(flank, inward[0], {inward.begin() + 1, inward.end()}, jump.off))
            return false;
    }
    double const limit = (flank.alone ? no_noise : odd_jump) * flank.noise * jump.deviation;
    return std::isfinite(limit) && std::abs(jump.off) > std::max(least_stray, limit + bend);
}

/// Whether each of @p suspects is odd against the parabola through the other points.
bool all_odd(Tested const& flank, RunParabola const& parabola, std::vector<std::size_t> const& suspects)
{
    auto const n = static_cast<Eigen::Index>(suspects.size());
    Eigen::Matrix2d shares = Eigen::Matrix2d::Identity();
    Eigen::Vector2d left = Eigen::Vector2d::Zero();
    for (Eigen::Index a = 0; a < n; ++a) {
        std::size_t const i = suspects[static_cast<std::size_t>(a)];
        left[a] = parabola.remainder(i);
        for (Eigen::Index b = 0; b < n; ++b)
            shares(a, b) = parabola.share(i, suspects[static_cast<std::size_t>(b)]);
    }
    Eigen::Matrix2d inverse;
    bool regular = false;
    shares.computeInverseWithCheck(inverse, regular, RunParabola::least_share);
    if (!regular)
        return false;
    Eigen::Vector2d const off = inverse * left;
    for (Eigen::Index a = 0; a < n; ++a) {
        std::size_t const i = suspects[static_cast<std::size_t>(a)];
        double const limit = no_noise * std::max(flank.noise, flank.spread[i]) * std::sqrt(inverse(a, a));
        if (std::abs(off[a]) <= std::max(least_stray, limit + flank.bend[i]) ||
            !jumps_from_neighbours(flank, i, suspects))
            return false;
    }
    return true;
}

/// Points and pairs that the parabola misses most, the worst first: by what the sum of squares falls without them.
std::vector<Suspects> suspects_of(Tested const& flank, RunParabola const& parabola)
{
    constexpr std::size_t reach = 8;  // strays further apart hide each other only among few points
    std::size_t const n = flank.xi.size();
    double const limit = std::pow(std::max(no_noise * flank.noise, least_stray), 2);
    std::vector<Suspects> found;
    for (std::size_t i = 0; i < n; ++i)
        if (double const off = parabola.off(i); off * off > limit)
            found.push_back({{i}, off * off});
    if (n > fewest_points + 1)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 1; j < std::min(n, i + reach); ++j) {
                double const a = parabola.share(i, i), b = parabola.share(i, j), c = parabola.share(j, j);
                double const r = parabola.remainder(i), s = parabola.remainder(j), det = a * c - b * b;
                double const fall = det > RunParabola::least_share ? (c * r * r - 2 * b * r * s + a * s * s) / det : 0;
                if (fall > 2 * limit)
                    found.push_back({{i, j}, fall - limit});
            }
    std::ranges::stable_sort(found, std::ranges::greater{}, &Suspects::score);
    return found;
}

/// Indices of the strays of one flank.
std::vector<std::size_t> strays_of_flank(Tested flank)
{
    std::vector<std::size_t> strays;
    for (bool found = true; found && flank.xi.size() > fewest_points;) {
        RunParabola const parabola(flank.xi, flank.value);
        std::vector<Suspects> const suspects = suspects_of(flank, parabola);
        auto const first =
            std::ranges::find_if(suspects, [&](Suspects const& each) { return all_odd(flank, parabola, each.points); });
        found = first != suspects.end();
        if (found)
            for (std::size_t k = first->points.size(); k-- > 0;) {
                strays.push_back(flank.index[first->points[k]]);
                flank.erase(first->points[k]);
            }
    }
    return strays;
}

}  // namespace

std::vector<std::vector<std::size_t>> strays_of(std::vector<FlankRun> const& side)
{
    CommonForm const form(side);
    std::vector<Tested> flanks;
    std::vector<double> jumps;
    for (FlankRun const& run : side) {
        Tested flank;
        flank.xi = run.xi;
        flank.value = form.without(run);
        std::vector<double> own;
        add_jumps(flank.xi, flank.value, own);
        flank.noise = deviation_of(own, 2);
        jumps.insert(jumps.end(), own.begin(), own.end());
        for (std::size_t i = 0; i < run.xi.size(); ++i) {
            flank.spread.push_back(form.spread(run.xi[i]) / median_of_normal);
            flank.bend.push_back(form.bend(run.xi[i]));
            flank.index.push_back(i);
        }
        flanks.push_back(std::move(flank));
    }
    // few points scatter more (Rousseeuw and Leroy 1987, 5.3), and the form that few flanks share has noise too
    double const few = 1 + 5 / std::max(1.0, static_cast<double>(jumps.size()) - 3);
    double const of_form = form.known() ? std::sqrt(1 + 3 / static_cast<double>(side.size())) : 1;
    double const noise = few * of_form * deviation_of(std::move(jumps), 1);
    std::vector<std::vector<std::size_t>> strays;
    for (Tested& flank : flanks) {
        flank.noise = std::max(flank.noise, noise);
        flank.alone = !form.known();
        strays.push_back(strays_of_flank(std::move(flank)));
    }
    return strays;
}

}  // namespace hdconj::inspect
