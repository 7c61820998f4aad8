// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A whole tooth that is symmetric to the last digit, flat or crowned at its tip: a contact passes the joint on its
/// centre line at the very ends of the lobe. Its contacts are those of its mirror image, and none is in doubt.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drive/drive.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "profile/measured_points.hpp"
#include "support/catch.hpp"
#include "support/draws.hpp"
#include "support/type50.hpp"

namespace hdconj::test::symmetric_tips_cases {
namespace {

/// Points of a whole tooth for the module 0.25 mm, @p scale times as large, @p tip of them from edge to edge of its
/// tip, which is crowned by @p crown [mm].
std::vector<Vec2> tooth_points(int tip, double crown, double scale)
{
    std::vector<Vec2> points{{-0.3348, -0.28}, {-0.3024, -0.24}, {-0.274, -0.2},   {-0.2496, -0.16},
                             {-0.2292, -0.12}, {-0.2128, -0.08}, {-0.2004, -0.04}, {-0.192, 0.0},
                             {-0.18256, 0.04}, {-0.16704, 0.08}, {-0.14544, 0.12}, {-0.11776, 0.16}};
    double const edge = 0.084, height = 0.2;
    for (int i = 0; 2 * i < tip - 1; ++i) {
        double const share = 1 - 2.0 * i / (tip - 1);
        points.emplace_back(-edge * share, height + crown * (1 - share * share));
    }
    for (Vec2& point : points)
        point *= scale;
    std::vector<Vec2> whole = points;
    if (tip % 2 == 1)
        whole.emplace_back(0, scale * (height + crown));
    for (std::size_t i = points.size(); i-- > 0;)
        whole.emplace_back(-points[i].x(), points[i].y());
    return whole;
}

std::string scene_text(std::vector<Vec2> const& points, double module, std::string const& cam)
{
    std::string rows;
    for (Vec2 const& point : points)
        rows += "[" + std::to_string(point.x()) + ", " + std::to_string(point.y()) + "],\n";
    return "[drive]\nname = \"tips\"\nmodule = " + std::to_string(module) +
           "\nflexspline_teeth = 200\ncircular_spline_teeth = 202\n[flexspline]\nwall = " +
           std::to_string(2.8 * module) + "\n[flexspline.profile]\nfamily = \"b-spline\"\nside = \"full\"\npoints = [" +
           rows + "]\n[wave_generator]\nfamily = \"" + cam + "\"\nradial_deformation = " + std::to_string(module) +
           "\nwaves = 2\n";
}

/// Arcs of @p image that are not the mirror image of one of @p arcs, of which either has as many.
int without_image(std::vector<envelope::ContactArc> const& arcs, std::vector<envelope::ContactArc> const& image)
{
    constexpr double same = 1e-6;  // two contacts that merge are known to the root of rounding
    auto const is_image = [&](envelope::ContactArc const& a, envelope::ContactArc const& b) {
        return std::max({std::abs(a.u_begin + b.u_end), std::abs(a.u_end + b.u_begin),
                         std::abs(a.t_begin + b.t_end - 1), std::abs(a.t_end + b.t_begin - 1)}) < same;
    };
    auto const is_long = [](envelope::ContactArc const& arc) { return arc.u_end - arc.u_begin > 1e-9; };
    int missing = 0;
    for (envelope::ContactArc const& a : image)
        missing += is_long(a) && std::none_of(arcs.begin(), arcs.end(),
                                              [&](envelope::ContactArc const& b) { return is_image(a, b); });
    return missing;
}

}  // namespace

TEST_CASE("symmetric tips: every branch of a tooth with a flat or crowned tip is found", "[envelope]")
{
    for (std::string const cam : {"cosine", "ellipse"})
        for (double const module : {0.25, 1.25})
            for (int const tip : {3, 5, 7, 9, 15})
                for (double const crown : {0.0, 0.004}) {
                    CAPTURE(cam, module, tip, crown);
                    Scene const scene =
                        parse_scene(scene_text(tooth_points(tip, crown, module / 0.25), module, cam), "tips");
                    Faults faults;
                    profile::Profile const tooth = drive::given_tooth(scene, faults);
                    wavegen::AnyWaveShape const shape = drive::wave_shape(scene, tooth, faults);
                    REQUIRE(faults.empty());
                    motion::ExactMotion<wavegen::AnyWaveShape> const motion(
                        wavegen::NeutralCurve<wavegen::AnyWaveShape>(shape, drive::pair_geometry(scene).r_m),
                        type50_ratio);
                    envelope::BranchSet const set = envelope::find_branches(envelope::Envelope(tooth, motion, 0), 1);
                    for (envelope::RootDoubt const& doubt : set.record.doubts)
                        CHECK(doubt.reach < 1e-9);
                }
}

TEST_CASE("symmetric tips: contacts beside the centre line are those of the mirror image", "[envelope]")
{
    designs::Draws random(7);
    int missing = 0, arcs = 0;
    for (int k = 0; k < 1500; ++k) {
        double const scale = random.between(0.3, 3), module = 0.25 * scale;
        std::vector<Vec2> const points =
            tooth_points(random.whole(2, 10) * 2 - 1, random.between(-0.004, 0.01) * random.whole(0, 1), scale);
        int const waves = random.whole(1, 3);
        double const teeth = random.whole(60, 240);
        profile::Profile tooth;
        tooth.segment_names = {"tooth"};
        for (profile::CurvePiece const& piece : profile::spline_through(points)) {
            double const begin = static_cast<double>(tooth.pieces.size());
            tooth.pieces.push_back({piece, 0, begin, begin + 1, false});
        }
        tooth = profile::moved_up(tooth, 0.63 * scale);
        Exact const motion(
            wavegen::NeutralCurve<wavegen::CosineCam>(
                wavegen::CosineCam{module * waves / 2 * random.between(0.6, 1.4), waves}, module * teeth / 2),
            teeth / (teeth + waves));
        std::vector<motion::RatesModel> const rates{
            motion::rates_model(motion, -motion.half_lobe(), motion.half_lobe())};
        envelope::Envelope const envelope(tooth, motion, 0);
        envelope::TraceRecord record;
        int const right = static_cast<int>(tooth.pieces.size() / 2);
        auto const of_left = envelope::trace_piece(envelope, rates, right - 1, record);
        auto const of_right = envelope::trace_piece(envelope, rates, right, record);
        missing += without_image(of_left, of_right) + without_image(of_right, of_left);
        arcs += static_cast<int>(of_left.size() + of_right.size());
    }
    CHECK(arcs > 3000);
    CHECK(missing == 0);
}

}  // namespace hdconj::test::symmetric_tips_cases
