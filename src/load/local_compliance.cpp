// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_compliance.hpp"

#include <algorithm>
#include <cmath>

namespace hdconj::load {

std::vector<double> LocalCompliance::operator()(std::vector<double> const& force) const
{
    std::vector<double> approach(force.size());
    for (std::size_t i = 0; i < force.size(); ++i)
        approach[i] = own[i] * force[i];
    for (Coupling const& c : couplings) {
        approach[c.first] += c.compliance * force[c.second];
        approach[c.second] += c.compliance * force[c.first];
    }
    return approach;
}

LocalCompliance local_compliance(ElasticDrive const& drive, std::vector<FlankContact> const& contacts,
                                 std::vector<double> const& force)
{
    constexpr double start_load = 1;  // [N/mm] at which a contact without force is linearised
    LocalCompliance result;
    auto const width = [&](FlankContact const& c) { return drive.slice_width[c.slice]; };
    auto const load = [&](std::size_t i) { return force[i] > 0 ? force[i] / width(contacts[i]) : start_load; };
    // The component of a line load along x bends the tooth.
    auto const bending = [&](FlankContact const& a, FlankContact const& b) {
        return drive.bending(a.tooth_y, b.tooth_y) *
               std::sqrt((1 - a.inclination * a.inclination) * (1 - b.inclination * b.inclination));
    };
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        FlankContact const& c = contacts[i];
        result.own.push_back((approach(drive.line_contact(c), load(i)) / load(i) + bending(c, c)) / width(c));
        for (std::size_t j = i; j-- > 0;) {
            FlankContact const& other = contacts[j];
            if (other.space != c.space || other.flank != c.flank || other.slice != c.slice)
                break;
            if (other.tooth != c.tooth)
                continue;
            // The wider strip decides at which distance two strips merge.
            LineContact const a = drive.line_contact(c), b = drive.line_contact(other);
            double const half = std::max(half_width(a, load(i)), half_width(b, load(j)));
            result.couplings.push_back(
                {j, i,
                 (approach_beside(a, std::abs(c.arc_length - other.arc_length), half) + bending(c, other)) / width(c)});
        }
    }
    return result;
}

}  // namespace hdconj::load
