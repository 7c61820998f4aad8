// SPDX-License-Identifier: GPL-3.0-or-later
#include "linearisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "hdconj/base/parallel.hpp"
#include "load/elastic_drive.hpp"

namespace hdconj::load {
namespace {

auto flank_of(FlankContact const& c)
{
    return std::tuple(c.space, c.flank, c.slice);
}

/// Forces of the contacts @p before, each given to the nearest of the contacts @p now on the same flank.
std::vector<double> carried_over(std::vector<FlankContact> const& before, std::vector<double> const& force,
                                 std::vector<FlankContact> const& now)
{
    std::vector<double> result(now.size(), 0);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!(force[i] > 0))
            continue;
        auto const first = std::lower_bound(now.begin(), now.end(), before[i],
                                            [](auto const& a, auto const& b) { return flank_of(a) < flank_of(b); });
        auto const distance = [&](FlankContact const& c) { return std::abs(c.arc_length - before[i].arc_length); };
        auto best = now.end();
        for (auto c = first; c != now.end() && flank_of(*c) == flank_of(before[i]); ++c)
            if (best == now.end() || distance(*c) < distance(*best))
                best = c;
        if (best != now.end())
            result[static_cast<std::size_t>(best - now.begin())] += force[i];
    }
    return result;
}

}  // namespace

FlankSearch search_of(LoadProblem const& problem, ContactChoice const& choice, double turn, double limit)
{
    FlankSearch search = flank_search(problem, turn, limit, choice.depth);
    search.in_middle = choice.in_middle;
    search.tangents = choice.tangents;
    return search;
}

Linearisation linearised(LoadProblem const& problem, LoadedDrive const& now, ContactChoice const& choice,
                         SearchReach& reach)
{
    Linearisation result;
    LinearGaps& gaps = result.gaps;
    gaps.turn = now.state.turn;
    contact::GapField const field = gap_field(problem, now.shape, problem.edges);
    FlankSearch const search = search_of(problem, choice, gaps.turn, reach.limit);
    gaps.contacts = flank_contacts(field, search, problem.context.threads, &reach.known);
    if (choice.hold)
        hold_contacts(field, search, now.contacts, now.state.flank, gaps.contacts);
    result.force = carried_over(now.contacts, now.state.flank, gaps.contacts);
    gaps.compliance = local_compliance(problem.drive, gaps.contacts, result.force);
    return result;
}

Linearisation first_linearised(LoadProblem const& problem, LoadedDrive& now, ContactChoice const& choice,
                               SearchReach& reach)
{
    std::optional<SearchReach> found = std::exchange(now.found, std::nullopt);
    if (!found || choice != ContactChoice{})
        return linearised(problem, now, choice, reach);
    reach = *std::move(found);
    now.shape = reach.shape;
    Linearisation result{{now.contacts, {}, {}, reach.turn}, now.state.flank};
    result.gaps.compliance = local_compliance(problem.drive, result.gaps.contacts, result.force);
    return result;
}

double mismatch_of(Linearisation const& at)
{
    std::vector<double> const approach = at.gaps.compliance(at.force);
    double worst = 0;
    for (std::size_t i = 0; i < at.force.size(); ++i) {
        double const gap = at.gaps.contacts[i].gap + approach[i];
        worst = std::max(worst, at.force[i] > 0 ? std::abs(gap) : -gap);
    }
    return worst;
}

Equilibrium solved_linear(LoadProblem const& problem, LoadedDrive const& now, double torque, Linearisation& at)
{
    Equilibrium guess = now.state;
    guess.flank = at.force;
    at.gaps.displacement.resize(at.gaps.contacts.size());
    constexpr std::size_t grain = 64;
    parallel_for(at.gaps.contacts.size(), problem.context.threads, grain, [&](std::size_t i) {
        at.gaps.displacement[i] = normal_displacement(problem.drive, now.shape, at.gaps.contacts[i]);
    });
    return equilibrium(problem.drive, at.gaps, torque, &guess, problem.context.threads);
}

}  // namespace hdconj::load
