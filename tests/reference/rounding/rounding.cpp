// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What docs/explanation/stability.md says about rounding, on the drives it names.
#include <fstream>
#include <sstream>

#include "support/catch.hpp"
#include "support/oracle/envelope.hpp"
#include "support/rounding/cases.hpp"
#include "support/rounding/special.hpp"

namespace hdconj::test::rounding_cases {

using namespace rounding;

namespace {

/// Rounding inside the formulas, on top of that of the numbers they start from: in units of the condition.
constexpr double share_of_formulas = 8;

Steps<Fifty> exact_steps(FourTypes const& drive, Place const& place, Fifty const& u)
{
    Inputs<Fifty> in = drive.in_fifty().inputs(place.piece, place.t, 0, place.sign);
    in.u = u;
    in.phi = drive.in_fifty().motion.phi(u);
    return steps(in);
}

double largest(double a, double b, double c)
{
    return std::max({a, b, c, 1.0});
}

}  // namespace

TEST_CASE("the formulas of the rounding study are those of an envelope", "[reference]")
{
    for (Scene const& scene : {oracle::type_50(), fast_contact()}) {
        FourTypes const drive(scene);
        oracle::Motion<Fifty> const& motion = drive.in_fifty().motion;
        for (Place const& place : places(drive.in_double(), 2)) {
            INFO(drive.scene().drive.name << " piece " << place.piece << " u " << place.u);
            Fifty const u(place.u), step("1e-14");
            Steps<Fifty> const at = exact_steps(drive, place, u), before = exact_steps(drive, place, u - step),
                               after = exact_steps(drive, place, u + step);
            // the oracle's way: frames from tangents, velocities from differences
            CHECK(static_cast<double>(abs(oracle::normal_velocity(motion, {at.contact, at.normal}, u))) < 1e-30);
            CHECK(static_cast<double>(length(motion.pose(u).to_circular_spline(at.contact) - at.point)) < 1e-40);
            // the point moves along the tangent, at the speed given
            Point<Fifty> const moved = (1 / (2 * step)) * (after.point - before.point);
            Point<Fifty> const tangent{at.across.y, -at.across.x};
            Fifty const size = abs(at.speed) + 1;
            CHECK(static_cast<double>(abs(dot(moved, at.across)) / size) < 1e-15);
            CHECK(static_cast<double>(abs(dot(moved, tangent) - at.speed) / size) < 1e-15);
        }
    }
}

TEST_CASE("every number type loses what the condition says and no type more", "[reference]")
{
    for (auto const& [name, scene] : cases()) {
        FourTypes const drive(scene);
        Losses in_float{}, in_double{}, in_long_double{};
        // coordinates of this size make the point, and angles up to a lobe turn it
        double size = drive.in_double().motion.r_m;
        for (auto const& piece : drive.in_double().tooth.flank)
            size = std::max(size, 2 * std::abs(piece.radius));
        double const across = 6 * size / static_cast<double>(drive.height());
        for (Place const& place : places(drive.in_double(), 4)) {
            Contact const c = drive(place);
            INFO(name << ": " << c.piece << " at u " << place.u);
            CHECK(c.condition[judged_across] < across);
            for (std::size_t i = 0; i < judged_count; ++i) {
                INFO(judged_names[i] << ", condition " << c.condition[i]);
                double const allowed = share_of_formulas * (i == judged_across ? across : c.condition[i] + 1);
                CHECK(c.in_float[i] < allowed);
                CHECK(c.in_double[i] < allowed);
                CHECK(c.in_long_double[i] < allowed);
                CHECK(c.in_program[i] < allowed);
                in_float[i] = std::max(in_float[i], c.in_float[i]);
                in_double[i] = std::max(in_double[i], c.in_double[i]);
                in_long_double[i] = std::max(in_long_double[i], c.in_long_double[i]);
            }
        }
        // the digits go in the drive, not in the type
        for (Judged step : {judged_velocity, judged_across}) {
            INFO(name << ": " << judged_names[step]);
            double const most = largest(in_float[step], in_double[step], in_long_double[step]);
            double const least = std::max(1.0, std::min({in_float[step], in_double[step], in_long_double[step]}));
            CHECK(most / least < 100);
        }
    }
}

TEST_CASE("folds and cusps do not disturb the envelope", "[reference]")
{
    FourTypes const drive(swallowtail());
    std::size_t const concave = 0;
    int const sign = place_at(drive.in_double(), concave, 0.5, 0.1).sign;
    Fifty const cusp =
        special_position(drive, concave, sign, 0.003, [](auto const& s, auto const&) { return s.speed; });
    for (int k = 3; k < 12; ++k) {
        double const u = static_cast<double>(cusp) + std::pow(10.0, -k);
        Inputs<Fifty> const in = drive.in_fifty().inputs(concave, 0.5, u, sign);
        Losses const wrong =
            errors(steps(drive.in_double().inputs(concave, 0.5, u, sign)), steps(in), in, drive.height());
        INFO("1e-" << k << " after the cusp");
        double const roundoff = std::numeric_limits<double>::epsilon();
        double const r_m = static_cast<double>(drive.in_fifty().motion.r_m),
                     height = static_cast<double>(drive.height());
        CHECK(wrong[judged_across] < 3 * roundoff * r_m / height);
        // the speed is right to roundoff of what it is the difference of: its sign is lost that near only
        CHECK(wrong[judged_speed] < 1e4 * roundoff * std::pow(10.0, k));
    }
}

TEST_CASE("the table of conditions is that of the program beside it", "[reference]")
{
    std::ifstream in(std::string(HDCONJ_SOURCE_DIR) + "/data/reference/rounding-cases.csv");
    FourTypes const drive(oracle::type_50());
    Losses worst{};
    for (Place const& place : places(drive.in_double(), 24)) {
        Losses const condition = drive(place).condition;
        for (std::size_t i = 0; i < judged_count; ++i)
            worst[i] = std::max(worst[i], condition[i]);
    }
    std::size_t row = 0;
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("type-50,"))
            continue;
        std::istringstream fields(line);
        std::string name, step, condition;
        std::getline(fields, name, ',');
        std::getline(fields, step, ',');
        std::getline(fields, condition, ',');
        REQUIRE(row < judged_count);
        CHECK(step == judged_names[row]);
        // the file has three digits
        CHECK(std::stod(condition) == Approx(worst[row]).epsilon(0.01));
        ++row;
    }
    CHECK(row == judged_count);
}

}  // namespace hdconj::test::rounding_cases
