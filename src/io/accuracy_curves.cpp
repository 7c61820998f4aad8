// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "hdconj/study/accuracy.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"

namespace hdconj::study_picture {
namespace {

constexpr double below_axis = 66;   // [px]
constexpr double legend_row = 26;   // [px]
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9", "#8c6d46"};

}  // namespace

std::vector<Curve> curves_of(std::vector<StudyLadder> const& ladders, std::string const& name)
{
    std::vector<Curve> curves;
    std::vector<std::string> methods;
    for (auto const& ladder : ladders) {
        if (ladder.study != name) {
            continue;
        }
        Curve curve{&ladder, {}, "", ladder.drive == worst_of_sample};
        for (auto const& rung : ladder.rungs) {
            if (rung.error > 0 && rung.median > 0) {
                curve.rungs.push_back(&rung);
            }
        }
        if (curve.rungs.empty()) {
            continue;
        }
        auto const known = std::find(methods.begin(), methods.end(), ladder.method + ladder.knob);
        std::size_t const number = static_cast<std::size_t>(known - methods.begin());
        if (known == methods.end()) {
            methods.push_back(ladder.method + ladder.knob);
        }
        curve.colour = colours[number % colours.size()];
        curves.push_back(std::move(curve));
    }
    return curves;
}

std::string look(Curve const& curve)
{
    // Widths differ as well: in SVG, gnuplot joins lines of one colour and width and forgets the second one's dashes.
    return fmt::format("linecolor rgb '{}' linewidth {} dashtype {}", curve.colour, curve.sample ? 1.4 : 2.2, curve.sample ? "(8,5)" : "solid");
}

double height_of(std::size_t curves)
{
    return top + panel_height + below_axis + legend_row * (static_cast<double>(curves) + 1);
}

std::string frame(StoredAccuracy const& study, std::string const& name, std::string const& hint, double height, PictureFormat format)
{
    std::string question;
    for (auto const& kind : study_kinds()) {
        if (kind.name == name) {
            question = kind.question;
        }
    }
    picture::Words const words{study.report.scene.drive.name + ": " + name, question + "; " + hint, "", ""};
    return picture::terminal(format, height) + picture::title(height, words) +
           picture::axes({.left = left_axis, .right = picture::width - picture::right_margin, .top = top, .bottom = top + panel_height}, height) +
           "set logscale xy\nset grid linecolor rgb '#e0e0e0' linewidth 0.6\n";
}

std::string legend(Curve const& curve, std::size_t i, std::string const& remark, double height)
{
    constexpr double sample = 46, gap = 12;
    double const y = top + panel_height + below_axis + legend_row * (static_cast<double>(i) + 1);
    std::string const text = ladder_name(*curve.ladder) + (curve.has_knob() ? " (" + curve.ladder->knob + ")" : "") + (remark.empty() ? "" : ": " + remark);
    return fmt::format("set arrow from {} to {} nohead {}\nset label {} at {} noenhanced\n", picture::screen(left_axis, y, height), picture::screen(left_axis + sample, y, height),
                       look(curve), gnuplot_quoted(text), picture::screen(left_axis + sample + gap, y, height));
}

}  // namespace hdconj::study_picture
