// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/envelope/sample.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::envelope_cases {

namespace {

/// A motion with a closed-form envelope: the tooth only slides along +x, one unit per unit of u.
struct Sliding
{
    Pose pose(double u) const { return {1, 0, {u, 0}}; }
    motion::MotionRates rates(double) const { return {{0, {1, 0}}, {0, {0, 0}}}; }
    motion::ToothAngles angles(double u) const { return {u, u}; }
    double half_lobe() const { return 1; }
    std::span<double const> breaks() const { return {}; }
    bool symmetric() const { return false; }
};

/// A circle of radius `radius` rolling without sliding along the x axis, as a motion of the frame at its centre:
/// its envelope is the line y = 0 (and y = 2 radius).
struct Rolling
{
    double radius;
    Pose pose(double u) const { return {std::cos(u), std::sin(u), {radius * u, radius}}; }
    motion::MotionRates rates(double u) const
    {
        double const c = std::cos(u);
        double const s = std::sin(u);
        return {{1, {radius * c, radius * s}}, {0, {-radius * s, radius * c}}};
    }
    motion::ToothAngles angles(double u) const { return {u, u}; }
    double half_lobe() const { return 1; }
    std::span<double const> breaks() const { return {}; }
    bool symmetric() const { return false; }
};

profile::Profile single(profile::PieceShape shape)
{
    profile::Profile profile;
    profile.segment_names = {"only"};
    profile.pieces.push_back({std::move(shape), 0, 0, 1, false});
    return profile;
}

/// The cubic Bernstein curve nearest to an arc: shares its ends and end tangents.
profile::CurvePiece bezier_arc(profile::ArcPiece const& arc)
{
    Vec2 const a = arc.centre + arc.radius * direction(arc.from);
    Vec2 const b = arc.centre + arc.radius * direction(arc.to);
    double const span = std::abs(arc.to - arc.from);
    double const handle = 4.0 / 3 * std::tan(span / 4) * std::abs(arc.radius);
    Vec2 const p = a + handle * right_of(direction(arc.from));
    Vec2 const q = b - handle * right_of(direction(arc.to));
    return profile::CurvePiece({a.x(), p.x(), q.x(), b.x()}, {a.y(), p.y(), q.y(), b.y()});
}

template <class Motion>
double largest_meshing_residual(profile::Profile const& tooth, Motion const& motion, double offset)
{
    envelope::Envelope<Motion> const envelope(tooth, motion, offset);
    envelope::BranchSet const set = envelope::find_branches(envelope, 1);
    REQUIRE(set.record.certified());
    double worst = 0;
    for (envelope::Branch const& branch : set.branches)
        for (envelope::ContactArc const& arc : branch.arcs)
            for (int i = 0; i <= 20; ++i) {
                double const u = envelope::arc_parameter_to_u(arc, i / 20.0);
                envelope::Contact const c = envelope.contact(arc, u);
                worst = std::max(worst, std::abs(c.n.dot(motion.rates(u).twist(c.x))));
            }
    return worst;
}

}  // namespace

TEST_CASE("at every contact the velocity has no part along the normal", "[envelope]")
{
    for (double offset : {0.0, 0.02}) {
        CHECK(largest_meshing_residual(type50_tooth(), type50_motion(), offset) < 1e-13);
        CHECK(largest_meshing_residual(type50_tooth(), type50_first_order(), offset) < 1e-13);
        CHECK(largest_meshing_residual(type50_tooth(), type50_motion(3), offset) < 1e-13);
    }
}

TEST_CASE("a sliding circle envelopes its two tangents, a rolling one the line it rolls on", "[envelope]")
{
    profile::ArcPiece const circle{{0, 0}, 0.5, 3.0, 0.2};
    profile::Profile const slid = single(circle);
    envelope::BranchSet const set = envelope::find_branches(envelope::Envelope<Sliding>(slid, Sliding{}, 0), 1);
    REQUIRE(set.branches.size() == 1);
    envelope::ContactArc const& arc = set.branches[0].arcs.front();
    CHECK(arc.begins == envelope::BranchEnd::range_end);
    envelope::EnvelopePoint const e = envelope::Envelope<Sliding>(slid, Sliding{}, 0).point(arc, 0.3);
    CHECK(e.p.y() == Approx(0.5));
    CHECK(e.p.x() == Approx(0.3));

    // rolling: the circle about the frame's origin touches y = 0 and y = 2 radius
    profile::ArcPiece const disc{{0, 0}, 0.5, -0.5, -2.5};
    profile::Profile const rolled = single(disc);
    Rolling const motion{0.5};
    envelope::Envelope<Rolling> const envelope(rolled, motion, 0);
    envelope::BranchSet const rolling = envelope::find_branches(envelope, 1);
    REQUIRE_FALSE(rolling.branches.empty());
    bool on_floor = false;
    for (envelope::Branch const& branch : rolling.branches) {
        envelope::EnvelopePoint const p =
            envelope.point(branch.arcs[0], 0.5 * (branch.arcs[0].u_begin + branch.arcs[0].u_end));
        on_floor = on_floor || std::abs(p.p.y()) < 1e-14;
        CHECK((std::abs(p.p.y()) < 1e-14 || std::abs(p.p.y() - 1) < 1e-14));
    }
    CHECK(on_floor);
}

