// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that merge: meshing conditions given by their polynomial.
#include <cmath>

#include "hdconj/envelope/find_branches.hpp"
#include "row.hpp"
#include "support/turning_motion.hpp"

namespace hdconj::test::merging_cases {

namespace {

/// Branches of one curve with the slope polynomial @p p under a turning translation, the same on 1, 2 and 4 threads.
envelope::BranchSet branches_of(std::vector<double> const& p)
{
    static Turning const motion{0.7, 0.1};
    static profile::Profile profile;
    profile.segment_names = {"only"};
    profile.pieces.clear();
    profile.pieces.push_back({with_slope(p), 0, 0, 1, false});
    envelope::Envelope<Turning> const envelope(profile, motion, 0);
    envelope::BranchSet const one = envelope::find_branches(envelope, 1);
    for (int threads : {2, 4}) {
        envelope::BranchSet const many = envelope::find_branches(envelope, threads);
        REQUIRE(many.branches.size() == one.branches.size());
        for (std::size_t i = 0; i < one.branches.size(); ++i) {
            CHECK(many.branches[i].arcs.front().u_begin == one.branches[i].arcs.front().u_begin);
            CHECK(many.branches[i].arcs.back().u_end == one.branches[i].arcs.back().u_end);
        }
    }
    return one;
}

}  // namespace

HARD_ROW("double root", "two contacts merge in the middle of a curve", "both branches begin at the merge, certified")
{
    // p = (t - 0.4)^2
    envelope::BranchSet const set = branches_of({0.16, -0.24, 0.36});
    CHECK(set.record.certified());
    // a branch may go on behind a cusp of the envelope; two begin where the contacts part
    int merging = 0;
    for (envelope::Branch const& branch : set.branches) {
        envelope::ContactArc const& first = branch.arcs.front();
        CHECK((first.begins == envelope::BranchEnd::double_root || first.begins == envelope::BranchEnd::cusp));
        if (first.begins != envelope::BranchEnd::double_root)
            continue;
        ++merging;
        CHECK(std::abs(first.u_begin - 0.1) < 1e-11);
        CHECK(std::abs(first.t_begin - 0.4) < 1e-5);
    }
    CHECK(merging == 2);
    say("merge at u = 0.1 within " + three_digits(std::abs(set.branches[0].arcs.front().u_begin - 0.1)));
}

HARD_ROW("triple root", "three contacts merge at one point: f = f_t = f_tt = 0",
         "one branch goes through, with a doubt of stated width and reach")
{
    // p = (t - 0.4)^3
    envelope::BranchSet const set = branches_of({-0.064, 0.096, -0.144, 0.216});
    CHECK_FALSE(set.record.certified());
    REQUIRE(set.record.doubts.size() == 1);
    envelope::RootDoubt const& doubt = set.record.doubts.front();
    CHECK(std::abs(doubt.u - 0.1) <= doubt.width / 2);
    CHECK(doubt.reach < 1e-15);
    REQUIRE(set.branches.size() == 1);
    CHECK(set.branches[0].arcs.front().begins == envelope::BranchEnd::segment_end);
    CHECK(set.branches[0].arcs.back().ends == envelope::BranchEnd::segment_end);
    say("doubt " + three_digits(doubt.width) + " rad wide, reach " + three_digits(doubt.reach) + " mm");
}

}  // namespace hdconj::test::merging_cases
