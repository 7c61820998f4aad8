// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/profile/registry.hpp"

#include "arc_chain.hpp"
#include "b_spline.hpp"
#include "bezier.hpp"
#include "cycloid.hpp"
#include "double_circular_arc.hpp"
#include "involute.hpp"
#include "measured_points.hpp"
#include "s_tooth.hpp"
#include "straight_sided.hpp"

namespace hdconj::profile {

namespace {

struct Registered
{
    scene::FamilyDescription description;
    Profile (*build)(scene::FamilyChoice const&, ToothPlace const&, Faults&);
};

template <class Family>
Registered registered()
{
    return {Family::describe(), &Family::build};
}

/// A new family is one header and one line here.
std::vector<Registered> const& table()
{
    static std::vector<Registered> const families{
        registered<DoubleCircularArc>(), registered<StraightSided>(), registered<MeasuredPoints>(),
        registered<Involute>(),          registered<Cycloid>(),       registered<STooth>(),
        registered<ArcChain>(),          registered<Bezier>(),        registered<BSpline>(),
    };
    return families;
}

}  // namespace

std::vector<scene::FamilyDescription> const& profile_families()
{
    static std::vector<scene::FamilyDescription> const descriptions = [] {
        std::vector<scene::FamilyDescription> all;
        for (Registered const& family : table())
            all.push_back(family.description);
        return all;
    }();
    return descriptions;
}

Profile build_profile(scene::FamilyChoice const& choice, ToothPlace const& place, Faults& faults)
{
    for (Registered const& family : table())
        if (family.description.name == choice.family)
            return family.build(choice, place, faults);
    faults.push_back({choice.path + ".family", choice.line, choice.family, "no such tooth family",
                      "write one of those that `hdconj check --help` lists"});
    return {};
}

}  // namespace hdconj::profile
