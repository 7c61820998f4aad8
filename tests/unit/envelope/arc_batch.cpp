// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/arc_batch.hpp"

#include <variant>
#include <vector>

#include "hdconj/envelope/find_branches.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::arc_batch_cases {

TEST_CASE("arc batch: the points of every contact arc of type-50, 1 to 3 waves", "[envelope]")
{
    profile::Profile const tooth = type50_tooth();
    int arcs = 0;
    for (int const waves : {1, 2, 3})
        for (double const offset : {0.0, 0.004}) {
            Exact const motion = type50_motion(waves);
            envelope::Envelope<Exact> const envelope(tooth, motion, offset);
            for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
                for (envelope::ContactArc const& arc : branch.arcs) {
                    auto const* circle =
                        std::get_if<profile::ArcPiece>(&tooth.pieces[static_cast<std::size_t>(arc.piece)].shape);
                    if (circle == nullptr || arc.resting)
                        continue;
                    ++arcs;
                    envelope::ArcBatch const batch(motion, type50_ratio, *circle, arc.candidate, offset);
                    // an odd number, so that the last points are not a whole vector
                    constexpr int count = 37;
                    std::vector<double> u, x(count), y(count);
                    for (int i = 0; i < count; ++i)
                        u.push_back(arc.u_begin + (arc.u_end - arc.u_begin) * (i + 0.5) / count);
                    batch(u, x, y);
                    for (std::size_t i = 0; i < u.size(); ++i) {
                        envelope::EnvelopePoint const point = envelope.point(arc, u[i]);
                        // along the envelope a fast contact is uncertain; across it never is
                        Vec2 const gap = Vec2(x[i], y[i]) - point.p;
                        CHECK(std::abs(gap.dot(point.n)) < 5e-14);
                        CHECK(gap.norm() <= 5e-14 + point.error);
                        // the same one by one: no point knows its neighbours
                        double one_x = 0, one_y = 0;
                        batch({&u[i], 1}, {&one_x, 1}, {&one_y, 1});
                        CHECK(one_x == x[i]);
                        CHECK(one_y == y[i]);
                    }
                }
        }
    CHECK(arcs > 20);
}

}  // namespace hdconj::test::arc_batch_cases
