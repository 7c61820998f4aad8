// SPDX-License-Identifier: GPL-3.0-or-later
// The page's conclusions follow the records, whatever these are; labels of its pictures lie apart.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "figures/accuracy_figures.hpp"
#include "hdconj/accuracy_files.hpp"
#include "report/plots/label_places.hpp"
#include "report/plots/plots.hpp"
#include "support/catch.hpp"
#include "support/plot_data.hpp"

namespace hdconj::test::accuracy_page_cases {

namespace {

struct Run
{
    double value, error, seconds, points = 60;
    int missed = 0, repeat = 0;
};

void add(AccuracyReport& report, std::string const& study, std::string const& method, std::string const& knob,
         std::vector<Run> const& runs)
{
    for (Run const& run : runs) {
        StudyRecord record;
        record.study = study;
        record.drive = "drive";
        record.method = method;
        record.knob = knob;
        record.value = run.value;
        record.error = record.hausdorff = record.estimate = run.error;
        record.seconds = run.seconds;
        record.points = run.points;
        record.missed = run.missed;
        record.repeat = run.repeat;
        record.threads = knob == "solver.threads" ? static_cast<int>(run.value) : 1;
        report.records.push_back(record);
    }
}

AccuracyReport report_of_drive()
{
    AccuracyReport report;
    report.scene.drive = {"drive", 0.5, 100, 102};
    return report;
}

std::string page_of(AccuracyReport const& report)
{
    return accuracy_page({report, {}}, "page.md", false);
}

std::size_t times_said(std::string const& script, std::string const& words)
{
    std::size_t found = 0;
    for (auto at = script.find(words); at != std::string::npos; at = script.find(words, at + 1))
        ++found;
    return found;
}

std::string fit_page(std::vector<Run> const& runs)
{
    AccuracyReport report = report_of_drive();
    add(report, "polynomial-fit", "fit, exact motion", "degree", runs);
    return page_of(report);
}

}  // namespace

TEST_CASE("accuracy page: which degree fits best is read from the records", "[accuracy]")
{
    CHECK_THAT(fit_page({{3, 1e-2, 1}, {6, 1e-4, 1}, {9, 1e-3, 1}}),
               ContainsSubstring(
                   "best with degree 6, 1.00e-04 mm; degree 9, the highest that was tried, is off by 1.00e-03 mm"));
    CHECK_THAT(fit_page({{3, 1e-2, 1}, {6, 1e-4, 1}, {9, 1e-5, 1}}),
               ContainsSubstring("best with degree 9, 1.00e-05 mm, the highest that was tried."));
    CHECK_THAT(fit_page({{3, 1e-2, 1}, {6, 1e-4, 1}, {9, 2e-14, 1}}),
               ContainsSubstring("best with degree 9, 2.00e-14 mm, which is rounding"));
    CHECK_THAT(fit_page({{3, 1e-2, 1, 43, 17}, {6, 1e-4, 1, 43, 17}}),
               ContainsSubstring("(17 of 60 points of the grid have no contact on the flank)"));
    CHECK_THAT(fit_page({{3, not_measured, 1, 2, 58}, {6, not_measured, 1, 2, 58}}),
               ContainsSubstring("too few points of the grid have a contact on the flank for a fit"));
    for (double const last : {1e-3, 1e-5}) {
        CHECK_THAT(fit_page({{3, 1e-2, 1}, {6, 1e-4, 1}, {9, last, 1}}),
                   !ContainsSubstring("arc") && !ContainsSubstring("order"));
    }
}

TEST_CASE("accuracy page: orders of sampling are measured ones", "[accuracy]")
{
    AccuracyReport report = report_of_drive();
    add(report, "sampling", "equal steps of u", "steps over the lobe",
        {{10, 1e-1, 1, 10}, {100, 1e-2, 1, 100}, {1000, 1e-3, 1, 1000}});
    add(report, "sampling", "adaptive", "chord", {{1e-2, 1e-2, 1, 10}, {1e-4, 1e-4, 1, 100}, {1e-6, 1e-6, 1, 1000}});
    CHECK_THAT(page_of(report),
               ContainsSubstring("order 1.00 for equal steps of u, with order 2.00 for the adaptive sampler") &&
                   ContainsSubstring("10 at 1.00e-02 mm"));
    report = report_of_drive();
    add(report, "sampling", "equal steps of u", "steps over the lobe",
        {{10, 1e-3, 1, 10}, {100, 1e-2, 1, 100}, {1000, 1e-1, 1, 1000}});
    add(report, "sampling", "adaptive", "chord", {{1e-2, 1e-2, 1, 10}, {1e-4, 1e-4, 1, 100}});
    CHECK_THAT(page_of(report), ContainsSubstring("no order that could be told for equal steps of u") &&
                                    !ContainsSubstring("this many times the points"));
}

TEST_CASE("accuracy page: times of single runs are compared with none", "[accuracy]")
{
    for (int const repeats : {1, 2}) {
        AccuracyReport report = report_of_drive();
        report.threads = repeats;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            add(report, "tolerance", "solve", "solver.tolerance",
                {{1e-3, 1e-3, 9e-3, 60, 0, repeat},
                 {1e-4, 1e-4, 5e-3, 60, 0, repeat},
                 {1e-5, 1e-5, 1e-3, 60, 0, repeat}});
            add(report, "threads", "solve", "solver.threads",
                {{1, 1e-9, 3e-3, 60, 0, repeat}, {2, 1e-9, 1e-3, 60, 0, repeat}});
        }
        std::string const page = page_of(report);
        INFO(repeats);
        bool const single = repeats == 1;
        CHECK((page.find("times are of single runs, and no ratio is drawn from them") != std::string::npos) == single);
        CHECK((page.find("times as fast as one") == std::string::npos) == single);
        CHECK((page.find("time goes from 9 ms to 1 ms") == std::string::npos) == single);
        CHECK_THAT(page, !ContainsSubstring("time grows"));
        CHECK_THAT(page, ContainsSubstring(single ? ", 1 thread, which" : ", 2 threads, which"));
    }
}

