// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "hdconj/study/accuracy.hpp"
#include "picture_lines.hpp"

namespace hdconj::study_picture {
namespace {

// Layout [px].
constexpr double top = 82, panel_height = 430, left_axis = 112, between = 34, below_title = 30;
constexpr double below_axis = 66, legend_row = 26;
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
    return fmt::format("linecolor rgb '{}' linewidth 2.2", curve.colour);
}

std::vector<Part> parts_of(std::vector<Curve> const& curves, std::string const& drive)
{
    std::vector<Part> parts;
    for (bool const sample : {false, true}) {
        Part part{sample ? worst_of_sample : drive, {}, {.left = left_axis, .right = picture::width - picture::right_margin, .top = top, .bottom = top + panel_height}};
        std::copy_if(curves.begin(), curves.end(), std::back_inserter(part.curves), [&](Curve const& curve) { return curve.sample == sample; });
        if (!part.curves.empty()) {
            parts.push_back(std::move(part));
        }
    }
    if (parts.size() < 2) {
        for (auto& part : parts) {
            part.title.clear();
        }
        return parts;
    }
    double const middle = (left_axis + picture::width - picture::right_margin) / 2;
    parts[0].panel.right = middle - between / 2;
    parts[1].panel.left = middle + between / 2;
    for (auto& part : parts) {
        part.panel.top += below_title;
        part.panel.bottom += below_title;
    }
    return parts;
}

Legend::Legend(std::vector<Curve> const& curves, std::string (*remark)(Curve const&))
{
    auto const find = [&](Curve const& of, bool sample) {
        auto const found = std::find_if(curves.begin(), curves.end(), [&](Curve const& curve) {
            return curve.sample == sample && curve.ladder->method == of.ladder->method && curve.ladder->knob == of.ladder->knob;
        });
        return found == curves.end() ? nullptr : &*found;
    };
    auto const add = [&](Curve const* line, std::string const& name, Curve const& of) {
        std::string const said = remark(of);
        rows.push_back({line, name + (said.empty() ? "" : ": " + said)});
    };
    for (auto const& curve : curves) {
        if (curve.sample && find(curve, false) != nullptr) {
            continue;   // said with its drive's
        }
        add(&curve, ladder_name(*curve.ladder) + (curve.has_knob() ? " (" + curve.ladder->knob + ")" : ""), curve);
        if (auto const* sample = curve.sample ? nullptr : find(curve, true); sample != nullptr && !remark(*sample).empty()) {
            add(nullptr, worst_of_sample, *sample);
        }
    }
}

std::string Legend::text(picture::Panel const& panel, double height) const
{
    constexpr double sample = 46, gap = 12, indent = 24;
    std::string text;
    double y = panel.bottom + below_axis;
    for (auto const& row : rows) {
        y += legend_row;
        double const x = left_axis + sample + gap + (row.curve != nullptr ? 0 : indent);
        text += fmt::format("set label {} at {} noenhanced\n", gnuplot_quoted(row.text), picture::screen(x, y, height));
        if (row.curve == nullptr) {
            continue;
        }
        text += fmt::format("set label '' at {} point pointtype 7 pointsize 0.7 linecolor rgb '{}'\n", picture::screen(left_axis + sample / 2, y, height), row.curve->colour);
        if (row.curve->rungs.size() > 1) {
            text += fmt::format("set arrow from {} to {} nohead {}\n", picture::screen(left_axis, y, height), picture::screen(left_axis + sample, y, height), look(*row.curve));
        }
    }
    return text;
}

double Legend::height_below(picture::Panel const& panel) const
{
    return panel.bottom + below_axis + legend_row * (static_cast<double>(rows.size()) + 1);
}

std::string frame(StoredAccuracy const& study, std::string const& name, std::string const& hint, std::string const& legend, double height, PictureFormat format)
{
    std::string question;
    for (auto const& kind : study_kinds()) {
        if (kind.name == name) {
            question = kind.question;
        }
    }
    picture::Words const words{study.report.scene.drive.name + ": " + name, question + (hint.empty() ? "" : "; " + hint), "", ""};
    return picture::terminal(format, height) + picture::title(height, words) + legend + "set multiplot\n";
}

std::string axes_of(Part const& part, std::size_t i, double height)
{
    constexpr double title_above = 16;   // [px]
    std::string script = i > 0 ? "unset label\nunset arrow\nunset ylabel\nset format y ''\n" : "";
    script += picture::axes(part.panel, height) + "set logscale xy\nset grid linecolor rgb '#e0e0e0' linewidth 0.6\n";
    if (!part.title.empty()) {
        script += fmt::format("set label {} at {} left noenhanced\n", gnuplot_quoted(part.title), picture::screen(part.panel.left, part.panel.top - title_above, height));
    }
    return script;
}

}  // namespace hdconj::study_picture
