// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "load_scripts.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double top = 82;
constexpr double panel_height = 470;
constexpr double below_axis = 80;
constexpr double legend_row = 25;

// Colours that stay apart for colour-blind eyes.
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr char const* measured_colour = "#505050";

char const* colour_of(std::size_t number)
{
    return colours[number % colours.size()];
}

double arcmin(double angle)
{
    return angle * arcmin_per_radian;
}

double nm(double torque)
{
    return torque * nm_per_nmm;
}

void add_row(std::string& rows, double twist, double torque)
{
    fmt::format_to(std::back_inserter(rows), "{:.8g} {:.8g}\n", arcmin(twist), nm(torque));
}

/// The curve as it is run through. Without torque the drive may lie anywhere in its play: drawn from end to end where the torque changes its sign.
std::string rows_of(LoadCase const& each)
{
    std::string rows;
    double const half = each.backlash / 2;
    double last = 0;  // side of the play, 0: not known yet
    bool from_zero = false;
    for (auto const& state : each.curve) {
        double const side = state.torque > 0 ? 1 : state.torque < 0 ? -1 : 0;
        if (half <= 0 || (side != 0 && side == last)) {
            add_row(rows, state.twist, state.torque);
        } else if (side == 0) {
            from_zero = true;
            if (last != 0) {
                add_row(rows, last * half, 0);
            }
        } else {
            if (last != 0) {
                add_row(rows, last * half, 0);
            }
            if (last != 0 || from_zero) {
                add_row(rows, side * half, 0);
            }
            add_row(rows, state.twist, state.torque);
            last = side;
        }
    }
    return rows;
}

/// Both lines, each a little beyond the bend.
std::string stages_of(LoadCase const& each)
{
    auto const& stages = each.stages;
    double const largest = each.rated < each.curve.size() ? each.curve[each.rated].torque : 0;
    constexpr double beyond = 0.3;  // of the distance that the line covers
    std::string rows;
    auto const line = [&](double slope, double from, double to) {
        for (double const torque : {from, to}) {
            add_row(rows, stages.knee_twist + (torque - stages.knee) / slope, torque);
        }
        rows += "\n";
    };
    line(stages.first, 0, stages.knee + beyond * (largest - stages.knee));
    line(stages.second, stages.knee - beyond * stages.knee, largest);
    return rows;
}

/// A measured point as one of the circular spline, whose curves it is laid over.
double twist_on_spline(Measurement const& measured, std::size_t i)
{
    return (measured.curve.twist[i] - measured.found.middle) / measured.curve.rig.angle_per_spline;
}

double torque_on_spline(Measurement const& measured, std::size_t i)
{
    return measured.curve.torque[i] * measured.curve.rig.angle_per_spline;
}

/// Few enough for a picture that one can still open.
std::string rows_of(Measurement const& measured)
{
    constexpr std::size_t most = 4000;
    auto const& curve = measured.curve;
    std::size_t const step = curve.twist.size() / most + 1;
    std::string rows;
    for (std::size_t i = 0; i < curve.twist.size(); i += step) {
        add_row(rows, twist_on_spline(measured, i), torque_on_spline(measured, i));
    }
    return rows;
}

std::string words_of(LoadCase const& each)
{
    auto const& stages = each.stages;
    std::string text = fmt::format("{}:  backlash {:.3g}′", case_name(each), arcmin(each.backlash));
    if (stages.found) {
        text += fmt::format(",  {:.4g} and {:.4g} N m/°,  bend at {:.3g} N m", stages.first * nm_per_deg, stages.second * nm_per_deg, nm(stages.knee));
    } else if (stages.first != 0) {
        text += fmt::format(",  {:.4g} N m/°,  no bend", stages.first * nm_per_deg);
    }
    return text;
}

std::string words_of(Measurement const& measured)
{
    auto const& found = measured.found;
    std::string text = fmt::format("measured{}, {} cycle{}:  backlash {:.2f} ± {:.2f}′", measured.curve.rig.angle_per_spline != 1 ? " at the cup" : "", found.cycles, found.cycles == 1 ? "" : "s", arcmin(found.backlash.value), arcmin(found.backlash.error));
    if (found.first.count > 0) {
        text += fmt::format(",  {:.1f} ± {:.1f} and {:.1f} ± {:.1f} N m/°,  bend at {:.3g} N m", found.first.value * nm_per_deg, found.first.error * nm_per_deg,
                            found.second.value * nm_per_deg, found.second.error * nm_per_deg, nm(found.knee.value));
    }
    return text;
}

struct Range
{
    double low = 0, high = 0;
    void take(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// With some air, or around one value.
    void widen()
    {
        constexpr double air = 0.06;
        double const by = high > low ? air * (high - low) : 1;
        high += by;
        low -= low < 0 || high <= by ? by : 0;
    }
};

}  // namespace

