// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/envelope/contact_batch.hpp"

#include <cstddef>
#include <random>
#include <span>
#include <variant>
#include <vector>

#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/envelope/sample.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::contact_batch_cases {

namespace {

/// More than a block and no whole number of vectors.
constexpr int count = 293;

std::vector<double> inside(envelope::ContactArc const& arc)
{
    std::vector<double> u;
    for (int i = 0; i < count; ++i)
        u.push_back(arc.u_begin + (arc.u_end - arc.u_begin) * (i + 0.5) / count);
    return u;
}

bool same(envelope::EnvelopePoint const& a, envelope::EnvelopePoint const& b)
{
    return a.u == b.u && a.t == b.t && a.p == b.p && a.n == b.n && a.error == b.error;
}

/// How far rounding may turn the normal: some roundings of the velocity's terms against its size.
double turn_rounding(profile::ArcPiece const& arc, motion::MotionRates const& rates)
{
    constexpr double roundings = 16;
    return roundings * unit_roundoff * (1 + rates.velocity_size(arc.centre) / rates.twist(arc.centre).norm());
}

}  // namespace

TEST_CASE("contact batch: point for point that of the envelope, on arcs, corners and lines, 1 to 3 waves", "[envelope]")
{
    profile::Profile const tooth = type50_tooth();
    int arcs = 0, corners = 0, lines = 0;
    for (int const waves : {1, 2, 3})
        for (double const offset : {0.0, 0.004}) {
            Exact const motion = type50_motion(waves);
            envelope::Envelope<Exact> const envelope(tooth, motion, offset);
            for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
                for (envelope::ContactArc const& arc : branch.arcs) {
                    auto const batch = envelope::contact_batch(envelope, arc);
                    REQUIRE(batch.has_value() == !arc.resting);
                    if (!batch)
                        continue;
                    profile::PieceShape const& shape = tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
                    auto const* circle = std::get_if<profile::ArcPiece>(&shape);
                    auto const* line = std::get_if<profile::LinePiece>(&shape);
                    ++(line != nullptr ? lines : circle->radius == 0 ? corners : arcs);
                    std::vector<double> const u = inside(arc);
                    std::vector<envelope::EnvelopePoint> points(u.size());
                    envelope::point_batch(envelope, arc, *batch, u, points);
                    double across = 0, beyond = 0, turned = 0, moved = 0, error = 0;
                    bool alone = true;
                    for (std::size_t i = 0; i < u.size(); ++i) {
                        envelope::EnvelopePoint const point = envelope.point(arc, u[i]);
                        Vec2 const gap = points[i].p - point.p;
                        motion::MotionRates const rates = motion.rates(u[i]);
                        double const turn = circle != nullptr ? turn_rounding(*circle, rates) : 16 * unit_roundoff;
                        double const slide = circle != nullptr
                                                 ? turn / std::abs(circle->to - circle->from) + 4 * unit_roundoff
                                                 : point.error / line->length() + 4 * unit_roundoff;
                        across = std::max(across, std::abs(gap.dot(point.n)));
                        beyond = std::max(beyond, gap.norm() - point.error);
                        turned = std::max(turned, (points[i].n - point.n).norm() / turn);
                        moved = std::max(moved, std::abs(points[i].t - point.t) / slide);
                        error = std::max(error, std::abs(points[i].error / point.error - 1));
                        // the same one by one: no point knows its neighbours
                        envelope::EnvelopePoint single;
                        envelope::point_batch(envelope, arc, *batch, std::span(&u[i], 1), std::span(&single, 1));
                        alone = alone && same(single, points[i]);
                    }
                    INFO("waves " << waves << " offset " << offset << " piece " << arc.piece << " u " << arc.u_begin
                                  << " ... " << arc.u_end);
                    // a fast contact is uncertain along the envelope; across it never is
                    CHECK(across < 5e-14);
                    CHECK(beyond < 5e-14);
                    CHECK(turned <= 1);
                    CHECK(moved <= 1);
                    CHECK(error < 1e-6);
                    CHECK(alone);
                    // ends that were solved for are those of the envelope, bit for bit
                    std::vector<double> const ends{arc.u_begin, arc.u_end};
                    std::vector<envelope::EnvelopePoint> at_ends(2);
                    envelope::point_batch(envelope, arc, *batch, ends, at_ends);
                    CHECK(same(at_ends[0], envelope.point(arc, arc.u_begin)));
                    CHECK(same(at_ends[1], envelope.point(arc, arc.u_end)));
                }
        }
    CHECK(arcs > 10);
    CHECK(corners > 6);
    CHECK(lines > 6);
}

