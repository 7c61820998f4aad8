// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The oracle against itself and against numbers computed elsewhere: a law is worth what its judge
/// is worth.
#include "support/catch.hpp"
#include "support/oracle/envelope.hpp"
#include "support/oracle/run.hpp"
#include "support/oracle/sweep.hpp"
#include "support/oracle/touch_law.hpp"

namespace hdconj::test::oracle_cases {

using namespace oracle;
using hdconj::Kinematics;
using hdconj::Scene;

namespace {

double in_degrees(double angle)
{
    return angle * 180 / pi<double>();
}

/// Positions of contact, as the undeformed angle in degrees, of the end of a right piece.
std::vector<double> contacts_of_end(Scene const& scene, std::string const& piece, double t, bool closed = true)
{
    Tooth<double> const tooth(scene);
    Motion<double> const motion(scene, closed);
    for (std::size_t i = 0; i < tooth.pieces_of_whole(); ++i) {
        if (tooth.name_of_whole(i) != piece)
            continue;
        std::vector<double> found;
        for (double const s : contact_positions(motion, tooth.on_whole(i, t)))
            found.push_back(in_degrees(motion.phi(s)));
        return found;
    }
    throw std::invalid_argument("no piece " + piece);
}

}  // namespace

TEST_CASE("oracle: the tooth is the one of the drawing", "[oracle]")
{
    // Tangent arcs of type-50, computed by hand from the table.
    Tooth<double> const tooth(type_50());
    REQUIRE(tooth.flank.size() == 4);
    CHECK(tooth.flank[0].centre.x == Approx(0.683525).margin(1e-6));
    CHECK(tooth.flank[0].upper.x == Approx(0.170910).margin(1e-6));
    CHECK(tooth.flank[0].upper.y == Approx(0.023099).margin(1e-6));
    CHECK(tooth.half_thickness(0.0) == Approx(0.17342).margin(1e-5));
    CHECK(tooth.half_thickness(-0.303) == Approx(0.32612).margin(1e-5));
    CHECK(tooth.pitch_line == Approx(0.653).margin(1e-15));

    // Lengths of the paper's flank: tip to joint, joint to joint, to the root.
    Tooth<double> const liu(liu_2025());
    REQUIRE(liu.flank.size() == 4);
    CHECK(liu.flank[2].arc_length() == Approx(0.292285).margin(1e-6));
    CHECK(liu.flank[1].arc_length() == Approx(0.131875).margin(1e-6));
    CHECK(liu.flank[0].arc_length() == Approx(0.726331 - 0.424159).margin(2e-6));
    CHECK(liu.tip_corner().x == Approx(0.186135).margin(1e-6));
    CHECK(liu.root().x == Approx(0.501199).margin(1e-6));
}

TEST_CASE("oracle: neighbouring pieces meet and normals are continuous where the profile is smooth", "[oracle]")
{
    for (Scene const& scene : {type_50(), liu_2025()}) {
        Tooth<double> const tooth(scene);
        for (std::size_t i = 0; i + 1 < tooth.pieces_of_whole(); ++i) {
            INFO(tooth.name_of_whole(i) << " to " << tooth.name_of_whole(i + 1));
            auto const end = tooth.on_whole(i, 1.0), start = tooth.on_whole(i + 1, 0.0);
            CHECK(length(end.point - start.point) < 1e-15);
            bool const corner = tooth.name_of_whole(i) == "tip" || tooth.name_of_whole(i + 1) == "tip";
            CHECK((dot(end.normal, start.normal) > 1 - 1e-14) == !corner);
        }
    }
}

TEST_CASE("oracle: distance to the tooth", "[oracle]")
{
    for (Scene const& scene : {type_50(), liu_2025()}) {
        Tooth<double> const tooth(scene);
        Tooth<Fifty> const exact(scene);
        // A step along the normal is a distance, on both sides.
        for (std::size_t i = 0; i < tooth.pieces_of_whole(); ++i)
            for (double const t : {0.0, 0.2, 0.5, 0.9, 1.0})
                for (double const step : {-1e-3, -1e-9, 1e-9, 1e-3}) {
                    auto const on = tooth.on_whole(i, t);
                    bool const corner = (t == 0.0 || t == 1.0) && step < 0;
                    if (!corner)
                        CHECK(tooth.distance(on.point + step * on.normal) == Approx(step).epsilon(0).margin(1e-15));
                }
        double worst = 0;
        for (double x = -0.8; x < 0.8; x += 0.037)
            for (double y = -0.28; y < 0.5; y += 0.0213)
                worst = std::max(worst,
                                 std::abs(tooth.distance_from_pitch_line({x, y}) -
                                          static_cast<double>(exact.distance_from_pitch_line({Fifty(x), Fifty(y)}))));
        CHECK(worst < 1e-15);
    }
}

TEST_CASE("oracle: the neutral curve closes", "[oracle]")
{
    Motion<Fifty> const motion(type_50());
    // design value, and leading term of the theory -w0^2 / r_m
    CHECK(static_cast<double>(motion.r_0 - motion.r_m) == Approx(-2.567e-3).margin(5e-7));
    CHECK(static_cast<double>(motion.r_0 - motion.r_m) ==
          Approx(static_cast<double>(-motion.w0 * motion.w0 / motion.r_m)).epsilon(1e-3));

    GaussLegendre<Fifty> const rule(30);
    Fifty const turn = motion.phi_by_quadrature(2 * pi<Fifty>(), rule, 8);
    CHECK(static_cast<double>(abs(turn - 2 * pi<Fifty>())) < 1e-45);
}

TEST_CASE("oracle: two quadratures and three number types agree on the motion", "[oracle]")
{
    GaussLegendre<Fifty> const rule(30);
    for (Scene const& scene :
         {type_50(), liu_2025(), type_50(Kinematics::first_order), liu_2025(Kinematics::material)}) {
        Motion<Fifty> const exact(scene);
        Motion<double> const quick(scene);
        Motion<long double> const middle(scene);
        for (double s = -3.1; s < 3.2; s += 0.61) {
            CHECK(static_cast<double>(abs(exact.phi(Fifty(s)) - exact.phi_by_quadrature(Fifty(s), rule, 8))) < 1e-45);
            auto const pose = exact.pose(Fifty(s));
            CHECK(length(as<double>(pose.origin) - quick.pose(s).origin) < 5e-14);
            CHECK(length(as<double>(pose.along) - quick.pose(s).along) < 3e-15);
            CHECK(static_cast<double>(length(as<long double>(pose.origin) - middle.pose(s).origin)) < 1e-17);
            // a rigid, direct frame
            CHECK(static_cast<double>(abs(dot(pose.along, pose.along) - 1)) < 1e-45);
            CHECK(static_cast<double>(abs(pose.along.x * pose.outward.y - pose.along.y * pose.outward.x - 1)) < 1e-45);
        }
    }
}

TEST_CASE("oracle: after a lobe the motion repeats, moved by whole pitches", "[oracle]")
{
    for (Scene const& scene : {type_50(), liu_2025(Kinematics::first_order), type_50(Kinematics::material)}) {
        Motion<double> const motion(scene);
        double const angle = motion.pitches_per_turn * motion.pitch() / motion.waves;
        for (double const s : {-1.2, -0.1, 0.0, 0.7}) {
            auto const now = motion.pose(s), later = motion.pose(s + 2 * motion.half_lobe());
            CHECK(length(turned_clockwise(now.origin, angle) - later.origin) < 1e-13);
            CHECK(length(turned_clockwise(now.outward, angle) - later.outward) < 1e-14);
        }
    }
}

TEST_CASE("oracle: intervals of contact agree with an independent program", "[oracle]")
{
    // Numbers of another program for the ends of the flank, undeformed angle in degrees. It left the
    // neutral curve unclosed, r_0 = r_m: so does the oracle here. Closing it moves them by 0.4 degrees.
    struct Row
    {
        Kinematics kinematics;
        char const* piece;
        double t, first, second;
    };
    Scene liu = liu_2025();
    for (Row const& row : {Row{Kinematics::exact, "right convex", 0, 1.818, 60.808},
                           Row{Kinematics::exact, "right concave", 1, -0.656, 58.284},
                           Row{Kinematics::first_order, "right convex", 0, 1.476, 59.525},
                           Row{Kinematics::first_order, "right concave", 1, -0.997, 56.922}}) {
        liu.solver.kinematics = row.kinematics;
        auto const found = contacts_of_end(liu, row.piece, row.t, false);
        REQUIRE(found.size() == 2);
        CHECK(found[0] == Approx(row.first).epsilon(0).margin(6e-4));
        CHECK(found[1] == Approx(row.second).epsilon(0).margin(6e-4));
    }
    Scene plain = type_50();
    plain.flexspline.profile.given.erase("tip_line_from");
    auto const tip = contacts_of_end(plain, "right convex", 0, false);
    auto const root = contacts_of_end(plain, "right concave", 1, false);
    REQUIRE(tip.size() == 2);
    REQUIRE(root.size() == 2);
    CHECK(tip[0] == Approx(0.998).epsilon(0).margin(6e-4));
    CHECK(tip[1] == Approx(72.469).epsilon(0).margin(6e-4));
    CHECK(root[0] == Approx(-0.336).epsilon(0).margin(6e-4));
    CHECK(root[1] == Approx(64.655).epsilon(0).margin(6e-4));
}

TEST_CASE("oracle: its own envelope points obey the touch law", "[oracle]")
{
    for (Scene const& scene : {type_50(), liu_2025(), type_50(Kinematics::first_order)}) {
        TouchScan scan(scene);
        double const tip = designs::tip_circle(scene);
        std::size_t asked = 0, touched = 0;
        double shallow = 0;
        for (auto const& contact : envelope_points<double>(scene, 20)) {
            if (length(contact.point) < tip)
                continue;
            ++asked;
            double const distance = scan.nearest(contact.point).distance;
            // On the tooth at its own position, so never outside of all of them.
            CHECK(distance < 1e-12);
            if (distance > -touch_limit) {
                ++touched;
                shallow = std::min(shallow, distance);
            } else
                CHECK(distance < -1e-7);  // clearly inside: nothing in between
        }
        CHECK(asked > 150);
        CHECK(touched > asked / 2);
        CHECK(touched < asked);
        CHECK(shallow > -1e-12);
    }
}

TEST_CASE("oracle: a scan twice as fine finds the same smallest distance", "[oracle]")
{
    designs::RandomDesigns draw(7);
    for (int i = 0; i < 12; ++i) {
        Scene const scene = draw.next();
        TouchScan coarse(scene), fine(scene, 7001);
        double const tip = designs::tip_circle(scene), half_pitch = coarse.motion.pitch() / 2;
        for (int k = 0; k <= 20; ++k) {
            double const angle = half_pitch * (k - 10) / 10.0, radius = tip + 0.04 * k * scene.drive.module;
            Point<double> const p{radius * std::sin(angle), radius * std::cos(angle)};
            CHECK(coarse.nearest(p).distance == Approx(fine.nearest(p).distance).epsilon(0).margin(1e-11));
        }
    }
}

TEST_CASE("oracle: the union of tooth positions obeys the touch law within its stated error", "[oracle]")
{
    for (Scene const& scene : {type_50(), liu_2025()}) {
        double const tip = designs::tip_circle(scene);
        auto const swept = swept_boundary(scene, tip, 4000, 4e-6);
        TouchScan scan(scene);
        std::size_t asked = 0;
        for (auto const& loop : swept.loops)
            for (auto const& p : loop) {
                if (length(p) < tip + 1e-3 || std::abs(std::atan2(p.x, p.y)) > scan.motion.pitch() / 2 || ++asked % 10)
                    continue;
                CHECK(std::abs(scan.nearest(p).distance) < swept.error);
            }
        CHECK(asked > 1000);
    }
}

TEST_CASE("random designs: the text reads back as the same scene", "[oracle]")
{
    designs::RandomDesigns draw(3);
    for (int i = 0; i < 50; ++i) {
        Scene const scene = draw.next();
        Scene const read = as_read(scene);
        CHECK(read.drive.module == scene.drive.module);
        CHECK(read.flexspline.wall == scene.flexspline.wall);
        CHECK(read.flexspline.inner_radius == scene.flexspline.inner_radius);
        CHECK(read.flexspline.neutral_offset == scene.flexspline.neutral_offset);
        CHECK(read.wave_generator.waves == scene.wave_generator.waves);
        CHECK(read.circular_spline.backlash_offset == scene.circular_spline.backlash_offset);
        CHECK(read.solver.kinematics == scene.solver.kinematics);
        for (auto const& [key, parameter] : scene.flexspline.profile.given) {
            INFO(key);
            REQUIRE(given(read.flexspline.profile, key));
            CHECK(read.flexspline.profile.given.find(key)->second.value == parameter.value);
        }
    }
}

}  // namespace hdconj::test::oracle_cases
