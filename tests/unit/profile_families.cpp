// SPDX-License-Identifier: GPL-3.0-or-later
// Each family's flank against its formula by a second path.
#include <numbers>

#include "hdconj/profile/involute.hpp"
#include "hdconj/profile/registry.hpp"
#include "support/catch.hpp"

using namespace hdconj;

namespace {

constexpr double degree = std::numbers::pi / 180;
ToothPlace const drive{0.25, 200, 0.7, 0, "", false, 2, 2};

FamilyChoice choice_of(std::string const& family, std::initializer_list<std::pair<char const*, ParameterValue>> given)
{
    FamilyChoice choice;
    choice.family = family;
    choice.path = "flexspline.profile";
    for (auto const& [key, value] : given)
        choice.given[key] = {value, 1};
    return choice;
}

Profile tooth_of(FamilyChoice const& choice, ToothPlace const& place = drive)
{
    Faults faults;
    Profile tooth = build_profile(choice, place, faults);
    INFO(describe(faults));
    REQUIRE(faults.empty());
    REQUIRE_FALSE(tooth.pieces.empty());
    return tooth;
}

/// Neighbouring pieces meet; inside segments and wherever there is no corner their tangents agree too.
void check_joints(Profile const& tooth, double bend = 1e-13)
{
    for (std::size_t i = 0; i + 1 < tooth.pieces.size(); ++i)
    {
        INFO("after piece " << i << " of segment " << tooth.segment_names[static_cast<std::size_t>(tooth.pieces[i].segment)]);
        PieceEnd const end = end_of(tooth.pieces[i].shape);
        PieceEnd const start = start_of(tooth.pieces[i + 1].shape);
        CHECK((end.point - start.point).norm() < 1e-15);
        CHECK((end.normal - start.normal).norm() < bend);
    }
}

/// Points of the right flank, y from the pitch line, where @p wanted says so of the piece's shape.
template<class Wanted>
std::vector<Vec2> right_points(Profile const& tooth, Wanted&& wanted)
{
    std::vector<Vec2> points;
    for (ProfilePiece const& piece : tooth.pieces)
    {
        bool const right = tooth.segment_names[static_cast<std::size_t>(piece.segment)].starts_with("right");
        if (!right || !wanted(piece))
            continue;
        for (int i = 0; i <= 64; ++i)
            points.push_back(point_at(piece.shape, i / 64.0) - Vec2(0, tooth.pitch_line));
    }
    return points;
}

bool is_curve(ProfilePiece const& piece)
{
    return std::holds_alternative<CurvePiece>(piece.shape);
}

FamilyChoice involute_choice(double alpha_deg, double thickness = 0.36)
{
    return choice_of("involute", {{"addendum", 0.18}, {"dedendum", 0.26}, {"pressure_angle_deg", alpha_deg}, {"thickness", thickness}});
}

/// Largest distance of the involute's points from the string construction: a point at radius q stands at the polar angle
/// s/(2 r) + inv(alpha) - inv(acos(r_b/q)), and an involute turned by d about the centre moves by r_b d along its normal.
double involute_error(Profile const& tooth, double alpha_deg, double thickness, ToothPlace const& place)
{
    using Long = long double;
    Long const r = Long(place.module) * place.teeth / 2;
    Long const alpha = Long(alpha_deg) * std::numbers::pi_v<Long> / 180;
    Long const base = r * std::cos(alpha);
    auto const roll_less_angle = [](Long t) { return t - std::atan(t); };
    Long worst = 0;
    for (Vec2 const& p : right_points(tooth, is_curve))
    {
        Long const q = std::hypot(Long(p.x()), r + p.y());
        Long const roll = std::sqrt((q - base) * (q + base)) / base;
        Long const polar = std::atan2(Long(p.x()), r + p.y());
        Long const wanted = Long(thickness) / (2 * r) + roll_less_angle(std::tan(alpha)) - roll_less_angle(roll);
        worst = std::max(worst, std::abs(base * (polar - wanted)));
    }
    return static_cast<double>(worst);
}

}  // namespace

TEST_CASE("an involute tooth is what a string draws that leaves its base circle", "[profile][involute]")
{
    for (double alpha : {3.0, 5.0, 10.0, 20.0, 28.0})
        for (int teeth : {30, 200, 5000})
        {
            INFO(alpha << " degrees, " << teeth << " teeth");
            ToothPlace const place{0.25, teeth, 0.7, 0, "", false, 2, 2};
            Profile const tooth = tooth_of(involute_choice(alpha), place);
            check_joints(tooth, 1e-10);
            CHECK(involute_error(tooth, alpha, 0.36, place) < 1e-14 * 0.44);
            auto const points = right_points(tooth, [](ProfilePiece const&) { return true; });
            CHECK(points.front().y() == Approx(0.18).epsilon(1e-14));
            CHECK(points.back().y() == Approx(-0.26).epsilon(1e-14));
        }
}

