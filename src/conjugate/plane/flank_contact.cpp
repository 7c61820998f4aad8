// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conjugate/outline.hpp"
#include "hdconj/units.hpp"

namespace hdconj::conjugate {
namespace {

using Stretches = std::vector<std::pair<double, double>>;

/// Length of the union of @p stretches.
double covered(Stretches stretches)
{
    std::sort(stretches.begin(), stretches.end());
    double sum = 0, reached = -std::numeric_limits<double>::infinity();
    for (auto const& [from, to] : stretches) {
        sum += std::max(0.0, to - std::max(from, reached));
        reached = std::max(reached, to);
    }
    return sum;
}

/// Length of what @p stretches cover beside @p others.
double covered_beside(Stretches const& others, Stretches stretches)
{
    stretches.insert(stretches.end(), others.begin(), others.end());
    return covered(std::move(stretches)) - covered(others);
}

std::pair<double, double> polar(envelope::AnyEnvelope const& envelope, double a, double b)
{
    return std::minmax({envelope.motion().angles(a).u, envelope.motion().angles(b).u});
}

bool is_flank(profile::Profile const& tooth, envelope::ContactArc const& arc)
{
    return made_by(tooth, arc).kind == OutlineKind::flank;
}

std::size_t flank_of(profile::Profile const& tooth, envelope::ContactArc const& arc)
{
    profile::PieceShape const& shape = tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
    return profile::start_of(shape).normal.x() + profile::end_of(shape).normal.x() > 0 ? 1 : 0;
}

/// Where @p arc lies in a space, told apart by a twentieth of a degree.
Stretches in_space_of(envelope::AnyEnvelope const& envelope, envelope::ContactArc const& arc,
                      std::function<bool(Vec2 const&)> const& in_space)
{
    constexpr double step = 0.05;  // [deg]
    double const length = arc.u_end - arc.u_begin, steps = std::ceil(length / from_deg(step));
    Stretches found;
    for (double i = 0; i < steps; ++i) {
        double const from = arc.u_begin + length * (i / steps), to = arc.u_begin + length * ((i + 1) / steps);
        if (in_space(envelope.point(arc, (from + to) / 2).p))
            found.push_back(polar(envelope, from, to));
    }
    return found;
}

}  // namespace

void FlankContactSum::add(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                          std::vector<BoundaryPiece> const& pieces, std::function<bool(Vec2 const&)> const& in_space)
{
    profile::Profile const& tooth = envelope.profile();
    for (BoundaryPiece const& piece : pieces) {
        if (piece.arc < 0)
            continue;
        envelope::ContactArc const& arc = arcs[static_cast<std::size_t>(piece.arc)];
        if (is_flank(tooth, arc))
            flanks_[flank_of(tooth, arc)].used.push_back(polar(envelope, piece.begin, piece.end));
    }
    for (auto first = arcs.begin(), last = first; first != arcs.end(); first = last) {
        last = first + 1;
        if (!first->bounding || !is_flank(tooth, *first))
            continue;
        while (last[-1].ends == envelope::BranchEnd::continues && last != arcs.end() && last->bounding)
            ++last;
        bool const reaches_cusp =
            (first->begins == envelope::BranchEnd::cusp && in_space(envelope.point(*first, first->u_begin).p)) ||
            (last[-1].ends == envelope::BranchEnd::cusp && in_space(envelope.point(last[-1], last[-1].u_end).p));
        for (auto arc = first; reaches_cusp && arc != last; ++arc)
            for (auto const& stretch : in_space_of(envelope, *arc, in_space))
                flanks_[flank_of(tooth, *arc)].undercut.push_back(stretch);
    }
}

FlankEngagement FlankContactSum::value() const
{
    FlankEngagement worst;
    for (Flank const& flank : flanks_) {
        double const used = covered(flank.used), lost = covered_beside(flank.used, flank.undercut);
        if (&flank == flanks_.data() || lost * worst.used > worst.lost * used) {
            worst.used = used;
            worst.lost = lost;
        }
    }
    worst.angle = std::min(covered(flanks_[0].used), covered(flanks_[1].used));
    return worst;
}

}  // namespace hdconj::conjugate
