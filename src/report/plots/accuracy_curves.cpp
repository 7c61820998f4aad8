// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_curves.hpp"

#include <algorithm>
#include <iterator>

#include "accuracy/convergence_series.hpp"
#include "hdconj/accuracy.hpp"

namespace hdconj::report {
namespace {

/// Lines of the legend: one for each method, and below it what is to say of its worst in the sample.
PlotColumns study_legend(std::vector<StudyCurve> const& curves, std::string (*remark)(StudyCurve const&))
{
    auto const find = [&](StudyCurve const& of, bool sample) {
        auto const found = std::find_if(curves.begin(), curves.end(), [&](StudyCurve const& curve) {
            return curve.sample == sample && curve.colour == of.colour;
        });
        return found == curves.end() ? nullptr : &*found;
    };
    PlotColumns legend;
    auto const with_remark = [&](std::string const& name, StudyCurve const& curve) {
        std::string const said = remark(curve);
        return name + (said.empty() ? "" : ": " + said);
    };
    for (auto const& curve : curves) {
        if (curve.sample && find(curve, false) != nullptr)
            continue;  // said with its drive's
        std::string const knob = curve.has_knob() ? " (" + curve.series->knob + ")" : "";
        legend.named_row(with_remark(figures::series_name(*curve.series) + knob, curve), curve.colour,
                         curve.levels.size());
        auto const* sample = curve.sample ? nullptr : find(curve, true);
        if (sample != nullptr && !remark(*sample).empty())
            legend.named_row(with_remark(accuracy::worst_of_sample, *sample), 0, 0);
    }
    return legend;
}

}  // namespace

std::vector<StudyCurve> study_curves(std::vector<ConvergenceSeries> const& series_list, std::string const& name)
{
    std::vector<StudyCurve> curves;
    std::vector<std::string> methods;
    for (auto const& series : series_list) {
        if (series.study != name)
            continue;
        StudyCurve curve{&series, {}, 1, series.drive == accuracy::worst_of_sample};
        for (auto const& level : series.levels)
            if (level.error > 0 && level.median > 0)
                curve.levels.push_back(&level);
        if (curve.levels.empty())
            continue;
        auto const known = std::find(methods.begin(), methods.end(), series.method + series.knob);
        curve.colour = static_cast<std::size_t>(known - methods.begin()) + 1;
        if (known == methods.end())
            methods.push_back(series.method + series.knob);
        curves.push_back(std::move(curve));
    }
    return curves;
}

std::vector<StudyPanel> study_panels(std::vector<StudyCurve> const& curves, std::string const& drive)
{
    constexpr LabelBox whole{112, 970, 82, 512};
    constexpr double between = 34, below_title = 30;
    std::vector<StudyPanel> panels;
    for (bool const sample : {false, true}) {
        StudyPanel panel{whole, sample ? accuracy::worst_of_sample : drive, {}};
        std::copy_if(curves.begin(), curves.end(), std::back_inserter(panel.curves),
                     [&](StudyCurve const& curve) { return curve.sample == sample; });
        if (!panel.curves.empty())
            panels.push_back(std::move(panel));
    }
    if (panels.size() < 2) {
        for (auto& panel : panels)
            panel.title.clear();
        return panels;
    }
    panels[0].axes.right = (whole.left + whole.right - between) / 2;
    panels[1].axes.left = (whole.left + whole.right + between) / 2;
    for (auto& panel : panels) {
        panel.axes.top += below_title;
        panel.axes.bottom += below_title;
    }
    return panels;
}

PlotData study_data(StoredAccuracy const& study, std::string const& name, std::vector<StudyPanel> const& panels,
                    std::string (*remark)(StudyCurve const&))
{
    PlotData data(study.report.scene.drive.name + ": " + name);
    data.set("question", figures::question_of(name));
    PlotColumns axes;
    std::vector<StudyCurve> curves;
    for (auto const& panel : panels) {
        std::size_t const first = curves.size() + 1;
        curves.insert(curves.end(), panel.curves.begin(), panel.curves.end());
        axes.named_row(panel.title, panel.axes.left, panel.axes.right, panel.axes.top, panel.axes.bottom, first,
                       curves.size());
    }
    data.set("panels", axes);
    data.set("legend", study_legend(curves, remark));
    return data;
}

}  // namespace hdconj::report
