// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_figures.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/version.hpp>

#include "hdconj/accuracy.hpp"
#include "hdconj/version.hpp"

namespace hdconj {

AccuracyOrigin this_program()
{
    return {std::string(program_version()), std::string(git_revision()), std::string(build_description()),
            fmt::format("CGAL {}; GSL {}; Eigen {}.{}.{}; Boost {}.{}; HDF5 {}; fmt {}", HDCONJ_CGAL_VERSION,
                        HDCONJ_GSL_VERSION, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
                        BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, HDCONJ_HDF5_VERSION, FMT_VERSION)};
}

}  // namespace hdconj

namespace hdconj::figures {

using namespace unit;

namespace {

/// A number of a record, read and set.
template <auto member>
constexpr RecordFigure number(char const* name, Unit const& unit, char const* meaning, char const* former = nullptr)
{
    return {figure<member>(name, unit, meaning).formerly(former), [](StudyRecord& record, double value) {
                record.*member = static_cast<std::decay_t<decltype(record.*member)>>(value);
            }};
}

constexpr Unit unit_of_record{"as in unit", "", ""};

}  // namespace

std::span<RecordFigure const> record_figures()
{
    using R = StudyRecord;
    static constexpr std::array figures = {
        number<&R::value>("value", one, "of the setting"),
        number<&R::repeat>("repeat", one, "number of the run"),
        number<&R::error>("error", unit_of_record, "largest distance of a computed point from the true curve"),
        number<&R::hausdorff>("hausdorff", unit_of_record, "distance of the computed curve from the true one"),
        number<&R::estimate>("estimate", unit_of_record, "the method's own estimate of the error"),
        number<&R::normal_speed>("normal_speed", mm_per_rad, "largest n.v at the computed contacts; 0 at true ones",
                                 "residual"),
        number<&R::branches>("branches", one, "branches or roots found"),
        number<&R::missed>("missed", one, "branches or roots missed"),
        number<&R::extra>("extra", one, "branches or roots found where there are none"),
        number<&R::seconds>("seconds", second, "time of the run"),
        number<&R::evaluations>("evaluations", one, "evaluations of the meshing condition or the envelope point"),
        number<&R::points>("points", one, "points of the result"),
        number<&R::memory>("memory", megabyte, "largest resident set of the process"),
        number<&R::threads>("threads", one, "threads of the run")};
    return figures;
}

std::span<RecordText const> record_texts()
{
    static constexpr std::array texts = {RecordText{"study", &StudyRecord::study, "name of the study"},
                                         RecordText{"drive", &StudyRecord::drive, "name of the drive"},
                                         RecordText{"method", &StudyRecord::method, "name of the method"},
                                         RecordText{"knob", &StudyRecord::knob, "key that is varied"},
                                         RecordText{"unit", &StudyRecord::unit, "unit of the errors"}};
    return texts;
}

Rows<AccuracyReport> report_figures()
{
    using T = AccuracyReport;
    static constexpr std::array rows = {
        figure<&T::threads>("threads", one, "threads of the studies"),
        figure<&T::reference_error>("reference_error", mm, "distance of the reference from 50 digits",
                                    {"error", scientific}),
        figure<&T::reference_interference>("reference_interference", mm, "deepest interference with the reference",
                                           {"interference", scientific})
            .formerly("reference_entry"),
        figure<&T::sample>("sample", one, "designs of the sample"),
        figure<&T::sample_refused>("sample_refused", one, "random designs that are no valid drive"),
        figure<&T::quick>("quick", one, "whether series are short").without(json),
        figure<&T::seconds>("seconds", one, "time of all")};
    return Rows<T>(rows);
}

Rows<ConvergenceLevel> level_figures()
{
    using T = ConvergenceLevel;
    static constexpr std::array rows = {
        figure<&T::value>("value", one, "of the setting", {"knob", knob_text}),
        figure<&T::error>("error", one, "in the unit of the series", {"error", scientific}),
        figure<&T::estimate>("estimate", one, "the method's own estimate", {"estimate", scientific}),
        figure<&T::normal_speed>("normal_speed", mm_per_rad, "largest n.v at the computed contacts; 0 at true ones",
                                 {"normal speed", scientific})
            .formerly("residual"),
        figure<&T::missed>("missed", one, "branches or roots missed", {"missed", whole}),
        figure<&T::extra>("extra", one, "found where there are none", {"extra", whole}),
        figure<&T::median>("median", second, "median of the times", {"median", duration}),
        figure<&T::least>("least", second, "shortest of the times", {"least", duration}),
        figure<&T::most>("most", second, "longest of the times", {"most", duration}),
        figure<&T::evaluations>("evaluations", one, "of the meshing condition or the envelope point"),
        figure<&T::points>("points", one, "of the result", {"points", whole}),
        figure<&T::memory>("memory", megabyte, "largest resident set of the process"),
        figure<&T::threads>("threads", one, "threads of the runs"),
        figure<&T::drives>("drives", one, "designs that this is the worst of"),
        figure<&T::runs>("runs", one, "runs of each design")};
    return Rows<T>(rows);
}

Rows<accuracy::Recommendation> advice_figures()
{
    using T = accuracy::Recommendation;
    static constexpr std::array rows = {
        figure<&T::reaches>("target_met", one, "whether it keeps what was asked for").formerly("reaches"),
        figure<&T::level, &ConvergenceLevel::error>("error", mm, "on this drive"),
        figure<&T::sample_error>("sample_error", mm, "on the worst of the sample"),
        figure<&T::level, &ConvergenceLevel::median>("time", second, "median of the runs")};
    return Rows<T>(rows);
}

std::string question_of(std::string const& study)
{
    auto const& kinds = study_kinds();
    auto const kind = std::find_if(kinds.begin(), kinds.end(), [&](auto const& each) { return each.name == study; });
    return kind != kinds.end() ? std::string(kind->question) : std::string();
}

std::string threads_text(int threads)
{
    return threads == 1 ? "1 thread" : fmt::format("{} threads", threads);
}

std::string series_name(ConvergenceSeries const& series)
{
    return series.drive == accuracy::worst_of_sample ? series.method + ", worst of the sample" : series.method;
}

std::string unit_of_errors(ConvergenceSeries const& series)
{
    return series.unit == "1" ? "relative" : series.unit;
}

std::string series_remark(ConvergenceSeries const& series)
{
    std::string remark;
    if (series.order == series.order) {
        remark = fmt::format("order {:.2f}", series.order);
    } else if (!series.no_order.empty()) {
        remark = "no order: " + series.no_order;
    } else if (auto const fall = series.knob == accuracy::polynomial_degree ? accuracy::error_per_step(series.levels)
                                                                            : std::nullopt) {
        remark = fmt::format("error falls {:.2g} times a degree until degree {:.0f}", fall->factor, fall->until);
    }
    if (series.floor == series.floor)
        remark += fmt::format("{}floor {:.2e} {}", remark.empty() ? "" : ", ", series.floor, unit_of_errors(series));
    return remark;
}

std::string advice_text(accuracy::Recommendation const& advice)
{
    auto const& level = advice.level;
    std::string text = fmt::format("{}--set {}={}: error {} mm on this drive",
                                   advice.reaches ? "" : "no measured setting reaches it; the nearest is ", level.knob,
                                   knob_text(level.value), scientific(level.error));
    if (advice.sample_error == advice.sample_error)
        text += fmt::format(", {} mm on the worst of the sample", scientific(advice.sample_error));
    return text + fmt::format(", {} (median)", duration(level.median));
}

bool are_single_runs(std::vector<ConvergenceSeries> const& series_list)
{
    auto const repeated = [](ConvergenceLevel const& level) { return level.runs > 1; };
    return std::none_of(series_list.begin(), series_list.end(), [&](ConvergenceSeries const& series) {
        return std::any_of(series.levels.begin(), series.levels.end(), repeated);
    });
}

std::vector<std::string> studies_of(std::vector<ConvergenceSeries> const& series_list)
{
    std::vector<std::string> names;
    for (auto const& series : series_list)
        if (std::find(names.begin(), names.end(), series.study) == names.end())
            names.push_back(series.study);
    return names;
}

}  // namespace hdconj::figures