TEST_CASE("accuracy page: the finest levels of a load say how right they are", "[accuracy]")
{
    AccuracyReport report = report_of_drive();
    add(report, "load", "harmonics: twist", "load.harmonics", {{25, 3e-3, 1}, {50, 2e-4, 1}, {75, 3e-4, 1}});
    add(report, "load", "reference: harmonics: twist", "load.harmonics", {{100, not_measured, 1}});
    report.records.back().estimate = 2e-2;
    std::string const page = page_of(report);
    CHECK_THAT(page, ContainsSubstring("right to 2.00e-02 of the twist or better, as the program estimates them") &&
                         ContainsSubstring("how the twist converges as one count grows"));
    CHECK_THAT(page, ContainsSubstring("**harmonics: twist**: no order: errors do not fall by 5 % at every level"));
    report.records.back().estimate = 1e-9;
    CHECK_THAT(page_of(report), !ContainsSubstring("how the twist converges"));
}

TEST_CASE("accuracy pictures: labels keep off each other, off points and lines, and inside the frame", "[accuracy]")
{
    report::LabelBox const frame{100, 900, 80, 500};
    report::LabelPlaces places(frame);
    std::vector<report::Spot> points;
    for (int i = 0; i < 12; ++i) {
        points.push_back({880.0 - 9 * (i % 4), 90.0 + 14 * i});  // a crowd at the upper right corner
        places.add_point(points.back());
        if (i > 0)
            places.add_line(points[points.size() - 2], points.back());
    }
    std::vector<report::LabelBox> boxes;
    for (int i = 0; i < 12; i += 2)
        boxes.push_back(places.place("1e-07", points[static_cast<std::size_t>(i)]));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        report::LabelBox const& box = boxes[i];
        CHECK(box.left >= frame.left);
        CHECK(box.right <= frame.right);
        CHECK(box.top >= frame.top);
        for (auto const& point : points)
            CHECK_FALSE(box.holds(point));
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE(box.meets(boxes[j]));
    }
    // a line through the usual place beside a point moves the label to another side
    report::LabelPlaces crossed(frame);
    crossed.add_line({500, 300}, {560, 270});
    report::LabelBox const beside = crossed.place("64", {500, 300});
    for (double share = 0; share <= 1; share += 0.01) {
        CHECK_FALSE(beside.holds({500 + 60 * share, 300 - 30 * share}));
    }
}

