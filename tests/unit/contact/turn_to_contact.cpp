// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/turn_to_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contact/gap_field.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/oracle/tooth.hpp"

namespace hdconj::test::turn_to_contact_cases {

namespace {

/// At and between the points of the flanks, after a turn.
double smallest(contact::GapField const& field, double turn, int flank)
{
    return contact::smallest_gap(field, field.map(turn, 1), turn, flank, 1).gap;
}

/// All teeth turned clockwise by @p angle about the axis, as the flexspline itself turns.
contact::ToothPoses turned(contact::ToothPoses places, double angle)
{
    for (Pose& pose : places.pose) {
        double const theta = std::atan2(pose.sine, pose.cosine) + angle;
        pose = {std::cos(theta), std::sin(theta), turned_clockwise(pose.origin, angle)};
    }
    return places;
}

/// Field of the built-in pair, or of its coned form, with a side clearance.
struct Pair
{
    Pair(std::vector<std::string> const& keys, int slices, double clearance, double phase = 0, double turned_by = 0)
        : drive(builtin_scene(keys), slices),
          grid(contact::moved_into_material(
              drive.flanks(drive.surface(slices > 1 ? ToothSurface::per_slice : ToothSurface::tilted), 60), clearance)),
          places(turned(contact::tooth_places(*drive.context, phase, drive.context->maker.z()), turned_by)),
          field(drive.tooth, grid, places, drive.z_f(), drive.z_c(), phase),
          rest(field.map(0, 1))
    {
    }
    ConedDrive drive;
    contact::FlankGrid grid;
    contact::ToothPoses places;
    contact::GapField field;
    GapMap rest;
};

constexpr double enough = 1e-12;  // mm

/// Few teeth, so that z_c/z_f is far from 1; 10 um of side clearance are laid on afterwards.
constexpr char const* thirty_teeth = R"([drive]
name = "thirty teeth"
module = 0.5
flexspline_teeth = 30
circular_spline_teeth = 32
[flexspline]
wall = 0.6
[flexspline.profile]
family = "double-circular-arc"
addendum = 0.35
dedendum = 0.606
convex_radius = 0.5402
convex_offset = 0.1964
concave_radius = 1.029
concave_offset = "tangent"
concave_rise = 0.1342
[wave_generator]
family = "cosine"
radial_deformation = 0.5
waves = 2
[circular_spline]
width = 5.0
)";

/// All teeth of the flexspline about a held wave generator, by the oracle's tooth and motion.
class HeldWave
{
  public:
    explicit HeldWave(Scene const& scene)
        : z_f_(scene.drive.flexspline_teeth),
          k_(static_cast<double>(z_f_) / scene.drive.circular_spline_teeth),
          tooth_(scene),
          motion_(scene)
    {
    }

    /// The least distance of @p points [mm] with the flexspline turned so far that tooth 0 has the undeformed angle @p
    /// phase: its teeth have moved along the neutral curve.
    [[nodiscard]] double least(std::vector<Vec2> const& points, double phase) const
    {
        double best = std::numeric_limits<double>::infinity();
        for (int i = 0; i < z_f_; ++i) {
            double const phi = 2 * std::numbers::pi * i / z_f_ + phase;
            oracle::Pose<double> pose = motion_.pose(oracle_parameter(motion_, phi), phi);
            for (auto* v : {&pose.origin, &pose.along, &pose.outward})
                *v = oracle::turned_clockwise(*v, k_ * phi);
            for (Vec2 const& p : points) {
                oracle::Point<double> const x = pose.to_tooth({p.x(), p.y()});
                if (x.y > 0 && std::abs(x.x) < 3 * tooth_.half_width)
                    best = std::min(best, tooth_.distance(x));
            }
        }
        return best;
    }

