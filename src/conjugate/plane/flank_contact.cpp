// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank_contact.hpp"

#include <algorithm>
#include <cmath>

#include "conjugate/outline.hpp"

namespace hdconj::conjugate {
namespace {

/// Length of the union of @p stretches.
double covered(std::vector<std::pair<double, double>> stretches)
{
    std::sort(stretches.begin(), stretches.end());
    double sum = 0, reached = -std::numeric_limits<double>::infinity();
    for (auto const& [from, to] : stretches) {
        sum += std::max(0.0, to - std::max(from, reached));
        reached = std::max(reached, to);
    }
    return sum;
}

}  // namespace

void FlankContactSum::add(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
                          std::vector<BoundaryPiece> const& pieces)
{
    profile::Profile const& tooth = envelope.profile();
    for (BoundaryPiece const& piece : pieces) {
        if (piece.arc < 0)
            continue;
        envelope::ContactArc const& arc = arcs[static_cast<std::size_t>(piece.arc)];
        if (made_by(tooth, arc).kind != OutlineKind::flank)
            continue;
        profile::PieceShape const& shape = tooth.pieces[static_cast<std::size_t>(arc.piece)].shape;
        std::size_t const flank = profile::start_of(shape).normal.x() + profile::end_of(shape).normal.x() > 0 ? 1 : 0;
        stretches_[flank].push_back(std::minmax({envelope.motion().angles(piece.begin).u,  //
                                                 envelope.motion().angles(piece.end).u}));
        if (arc.begins == envelope::BranchEnd::cusp)
            compare_with_cusp(envelope, piece, arc.u_begin);
        if (arc.ends == envelope::BranchEnd::cusp)
            compare_with_cusp(envelope, piece, arc.u_end);
    }
}

void FlankContactSum::compare_with_cusp(envelope::AnyEnvelope const& envelope, BoundaryPiece const& piece, double cusp)
{
    auto const angle = [&](double from, double to) {
        return std::abs(envelope.motion().angles(to).u - envelope.motion().angles(from).u);
    };
    double const used = angle(piece.begin, piece.end);
    double const lost = std::min(angle(piece.begin, cusp), angle(piece.end, cusp));
    if (lost * worst_.used >= worst_.lost * used) {
        worst_.used = used;
        worst_.lost = lost;
    }
}

FlankEngagement FlankContactSum::value() const
{
    FlankEngagement contact = worst_;
    contact.angle = std::min(covered(stretches_[0]), covered(stretches_[1]));
    return contact;
}

}  // namespace hdconj::conjugate