TEST_CASE("accuracy pictures: a short axis of times has more than one number", "[accuracy]")
{
    for (bool const wide : {false, true}) {
        AccuracyReport report = report_of_drive();
        add(report, "tolerance", "solve", "solver.tolerance", {{1e-3, 1e-3, 0.3}, {1e-4, 1e-4, wide ? 30 : 0.9}});
        std::string const script =
            report::accuracy_script({report, {}}, accuracy::convergence_series(report), "tolerance");
        std::vector<std::string> const tics{"0.2 \"0.2\"", "0.5 \"0.5\"", "1 \"1\""};
        CHECK(test::plot_lines(script, "tics") == (wide ? std::vector<std::string>{} : tics));
    }
    auto const tics_of = [](std::vector<Run> const& runs) {
        AccuracyReport report = report_of_drive();
        add(report, "tolerance", "solve", "solver.tolerance", runs);
        return test::plot_lines(
            report::accuracy_script({report, {}}, accuracy::convergence_series(report), "tolerance"), "tics");
    };
    // one power of ten among 26 times
    auto const some = tics_of({{1e-3, 1e-3, 4e-5}, {1e-4, 1e-4, 4e-4}});
    REQUIRE(some.size() > 3);
    CHECK(some[0] == "5.0e-05 \"5·10^{-5}\"");
    CHECK(some[1] == "0.0001 \"1·10^{-4}\"");
    CHECK_THAT(some[2], ContainsSubstring("\"2·10^{-4}\""));
    CHECK(tics_of({{1e-3, 1e-3, 3e-5}, {1e-4, 1e-4, 9e-5}}) ==
          std::vector<std::string>{"2.0e-05 \"2·10^{-5}\"", "5.0e-05 \"5·10^{-5}\"", "0.0001 \"1·10^{-4}\""});
}

TEST_CASE("accuracy pictures: a method with a single setting is named without a knob, and no value stands beside it",
          "[accuracy]")
{
    AccuracyReport report = report_of_drive();
    add(report, "roots", "closed form", "scan steps", {{1, 1e-13, 1e-5}});
    add(report, "roots", "scan", "scan steps", {{1, 1e-9, 1e-3}, {64, 1e-12, 1e-1}});
    auto const script = report::accuracy_script({report, {}}, accuracy::convergence_series(report), "roots");
    CHECK_THAT(script, ContainsSubstring("\"closed form\"") && ContainsSubstring("\"scan (scan steps)"));
    std::vector<std::string> settings;
    for (auto const& label : test::plot_lines(script, "labels"))
        settings.push_back(label.substr(label.find('"')));
    CHECK(settings == std::vector<std::string>{"\"1\"", "\"64\""});
}

TEST_CASE(
    "accuracy pictures: the worst of the sample has axes of its own, and no entry of the legend says a method twice",
    "[accuracy]")
{
    AccuracyReport report = report_of_drive();
    add(report, "tolerance", "solve", "solver.tolerance",
        {{1e-3, 1e-3, 0.1}, {1e-4, 1e-4, 0.2}, {1e-5, 1e-5, 0.4}, {1e-6, 1e-6, 1}});
    auto const script = [&] {
        return report::accuracy_script({report, {}}, accuracy::convergence_series(report), "tolerance");
    };
    auto const of_sample = [&](std::string const& block) {
        auto const lines = test::plot_lines(script(), block);
        return std::count_if(lines.begin(), lines.end(), [](std::string const& line) {
            return line.find("\"worst of the sample") != std::string::npos;
        });
    };
    CHECK(test::plot_rows(script(), "panels").size() == 1);
    CHECK(of_sample("panels") + of_sample("legend") == 0);
    add(report, "tolerance", "solve", "solver.tolerance",
        {{1e-3, 2e-3, 0.2}, {1e-4, 2e-4, 0.4}, {1e-5, 2e-5, 0.8}, {1e-6, 2e-6, 2}});
    for (std::size_t i = report.records.size() / 2; i < report.records.size(); ++i)
        report.records[i].drive = "design 1";
    CHECK(test::plot_rows(script(), "panels").size() == 2);
    CHECK(times_said(script(), "\"solve (solver.tolerance): order 1.00\"") == 1);
    CHECK(times_said(script(), "\"worst of the sample: order 1.00\"") == 1);
    CHECK(of_sample("panels") == 1);
    CHECK(of_sample("legend") == 1);
    // the same axes for both
    CHECK(times_said(script(), "\ntime_low = 0.0625\ntime_high = 3.2\n") == 1);
    CHECK(times_said(script(), "\nerror_low = 1e-07\nerror_high = 0.01\n") == 1);
    CHECK(times_said(script(), "set xrange [time_low:time_high]") == 1);
    CHECK(times_said(script(), "set yrange [error_low:error_high]") == 1);
}

TEST_CASE("accuracy: a count is written as a count", "[accuracy]")
{
    CHECK(figures::knob_text(1048576) == "1048576");
    CHECK(figures::knob_text(1e-6) == "1e-06");
    CHECK(figures::knob_text(0.25) == "0.25");
}

}  // namespace hdconj::test::accuracy_page_cases