bool has_curve(LoadStudy const& study)
{
    return std::any_of(study.cases.begin(), study.cases.end(), [](auto const& each) { return each.curve.size() > 1; });
}

std::string shown_load(LoadStudy const& study)
{
    auto const* shown = shown_case(study);
    return study.solution.scene.drive.name + (shown != nullptr ? fmt::format(":  {},  {:.4g} N m", case_name(*shown), nm(study.rated_torque)) : "");
}

std::string load_curve_script(LoadStudy const& study, Measurement const* measured, PictureFormat format)
{
    std::size_t const rows = study.cases.size() + (measured != nullptr ? 1 : 0);
    double const height = top + panel_height + below_axis + legend_row * (static_cast<double>(rows) + 0.6);
    Range twist, torque;
    for (auto const& each : study.cases) {
        for (auto const& state : each.curve) {
            twist.take(arcmin(state.twist));
            torque.take(nm(state.torque));
        }
    }
    for (std::size_t i = 0; measured != nullptr && i < measured->curve.twist.size(); ++i) {
        twist.take(arcmin(twist_on_spline(*measured, i)));
        torque.take(nm(torque_on_spline(*measured, i)));
    }
    twist.widen();
    torque.widen();
    picture::Words const words{study.solution.scene.drive.name, "torque on the circular spline against its twist, wave generator and cup held; dashed: the two stages by least squares", "", ""};
    std::string script = picture::terminal(format, height) + picture::title(height, words) + picture::axes({.top = top, .bottom = top + panel_height}, height);
    script += fmt::format(
        "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset xtics {:g}\nset ytics {:g}\nset xlabel 'twist [arcmin]' noenhanced\nset ylabel 'torque [N m]' noenhanced\n"
        "set xzeroaxis linecolor rgb '#c0c0c0' linewidth 0.8\nset yzeroaxis linecolor rgb '#c0c0c0' linewidth 0.8\n",
        twist.low, twist.high, torque.low, torque.high, picture::tic_step(twist.high - twist.low), picture::tic_step(torque.high - torque.low));
    std::string plot;
    auto const add = [&](std::string const& command) { plot += (plot.empty() ? "plot " : ", \\\n    ") + command; };
    constexpr double sample = 46, gap = 12;
    double y = top + panel_height + below_axis + legend_row * 0.6;
    auto const legend = [&](std::string const& text, std::string const& mark) {
        script += mark + fmt::format("set label {} at {} noenhanced\n", gnuplot_quoted(text), picture::screen(picture::left_margin + sample + gap, y, height));
        y += legend_row;
    };
    if (measured != nullptr) {
        script += "$measured << END\n" + rows_of(*measured) + "END\n";
        auto const look = [](double size) { return fmt::format("pointtype 7 pointsize {} linecolor rgb '{}'", size, measured_colour); };
        add("$measured using 1:2 with points " + look(0.2) + " notitle");
        legend(words_of(*measured), fmt::format("set label '' at {} point {}\n", picture::screen(picture::left_margin + sample / 2, y, height), look(0.5)));
    }
    for (std::size_t i = 0; i < study.cases.size(); ++i) {
        auto const& each = study.cases[i];
        std::string const look = fmt::format("linecolor rgb '{}' linewidth {}", colour_of(i), i == study.shown ? 2.4 : 1.6);
        if (!each.curve.empty()) {
            script += fmt::format("$curve{} << END\n{}END\n", i, rows_of(each));
            add(fmt::format("$curve{} using 1:2 with linespoints {} pointtype 7 pointsize 0.35 notitle", i, look));
        }
        if (each.stages.found) {
            script += fmt::format("$stages{} << END\n{}END\n", i, stages_of(each));
            add(fmt::format("$stages{} using 1:2 with lines linecolor rgb '{}' linewidth 1.1 dashtype (7,5) notitle", i, colour_of(i)));
        }
        legend(words_of(each), fmt::format("set arrow from {} to {} nohead {}\n", picture::screen(picture::left_margin, y, height), picture::screen(picture::left_margin + sample, y, height), look));
    }
    if (auto const* shown = shown_case(study); shown != nullptr && shown->backlash > 0 && shown->curve.size() > 1) {
        double const half = arcmin(shown->backlash) / 2, down = -0.05 * (torque.high - torque.low);
        script += fmt::format("set arrow from first {:.6g},{:.6g} to first {:.6g},{:.6g} heads filled size screen 0.008,20 linewidth 1 linecolor rgb '#303030' front\n"
                              "set label 'backlash {:.3g}′' at first 0,{:.6g} center noenhanced front\n",
                              -half, down, half, down, 2 * half, 2 * down);
    }
    return script + plot + "\n";
}

}  // namespace hdconj