TEST_CASE("branch ends are solved for: a tenth of a roundoff further the contact is outside", "[envelope]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    int checked = 0;
    for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
        for (envelope::ContactArc const& arc : branch.arcs) {
            if (arc.ends != envelope::BranchEnd::segment_end)
                continue;
            profile::PieceShape const& shape = tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
            profile::PieceEnd const end = arc.t_end == 0 ? start_of(shape) : end_of(shape);
            // f at the end of the segment is zero there, to the roundoff of lengths of 24 mm
            CHECK(std::abs(end.normal.dot(motion.rates(arc.u_end).twist(end.point))) < 1e-13);
            double const beyond = envelope.contact(arc, arc.u_end + 1e-6).t;
            CHECK((beyond < 0 || beyond > 1));
            ++checked;
        }
    CHECK(checked >= 10);
}

TEST_CASE("both conjugate zones of the convex arc, their fold and the cusp of the concave arc", "[envelope]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    envelope::BranchSet const set = envelope::find_branches(envelope::Envelope<Exact>(tooth, motion, 0), 1);
    auto const degrees = [](double u) { return u * 180 / std::numbers::pi; };
    bool fold = false;
    bool cusp = false;
    for (envelope::Branch const& branch : set.branches) {
        std::string const& name = tooth.segment_names[static_cast<std::size_t>(branch.segment)];
        envelope::ContactArc const& arc = branch.arcs.front();
        if (name == "right convex arc") {
            REQUIRE(arc.reversals.size() == 1);
            CHECK(degrees(arc.reversals[0]) == Approx(12.2).margin(0.05));  // design 3.4
            CHECK(arc.bounding);
            fold = true;
        }
        if (name == "right concave arc" && arc.ends == envelope::BranchEnd::cusp) {
            // at a cusp the envelope stands still
            envelope::Contact const c = envelope::Envelope<Exact>(tooth, motion, 0).contact(arc, arc.u_end);
            CHECK(std::abs(c.bound) <= 64 * unit_roundoff * c.bound_size);
            cusp = true;
        }
    }
    CHECK(fold);
    CHECK(cusp);
}

TEST_CASE("the general curve path agrees with the closed form on an arc", "[envelope]")
{
    // the cubic through an arc of 2 degrees leaves it by less than 1e-13 of its radius
    Exact const motion = type50_motion();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> where(-0.3, 0.3), size(0.1, 0.6), turn(0.2, 1.2);
    int compared = 0;
    for (int trial = 0; trial < 60; ++trial) {
        double const from = turn(random);
        profile::ArcPiece const arc{{where(random), 0.6 + where(random)}, size(random), from, from - 0.035};
        profile::Profile const round = single(arc);
        profile::Profile const curved = single(bezier_arc(arc));
        envelope::BranchSet const a = envelope::find_branches(envelope::Envelope<Exact>(round, motion, 0), 1);
        envelope::BranchSet const b = envelope::find_branches(envelope::Envelope<Exact>(curved, motion, 0), 1);
        for (envelope::Branch const& x : a.branches)
            for (envelope::Branch const& y : b.branches) {
                envelope::ContactArc const& p = x.arcs.front();
                envelope::ContactArc const& q = y.arcs.front();
                if (std::abs(p.u_begin - q.u_begin) > 1e-7 || std::abs(p.u_end - q.u_end) > 1e-7)
                    continue;
                double const u = 0.5 * (std::max(p.u_begin, q.u_begin) + std::min(p.u_end, q.u_end));
                Vec2 const d = envelope::Envelope<Exact>(round, motion, 0).point(p, u).p -
                               envelope::Envelope<Exact>(curved, motion, 0).point(q, u).p;
                CHECK(d.norm() < 1e-11);
                ++compared;
            }
    }
    CHECK(compared > 20);
}

