// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_wishes.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "wishes.hpp"

namespace hdconj::design {
namespace {

/// Why the trial nearest to the usual deformation is refused.
std::string why(MeshChoice const& failed)
{
    auto const nearest = std::min_element(
        failed.trials.begin(), failed.trials.end(),
        [](MeshTrial const& a, MeshTrial const& b) { return std::abs(a.ratio - 1) < std::abs(b.ratio - 1); });
    return "no radial deformation from 0.8 to 1.2 m (z_c - z_f)/2 makes a mesh; with " + short_number(nearest->w0) +
           " mm " + nearest->refusal;
}

bool works(DesignWishes const& wishes)
{
    return check_design(wishes).empty() && mesh_with_wall(wishes).mesh.best.has_value();
}

/// The value nearest to @p asked with which the design works, between it and @p easiest, by a sixteenth of their
/// distance; nothing where not even that does.
template <class Enter>
std::optional<double> nearest_value(DesignWishes wishes, double asked, double easiest, Enter enter)
{
    constexpr int halvings = 4;
    if (asked == easiest || !works((enter(wishes, easiest), wishes)))
        return std::nullopt;
    double refused = asked, accepted = easiest;
    for (int i = 0; i < halvings; ++i) {
        double const middle = rounded((refused + accepted) / 2);
        (works((enter(wishes, middle), wishes)) ? accepted : refused) = middle;
    }
    return accepted;
}

}  // namespace

Faults nearest_wishes(DesignWishes const& wishes, MeshChoice const& failed)
{
    Faults faults;
    std::string const reason = why(failed);
    auto const nearest = [&](char const* option, double asked, double easiest, auto enter) {
        auto const value = nearest_value(wishes, asked, easiest, enter);
        if (value)
            faults.push_back(
                {option, 0, short_number(asked), reason, "the nearest that works is " + short_number(*value)});
    };
    constexpr double accepted_land = 0.2;
    nearest("--land", wishes.land, std::min(wishes.land, accepted_land),
            [](DesignWishes& changed, double value) { changed.land = value; });
    nearest("--clearance", wishes.clearance, 0.0,
            [](DesignWishes& changed, double value) { changed.clearance = value; });
    nearest("--safety", wishes.safety, 1.0, [](DesignWishes& changed, double value) { changed.safety = value; });
    DesignWishes other = wishes;
    other.family = DesignWishes().family;
    if (other.family != wishes.family && works(other))
        faults.push_back({"--family", 0, wishes.family, reason, "the nearest that works is " + other.family});
    if (!faults.empty())
        return faults;
    for (auto const& [option, value] :
         {std::pair{"--ratio", wishes.ratio}, std::pair{"--land", wishes.land},
          std::pair{"--clearance", wishes.clearance}, std::pair{"--safety", wishes.safety}})
        faults.push_back({option, 0, short_number(value), reason,
                          "together with the others; `hdconj design --ratio 100 --diameter 50` works"});
    return faults;
}

void add_mesh_figures(Design& design, MeshTrial const& taken)
{
    double const open = DesignRange().high;
    auto const add = [&](std::string name, std::string rule, DesignRange range, double value, std::string unit) {
        constexpr int digits = 4;
        design.rows.push_back({std::move(name), "", "", std::move(rule), range, rounded(value, digits), std::move(unit),
                               "solve", DesignOrigin::figure, ""});
    };
    add("tip land of the circular spline", "as asked for", {design.wishes.land, open}, taken.land, "m");
    add("teeth of a lobe in flank contact", "at least 1, usually 2", {1, open}, taken.flank_contact, "1");
    add("angle lost before a cusp over angle used", "at most 0.1", {0, 0.1}, taken.lost, "1");
}

}  // namespace hdconj::design