TEST_CASE("an involute's thickness is half the pitch when absent", "[profile][involute]")
{
    FamilyChoice choice = involute_choice(20);
    choice.given.erase("thickness");
    Profile const tooth = tooth_of(choice);
    CHECK(involute_error(tooth, 20, std::numbers::pi * 0.125, drive) < 5e-15);
}

TEST_CASE("below the base circle an involute tooth is radial", "[profile][involute]")
{
    // r_b = 25 cos 5 deg lies 0.095 below the pitch circle, the root 0.26
    Profile const tooth = tooth_of(involute_choice(5));
    CHECK(tooth.segment_names.back() == "right radial line");
    auto const& line = std::get<LinePiece>(tooth.pieces.back().shape);
    Vec2 const centre{0, tooth.pitch_line - 25};
    CHECK(std::abs(cross(line.tangent(), (line.a - centre).normalized())) < 1e-11);
    CHECK((line.a - centre).norm() == Approx(25 * std::cos(5 * degree)).margin(1e-6));
    CHECK(tooth_of(involute_choice(20)).segment_names.back() == "right involute");
    // the arc at the base circle leaves the involute by less than 1e-12 of the height
    for (ProfilePiece const& piece : tooth.pieces)
        if (auto const* arc = std::get_if<ArcPiece>(&piece.shape); arc != nullptr && !piece.corner)
            CHECK(arc->length() < 1e-5);
}

TEST_CASE("a root within nanometres of the base circle is no special case", "[profile][involute]")
{
    double const base_depth = 25 - (25 * std::cos(5 * degree));
    for (double off : {0.0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9, 1e-7, -1e-7})
    {
        INFO(off);
        FamilyChoice choice = involute_choice(5);
        choice.given["dedendum"] = {base_depth + off, 1};
        Profile const tooth = tooth_of(choice);
        for (Vec2 const& p : polygon_of(tooth, 1e-4))
            REQUIRE(p.allFinite());
        for (ProfilePiece const& piece : tooth.pieces)
            REQUIRE(end_of(piece.shape).normal.norm() == Approx(1));
        check_joints(tooth, 1e-3);
    }
}

TEST_CASE("the involute tooth of a circular spline is the space of an external one", "[profile][involute]")
{
    // s + s' = pitch: the flanks of the external tooth and of the internal one on the same pitch circle are the same curve
    double const pitch = std::numbers::pi * 0.25;
    ToothPlace const inside{0.25, 202, 0, 0, "", true, 2, 2};
    ToothPlace const outside{0.25, 202, 0.7, 0, "", false, 2, 2};
    Profile const internal = tooth_of(involute_choice(20, pitch - 0.36), inside);
    check_joints(internal);
    double const r = 25.25;
    std::vector<Vec2> turned;
    // seen from the centre, the middle of the space lies half a pitch from the middle of the tooth
    for (Vec2 const& p : right_points(internal, is_curve))
    {
        Vec2 const from_centre{-p.x(), r - p.y()};
        double const half_pitch = std::numbers::pi / 202;
        turned.push_back({from_centre.x() * std::cos(half_pitch) + from_centre.y() * std::sin(half_pitch),
                          -from_centre.x() * std::sin(half_pitch) + from_centre.y() * std::cos(half_pitch) - r});
    }
    double const alpha = 20 * degree;
    double const base = r * std::cos(alpha);
    for (Vec2 const& p : turned)
    {
        double const q = std::hypot(p.x(), r + p.y());
        double const roll = std::sqrt((q - base) * (q + base)) / base;
        double const wanted = 0.36 / (2 * r) + std::tan(alpha) - alpha - (roll - std::atan(roll));
        CHECK(std::abs(base * (std::atan2(p.x(), r + p.y()) - wanted)) < 2e-14);
    }
    Faults faults;
    CHECK(build_profile(involute_choice(5), inside, faults).pieces.empty());
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0].reason, ContainsSubstring("base circle"));
}

TEST_CASE("a pointed involute tooth is refused with the height of its point", "[profile][involute]")
{
    FamilyChoice choice = involute_choice(30);
    choice.given["addendum"] = {0.35, 1};
    Faults faults;
    CHECK(build_profile(choice, drive, faults).pieces.empty());
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].path == "flexspline.profile.addendum");
    CHECK_THAT(faults[0].reason, ContainsSubstring("becomes pointed at height 0.306"));
    choice.given["addendum"] = {0.306, 1};
    (void)tooth_of(choice);
}
