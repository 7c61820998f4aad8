// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals of registrations that turn and shift hold what the same ring gives without noise.
#include <cmath>
#include <numbers>

#include "hdconj/inspect.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"
#include "support/run/full_run.hpp"

namespace hdconj::test::zone_intervals_cases {
namespace {

/// A sector of a ring: its registration is known worse than that of a whole ring.
MeasuredRing drawn(designs::Draws& draws)
{
    MeasuredRing ring;
    ring.teeth = 60;
    for (int k = 0; k < 60; k += 5)
        ring.measured.push_back(k);
    ring.points = 12;
    ring.noise = draws.between(1e-4, 6e-4);
    // from rings as good as their measurement to rings that are much worse
    double const errors = draws.between(0, 5e-3);
    for (auto* side : {&ring.left, &ring.right})
        for (std::size_t k = 0; k < ring.measured.size(); ++k)
            side->push_back({draws.between(-errors, errors), draws.between(-errors, errors) / 2,
                             draws.between(-errors, errors) / 3, 0});
    ring.shift = 5e-3 * direction(draws.between(-3, 3));
    ring.turn = draws.between(-0.2, 0.2) * 2 * std::numbers::pi / ring.teeth;
    return ring;
}

Inspection inspected_with(MeasuredRing ring, std::uint64_t seed, double noise, Registration registration)
{
    designs::Draws draws(seed);
    ring.noise = noise;
    return inspected(ring, draws, registration);
}

struct Share
{
    int held = 0, all = 0;

    void count(Uncertain const& found, Uncertain const& truth)
    {
        held += std::abs(found.value - truth.value) <= found.error ? 1 : 0;
        ++all;
    }
    [[nodiscard]] double value() const { return static_cast<double>(held) / all; }
};

}  // namespace

TEST_CASE("intervals hold the registration and the figures of the same ring without noise", "[inspect]")
{
    auto const registration = GENERATE(Registration::least_squares, Registration::minimum_zone);
    int const rings = full_run() ? 400 : 60;
    Share placement, flanks, teeth, circle, extremes;
    for (int i = 0; i < rings; ++i) {
        auto const seed = 7000 + static_cast<std::uint64_t>(i);
        designs::Draws draws(seed);
        MeasuredRing const ring = drawn(draws);
        Inspection const found = inspected_with(ring, seed, ring.noise, registration),
                         truth = inspected_with(ring, seed, 0, registration);
        placement.count(found.placement.turn, truth.placement.turn);
        placement.count(found.placement.shift_x, truth.placement.shift_x);
        placement.count(found.placement.shift_y, truth.placement.shift_y);
        REQUIRE(found.flanks.size() == truth.flanks.size());
        for (std::size_t k = 0; k < found.flanks.size(); ++k) {
            flanks.count(found.flanks[k].position, truth.flanks[k].position);
            flanks.count(found.flanks[k].slope, truth.flanks[k].slope);
            flanks.count(found.flanks[k].crowning, truth.flanks[k].crowning);
        }
        REQUIRE(found.teeth.size() == truth.teeth.size());
        for (std::size_t k = 0; k < found.teeth.size(); ++k) {
            teeth.count(found.teeth[k].thickness, truth.teeth[k].thickness);
            teeth.count(found.teeth[k].radial, truth.teeth[k].radial);
        }
        for (std::size_t k = 0; k < 2; ++k)
            teeth.count(found.sides[k].slope, truth.sides[k].slope);
        circle.count(found.planes[0].eccentricity, truth.planes[0].eccentricity);
        extremes.count(found.planes[0].runout, truth.planes[0].runout);
    }
    CAPTURE(to_string(registration), placement.value(), flanks.value(), teeth.value(), circle.value(),
            extremes.value());
    CHECK(std::abs(placement.value() - 0.95) <= 0.03);
    CHECK(std::abs(flanks.value() - 0.95) <= 0.03);
    CHECK(std::abs(teeth.value() - 0.95) <= 0.03);
    CHECK(circle.value() >= 0.92);
    CHECK(extremes.value() >= 0.92);
}

}  // namespace hdconj::test::zone_intervals_cases
