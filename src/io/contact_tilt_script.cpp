// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_scripts.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"
#include "summary_figures.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double top = 82;
constexpr double panel_height = 440;
constexpr double left_axis = 112;
constexpr double right_axis = 95;
constexpr double below_axis = 66;
constexpr double legend_row = 26;
constexpr double percent = 100;

// Colours that stay apart for colour-blind eyes; area is a full line, offset a dashed one.
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00"};

/// The cases of one surface and kind, by tilt.
struct Curve
{
    std::string surface, kind;
    std::vector<ContactCase const*> cases;

    [[nodiscard]] bool is_level() const { return cases.size() == 1; }
    [[nodiscard]] std::string name() const { return kind.empty() ? surface : surface + ", " + kind; }
};

/// Without a tilt all kinds are one: such a case begins the curves of all kinds of its surface, where there are any.
void share_untilted(std::vector<Curve>& curves)
{
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (!curves[i].kind.empty()) {
            continue;
        }
        bool shared = false;
        for (auto& curve : curves) {
            if (curve.surface == curves[i].surface && !curve.kind.empty()) {
                curve.cases.insert(curve.cases.begin(), curves[i].cases.begin(), curves[i].cases.end());
                shared = true;
            }
        }
        if (shared) {
            curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(i--));
        }
    }
}

std::vector<Curve> curves_of(std::vector<ContactCase> const& cases)
{
    std::vector<Curve> curves;
    for (auto const& each : cases) {
        auto curve = std::find_if(curves.begin(), curves.end(), [&](Curve const& known) {
            return known.surface == each.surface && known.kind == each.kind;
        });
        if (curve == curves.end()) {
            curves.push_back({each.surface, each.kind, {}});
            curve = curves.end() - 1;
        }
        curve->cases.push_back(&each);
    }
    share_untilted(curves);
    for (auto& curve : curves) {
        std::stable_sort(curve.cases.begin(), curve.cases.end(), [](auto const* a, auto const* b) { return a->tilt < b->tilt; });
    }
    return curves;
}

/// Upper end of an axis from 0, a whole number of tics above @p largest.
double upper_end(double largest)
{
    constexpr double nothing_to_see = 1;
    double const range = largest > 0 ? largest : nothing_to_see;
    double const step = picture::tic_step(range);
    return step * std::ceil(range * 1.04 / step);
}

struct Ranges
{
    double tilt_from = 0, tilt_to = 0;  // [deg]
    double area = 0;                    // [%]
    double offset = 0;                  // [um]
};

Ranges ranges_of(ContactStudy const& study)
{
    Ranges ranges;
    for (auto const& each : study.cases) {
        ranges.tilt_from = std::min(ranges.tilt_from, each.tilt * degree_per_radian);
        ranges.tilt_to = std::max(ranges.tilt_to, each.tilt * degree_per_radian);
        ranges.area = std::max(ranges.area, each.state.share * percent);
        ranges.offset = std::max(ranges.offset, each.clearing_offset * um_per_mm);
    }
    for (auto const& best : study.best) {
        bool const area = best.what == "area";
        double& range = area ? ranges.area : ranges.offset;
        range = std::max(range, best.value * (area ? percent : um_per_mm));
    }
    ranges.area = upper_end(ranges.area);
    ranges.offset = upper_end(ranges.offset);
    return ranges;
}

std::size_t index_of(std::vector<Curve> const& curves, BestTilt const& best)
{
    auto const found = std::find_if(curves.begin(), curves.end(),
                                    [&](Curve const& curve) { return curve.kind == best.kind && !curve.is_level(); });
    return static_cast<std::size_t>(found - curves.begin());
}

/// A curve with no tilt of its own goes across the whole picture.
std::string rows_of(Curve const& curve, Ranges const& ranges)
{
    std::string rows;
    auto const add = [&](double tilt, ContactCase const& each) {
        rows += fmt::format("{:.8g} {:.8g} {:.8g}\n", tilt, each.state.share * percent, each.clearing_offset * um_per_mm);
    };
    if (curve.is_level()) {
        add(ranges.tilt_from, *curve.cases.front());
        add(ranges.tilt_to, *curve.cases.front());
    } else {
        for (auto const* each : curve.cases) {
            add(each->tilt * degree_per_radian, *each);
        }
    }
    return rows;
}

/// Widths differ as well: in SVG, gnuplot joins lines of one colour and width and forgets the second one's dashes.
std::string look(std::string const& colour, bool area, double width)
{
    return fmt::format("linecolor rgb '{}' linewidth {} dashtype {}", colour, area ? width : 0.9 * width, area ? "solid" : "(8,5)");
}

/// A row for each curve: area on the left, offset on the right.
std::string legend(std::vector<Curve> const& curves, double height)
{
    constexpr double sample = 46, gap = 12;
    double const middle = (left_axis + picture::width - right_axis) / 2;
    std::string text;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        double const y = top + panel_height + below_axis + legend_row * (static_cast<double>(i) + 1);
        std::string const level = curves[i].is_level() && curves[i].kind.empty() ? " (no tilt)" : "";
        for (bool const area : {true, false}) {
            double const x = area ? left_axis : middle;
            text += fmt::format("set arrow from {} to {} nohead {}\nset label {} at {} noenhanced\n",
                                picture::screen(x, y, height), picture::screen(x + sample, y, height),
                                look(colours[i % colours.size()], area, 2.2),
                                gnuplot_quoted((area ? "contact area: " : "clearing offset: ") + curves[i].name() + level),
                                picture::screen(x + sample + gap, y, height));
        }
    }
    return text;
}

