// SPDX-License-Identifier: GPL-3.0-or-later
// A form that flanks share is no stray, wherever its points stand, and wild points are: the figures of a ring are
// within their intervals of those of its points without noise.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/inspect.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"

namespace hdconj::test::strays_cases {
namespace {

/// The part that is measured.
MeasuredRing nominal_ring()
{
    MeasuredRing ring;
    ring.teeth = 60;
    return ring;
}

enum class Kind
{
    tip_relief,
    root_left,
    waves,
    relief_of_ends
};

/// A smooth form over xi, beside slope and crowning [mm].
struct Form
{
    Kind kind;
    double height, width, waves, phase;

    [[nodiscard]] double at(double xi) const
    {
        auto const end = [&](double from) { return std::pow(std::max(0.0, 1 - from / width), 2); };
        switch (kind) {
            case Kind::tip_relief:
                return -height * end(1 - xi);
            case Kind::root_left:
                return height * end(1 + xi);
            case Kind::relief_of_ends:
                return -height * end(1 - std::abs(xi));
            default:
                return 0.15 * height * std::sin(waves * xi + phase);
        }
    }
};

Form drawn_form(designs::Draws& draws)
{
    auto const kind = static_cast<Kind>(draws.whole(0, 3));
    return {kind, draws.between(5e-3, 2e-2), draws.between(0.3, 0.6), draws.between(2, 6), draws.between(0, 6)};
}

/// A point as it was made.
struct Made
{
    double xi, smooth;
    bool stray;
};

struct Ring
{
    PointFile file{"strays", {}, false};
    std::vector<Made> made;  ///< by line
};

/// How a ring is measured.
struct Measurement
{
    int teeth, points, spacing;  ///< spacing: even, nearly even, random
    double noise, spread;        ///< spread: standard deviation of slope and crowning between flanks
    double strays, stray_size;   ///< share of points, and by what these are off
    double burrs = 0;            ///< share of flanks whose last point is off by the same
};

/// Constant, slope and -crowning by least squares.
Eigen::Vector3d parabola_of(std::vector<Made> const& points)
{
    auto const n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixX3d basis(n, 3);
    Eigen::VectorXd value(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        Made const& each = points[static_cast<std::size_t>(i)];
        basis.row(i) << 1, each.xi, each.xi * each.xi;
        value[i] = each.smooth;
    }
    return basis.colPivHouseholderQr().solve(value);
}

void add_flank_of(Ring& ring, Form const& form, Measurement const& how, int tooth, bool right, designs::Draws& draws)
{
    FormulaFlank const flank;
    MeasuredRing const part = nominal_ring();
    double const slope = how.spread * normal(draws), crowning = how.spread * normal(draws);
    std::vector<Made> points;
    for (int i = 0; i < how.points; ++i) {
        double const scatter = how.spacing == 0 ? 0 : draws.between(-0.3, 0.3);
        double const xi = how.spacing == 2 ? draws.between(-0.96, 0.96)
                                           : std::clamp(-0.94 + 1.88 * (i + scatter) / (how.points - 1), -0.97, 0.97);
        bool const stray = draws.between(0, 1) < (i + 1 < how.points ? how.strays : how.strays + how.burrs);
        points.push_back({xi, form.at(xi) + slope / 2 * xi - crowning * xi * xi, stray});
    }
    double const middle = parabola_of(points)[0];
    for (Made& each : points) {
        each.smooth -= middle;  // the flank stands at its own position then
        double const off = each.smooth + how.noise * normal(draws) + (each.stray ? draws.sign() * how.stray_size : 0.0);
        auto const [where, out] = flank.at(flank.length() * (1 + each.xi) / 2);
        Vec2 p = where + off * out;
        p.x() *= right ? 1 : -1;
        p = turned_clockwise(p + Vec2(0, part.pitch_radius()), tooth * 2 * std::numbers::pi / part.teeth);
        ring.file.points.push_back({p, 0, tooth + 1, right, static_cast<int>(ring.made.size())});
        ring.made.push_back(each);
    }
}

Ring ring_of(Form const& form, Measurement const& how, designs::Draws& draws)
{
    Ring ring;
    for (int tooth = 0; tooth < how.teeth; ++tooth)
        for (bool const right : {false, true})
            add_flank_of(ring, form, how, tooth, right, draws);
    return ring;
}

Inspection inspected_ring(Ring const& ring)
{
    return inspect_points(scene_of(nominal_ring()), ring.file,
                          {InspectedPart::flexspline, std::nullopt, 0, Registration::datum});
}

/// How often intervals hold, and what became of points.
struct Count
{
    int held = 0, all = 0, held_ranges = 0, ranges = 0;
    int strays = 0, found = 0, wrong = 0;

