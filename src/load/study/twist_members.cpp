// SPDX-License-Identifier: GPL-3.0-or-later
#include "twist_members.hpp"

#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "hdconj/error.hpp"

namespace hdconj::load {

double disc_in_torsion(double inner, double outer, double width, elastic::Elasticity const& material)
{
    double const shear = material.youngs_modulus / (2 * (1 + material.poissons_ratio));
    return 4 * std::numbers::pi * shear * width / (1 / (inner * inner) - 1 / (outer * outer));
}

std::vector<TwistMember> series_members(Scene const& scene, double root_radius)
{
    std::vector<TwistMember> members;
    if (!scene.compliance)
        return members;
    Compliance const& given = *scene.compliance;
    CircularSpline const& spline = scene.circular_spline;
    if (given.outer_radius) {
        if (!(*given.outer_radius > root_radius))
            throw NumericalError(ErrorCode::unsuitable_body, "load", "compliance.outer_radius",
                                 "the body of the circular spline has no thickness: its root circle is at " +
                                     short_number(root_radius) + " mm",
                                 "write the larger radius at which it is held");
        members.push_back(
            {"body of the circular spline", disc_in_torsion(root_radius, *given.outer_radius, *spline.width,
                                                            {spline.youngs_modulus, spline.poissons_ratio})});
    }
    for (auto const& [name, stiffness] :
         {std::pair("flange", given.flange), std::pair("hub", given.hub), std::pair("shaft", given.shaft)})
        if (stiffness)
            members.push_back({name, *stiffness});
    return members;
}

double compliance_of(std::vector<TwistMember> const& members)
{
    double sum = 0;
    for (TwistMember const& member : members)
        sum += 1 / member.stiffness;
    return sum;
}

double cup_in_torsion(ElasticDrive const& drive, double radius)
{
    Eigen::MatrixXd const& even = drive.response->harmonics().front().response;
    double moved = 0, width = 0;
    for (std::size_t k = 0; k < drive.stations.slices; ++k) {
        width += drive.slice_width[k];
        for (std::size_t j = 0; j < drive.stations.slices; ++j)
            moved += drive.slice_width[k] * drive.slice_width[j] *
                     even(static_cast<Eigen::Index>(drive.stations.tangential(k)),
                          static_cast<Eigen::Index>(drive.stations.tangential(j)));
    }
    // under 1 N/rad all around: a torque of 2 pi r
    return 2 * std::numbers::pi * radius * radius * width * width / moved;
}

void add_in_series(double compliance, LoadedState& state)
{
    state.twist += compliance * state.torque;
    state.stiffness /= softening(compliance, state.stiffness);
}

std::vector<TwistMember> twist_members(LoadedState const& state, double free, double cup,
                                       std::vector<TwistMember> series)
{
    if (state.torque == 0)
        return {};
    double const rest = state.twist - free - state.torque / cup - compliance_of(series) * state.torque;
    std::vector<TwistMember> members{
        {"half of the backlash", 0, free}, {"teeth and bearing", state.torque / rest}, {"cup in torsion", cup}};
    members.insert(members.end(), series.begin(), series.end());
    for (TwistMember& member : members) {
        if (member.stiffness != 0)
            member.twist = state.torque / member.stiffness;
        member.fraction = member.twist / state.twist;
    }
    return members;
}

}  // namespace hdconj::load
