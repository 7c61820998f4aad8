// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/table_cam.hpp"
#include "hdconj/units.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_spline.h>
#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>
#include <optional>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/number_pairs.hpp"

namespace hdconj::wavegen {
namespace {

struct FreeSpline
{
    void operator()(gsl_spline* s) const { gsl_spline_free(s); }
};

constexpr std::size_t fewest = 4;

/// Whether an angle is the seam of the wave but for what typing it in some unit does to it.
bool is_seam(double off)
{
    constexpr double rounding = 0x1p-40;  // rad
    return std::abs(off) <= rounding;
}

/// Knots in (-pi/n, pi/n], in order, and the first one a period later, with the values there.
struct WaveRows
{
    std::vector<double> x, y;
};

WaveRows sorted_rows(std::vector<double> const& angles, std::vector<double> const& values, double period)
{
    std::vector<std::pair<double, double>> rows;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        double u = angles[i] - period * std::round(angles[i] / period);
        if (u <= -period / 2 || is_seam(u + period / 2))
            u += period;
        // an angle that conversion between units has moved: no stretch of its own, which no contact could be followed
        // through
        if (is_seam(u - period / 2))
            u = period / 2;
        rows.emplace_back(u, values[i]);
    }
    std::sort(rows.begin(), rows.end());
    WaveRows result;
    for (auto const& [u, w] : rows) {
        result.x.push_back(u);
        result.y.push_back(w);
    }
    result.x.push_back(result.x.front() + period);
    result.y.push_back(result.y.front());
    return result;
}

}  // namespace

double TableCam::Cubic::largest(double h) const
{
    auto const value = [&](double d) { return c0 + d * (c1 + d * (c2 + d * c3)); };
    double found = value(0);
    auto const [first, second] = boost::math::tools::quadratic_roots(3 * c3, 2 * c2, c1);  // not numbers where none
    for (double const d : {first, second})
        if (d > 0 && d < h)
            found = std::max(found, value(d));
    return found;
}

TableCam::TableCam(std::vector<double> const& angles, std::vector<double> const& values, int n) : n_(n)
{
    gsl_set_error_handler_off();
    double const period = 2 * std::numbers::pi / n;
    auto const [x, y] = sorted_rows(angles, values, period);
    std::unique_ptr<gsl_spline, FreeSpline> const fit(gsl_spline_alloc(gsl_interp_cspline_periodic, x.size()));
    if (!fit)
        throw std::bad_alloc();
    if (int const status = gsl_spline_init(fit.get(), x.data(), y.data(), x.size()); status != GSL_SUCCESS)
        throw NumericalError(ErrorCode::no_solution, "wave generator", "periodic spline through the table",
                             gsl_strerror(status));

    auto spline = std::make_shared<Spline>();
    double integral = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        // a cubic from values and second derivatives at its ends
        double const h = x[i + 1] - x[i];
        double const s0 = gsl_spline_eval_deriv2(fit.get(), x[i], nullptr);
        double const s1 = gsl_spline_eval_deriv2(fit.get(), x[i + 1], nullptr);
        Cubic const c{y[i], (y[i + 1] - y[i]) / h - h * (2 * s0 + s1) / 6, s0 / 2, (s1 - s0) / (6 * h)};
        if (!std::isfinite(c.c1) || !std::isfinite(c.c2) || !std::isfinite(c.c3))
            throw NumericalError(ErrorCode::no_solution, "wave generator", "periodic spline through the table",
                                 "two rows at " + std::to_string(to_deg(x[i])) + " deg are too close");
        integral += h * (c.c0 + h * (c.c1 / 2 + h * (c.c2 / 3 + h * c.c3 / 4)));
        spline->knots.push_back(x[i]);
        spline->cubics.push_back(c);
    }
    double const mean = integral / period;
    for (Cubic& c : spline->cubics)
        c.c0 -= mean;
    spline_ = spline;

    double odd = 0;
    for (std::size_t i = 0; i < spline->knots.size(); ++i) {
        double const h = x[i + 1] - x[i];
        largest_ = std::max(largest_, spline->cubics[i].largest(h));
        odd = std::max({odd, std::abs((*this)(x[i]).w - (*this)(-x[i]).w),
                        std::abs((*this)(x[i] + h / 2).w - (*this)(-x[i] - h / 2).w)});
    }
    even_ = odd <= 16 * unit_roundoff * (largest_ + std::abs(mean));
}

RadialDisplacement TableCam::operator()(double u) const
{
    Spline const& s = *spline_;
    double const period = 2 * std::numbers::pi / n_;
    double v = u < -period / 2 || u > period / 2 ? u - period * std::round(u / period) : u;
    auto const after = std::upper_bound(s.knots.begin(), s.knots.end(), v);
    std::size_t i = static_cast<std::size_t>(after - s.knots.begin());
    if (i == 0) {
        i = s.knots.size();
        v += period;
    }
    --i;
    Cubic const& c = s.cubics[i];
    double const d = v - s.knots[i];
    return {c.c0 + d * (c.c1 + d * (c.c2 + d * c.c3)), c.c1 + d * (2 * c.c2 + d * 3 * c.c3), 2 * c.c2 + d * 6 * c.c3,
            6 * c.c3};
}

