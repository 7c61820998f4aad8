// SPDX-License-Identifier: GPL-3.0-or-later
// Where chords of one error stand: shares of a known number of chords, and the points of long polygons.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "hdconj/envelope/chord_measure.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/envelope/sample.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::chord_measure_cases {

namespace {

constexpr double chord = 1e-6;

/// Chords up to s of a curve that takes `all` of them, nowhere none: N(s) = all (s + sin(2 pi s) / 8).
double chords_up_to(double s)
{
    constexpr double all = 5000;
    return all * (s + std::sin(2 * std::numbers::pi * s) / 8);
}

/// The measure of that curve from @p cells equal steps of s.
envelope::ChordMeasure measured(int cells)
{
    std::vector<double> stations, errors;
    for (int i = 0; i <= cells; ++i) {
        stations.push_back(static_cast<double>(i) / cells);
        if (i > 0)
            errors.push_back(chord * std::pow(chords_up_to(stations[static_cast<std::size_t>(i)]) -
                                                  chords_up_to(stations[static_cast<std::size_t>(i) - 1]),
                                              2));
    }
    return {stations, errors, chord};
}

/// Largest deviation of a chord's share from 1 when the curve is cut into as many chords as it takes.
double worst_share(int cells)
{
    envelope::ChordMeasure const measure = measured(cells);
    auto const count = static_cast<std::size_t>(std::round(measure.total()));
    std::vector<double> s(count + 1);
    measure.shares(count, 0, s);
    double worst = 0;
    for (std::size_t k = 0; k < count; ++k)
        worst = std::max(worst, std::abs(chords_up_to(s[k + 1]) - chords_up_to(s[k]) - 1));
    return worst;
}

}  // namespace

TEST_CASE("shares of an arc ascend from end to end and do not depend on which are asked for", "[envelope]")
{
    envelope::ChordMeasure const measure = measured(20);
    CHECK(measure.total() == Approx(5000));
    constexpr std::size_t count = 1000;
    std::vector<double> whole(count + 1);
    measure.shares(count, 0, whole);
    CHECK(whole.front() == 0);
    CHECK(whole.back() == 1);
    CHECK(std::is_sorted(whole.begin(), whole.end()));
    CHECK(std::adjacent_find(whole.begin(), whole.end()) == whole.end());
    for (std::size_t const block : {std::size_t{1}, std::size_t{7}, std::size_t{256}}) {
        std::vector<double> parts(count + 1);
        for (std::size_t first = 0; first < parts.size(); first += block)
            measure.shares(count, first, std::span(parts).subspan(first, std::min(block, parts.size() - first)));
        CHECK(parts == whole);
    }
}

TEST_CASE("a density that is linear between stations is of second order in them", "[envelope]")
{
    double const coarse = worst_share(25);
    double const fine = worst_share(100);
    CHECK(coarse < 0.05);
    CHECK(fine < coarse / 12);
}

TEST_CASE("an arc without length has its ends alone", "[envelope]")
{
    envelope::ChordMeasure const measure({0, 0.5, 1}, std::vector<double>{0, 0}, chord);
    CHECK(measure.total() == 0);
    std::vector<double> ends(2);
    measure.shares(1, 0, ends);
    CHECK(ends == std::vector<double>{0, 1});
}

TEST_CASE("long polygons have at most 3 per cent more points than their curves need", "[envelope]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    constexpr double fine = 1e-9;
    int seen = 0;
    for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
        for (envelope::ContactArc const& arc : branch.arcs)
            for (envelope::ChordTest const test : {envelope::ChordTest::bound, envelope::ChordTest::estimate}) {
                envelope::SampledArc const s =
                    envelope::sample_arc(envelope, arc, arc.u_begin, arc.u_end, fine, 1, test);
                double needed = 0;
                for (std::size_t k = 0; k + 1 < s.points.size(); ++k)
                    needed += std::sqrt(envelope::chord_error(s.points[k], s.points[k + 1]) / fine);
                INFO("piece " << arc.piece << ", u " << arc.u_begin << ", " << s.points.size() << " points, " << needed
                              << " needed");
                CHECK(s.chord <= fine);
                if (needed < 1000)
                    continue;
                ++seen;
                CHECK(static_cast<double>(s.points.size()) < 1.03 * needed);
            }
    CHECK(seen >= 8);
}

TEST_CASE("an arc that is handed on in parts is the one that is kept, within the error from end to end", "[envelope]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    int seen = 0;
    for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
        for (envelope::ContactArc const& arc : branch.arcs)
            for (double const asked : {1e-5, 1e-7, 1e-9}) {
                INFO("piece " << arc.piece << ", u " << arc.u_begin << ", chord " << asked);
                std::vector<envelope::EnvelopePoint> points;
                std::vector<std::size_t> told;  // how many there would be without more cuts
                envelope::SampledArc const s = envelope::sample_arc_in_parts(
                    envelope, arc, asked, [&](std::span<envelope::EnvelopePoint const> more, std::size_t to_come) {
                        points.insert(points.end(), more.begin(), more.end());
                        CHECK(to_come > 0);
                        told.push_back(points.size() - more.size() + to_come);
                    });
                envelope::SampledArc const kept = envelope::sample_arc(envelope, arc, arc.u_begin, arc.u_end, asked, 1,
                                                                       envelope::ChordTest::estimate);
                REQUIRE(points.size() == kept.points.size());
                CHECK(s.points.empty());
                CHECK(std::is_sorted(told.begin(), told.end()));
                CHECK(told.back() <= points.size());
                CHECK(s.evaluations == kept.evaluations);
                CHECK(s.chord == kept.chord);
                CHECK(points.front().u == arc.u_begin);
                CHECK(points.back().u == arc.u_end);
                double worst = 0;
                bool same = true, ascends = true;
                for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                    worst = std::max(worst, envelope::chord_error(points[k], points[k + 1]));
                    ascends = ascends && points[k].u < points[k + 1].u;
                    same = same && points[k].u == kept.points[k].u && points[k].p == kept.points[k].p &&
                           points[k].t == kept.points[k].t;
                }
                CHECK(same);
                CHECK(ascends);
                CHECK(worst == s.chord);
                CHECK(worst <= asked);
                if (points.size() < 1000)
                    continue;
                ++seen;
                double const expected =
                    envelope::expected_chords(envelope, arc, asked) / static_cast<double>(points.size());
                CHECK(expected > 0.5);
                CHECK(expected < 1.5);
            }
    CHECK(seen >= 8);
}

}  // namespace hdconj::test::chord_measure_cases
