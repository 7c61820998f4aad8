// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The outline of one pitch, cut at its centre line; a symmetric pair's left half is the image of its right one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "conjugate/outline_sampler.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::conjugate {

/// The outline with the index of its middle point, where x = 0.
struct CentredOutline
{
    Outline outline;
    std::size_t middle = 0;
};

/// The boundary's pieces left and right of x = 0.
struct Halves
{
    std::vector<BoundaryPiece> left;
    std::vector<BoundaryPiece> right;
};

/// Cuts the boundary where it crosses x = 0.
/// @throws NumericalError when it does not
template <motion::RelativeMotion Motion>
[[nodiscard]] Halves cut_at_centre_line(envelope::Envelope<Motion> const& envelope,
                                        std::vector<envelope::ContactArc> const& arcs,
                                        std::vector<BoundaryPiece> const& pieces, double pitch,
                                        Tolerance const& tolerance)
{
    auto const x_at = [&](BoundaryPiece const& piece, double u) {
        return TurnedArc<Motion>{envelope, arcs[static_cast<std::size_t>(piece.arc)], piece.copy * pitch}
            .point(u)
            .p.x();
    };
    Halves halves;
    bool crossed = true;
    for (BoundaryPiece const& piece : pieces) {
        double const x_begin = piece.arc < 0 ? piece.begin : x_at(piece, piece.begin);
        double const x_end = piece.arc < 0 ? piece.end : x_at(piece, piece.end);
        if (!halves.right.empty()) {
            halves.right.push_back(piece);
        } else if (x_end <= tolerance.roundoff()) {
            halves.left.push_back(piece);
        } else if (x_begin < -tolerance.roundoff() && piece.arc >= 0) {
            auto const x = [&](double u) { return x_at(piece, u); };
            numeric::BracketedRoot const root =
                numeric::bracketed_root(x, std::min(piece.begin, piece.end), std::max(piece.begin, piece.end));
            crossed = crossed && root.found;
            halves.left.push_back({piece.arc, piece.copy, piece.begin, root.x});
            halves.right.push_back({piece.arc, piece.copy, root.x, piece.end});
        } else {
            halves.right.push_back(piece);
        }
    }
    if (!crossed || halves.left.empty() || halves.right.empty())
        throw NumericalError(ErrorCode::no_outline, "outline", "middle of the tooth space",
                             "does not cross the centre line");
    return halves;
}

/// Mirror image of the right half of a symmetric pair's outline.
[[nodiscard]] inline Outline mirrored(Outline const& half, profile::Profile const& tooth)
{
    Outline image;
    image.chord = half.chord;
    image.error = half.error;
    std::size_t const last = half.points.size() - 1;
    image.points.reserve(2 * half.points.size() + 2);  // the other half follows, and root walls may
    for (auto p = half.points.rbegin(); p != half.points.rend(); ++p)
        image.points.emplace_back(-p->x(), p->y());
    int const segments = static_cast<int>(tooth.segment_names.size());
    for (auto s = half.stretches.rbegin(); s != half.stretches.rend(); ++s) {
        // a corner carries the segment before it, whose image stands after the image of the corner
        int segment = s->segment < 0 ? -1 : segments - 1 - s->segment;
        if (s->kind == OutlineKind::corner)
            segment -= 1;
        image.stretches.push_back({s->kind, segment, last - s->last, last - s->first});
    }
    return image;
}

/// Samples the boundary of one pitch, piece by piece in any order; a symmetric pair's right half is mirrored, bit for
/// bit. What it is made of must outlive it.
template <motion::RelativeMotion Motion>
class CentredOutlineSampler
{
  public:
    /// @throws NumericalError when the boundary does not cross x = 0
    CentredOutlineSampler(envelope::Envelope<Motion> const& envelope, std::vector<envelope::ContactArc> const& arcs,
                          std::vector<BoundaryPiece> const& pieces, double tip_radius, double pitch,
                          Tolerance const& tolerance, double chord)
        : profile_(envelope.profile()), tip_radius_(tip_radius)
    {
        Halves halves = cut_at_centre_line(envelope, arcs, pieces, pitch, tolerance);
        right_.emplace(envelope, arcs, std::move(halves.right), pitch, chord);
        if (!(profile_.mirror_symmetric && envelope.motion().symmetric()))
            left_.emplace(envelope, arcs, std::move(halves.left), pitch, chord);
    }

    [[nodiscard]] std::size_t count() const { return right_->count() + (left_ ? left_->count() : 0); }
    [[nodiscard]] double expected(std::size_t i) const
    {
        return i < right_->count() ? right_->expected(i) : left_->expected(i - right_->count());
    }
    void sample(std::size_t i, int threads)
    {
        i < right_->count() ? right_->sample(i, threads) : left_->sample(i - right_->count(), threads);
    }

    [[nodiscard]] CentredOutline joined() const
    {
        Outline right = right_->joined(tip_radius_);
        right.points.front().x() = 0;
        CentredOutline result{left_ ? left_->joined(tip_radius_) : mirrored(right, profile_), 0};
        Outline& whole = result.outline;
        result.middle = whole.points.size() - 1;
        whole.points.pop_back();
        whole.points.insert(whole.points.end(), right.points.begin(), right.points.end());
        for (OutlineStretch stretch : right.stretches) {
            stretch.first += result.middle;
            stretch.last += result.middle;
            whole.stretches.push_back(stretch);
        }
        whole.chord = std::max(whole.chord, right.chord);
        whole.error = std::max(whole.error, right.error);
        whole.evaluations += right.evaluations;
        return result;
    }

  private:
    profile::Profile const& profile_;
    double tip_radius_;
    std::optional<OutlineSampler<Motion>> right_;
    std::optional<OutlineSampler<Motion>> left_;  ///< absent: the mirror image of the right one
};

}  // namespace hdconj::conjugate
