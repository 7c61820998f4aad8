// SPDX-License-Identifier: GPL-3.0-or-later
#include "wavegen/length_kept.hpp"

#include <cmath>
#include <numbers>

#include "hdconj/wavegen/cosine_cam.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::length_kept_cases {

namespace {

/// Stretch of the displaced curve at phi, less (w + v')/r_m of the linear displacement: what is left of second order
/// and above.
double stretch_left(wavegen::MaterialDisplacement const& completed, wavegen::MaterialDisplacement const& linear,
                    double phi)
{
    auto const [w, v] = wavegen::displacement_at(completed, phi);
    wavegen::PointDisplacement const first = wavegen::displacement_at(linear, phi);
    return std::hypot(w[1] - v[0], type50_r_m + w[0] + v[1]) / type50_r_m - 1 - (first.w[0] + first.v[1]) / type50_r_m;
}

double worst_stretch(wavegen::MaterialDisplacement const& completed, wavegen::MaterialDisplacement const& linear)
{
    double worst = 0;
    for (int i = 0; i < 720; ++i)
        worst = std::max(worst, std::abs(stretch_left(completed, linear, 2 * std::numbers::pi * i / 720)));
    return worst;
}

}  // namespace

TEST_CASE("a completed displacement stretches the neutral curve as the linear one does to third order", "[length_kept]")
{
    for (int const waves : {1, 2, 3}) {
        double before = 0;
        for (double const w0 : {0.4, 0.2, 0.1, 0.05}) {
            // with a stretch of its own, and lopsided
            wavegen::MaterialDisplacement linear{
                waves,
                {{0.01 * w0, 0, 0.02 * w0, 0}, {w0, 0.1 * w0, 0.03 * w0, -0.6 * w0}, {0, 0.2 * w0, 0.1 * w0, 0}}};
            double const left = worst_stretch(wavegen::length_kept(linear, type50_r_m), linear);
            CAPTURE(waves, w0, left, worst_stretch(linear, linear));
            CHECK(left < worst_stretch(linear, linear) / 5);
            if (before > 0)
                CHECK(std::log2(before / left) == Approx(3).margin(0.1));
            before = left;
        }
    }
}

TEST_CASE("the mean of an inextensional mode falls by w0^2 (n - 1/n)^2 / (4 r)", "[length_kept]")
{
    for (int const waves : {2, 3}) {
        wavegen::MaterialDisplacement const linear = wavegen::inextensional_mode(wavegen::CosineCam{type50_w0, waves});
        wavegen::MaterialDisplacement const completed = wavegen::length_kept(linear, type50_r_m);
        double const n = waves;
        double const falls = linear.harmonics[0].w_cosine - completed.harmonics[0].w_cosine;
        CHECK(falls == Approx(type50_w0 * type50_w0 * (n - 1 / n) * (n - 1 / n) / (4 * type50_r_m)).epsilon(1e-12));
        CHECK(is_symmetric(completed));
        CHECK(completed.harmonics.size() == 3);
        // v' = -(e - mean e), e = mean - mean cos(2 n phi)
        CHECK(completed.harmonics[2].v_sine == Approx(falls / (2 * n)).epsilon(1e-12));
    }
}

TEST_CASE("nothing displaced is left alone", "[length_kept]")
{
    CHECK(wavegen::length_kept({2, {}}, type50_r_m).harmonics.empty());
    wavegen::MaterialDisplacement const turned = wavegen::length_kept({2, {{0, 0, 0, 0}}}, type50_r_m);
    CHECK(turned.harmonics.front().w_cosine == 0);
}

}  // namespace hdconj::test::length_kept_cases
