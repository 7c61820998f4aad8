// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium_start.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "elastic_drive.hpp"
#include "hdconj/error.hpp"
#include "numeric/compliance.hpp"

namespace hdconj::load {
namespace {

using Eigen::Index;

/// Place of a contact.
struct Site
{
    std::size_t row;    ///< around the ring
    std::size_t place;  ///< within the row
};

/// Places of all contacts of a problem.
struct Layout
{
    std::vector<Site> sites;
    std::size_t flanks;  ///< number of contacts that are not the bearing's; they come first
    std::size_t places;  ///< in a row of the bearing
};

/// Rows are numbered first for the bearing by height, then for the flanks by slice and side.
std::vector<Site> sites_of(ElasticDrive const& drive, LinearGaps const& gaps, std::size_t flanks)
{
    std::vector<Site> sites;
    for (std::size_t i = 0; i < flanks; ++i) {
        FlankContact const& c = gaps.contacts[i];
        sites.push_back({drive.stations.bearing + 2 * c.slice + static_cast<std::size_t>(c.flank), c.space});
    }
    for (BearingNode const& node : bearing_nodes(drive))
        sites.push_back({node.height, node.angle});
    return sites;
}

/// The contacts at every other place.
struct ThinnedLayout
{
    std::vector<int> kept;        ///< indices among all contacts
    std::vector<int> of_bearing;  ///< indices of those of the bearing among its contacts
    Layout layout;
};

ThinnedLayout thinned_layout(Layout const& whole)
{
    ThinnedLayout thin{{}, {}, {{}, 0, (whole.places + 1) / 2}};
    for (std::size_t i = 0; i < whole.sites.size(); ++i) {
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

numeric::Complementarity part_of(numeric::Complementarity const& whole, std::vector<int> const& kept, int threads)
{
    numeric::Complementarity part{numeric::principal_part(whole, kept, threads), whole.approach(kept), {}, whole.total};
    if (whole.border.size() > 0)
        part.border = whole.border(kept);
    return part;
}

/// Contacts of the whole problem at the places of those that are @p closed in the thinned one, and at the neighbouring
/// places.
std::vector<int> closed_around(Layout const& whole, std::vector<int> const& kept, std::vector<int> const& closed)
{
    std::set<std::pair<std::size_t, std::size_t>> places;
    for (int const i : closed) {
        auto const at = static_cast<std::size_t>(kept[static_cast<std::size_t>(i)]);
        auto const [row, place] = whole.sites[at];
        // Rows of the bearing are closed; those of flanks end about the minor axis, where teeth are far apart.
        std::size_t const around = at < whole.flanks ? std::numeric_limits<std::size_t>::max() : whole.places;
        for (std::size_t const near : {place, place + 1 < around ? place + 1 : 0, place > 0 ? place - 1 : around - 1})
            places.insert({row, near});
    }
    std::vector<int> contacts;
    for (std::size_t i = 0; i < whole.sites.size(); ++i)
        if (places.contains({whole.sites[i].row, whole.sites[i].place}))
            contacts.push_back(static_cast<int>(i));
    return contacts;
}

/// The active set of the same problem with every other place only, which starts from that with every fourth, and so on.
/// Each of these problems takes an eighth of the time of the next. A wrong start costs steps and changes no result.
/// Empty where there are few places, or the thinned problem has no solution.
/// @param turn  first guess [rad]
Start coarse_start(numeric::Complementarity const& problem, std::optional<elastic::BallLine> const& line,
                   Layout const& layout, double turn, int threads)
{
    constexpr std::size_t few = 32;
    if (layout.places < few)
        return {};
    ThinnedLayout const thin = thinned_layout(layout);
    numeric::Complementarity part = part_of(problem, thin.kept, threads);
    std::optional<elastic::BallLine> balls;
    if (line)
        balls = elastic::BallLine{line->phi, line->held, line->stiffness, line->lift(thin.of_bearing, Eigen::all),
                                  line->hertz};
    Start result = coarse_start(part, balls, thin.layout, turn, threads);
    numeric::ComplementarityOptions const options{
        .start = std::move(result.contacts), .scalar = turn, .threads = threads};
    std::vector<int> closed;
    try {
        if (balls) {
            elastic::BallContact const found =
                elastic::solve_on_balls(part, static_cast<Index>(thin.layout.flanks), *balls, options, result.balls);
            closed = found.contacts.contacts;
            result.balls.assign(found.force.begin(), found.force.end());
        } else
            closed = numeric::solve_complementarity(part, options).contacts;
    } catch (NumericalError const& error) {
        if (error.code() != ErrorCode::not_converged && error.code() != ErrorCode::unsuitable_body)
            throw;
        return {};  // if the whole problem fails too, it says why
    }
    result.contacts = closed_around(layout, thin.kept, closed);
    return result;
}

/// The active set of a similar problem.
Start active_set_of(ElasticDrive const& drive, Equilibrium const& guess, std::size_t flanks)
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
    start.balls = guess.balls;
    return start;
}

}  // namespace

Start equilibrium_start(ElasticDrive const& drive, LinearGaps const& gaps, numeric::Complementarity const& problem,
                        std::size_t flanks, Equilibrium const* guess, int threads)
{
    Start start = guess != nullptr ? active_set_of(drive, *guess, flanks) : Start{};
    // From a start without flanks the active set would take many steps to the contacts all around the ring.
    bool const loaded = flanks > 0 && problem.total != 0;
    bool const unloaded_guess = guess != nullptr && std::none_of(guess->flank.begin(), guess->flank.end(),
                                                                 [](double force) { return force > 0; });
    if (guess == nullptr || (loaded && unloaded_guess)) {
        Start found =
            coarse_start(problem, drive.balls, {sites_of(drive, gaps, flanks), flanks, drive.bearing_steps.size()},
                         gaps.turn, threads);
        if (!found.contacts.empty())
            start = std::move(found);
    }
    return start;
}

}  // namespace hdconj::load