  private:
    int z_f_;
    double k_;
    oracle::Tooth<double> tooth_;
    oracle::Motion<double> motion_;
};

/// Right flanks of all spaces in the fixed frame, the circular spline turned clockwise by @p angle.
std::vector<Vec2> right_flanks(contact::GapField const& field, double angle)
{
    std::vector<Vec2> points;
    for (std::size_t space = 0; space < field.spaces(); ++space)
        for (Vec2 const& p : field.grid().point[GapMap::right][0])
            points.push_back(turned_clockwise(p, field.space_angle(space) + angle));
    return points;
}

/// Where @p gap, positive at 0, becomes zero.
template <class Gap>
double first_zero(Gap const& gap, double high)
{
    REQUIRE(gap(0.0) > 0);
    REQUIRE(gap(high) < 0);
    double low = 0;
    for (int i = 0; i < 40; ++i)
        (gap(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    return low;
}

}  // namespace

TEST_CASE(
    "turn to contact is the turn of the circular spline, and z_f/z_c times that of a flexspline that moves along its "
    "neutral "
    "curve",
    "[turn_to_contact]")
{
    ConedDrive drive(parse_scene(thirty_teeth, "thirty-teeth.toml", {}), 1, 1, 5.0);
    contact::FlankGrid const grid =
        contact::moved_into_material(drive.flanks(drive.surface(ToothSurface::tilted), 400), 0.01);
    HeldWave const teeth(drive.scene);
    double const ratio = static_cast<double>(drive.z_c()) / drive.z_f();
    constexpr double between_points = 3e-4;  // the flanks are points here
    for (double const phase : {0.0, 0.03, -0.07}) {
        INFO("phase " << phase);
        auto const field_at = [&](contact::ToothPoses const& places, double at) {
            return contact::GapField(drive.tooth, grid, places, drive.z_f(), drive.z_c(), at);
        };
        contact::ToothPoses const places = contact::tooth_places(*drive.context, phase, drive.context->maker.z());
        contact::GapField const field = field_at(places, phase);
        double const turn = contact::turn_to_contact(field, field.map(0, 1), GapMap::right, drive.pitch(), 1).turn;
        // wave generator and flexspline held, the circular spline turned against the teeth
        double const spline =
            first_zero([&](double x) { return teeth.least(right_flanks(field, -x), phase); }, 2 * turn);
        CHECK(spline == Approx(turn).epsilon(between_points));
        // wave generator and circular spline held, the flexspline turned: to first order at the same angle of the wave
        // generator
        std::vector<Vec2> const flanks = right_flanks(field, 0);
        double const flexspline = first_zero([&](double x) { return teeth.least(flanks, phase + x); }, 2 * turn);
        constexpr double first_order = 2e-3;
        CHECK(flexspline == Approx(ratio * turn).epsilon(first_order));
        // and exactly from where the wave generator stands as far back as the flexspline is turned
        contact::ToothPoses const back =
            contact::tooth_places(*drive.context, phase - ratio * turn, drive.context->maker.z());
        contact::GapField const before = field_at(back, phase - ratio * turn);
        std::vector<Vec2> const held = right_flanks(before, 0);
        CHECK(first_zero([&](double x) { return teeth.least(held, phase - ratio * turn + x); }, 2 * turn) ==
              Approx(ratio * turn).epsilon(between_points));
    }
}

TEST_CASE("turn to contact ends where the smallest gap is zero and not before", "[turn_to_contact]")
{
    for (double const phase : {0.0, 0.004, -0.011})
        for (int const slices : {1, 3}) {
            Pair const pair(slices > 1 ? coned() : std::vector<std::string>{}, slices, 0.01, phase);
            REQUIRE(smallest(pair.field, 0, GapMap::right) > 0);
            for (int const flank : {GapMap::left, GapMap::right}) {
                double const sense = flank == GapMap::right ? 1 : -1;
                contact::TurnToContact const found =
                    contact::turn_to_contact(pair.field, pair.rest, flank, pair.drive.pitch(), 1);
                INFO("phase " << phase << ", slices " << slices << ", flank " << flank << ", turn " << found.turn);
                CHECK(found.turn > 0);
                GapMap const touching = pair.field.map(sense * found.turn, 1);
                CHECK(std::abs(smallest(pair.field, sense * found.turn, flank)) < enough);
                CHECK(std::abs(found.gap) < enough);
                // the point beside the smallest gap
                double const beside = touching.at(found.where.space, flank, found.where.slice, found.where.point);
                CHECK(beside > found.gap - enough);
                CHECK(beside < found.gap + 0.5 * pair.field.spacing());
                CHECK(found.where.flank == flank);
                for (int i = 0; i < 16; ++i)
                    CHECK(smallest(pair.field, sense * found.turn * i / 16, flank) > 0);
                CHECK(smallest(pair.field, sense * found.turn * (1 + 1e-6), flank) < 0);
                // no faster than the reach
                CHECK(found.turn * pair.field.reach() >= smallest(pair.field, 0, flank));
                contact::TurnToContact const threaded =
                    contact::turn_to_contact(pair.field, pair.rest, flank, pair.drive.pitch(), 4);
                CHECK(threaded.turn == found.turn);
                CHECK(threaded.gap == found.gap);
            }
        }
}

TEST_CASE("turn to contact of a symmetric pair is the same either way and grows with the side clearance",
          "[turn_to_contact]")
{
    double before = 0;
    for (double const clearance : {1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.02}) {
        Pair const pair({}, 1, clearance);
        contact::TurnToContact const right =
            contact::turn_to_contact(pair.field, pair.rest, GapMap::right, pair.drive.pitch(), 1);
        contact::TurnToContact const left =
            contact::turn_to_contact(pair.field, pair.rest, GapMap::left, pair.drive.pitch(), 1);
        INFO("clearance " << clearance);
        // a turn moves flank points by the radius times a cosine; some flank stands within 60 degrees of the radius
        CHECK(right.turn > clearance / pair.field.reach());
        CHECK(right.turn < 2 * clearance / 25.0 + 1e-6);
        CHECK(left.turn == Approx(right.turn).margin(1e-14));
        CHECK(right.turn > before);
        before = right.turn;
    }
}

TEST_CASE("turn to contact turns back out of interference by as much as the flexspline was turned into it",
          "[turn_to_contact]")
{
    Pair const free({}, 1, 0.01, 0.003);
    double const play = contact::turn_to_contact(free.field, free.rest, GapMap::right, free.drive.pitch(), 1).turn;
    double const play_back = contact::turn_to_contact(free.field, free.rest, GapMap::left, free.drive.pitch(), 1).turn;
    for (double const turn : {0.5 * play, 1.001 * play, 1.5 * play, 3 * play, -0.5 * play_back, -4 * play_back}) {
        Pair const pair({}, 1, 0.01, 0.003, turn);
        INFO("turned by " << turn << " of " << play);
        contact::TurnToContact const right =
            contact::turn_to_contact(pair.field, pair.rest, GapMap::right, pair.drive.pitch(), 1);
        contact::TurnToContact const left =
            contact::turn_to_contact(pair.field, pair.rest, GapMap::left, pair.drive.pitch(), 1);
        CHECK(right.turn == Approx(play - turn).margin(1e-13));
        CHECK(left.turn == Approx(play_back + turn).margin(1e-13));
        CHECK((smallest(pair.field, 0, GapMap::right) < 0) == (turn > play));
        CHECK(std::abs(right.gap) < enough);
    }
}

TEST_CASE("turn to contact without any clearance turns by nothing", "[turn_to_contact]")
{
    Pair const pair({}, 1, 0);
    for (int const flank : {GapMap::left, GapMap::right})
        CHECK(std::abs(turn_to_contact(pair.field, pair.rest, flank, pair.drive.pitch(), 1).turn) < 1e-8);
}

TEST_CASE("turn to contact finds contact anywhere within its limit and says so where there is none",
          "[turn_to_contact]")
{
    Pair const pair({}, 1, 0.01);
    double const turn = contact::turn_to_contact(pair.field, pair.rest, GapMap::right, pair.drive.pitch(), 1).turn;
    for (double const part : {1.001, 1.01, 1.1, 1.3, 1.49, 2.0})
        CHECK(turn_to_contact(pair.field, pair.rest, GapMap::right, part * turn, 1).turn ==
              Approx(turn).margin(32 * unit_roundoff));
    for (double const part : {0.999, 0.5, 1e-3}) {
        CHECK_THROWS_AS(turn_to_contact(pair.field, pair.rest, GapMap::right, part * turn, 1), NumericalError);
        CHECK_THROWS_WITH(turn_to_contact(pair.field, pair.rest, GapMap::right, part * turn, 1),
                          ContainsSubstring("turn to contact") && ContainsSubstring("no flank touches"));
    }
}

}  // namespace hdconj::test::turn_to_contact_cases