    void add(Ring const& ring, Inspection const& found_ring)
    {
        std::map<std::pair<int, bool>, std::vector<Made>> used;
        for (PointDeviation const& point : found_ring.points) {
            Made const& made = ring.made[static_cast<std::size_t>(point.line)];
            bool const out = point.fate == PointFate::stray;
            strays += made.stray && point.fate != PointFate::beside ? 1 : 0;
            found += made.stray && out ? 1 : 0;
            wrong += !made.stray && out ? 1 : 0;
            if (point.fate == PointFate::used)
                used[{point.tooth, point.right}].push_back(made);
        }
        for (FlankFigures const& flank : found_ring.flanks)
            add(flank, used.at({flank.tooth, flank.right}));
    }
    void add(FlankFigures const& flank, std::vector<Made> const& points)
    {
        if (std::ranges::any_of(points, &Made::stray))
            return;
        Eigen::Vector3d const truth = parabola_of(points);
        double low = 1, high = -1, least = 1, most = -1;
        for (Made const& each : points) {
            double const left = each.smooth - truth.dot(Eigen::Vector3d(1, each.xi, each.xi * each.xi));
            low = std::min(low, left);
            high = std::max(high, left);
            least = std::min(least, each.smooth);
            most = std::max(most, each.smooth);
        }
        auto const within = [](Uncertain const& value, double true_value) {
            return std::abs(value.value - true_value) <= value.error ? 1 : 0;
        };
        held += within(flank.slope, 2 * truth[1]) + within(flank.crowning, -truth[2]);
        held_ranges += within(flank.form, high - low) + within(flank.total, most - least);
        all += 2;
        ranges += 2;
    }
};

Measurement drawn(designs::Draws& draws, int number)
{
    Measurement how{};
    how.teeth = std::array{12, 20, 60}[static_cast<std::size_t>(number % 3)];
    how.points = how.teeth == 60 ? draws.whole(8, 16) : draws.whole(12, 30);
    how.spacing = draws.whole(0, 2);
    how.noise = draws.between(1e-4, 6e-4);
    how.spread = draws.between(0, 2e-3);
    return how;
}

constexpr int rings = 24;

}  // namespace

TEST_CASE("a smooth form that flanks share is in their figures, wherever the points stand", "[inspect]")
{
    Count count;
    for (int i = 0; i < rings; ++i) {
        designs::Draws draws(9000 + static_cast<std::uint64_t>(i));
        Measurement const how = drawn(draws, i);
        Form const form = drawn_form(draws);
        Ring const ring = ring_of(form, how, draws);
        Inspection const found = inspected_ring(ring);
        CAPTURE(i, how.teeth, how.points, how.spacing, how.noise, static_cast<int>(form.kind), form.height, form.width);
        CHECK(found.strays == 0);
        count.add(ring, found);
    }
    CAPTURE(count.held, count.all, count.held_ranges, count.ranges);
    CHECK(count.held >= 0.94 * count.all);
    CHECK(count.held_ranges >= 0.94 * count.ranges);
}

TEST_CASE("wild points are left out of such flanks, and no others", "[inspect]")
{
    Count count;
    for (int i = 0; i < rings; ++i) {
        designs::Draws draws(9100 + static_cast<std::uint64_t>(i));
        Measurement how = drawn(draws, i);
        how.strays = draws.between(0.005, 0.02);
        how.stray_size = i % 2 == 0 ? 0.03 : std::max(5e-3, 15 * how.noise);
        Ring const ring = ring_of(drawn_form(draws), how, draws);
        count.add(ring, inspected_ring(ring));
    }
    CAPTURE(count.strays, count.found, count.held, count.all, count.held_ranges, count.ranges);
    CHECK(count.wrong <= 0.01 * count.strays);
    CHECK(count.found >= 0.9 * count.strays);
    CHECK(count.held >= 0.94 * count.all);
    CHECK(count.held_ranges >= 0.94 * count.ranges);
}

TEST_CASE("a single tooth keeps its relief and loses its dust", "[inspect]")
{
    for (int i = 0; i < rings; ++i) {
        designs::Draws draws(9200 + static_cast<std::uint64_t>(i));
        Form const form{static_cast<Kind>(i % 4), 0.02, 0.4, 5, 1};
        Measurement const how{1, 30, i % 2, 2e-4, 1e-3, 0, 0};
        Ring ring = ring_of(form, how, draws);
        CAPTURE(i);
        CHECK(inspected_ring(ring).strays == 0);
        auto const at = static_cast<std::size_t>(draws.whole(4, 25));
        PartPoint& dust = ring.file.points[at];
        dust.where += draws.sign() * 0.02 * right_of(dust.where.normalized());
        Inspection const found = inspected_ring(ring);
        CHECK(found.strays == 1);
        CHECK(found.points[at].fate == PointFate::stray);
    }
}

TEST_CASE("strays at one place of many flanks are told", "[inspect]")
{
    for (double const share : {0.0, 0.4}) {
        designs::Draws draws(9300);
        Measurement const how{30, 20, 0, 3e-4, 1e-3, 0, 2e-2, share};
        auto const notes = inspected_ring(ring_of({Kind::waves, 0, 1, 1, 0}, how, draws)).notes;
        bool const told = std::ranges::any_of(
            notes, [](std::string const& note) { return note.find("% of the flank") != std::string::npos; });
        CHECK(told == (share > 0));
    }
}

}  // namespace hdconj::test::strays_cases
