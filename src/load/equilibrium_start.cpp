// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium_start.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "contact_places.hpp"
#include "hdconj/numeric/dense.hpp"
#include "hdconj/numeric/error.hpp"

namespace hdconj::detail {
namespace {

using Eigen::Index;

/// Where a contact stands: in which row around the ring, and at which of its places.
struct Site
{
    std::size_t row;
    std::size_t place;
};

/// Where the contacts of a problem stand.
struct Layout
{
    std::vector<Site> sites;
    std::size_t flanks;       ///< contacts that are not the bearing's: the first
    std::size_t places;       ///< of the bearing around the sector
};

/// Rows of the bearing by height, then of the flanks by slice and side.
std::vector<Site> sites_of(ElasticDrive const& drive, LinearGaps const& gaps, std::size_t flanks)
{
    std::vector<Site> sites;
    for (std::size_t i = 0; i < flanks; ++i)
    {
        FlankContact const& c = gaps.contacts[i];
        sites.push_back({drive.stations.bearing + 2 * c.slice + static_cast<std::size_t>(c.flank), c.space});
    }
    for (BearingNode const& node : bearing_nodes(drive))
        sites.push_back({node.height, node.angle});
    return sites;
}

/// The contacts at every other place.
struct Thinned
{
    std::vector<int> kept, of_bearing;   ///< numbers among all, and among the bearing's
    Layout layout;
};

Thinned thinned(Layout const& whole)
{
    Thinned thin{{}, {}, {{}, 0, (whole.places + 1) / 2}};
    for (std::size_t i = 0; i < whole.sites.size(); ++i)
    {
        if (whole.sites[i].place % 2 != 0)
            continue;
        thin.kept.push_back(static_cast<int>(i));
        if (i >= whole.flanks)
            thin.of_bearing.push_back(static_cast<int>(i - whole.flanks));
        thin.layout.sites.push_back({whole.sites[i].row, whole.sites[i].place / 2});
    }
    thin.layout.flanks = thin.kept.size() - thin.of_bearing.size();
    return thin;
}

Complementarity part_of(Complementarity const& whole, std::vector<int> const& kept, int threads)
{
    Complementarity part{principal_part(whole.compliance, kept, threads), whole.approach(kept), {}, whole.total};
    if (whole.border.size() > 0)
        part.border = whole.border(kept);
    return part;
}

/// Contacts of the whole problem at the places of those that are @p closed in the thinned one, and at the next ones.
std::vector<int> closed_around(Layout const& whole, std::vector<int> const& kept, std::vector<int> const& closed)
{
    std::set<std::pair<std::size_t, std::size_t>> places;
    for (int const i : closed)
    {
        auto const at = static_cast<std::size_t>(kept[static_cast<std::size_t>(i)]);
        auto const [row, place] = whole.sites[at];
        std::size_t const around = at < whole.flanks ? std::numeric_limits<std::size_t>::max() : whole.places;   // teeth about the minor axis are far from each other
        for (std::size_t const near : {place, place + 1 < around ? place + 1 : 0, place > 0 ? place - 1 : around - 1})
            places.insert({row, near});
    }
    std::vector<int> contacts;
    for (std::size_t i = 0; i < whole.sites.size(); ++i)
        if (places.contains({whole.sites[i].row, whole.sites[i].place}))
            contacts.push_back(static_cast<int>(i));
    return contacts;
}

/// Those of the same problem with contacts at every other place only, each for its neighbours too, which begins with every fourth, and so on: each of these problems takes an eighth of
/// the next one's time. What a start says wrong costs steps and changes no result. Empty where there are few places, or the thinned problem has no solution.
/// @param turn  to begin with [rad]
Start coarse_start(Complementarity const& problem, std::optional<BallLine> const& line, Layout const& layout, double turn, int threads)
{
    constexpr std::size_t few = 32;
    if (layout.places < few)
        return {};
    Thinned const thin = thinned(layout);
    Complementarity part = part_of(problem, thin.kept, threads);
    std::optional<BallLine> balls;
    if (line)
        balls = BallLine{line->phi, line->held, line->stiffness, line->lift(thin.of_bearing, Eigen::all)};
    Start result = coarse_start(part, balls, thin.layout, turn, threads);
    ComplementarityOptions options;
    options.scalar = turn;
    options.threads = threads;
    options.start = std::move(result.contacts);
    std::vector<int> closed;
    try
    {
        if (balls)
        {
            BallContact const found = solve_on_balls(part, static_cast<Index>(thin.layout.flanks), *balls, options, result.off);
            closed = found.contacts.contacts;
            result.off.clear();
            for (double const force : found.force)
                result.off.push_back(!(force > 0));
        }
        else
            closed = solve_complementarity(part, options).contacts;
    }
    catch (NumericalError const&)
    {
        return {};  // the whole problem will say what is wrong, if it is its own
    }
    result.contacts = closed_around(layout, thin.kept, closed);
    return result;
}

/// What was closed in a like problem.
Start like(ElasticDrive const& drive, Equilibrium const& guess, std::size_t flanks)
{
    Start start;
    if (guess.flank.size() == flanks)
        for (std::size_t i = 0; i < flanks; ++i)
            if (guess.flank[i] > 0)
                start.contacts.push_back(static_cast<int>(i));
    std::vector<BearingNode> const nodes = bearing_nodes(drive);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (guess.bearing(static_cast<Index>(nodes[i].height), static_cast<Index>(nodes[i].angle)) > 0)
            start.contacts.push_back(static_cast<int>(flanks + i));
    for (double const force : guess.balls)
        start.off.push_back(!(force > 0));
    return start;
}

}  // namespace

Start equilibrium_start(ElasticDrive const& drive, LinearGaps const& gaps, Complementarity const& problem, std::size_t flanks, Equilibrium const* guess, int threads)
{
    Start start = guess != nullptr ? like(drive, *guess, flanks) : Start{};
    // from a start without flanks, contacts on one side of the ring would have to find their way to all others
    bool const loaded = flanks > 0 && problem.total != 0;
    bool const unloaded_guess = guess != nullptr && std::none_of(guess->flank.begin(), guess->flank.end(), [](double force) { return force > 0; });
    if (guess == nullptr || (loaded && unloaded_guess))
    {
        Start found = coarse_start(problem, drive.balls, {sites_of(drive, gaps, flanks), flanks, drive.bearing_steps.size()}, gaps.turn, threads);
        if (!found.contacts.empty())
            start = std::move(found);
    }
    return start;
}

}  // namespace hdconj::detail