TEST_CASE("double roots on a curve are found and end branches there", "[envelope]")
{
    // an S-shaped cubic: contacts of both bends merge where the centre of rotation crosses the evolute
    profile::CurvePiece const s_curve({0.30, 0.10, 0.42, 0.20}, {1.00, 0.85, 0.65, 0.40});
    profile::Profile const tooth = single(s_curve);
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    envelope::DoubleRoots const doubles =
        envelope::DoubleRootSearch(s_curve, motion::rates_model(motion, -motion.half_lobe(), motion.half_lobe()),
                                   -motion.half_lobe(), motion.half_lobe())();
    REQUIRE(doubles.certified());
    envelope::BranchSet const set = envelope::find_branches(envelope, 1);
    std::size_t ends = 0;
    for (envelope::Branch const& branch : set.branches)
        ends += (branch.arcs.front().begins == envelope::BranchEnd::double_root) +
                (branch.arcs.back().ends == envelope::BranchEnd::double_root);
    CHECK(ends == 2 * doubles.roots.size());
    for (envelope::DoubleRoot const& root : doubles.roots) {
        PlanarVelocity const w = motion.rates(root.u).twist;
        auto const f = [&](double t) {
            return w.omega * numeric::bernstein_value(s_curve.a(), t) +
                   w.q.x() * numeric::bernstein_value(s_curve.b(), t) +
                   w.q.y() * numeric::bernstein_value(s_curve.c(), t);
        };
        CHECK(std::abs(f(root.t)) < 1e-13);
        CHECK(std::abs(f(root.t + 1e-5) - f(root.t - 1e-5)) < 1e-12);
    }
}

TEST_CASE("branches and samples are bit-identical for 1, 2 and 4 threads", "[envelope][parallel]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    envelope::BranchSet const one = envelope::find_branches(envelope, 1);
    for (int threads : {2, 4}) {
        envelope::BranchSet const many = envelope::find_branches(envelope, threads);
        REQUIRE(many.branches.size() == one.branches.size());
        for (std::size_t i = 0; i < one.branches.size(); ++i) {
            envelope::ContactArc const& a = one.branches[i].arcs.front();
            envelope::ContactArc const& b = many.branches[i].arcs.front();
            CHECK(a.u_begin == b.u_begin);
            envelope::SampledArc const s = envelope::sample_arc(envelope, a, a.u_begin, a.u_end, 1e-8, 1);
            envelope::SampledArc const t = envelope::sample_arc(envelope, b, b.u_begin, b.u_end, 1e-8, threads);
            REQUIRE(s.points.size() == t.points.size());
            for (std::size_t k = 0; k < s.points.size(); ++k)
                CHECK(s.points[k].p == t.points[k].p);
        }
    }
}

TEST_CASE("adaptive samples keep the chord error with few more points than the curve needs", "[envelope]")
{
    profile::Profile const tooth = type50_tooth();
    Exact const motion = type50_motion();
    envelope::Envelope<Exact> const envelope(tooth, motion, 0);
    envelope::BranchSet const found = envelope::find_branches(envelope, 1);
    for (double const chord : {1e-3, 1e-4, 1e-6})
        for (envelope::Branch const& branch : found.branches)
            for (envelope::ContactArc const& arc : branch.arcs) {
                envelope::SampledArc const s = sample_arc(envelope, arc, arc.u_begin, arc.u_end, chord, 1);
                CHECK(s.chord <= chord);
                // true deviation, from many points between neighbours
                double worst = 0;
                double needed = 0;
                for (std::size_t k = 0; k + 1 < s.points.size(); ++k) {
                    Vec2 const a = s.points[k].p;
                    Vec2 const d = s.points[k + 1].p - a;
                    double here = 0;
                    constexpr int parts = 32;
                    for (int j = 1; j < parts; ++j) {
                        double const u = s.points[k].u + (s.points[k + 1].u - s.points[k].u) * j / parts;
                        Vec2 const p = envelope.point(arc, u).p - a;
                        here = std::max(here, std::abs(cross(d.normalized(), p)));
                    }
                    worst = std::max(worst, here);
                    needed += std::sqrt(here / chord);
                }
                INFO(tooth.segment_names[static_cast<std::size_t>(branch.segment)]
                     << " piece " << arc.piece << " u " << arc.u_begin << " chord " << chord);
                CHECK(worst <= s.chord + s.error);
                CHECK(static_cast<double>(s.points.size()) <= 1.1 * needed + 4);
            }
}

}  // namespace hdconj::test::envelope_cases