/// A line down to the tilt axis, a star on the curve, and the tilt in words beside it.
std::string marks(ContactStudy const& study, std::vector<Curve> const& curves, Ranges const& ranges, std::string& plot)
{
    std::string script = "set style textbox opaque noborder fillcolor rgb '#ffffff' margins 0.2,0.2\n";
    int number = 0;
    for (auto const& best : study.best) {
        std::size_t const curve = index_of(curves, best);
        char const* const colour = curve < curves.size() ? colours[curve % colours.size()] : "#303030";
        bool const area = best.what == "area";
        double const tilt = best.tilt * degree_per_radian;
        double const value = area ? best.value * percent : best.value * um_per_mm;
        double const share = value / (area ? ranges.area : ranges.offset);
        script += fmt::format("set arrow from first {:.8g}, graph 0 to first {:.8g}, graph {:.6f} nohead back linecolor rgb '{}' "
                              "linewidth 0.9 dashtype (2,3)\n",
                              tilt, tilt, share, colour);
        bool const on_the_right = tilt > ranges.tilt_from + 0.8 * (ranges.tilt_to - ranges.tilt_from);
        script += fmt::format("set label {} at first {:.8g}, graph {:.6f} {} offset {},{} noenhanced textcolor rgb '{}' front boxed\n",
                              gnuplot_quoted(fmt::format("{:.3g}°{}{}", tilt, area ? "" : fmt::format(", {:.3g} µm", value),
                                                         best.on_bound ? " (on the bound)" : "")),
                              tilt, share, on_the_right ? "right" : "left", on_the_right ? -0.9 : 0.9, 0.7, colour);
        script += fmt::format("$best{} << END\n{:.8g} {:.8g}\nEND\n", ++number, tilt, value);
        plot += fmt::format(", \\\n    $best{} using 1:2 axes {} with points pointtype {} pointsize 1.1 linecolor rgb '{}' notitle",
                            number, area ? "x1y1" : "x1y2", area ? 7 : 6, colour);
    }
    return script;
}

}  // namespace

bool has_tilt_curve(ContactStudy const& study)
{
    auto const curves = curves_of(study.cases);
    return std::any_of(curves.begin(), curves.end(), [](Curve const& curve) {
        return curve.cases.front()->tilt < curve.cases.back()->tilt;
    });
}

std::string tilt_script(ContactStudy const& study, PictureFormat format)
{
    auto const curves = curves_of(study.cases);
    Ranges const ranges = ranges_of(study);
    double const height = top + panel_height + below_axis + legend_row * (static_cast<double>(curves.size()) + 1);
    picture::Words const words{
        study.solution.scene.drive.name,
        fmt::format("contact area (gap up to {:g} µm), and the side clearance that clears the flanks, against tilt",
                    study.contact_gap * um_per_mm),
        "", ""};
    // numbers of small shares are long, and the axis' name lies beside them
    constexpr double small_shares = 0.01, for_long_tics = 35;
    std::string script = picture::terminal(format, height) + picture::title(height, words) + legend(curves, height) +
                         picture::axes({.left = ranges.area < small_shares ? left_axis + for_long_tics : left_axis, .right = picture::width - right_axis, .top = top, .bottom = top + panel_height}, height);
    script += fmt::format(
        "set border 11\nset xrange [{:.8g}:{:.8g}]\nset yrange [0:{:.8g}]\nset y2range [0:{:.8g}]\n"
        "set xtics {:g}\nset ytics {:g}\nset y2tics {:g}\n"
        "set xlabel 'tilt of the circular spline [deg]' noenhanced\n"
        "set ylabel 'contact area [% of the driving flanks]' noenhanced\n"
        "set y2label 'clearing offset [µm]' noenhanced\n",
        ranges.tilt_from, ranges.tilt_to, ranges.area, ranges.offset, picture::tic_step(ranges.tilt_to - ranges.tilt_from),
        picture::tic_step(ranges.area), picture::tic_step(ranges.offset));
    std::string plot;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        script += fmt::format("$curve{} << END\n{}END\n", i, rows_of(curves[i], ranges));
        double const width = curves[i].is_level() ? 1.2 : 2.2;
        for (bool const area : {false, true}) {
            plot += fmt::format("{}$curve{} using 1:{} axes {} with {} {} pointtype {} pointsize 0.6 notitle",
                                plot.empty() ? "plot " : ", \\\n    ", i, area ? 2 : 3, area ? "x1y1" : "x1y2",
                                curves[i].is_level() ? "lines" : "linespoints", look(colours[i % colours.size()], area, width),
                                area ? 7 : 6);
        }
    }
    script += marks(study, curves, ranges, plot);
    return script + plot + "\n";
}

}  // namespace hdconj