namespace {

struct Gap
{
    double from, length;  // [rad]
};

/// The longest gap between rows, or from the last to the first of the next wave, where it is more than a quarter of the
/// wave and several of the usual gaps: a part of the wave was left out.
std::optional<Gap> long_gap(std::vector<double> const& angles, double wave)
{
    constexpr double part = 0.25, several = 3;
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i < angles.size(); ++i)
        gaps.push_back({angles[i], (i + 1 < angles.size() ? angles[i + 1] : angles.front() + wave) - angles[i]});
    std::ranges::sort(gaps, {}, &Gap::length);
    double const usual = gaps[gaps.size() / 2].length;
    Gap const longest = gaps.back();
    return longest.length > std::max(part * wave, several * usual) ? std::optional(longest) : std::nullopt;
}

/// What to do about a table that spans @p length degrees in steps of @p step, more than one wave of @p wave degrees.
std::string shorter_table(double length, double step, double wave)
{
    constexpr double turn = 360, part = 0x1p-4;
    if (length > turn + step)
        return "name the unit of the angles in the heading, such as angle [deg], and give one wave";
    for (double const period : {length, length + step})  // with a closing row, and without
        if (double const waves = std::round(turn / period); std::abs(turn / waves - period) < part * step)
            return fmt::format("give one wave, or set waves = {:g}, of which the table holds one wave", waves);
    return fmt::format("give one wave of {:g} degrees, or a full turn and waves = 1", wave);
}

/// One wave of a table.
struct WaveTable
{
    std::vector<double> angles, values;  // [rad], [mm]
};

/// The rows of @p table without the closing one, or a fault where they are not those of one wave of @p wave degrees.
WaveTable one_wave(scene::NumberPairs const& table, double wave, scene::ParameterFaults const& refuse)
{
    auto const refused = [&](std::string reason, std::string remedy) {
        refuse("file", std::move(reason), std::move(remedy));
        return WaveTable{};
    };
    double const length = table.rows.empty() ? 0 : table.rows.back().value[0] - table.rows.front().value[0];
    WaveTable own;
    auto& [angles, values] = own;
    for (scene::NumberPair const& row : table.rows) {
        auto const [angle, value] = row.value;
        std::string const where = "line " + std::to_string(row.line) + " of " + table.file;
        double const radians = from_deg(angle);
        if (!angles.empty() && !(radians > angles.back()))
            return refused(where + ": the angle does not increase",
                           "sort the rows by angle and remove repeated angles");
        // angles are typed with as many digits as tell rows apart: the closing row may be off by a part of a step
        constexpr double part = 0x1p-6, typed = 0x1p-30;
        double const span = angles.empty() ? 0 : angle - to_deg(angles.front());
        double const step = angles.empty() ? 0 : angle - to_deg(angles.back());
        bool const closes = span > 0 && std::abs(span - wave) <= part * step;
        if ((span > wave && !closes) || (closes && length > wave + part * step))
            return refused(fmt::format("{}: the table is longer than one wave of {:g} degrees", where, wave),
                           shorter_table(length, step, wave));
        if (closes) {
            double const size = std::max(std::abs(value), std::abs(values.front()));
            if (std::abs(value - values.front()) > typed * size + part * std::abs(value - values.back()))
                return refused(where + ": the closing row differs from the first one",
                               "repeat the first value, or leave the closing row out");
            continue;
        }
        angles.push_back(radians);
        values.push_back(value);
    }
    return own;
}

}  // namespace

TableCam TableCam::build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    scene::ParameterFaults const refuse(choice, faults);
    scene::NumberPairs const table = scene::read_number_pairs(
        choice, "file", place.folder, {scene::ColumnQuantity::angle, scene::ColumnQuantity::length},
        "angle in degrees, radial displacement in mm", faults);
    if (refuse.any())
        return {};
    auto const refused = [&](std::string reason, std::string remedy) {
        refuse("file", std::move(reason), std::move(remedy));
        return TableCam{};
    };
    double const wave = 360.0 / place.waves;
    WaveTable const given = one_wave(table, wave, refuse);
    if (refuse.any())
        return {};
    auto const& [angles, values] = given;
    if (angles.size() < fewest)
        return refused(
            table.file + " holds " + std::to_string(angles.size()) + " rows of one wave, a periodic spline needs 4",
            "write at least 4 rows");
    if (auto const gap = long_gap(angles, from_deg(wave)))
        return refused(fmt::format("no row lies in the {:.4g} degrees after {:.6g}, of a wave of {:g} degrees",
                                   to_deg(gap->length), to_deg(gap->from), wave),
                       std::string(to_deg(angles.back() - angles.front()) < 2 * std::numbers::pi
                                       ? "write the heading angle [rad],w [mm] if the angles are in radians; else "
                                       : "") +
                           "write rows over the whole wave, of a symmetric cam its other half too");
    auto const [low, high] = std::minmax_element(values.begin(), values.end());
    if (!(*high > *low))
        return refused("all values are equal: the ring would stay round",
                       "write the radial displacement over one wave");
    try {
        TableCam cam(angles, values, place.waves);
        // the solver counts angles from the major axis
        if (!(cam(0).w > 0))
            return refused("the displacement at angle 0 is below its mean: angle 0 is not at the major axis",
                           "count the angle from the major axis");
        return cam;
    } catch (NumericalError const& error) {
        return refused(error.what(), "remove rows that are closer than the cam was measured");
    }
}

}  // namespace hdconj::wavegen
