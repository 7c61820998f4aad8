// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_figures.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <boost/version.hpp>
#include <cmath>

#include "hdconj/io/version.hpp"

namespace hdconj {
namespace {

std::string libraries()
{
    unsigned int major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    return fmt::format("CGAL {}; GSL {}; Eigen {}.{}.{}; Boost {}.{}; HDF5 {}.{}.{}; fmt {}", HDCONJ_CGAL_VERSION, HDCONJ_GSL_VERSION, EIGEN_WORLD_VERSION,
                       EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, major, minor, release, FMT_VERSION);
}

}  // namespace

AccuracyOrigin this_program()
{
    return {std::string(program_version()), std::string(git_revision()), std::string(build_description()), libraries()};
}

std::span<RecordFigure const> record_figures()
{
    using R = StudyRecord;
    static constexpr std::array figures = {
        RecordFigure{"value", "1", [](R const& r) { return r.value; }, [](R& r, double v) { r.value = v; }},
        RecordFigure{"repeat", "1", [](R const& r) { return static_cast<double>(r.repeat); }, [](R& r, double v) { r.repeat = static_cast<int>(v); }},
        RecordFigure{"error", "as in unit", [](R const& r) { return r.error; }, [](R& r, double v) { r.error = v; }},
        RecordFigure{"hausdorff", "as in unit", [](R const& r) { return r.hausdorff; }, [](R& r, double v) { r.hausdorff = v; }},
        RecordFigure{"estimate", "as in unit", [](R const& r) { return r.estimate; }, [](R& r, double v) { r.estimate = v; }},
        RecordFigure{"residual", "mm/rad", [](R const& r) { return r.residual; }, [](R& r, double v) { r.residual = v; }},
        RecordFigure{"branches", "1", [](R const& r) { return static_cast<double>(r.branches); }, [](R& r, double v) { r.branches = static_cast<int>(v); }},
        RecordFigure{"missed", "1", [](R const& r) { return static_cast<double>(r.missed); }, [](R& r, double v) { r.missed = static_cast<int>(v); }},
        RecordFigure{"extra", "1", [](R const& r) { return static_cast<double>(r.extra); }, [](R& r, double v) { r.extra = static_cast<int>(v); }},
        RecordFigure{"seconds", "s", [](R const& r) { return r.seconds; }, [](R& r, double v) { r.seconds = v; }},
        RecordFigure{"evaluations", "1", [](R const& r) { return r.evaluations; }, [](R& r, double v) { r.evaluations = v; }},
        RecordFigure{"points", "1", [](R const& r) { return r.points; }, [](R& r, double v) { r.points = v; }},
        RecordFigure{"memory", "MB", [](R const& r) { return r.memory; }, [](R& r, double v) { r.memory = v; }},
        RecordFigure{"threads", "1", [](R const& r) { return static_cast<double>(r.threads); }, [](R& r, double v) { r.threads = static_cast<int>(v); }}};
    return figures;
}

std::span<RecordText const> record_texts()
{
    static constexpr std::array texts = {RecordText{"study", &StudyRecord::study}, RecordText{"drive", &StudyRecord::drive},
                                         RecordText{"method", &StudyRecord::method}, RecordText{"knob", &StudyRecord::knob},
                                         RecordText{"unit", &StudyRecord::unit}};
    return texts;
}

std::string scientific(double value)
{
    return value == value ? fmt::format("{:.2e}", value) : "-";
}

std::string duration(double seconds)
{
    if (seconds < 1e-3) {
        return fmt::format("{:.3g} us", seconds * 1e6);
    }
    return seconds < 1 ? fmt::format("{:.3g} ms", seconds * 1e3) : fmt::format("{:.3g} s", seconds);
}

std::string knob_text(double value)
{
    constexpr double whole_below = 1e9;   // a count as a count
    return value == std::floor(value) && std::abs(value) < whole_below ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

std::string threads_text(int threads)
{
    return threads == 1 ? "1 thread" : fmt::format("{} threads", threads);
}

std::string ladder_name(StudyLadder const& ladder)
{
    return ladder.drive == worst_of_sample ? ladder.method + ", worst of the sample" : ladder.method;
}

std::string ladder_remark(StudyLadder const& ladder)
{
    std::string remark;
    if (ladder.order == ladder.order) {
        remark = fmt::format("order {:.2f}", ladder.order);
    } else if (!ladder.no_order.empty()) {
        remark = "no order: " + ladder.no_order;
    } else if (auto const fall = ladder.knob == polynomial_degree ? error_per_step(ladder.rungs) : std::nullopt) {
        remark = fmt::format("error falls {:.2g} times a degree until degree {:.0f}", fall->factor, fall->until);
    }
    if (ladder.floor == ladder.floor) {
        remark += fmt::format("{}floor {:.2e} {}", remark.empty() ? "" : ", ", ladder.floor, ladder.unit);
    }
    return remark;
}

std::string advice_text(Recommendation const& advice)
{
    auto const& rung = advice.rung;
    std::string text = fmt::format("{}--set {}={}: error {} mm on this drive", advice.reaches ? "" : "nothing measured does; nearest is ", rung.knob, knob_text(rung.value),
                                   scientific(rung.error));
    if (advice.sample_error == advice.sample_error) {
        text += fmt::format(", {} mm on the worst of the sample", scientific(advice.sample_error));
    }
    return text + fmt::format(", {} (median)", duration(rung.median));
}

bool are_single_runs(std::vector<StudyLadder> const& ladders)
{
    auto const repeated = [](StudyRung const& rung) { return rung.runs > 1; };
    return std::none_of(ladders.begin(), ladders.end(), [&](StudyLadder const& ladder) { return std::any_of(ladder.rungs.begin(), ladder.rungs.end(), repeated); });
}

std::vector<std::string> studies_of(std::vector<StudyLadder> const& ladders)
{
    std::vector<std::string> names;
    for (auto const& ladder : ladders) {
        if (std::find(names.begin(), names.end(), ladder.study) == names.end()) {
            names.push_back(ladder.study);
        }
    }
    return names;
}

}  // namespace hdconj
