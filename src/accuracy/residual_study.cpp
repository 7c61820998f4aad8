// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of the meshing condition at the contacts of a solution, by the reference's path.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#include "accuracy/reference/reference_contact.hpp"
#include "study_drive.hpp"

namespace hdconj::accuracy {
namespace {

using Wide = long double;

/// Unit normal of a piece at @p t of its own 0 ... 1, where @p x lies on it.
Pair<Wide> normal_at(profile::PieceShape const& shape, Wide t, Pair<Wide> const& x)
{
    auto const unit = [](Pair<Wide> const& v) { return (Wide(1) / length(v)) * v; };
    if (auto const* arc = std::get_if<profile::ArcPiece>(&shape))
        return unit(x - pair_of<Wide>(arc->centre));
    if (auto const* line = std::get_if<profile::LinePiece>(&shape))
        return unit(to_left(pair_of<Wide>(line->b) - pair_of<Wide>(line->a)));
    auto const& curve = std::get<profile::CurvePiece>(shape);
    return unit(to_left(Pair<Wide>{casteljau(numeric::bernstein_derivative(curve.x()), t),
                                   casteljau(numeric::bernstein_derivative(curve.y()), t)}));
}

/// The piece of a segment that has parameter @p t; null where a corner has it.
profile::ProfilePiece const* piece_at(profile::Profile const& tooth, int segment, double t)
{
    for (profile::ProfilePiece const& piece : tooth.pieces)
        if (piece.segment == segment && !piece.corner && t >= piece.t_begin && t <= piece.t_end)
            return &piece;
    return nullptr;
}

}  // namespace

double residual_of(StudyDrive const& drive, Solution const& solution, std::size_t samples)
{
    std::vector<ReferenceView<Wide>> const views = drive.views<Wide>();
    std::size_t all = 0;
    for (BranchRecord const& branch : solution.branches)
        all += branch.u.size();
    std::size_t const stride = std::max<std::size_t>(1, all / samples);
    Wide worst = 0;
    std::size_t count = 0;
    for (BranchRecord const& branch : solution.branches) {
        if (branch.kind != "regular")
            continue;
        ReferenceView<Wide> const& view = views[drive.index_of(branch.tooth)];
        Wide const lifted =
            drive.reverse() ? Wide(drive.geometry.pitch_line) : Wide(0);  // branches count from the pitch line
        for (std::size_t i = 0; i < branch.u.size(); ++i) {
            if (count++ % stride != 0)
                continue;
            profile::ProfilePiece const* const piece = piece_at(drive.tooth, branch.segment, branch.t[i]);
            if (piece == nullptr)
                continue;
            MovingFrame<Wide> const place =
                view.at(drive.scene.solver.kinematics == Kinematics::exact ? branch.u[i] : branch.phi[i]);
            Pair<Wide> const p{branch.point[i].x() - place.origin.x, branch.point[i].y() + lifted - place.origin.y};
            Pair<Wide> const x{inner(p, place.along), inner(p, place.outward)};
            Wide const local = (Wide(branch.t[i]) - piece->t_begin) / (Wide(piece->t_end) - piece->t_begin);
            worst =
                std::max(worst, std::abs(inner(place.turned(normal_at(piece->shape, local, x)), place.velocity(x))));
        }
    }
    return static_cast<double>(worst);
}

}  // namespace hdconj::accuracy
