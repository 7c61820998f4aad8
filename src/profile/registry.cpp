// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/profile/registry.hpp"

#include "hdconj/profile/arc_chain.hpp"
#include "hdconj/profile/b_spline.hpp"
#include "hdconj/profile/bezier.hpp"
#include "hdconj/profile/cycloid.hpp"
#include "hdconj/profile/double_circular_arc.hpp"
#include "hdconj/profile/involute.hpp"
#include "hdconj/profile/measured_points.hpp"
#include "hdconj/profile/s_tooth.hpp"
#include "hdconj/profile/straight_sided.hpp"

namespace hdconj {

namespace {

struct Registered
{
    FamilyDescription description;
    Profile (*build)(FamilyChoice const&, ToothPlace const&, Faults&);
};

template<class Family>
Registered registered()
{
    return {Family::describe(), &Family::build};
}

/// A new family is one header and one line here.
std::vector<Registered> const& table()
{
    static std::vector<Registered> const families{
        registered<DoubleCircularArc>(),
        registered<StraightSided>(),
        registered<MeasuredPoints>(),
        registered<Involute>(),
        registered<Cycloid>(),
        registered<STooth>(),
        registered<ArcChain>(),
        registered<Bezier>(),
        registered<BSpline>(),
    };
    return families;
}

}  // namespace

std::vector<FamilyDescription> const& profile_families()
{
    static std::vector<FamilyDescription> const descriptions = [] {
        std::vector<FamilyDescription> all;
        for (Registered const& family : table())
            all.push_back(family.description);
        return all;
    }();
    return descriptions;
}

Profile build_profile(FamilyChoice const& choice, ToothPlace const& place, Faults& faults)
{
    for (Registered const& family : table())
        if (family.description.name == choice.family)
            return family.build(choice, place, faults);
    faults.push_back({choice.path + ".family", choice.line, choice.family, "no such tooth family", "write one of those that `hdconj check --help` lists"});
    return {};
}

}  // namespace hdconj
