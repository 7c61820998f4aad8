// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/profile/registry.hpp"

#include "families.hpp"

namespace hdconj::profile {
namespace {

std::vector<Family> const& families()
{
    static std::vector<Family> const all{
        double_circular_arc(), straight_sided(), measured_points(), involute(), cycloid(), s_tooth(),
        arc_chain(),           bezier(),         b_spline()};
    return all;
}

}  // namespace

std::vector<scene::FamilyDescription> const& profile_families()
{
    static std::vector<scene::FamilyDescription> const descriptions = [] {
        std::vector<scene::FamilyDescription> all;
        for (Family const& family : families())
            all.push_back(family.description);
        return all;
    }();
    return descriptions;
}

Profile build_profile(scene::FamilyChoice const& choice, ToothPlace const& place, Faults& faults)
{
    for (Family const& family : families())
        if (family.description.name == choice.family)
            return family.build(choice, place, faults);
    faults.push_back({choice.path + ".family", choice.line, choice.family, "no such tooth family",
                      "write one of those that `hdconj check --help` lists"});
    return {};
}

}  // namespace hdconj::profile