TEST_CASE("contact batch: the angle on the undeformed circle, and which motions have a batch", "[envelope]")
{
    Exact const motion = type50_motion();
    auto const batch = motion::cosine_form(motion);
    REQUIRE(batch.has_value());
    std::vector<double> u, phi(count);
    for (int i = 0; i < count; ++i)
        u.push_back(motion.half_lobe() * (2.0 * i / (count - 1) - 1));
    envelope::undeformed_angles(*batch, u, phi);
    double worst = 0;
    for (std::size_t i = 0; i < u.size(); ++i)
        worst = std::max(worst, std::abs(phi[i] - motion.angles(u[i]).phi));
    CHECK(worst <= 8 * unit_roundoff);

    auto const exact = [](wavegen::AnyWaveShape const& shape) {
        return motion::ExactMotion<wavegen::AnyWaveShape>(
            wavegen::NeutralCurve<wavegen::AnyWaveShape>(shape, type50_r_m), type50_ratio);
    };
    // a scaled cam is a smaller cam
    auto const scaled =
        motion::cosine_form(exact(wavegen::AnyWaveShape(wavegen::CosineCam{2 * type50_w0, 2}).scaled(0.5)));
    REQUIRE(scaled.has_value());
    CHECK(scaled->w0 == type50_w0);
    CHECK(scaled->r_0 == batch->r_0);
    CHECK_FALSE(
        motion::cosine_form(exact(wavegen::AnyWaveShape(wavegen::EllipseCam(type50_w0, type50_r_m)))).has_value());
    CHECK_FALSE(motion::cosine_form(type50_first_order()).has_value());
}

TEST_CASE("chord errors many at once are those one by one, bit for bit", "[envelope]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> step(-1, 1);
    std::vector<envelope::EnvelopePoint> points;
    for (int i = 0; i < 1000; ++i) {
        envelope::EnvelopePoint e;
        // a smooth stretch; and wild ones, coincident points and normals along the chord among them
        double const angle = i < 500 ? 0.003 * i : 10 * step(random);
        e.n = direction(angle);
        e.p = i < 500 ? Vec2(25 * e.n) : Vec2(step(random), step(random));
        if (i > 500 && i % 7 == 0)
            e.p = points.back().p;
        if (i > 500 && i % 11 == 0)
            e.n = (e.p - points.back().p).normalized().eval();
        if (!(e.n.norm() > 0))
            e.n = Vec2(1, 0);
        points.push_back(e);
    }
    std::vector<double> errors(points.size() - 1), bends(points.size() - 1);
    envelope::chord_errors(points, errors, bends);
    int different = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        double const length = (points[i + 1].p - points[i].p).norm();
        bool const turns_little = points[i].n.dot(points[i + 1].n) > 0;
        double const bend = length > 0 && turns_little ? cross(points[i].n, points[i + 1].n) / length : 0;
        different += errors[i] != envelope::chord_error(points[i], points[i + 1]) || bends[i] != bend;
    }
    CHECK(different == 0);
    CHECK(errors[100] > 0);
    CHECK(bends[100] == Approx(1 / 25.0));
}

TEST_CASE("a sampled arc of many blocks is the same for 1, 2 and 4 threads", "[envelope][parallel]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    envelope::BranchSet const found = envelope::find_branches(envelope, 1);
    envelope::ContactArc const& arc = found.branches.front().arcs.front();
    constexpr double chord = 1e-11;
    for (envelope::ChordTest const test : {envelope::ChordTest::bound, envelope::ChordTest::estimate}) {
        envelope::SampledArc const one = envelope::sample_arc(envelope, arc, arc.u_begin, arc.u_end, chord, 1, test);
        CHECK(one.points.size() > 65536);
        CHECK(one.chord <= chord);
        for (int const threads : {2, 4}) {
            envelope::SampledArc const many =
                envelope::sample_arc(envelope, arc, arc.u_begin, arc.u_end, chord, threads, test);
            REQUIRE(many.points.size() == one.points.size());
            bool equal = many.chord == one.chord && many.error == one.error;
            for (std::size_t i = 0; i < one.points.size(); ++i)
                equal = equal && same(one.points[i], many.points[i]);
            CHECK(equal);
        }
    }
}

}  // namespace hdconj::test::contact_batch_cases
