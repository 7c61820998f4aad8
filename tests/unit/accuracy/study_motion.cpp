// SPDX-License-Identifier: GPL-3.0-or-later
// The reference's own paths: integrals across breaks, waves, motions and views, against closed forms, limits and the
// program's formulas.
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "accuracy/reference/fifty.hpp"
#include "accuracy/reference/reference_motion.hpp"
#include "hdconj/motion/any_motion.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/wavegen/inextensional_mode.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"

namespace hdconj::test::study_motion_cases {

namespace {

constexpr double r_m = 24.347, w0 = 0.25;
constexpr int z_f = 200, z_c = 202;

/// Rows of w0 cos 2u with 2 % of its second harmonic, and of @p skew sin 2u, one wave.
std::vector<std::array<double, 2>> rows_of_cam(int count, double second = 0.02, double skew = 0)
{
    std::vector<std::array<double, 2>> rows;
    for (int i = 0; i < count; ++i) {
        double const x = 2 * std::acos(-1.0) * i / count;
        rows.push_back({180.0 * i / count, w0 * (std::cos(x) + second * std::cos(2 * x) + skew * std::sin(x))});
    }
    return rows;
}

accuracy::ReferenceNumbers given(accuracy::ReferenceShape shape, Kinematics model = Kinematics::exact)
{
    accuracy::ReferenceNumbers numbers{shape, w0, 2, r_m, 4.5, 30, {}, z_f, z_c, model};
    if (shape == accuracy::ReferenceShape::table)
        numbers.rows = rows_of_cam(14, 0.02, 0.01);
    return numbers;
}

/// The same wave generator as the program has it.
wavegen::AnyWaveShape program_shape(accuracy::ReferenceNumbers const& numbers)
{
    double const degree = std::acos(-1.0) / 180;
    switch (numbers.shape) {
        case accuracy::ReferenceShape::cosine:
            return wavegen::AnyWaveShape(wavegen::CosineCam{numbers.w0, numbers.waves});
        case accuracy::ReferenceShape::ring_on_cosine_cam:
            return wavegen::AnyWaveShape(wavegen::RingOnCam(numbers.w0, numbers.waves, numbers.thickness, numbers.r_m));
        case accuracy::ReferenceShape::four_roller:
            return wavegen::AnyWaveShape(wavegen::FourRoller(numbers.w0, numbers.angle_deg * degree, numbers.waves));
        case accuracy::ReferenceShape::two_disc:
            return wavegen::AnyWaveShape(
                wavegen::TwoDisc(numbers.w0, numbers.angle_deg * degree, numbers.waves, numbers.r_m));
        default:
            break;
    }
    std::vector<double> angles, values;
    for (auto const& row : numbers.rows) {
        angles.push_back(row[0] * degree);
        values.push_back(row[1]);
    }
    return wavegen::AnyWaveShape(wavegen::TableCam(angles, values, numbers.waves));
}

constexpr std::array with_program{accuracy::ReferenceShape::cosine, accuracy::ReferenceShape::ring_on_cosine_cam,
                                  accuracy::ReferenceShape::four_roller, accuracy::ReferenceShape::two_disc,
                                  accuracy::ReferenceShape::table};

/// Largest difference of points and velocities of a tooth between the program's motion and the reference's, over a
/// lobe.
template <class Motion>
std::array<double, 2> difference(Motion const& motion, accuracy::ReferenceView<accuracy::Fifty> const& view)
{
    std::array<double, 2> worst{};
    constexpr int places = 7;
    for (int i = 0; i <= places; ++i) {
        double const u = motion.half_lobe() * (2.0 * i / places - 1);
        Pose const pose = motion.pose(u);
        PlanarVelocity const twist = motion.rates(u).twist;
        accuracy::MovingFrame<accuracy::Fifty> const place = view.at(accuracy::Fifty(u));
        for (Vec2 const& x : {Vec2(0.1, 0.4), Vec2(-0.3, 0.9)}) {
            accuracy::Pair<accuracy::Fifty> const wide{accuracy::Fifty(x.x()), accuracy::Fifty(x.y())};
            accuracy::Pair<accuracy::Fifty> const p = place.point(wide), v = place.velocity(wide);
            Vec2 const there(static_cast<double>(p.x), static_cast<double>(p.y)),
                speed(static_cast<double>(v.x), static_cast<double>(v.y));
            worst[0] = std::max(worst[0], (there - pose(x)).norm());
            worst[1] = std::max(worst[1], (speed - pose.rotate(twist(x))).norm());
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("reference: integrals across breaks", "[study]")
{
    // |u| on one turn, with a kink at 0 and one at the half turn
    accuracy::Fifty const pi = accuracy::half_turn<accuracy::Fifty>(), tiny("1e-46");
    auto const kinked = [&](accuracy::Fifty const& u) {
        accuracy::Fifty const v = accuracy::within_period(u, pi);
        return v < 0 ? accuracy::Fifty(-v) : v;
    };
    accuracy::ReferenceIntegral<accuracy::Fifty> const integral(kinked, 1, {accuracy::Fifty(0), pi});
    CHECK(abs(integral.mean() - pi / 2) < tiny);
    for (double const u : {-7.0, -2.5, -0.25, 0.0, 1.0, 3.0, 4.0, 12.0}) {
        INFO(u);
        accuracy::Fifty const turns = floor((accuracy::Fifty(u) + pi) / (2 * pi)),
                              v = accuracy::Fifty(u) - 2 * pi * turns;
        accuracy::Fifty const exact = turns * pi * pi + (v < 0 ? accuracy::Fifty(-v * v) : accuracy::Fifty(v * v)) / 2;
        CHECK(abs(integral(accuracy::Fifty(u)) - exact) < 40 * tiny);
    }
    // a smooth one by equal steps, and by panels between breaks that are none
    auto const smooth = [](accuracy::Fifty const& u) { return exp(cos(2 * u)); };
    accuracy::ReferenceIntegral<accuracy::Fifty> const steps(smooth, 2, {}),
        panels(smooth, 2, {accuracy::Fifty(-0.5), accuracy::Fifty(0.75)});
    for (double const u : {-3.0, 0.5, 0.75, 2.0})
        CHECK(abs(steps(accuracy::Fifty(u)) - panels(accuracy::Fifty(u))) < tiny);
}

TEST_CASE("reference: ring between rollers is the sum of its harmonics", "[study]")
{
    // two rollers: Timoshenko's ring under two opposite forces
    accuracy::Fifty const pi = accuracy::half_turn<accuracy::Fifty>();
    accuracy::ReferenceRollers<accuracy::Fifty> const two(accuracy::Fifty(1), accuracy::Fifty(0), 2);
    CHECK(abs(two.at(pi / 2).w + (2 / pi - accuracy::Fifty(1) / 2) / (pi / 4 - 2 / pi)) < accuracy::Fifty("1e-46"));
    for (int const waves : {2, 3}) {
        long double const beta = 0.4L;
        accuracy::ReferenceRollers<long double> const ring(1, beta, waves);
        auto const sum = [&](long double u) {
            long double total = 0;
            for (int k = 4000 * waves; k > 0; k -= waves) {
                long double const stiffness = static_cast<long double>(k) * k - 1;
                total += std::cos(k * beta) * std::cos(k * u) / (stiffness * stiffness);
            }
            return total;
        };
        for (long double const u : {0.0L, 0.2L, 0.4L, 0.7L, -0.9L, 2.5L})
            CHECK(std::abs(ring.at(u).w - sum(u) / sum(0)) < 1e-11L);
    }
    // w, w', w'' go on across a roller
    accuracy::ReferenceRollers<accuracy::Fifty> const four(accuracy::Fifty(1), accuracy::Fifty(0.4), 2);
    accuracy::Fifty const h("1e-30");
    accuracy::WaveJet<accuracy::Fifty> const before = four.at(accuracy::Fifty(0.4) - h),
                                             after = four.at(accuracy::Fifty(0.4) + h);
    for (accuracy::Fifty const& jump : {accuracy::Fifty(before.w - after.w), accuracy::Fifty(before.w1 - after.w1),
                                        accuracy::Fifty(before.w2 - after.w2)})
        CHECK(abs(jump) < accuracy::Fifty("1e-28"));
    CHECK(abs((after.w2 - four.at(accuracy::Fifty(0.4) + 2 * h).w2) / h -
              (four.at(accuracy::Fifty(0.4) - 2 * h).w2 - before.w2) / h) > 1);
}

TEST_CASE("reference: on a disc the ring is a circle, and as long as it was", "[study]")
{
    accuracy::ReferenceNeutralCurve<accuracy::Fifty> const curve(given(accuracy::ReferenceShape::two_disc));
    // centre and radius from three points
    auto const at = [&](double u) { return curve.at(accuracy::Fifty(u)).p; };
    accuracy::Pair<accuracy::Fifty> const top = at(0), side = at(0.5);
    accuracy::Fifty const centre = (accuracy::inner(top, top) - accuracy::inner(side, side)) / (2 * (top.y - side.y));
    accuracy::Fifty const radius = top.y - centre;
    for (double const u : {-0.52, -0.3, 0.1, 0.52})
        CHECK(abs(accuracy::length(at(u) - accuracy::Pair<accuracy::Fifty>{accuracy::Fifty(0), centre}) - radius) <
              accuracy::Fifty("1e-45"));
    CHECK(abs(accuracy::length(at(0.53) - accuracy::Pair<accuracy::Fifty>{accuracy::Fifty(0), centre}) - radius) >
          accuracy::Fifty("1e-12"));
    CHECK(abs(top.y - accuracy::Fifty(r_m) - accuracy::Fifty(w0)) < accuracy::Fifty("1e-45"));
    accuracy::ReferenceIntegral<accuracy::Fifty> const around(
        [&](accuracy::Fifty const& u) { return accuracy::length(curve.at(u).p1); }, 2, curve.breaks());
    CHECK(abs(around.mean() - accuracy::Fifty(r_m)) < accuracy::Fifty("1e-44"));
    // the second lobe is the first one turned
    accuracy::Pair<accuracy::Fifty> const opposite =
        curve.at(accuracy::Fifty(0.3) + accuracy::half_turn<accuracy::Fifty>()).p;
    CHECK(length(opposite + at(0.3)) < accuracy::Fifty("1e-45"));
}

TEST_CASE("reference: the spline through a table keeps its rows and goes on with its curvature", "[study]")
{
    for (int const count : {4, 7, 36}) {
        auto const rows = rows_of_cam(count, 0.02, 0.3);
        accuracy::ReferenceTable<accuracy::Fifty> const table(rows, 2);
        accuracy::Fifty const degree = accuracy::half_turn<accuracy::Fifty>() / 180;
        accuracy::Fifty const first = table.at(rows[0][0] * degree).w;
        for (auto const& row : rows) {
            accuracy::Fifty const u = accuracy::Fifty(row[0]) * degree, h("1e-30");
            CHECK(abs(table.at(u).w - first - (accuracy::Fifty(row[1]) - accuracy::Fifty(rows[0][1]))) <
                  accuracy::Fifty("1e-46"));
            CHECK(abs(table.at(u + h).w2 - table.at(u - h).w2) < accuracy::Fifty("1e-25"));
        }
        accuracy::ReferenceIntegral<accuracy::Fifty> const integral(
            [&](accuracy::Fifty const& u) { return table.at(u).w; }, 2, table.breaks());
        CHECK(abs(integral.mean()) < accuracy::Fifty("1e-46"));
    }
}

TEST_CASE("reference: every motion is the program's, by another path", "[study]")
{
    double const ratio = static_cast<double>(z_f) / z_c, pitch = 2 * std::acos(-1.0) / z_c;
    for (accuracy::ReferenceShape const shape : with_program) {
        for (Kinematics const model : all_kinematics) {
            INFO("shape " << static_cast<int>(shape) << ", " << to_string(model));
            accuracy::ReferenceNumbers const numbers = given(shape, model);
            wavegen::AnyWaveShape const wave = program_shape(numbers);
            if (model == Kinematics::material && !wave.breaks().empty())
                continue;
            motion::AnyMotion const motion =
                model == Kinematics::exact ? motion::AnyMotion::owning(motion::ExactMotion<wavegen::AnyWaveShape>(
                                                 wavegen::NeutralCurve<wavegen::AnyWaveShape>(wave, r_m), ratio))
                : model == Kinematics::first_order
                    ? motion::AnyMotion::owning(motion::FirstOrderMotion<wavegen::AnyWaveShape>(wave, r_m, ratio))
                    : motion::AnyMotion::owning(motion::MaterialMotion(wavegen::inextensional_mode(wave), r_m, ratio));
            accuracy::ReferenceMotion<accuracy::Fifty> const own(numbers);
            auto const forward = difference(motion, accuracy::ReferenceView<accuracy::Fifty>(own));
            CHECK(forward[0] < 1e-13);
            CHECK(forward[1] < 2e-12);
            for (int const number : {-1, 0, 1}) {
                auto const reverse =
                    difference(motion::seen_from_flexspline(motion, number, pitch, 25.3),
                               accuracy::ReferenceView<accuracy::Fifty>(own, number, accuracy::Fifty(25.3)));
                CHECK(reverse[0] < 1e-13);
                CHECK(reverse[1] < 2e-12);
            }
            CHECK(std::abs(static_cast<double>(own.phi(accuracy::Fifty(0.7))) - motion.angles(0.7).phi) <
                  (model == Kinematics::exact ? 1e-14 : 1));
        }
    }
}

TEST_CASE("reference: rates are difference quotients of places", "[study]")
{
    accuracy::Fifty const h("1e-20");
    for (accuracy::ReferenceShape const shape : with_program) {
        for (Kinematics const model : all_kinematics) {
            accuracy::ReferenceMotion<accuracy::Fifty> const own(given(shape, model));
            for (accuracy::ReferenceView<accuracy::Fifty> const& view :
                 {accuracy::ReferenceView<accuracy::Fifty>(own),
                  accuracy::ReferenceView<accuracy::Fifty>(own, 1, accuracy::Fifty(25.3))}) {
                accuracy::Fifty const u(0.3);
                accuracy::MovingFrame<accuracy::Fifty> const here = view.at(u), later = view.at(u + h),
                                                             earlier = view.at(u - h);
                for (auto const& part : {std::pair(&accuracy::MovingFrame<accuracy::Fifty>::origin,
                                                   &accuracy::MovingFrame<accuracy::Fifty>::origin_rate),
                                         std::pair(&accuracy::MovingFrame<accuracy::Fifty>::along,
                                                   &accuracy::MovingFrame<accuracy::Fifty>::along_rate),
                                         std::pair(&accuracy::MovingFrame<accuracy::Fifty>::outward,
                                                   &accuracy::MovingFrame<accuracy::Fifty>::outward_rate)})
                    CHECK(length((1 / (2 * h)) * (later.*part.first - earlier.*part.first) - here.*part.second) <
                          accuracy::Fifty("1e-25"));
            }
        }
    }
}

TEST_CASE("reference: limits of models and tables", "[study]")
{
    // linear models leave the exact one with the square of the amplitude; the exact one by its undeformed angle
    auto const apart = [](Kinematics model, double amplitude) {
        accuracy::ReferenceNumbers numbers = given(accuracy::ReferenceShape::four_roller, model);
        numbers.w0 = amplitude;
        accuracy::ReferenceMotion<accuracy::Fifty> const linear(numbers);
        numbers.model = Kinematics::exact;
        accuracy::ReferenceMotion<accuracy::Fifty> const exact(numbers);
        double worst = 0;
        for (double const u : {-0.6, 0.9}) {
            accuracy::Pair<accuracy::Fifty> const x{accuracy::Fifty(0.1), accuracy::Fifty(0.6)};
            worst = std::max(worst,
                             static_cast<double>(accuracy::length(exact.at(accuracy::Fifty(u)).point(x) -
                                                                  linear.at(exact.phi(accuracy::Fifty(u))).point(x))));
        }
        return worst;
    };
    for (Kinematics const model : {Kinematics::first_order, Kinematics::material}) {
        double const far = apart(model, 1e-2), near = apart(model, 1e-3);
        CHECK(far > 1e-7);
        CHECK(std::log10(far / near) == Approx(2).margin(0.02));
    }
    // tables of the same cam: fourth order in the rows
    accuracy::ReferenceNumbers cosine = given(accuracy::ReferenceShape::cosine);
    accuracy::ReferenceMotion<accuracy::Fifty> const cam(cosine);
    std::vector<double> errors;
    for (int const rows : {16, 32}) {
        accuracy::ReferenceNumbers numbers = given(accuracy::ReferenceShape::table);
        numbers.rows = rows_of_cam(rows, 0);
        accuracy::ReferenceMotion<accuracy::Fifty> const table(numbers);
        double worst = 0;
        for (double const u : {-1.23, -0.61, 0.17, 0.94, 1.4})
            worst = std::max(worst, static_cast<double>(accuracy::length(table.at(accuracy::Fifty(u)).origin -
                                                                         cam.at(accuracy::Fifty(u)).origin)));
        errors.push_back(worst);
    }
    CHECK(errors.back() < 1e-5);
    CHECK(std::log2(errors[0] / errors[1]) == Approx(4).margin(0.6));
}

}  // namespace hdconj::test::study_motion_cases
