// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds every contact arc of a profile: where it begins, where it ends and why.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "hdconj/envelope/join_arcs.hpp"
#include "hdconj/envelope/trace_closed_form.hpp"
#include "hdconj/envelope/trace_curve.hpp"

namespace hdconj::envelope {

/// Contact arcs of one piece over the lobe [-pi/n, pi/n], before they are cut at cusps.
///
/// Between two critical angles the number of contacts is constant and each is a smooth function of u; so the contacts
/// at the middle of each interval stand for all, and no arc is lost for being shorter than some step. Where the motion
/// has breaks, the ranges between them are traced one by one and their arcs joined.
template <motion::RelativeMotion Motion>
class PieceTracer
{
  public:
    /// @param rates  models of the motion on its smooth ranges, in order
    PieceTracer(Envelope<Motion> const& envelope, std::vector<motion::RatesModel> const& rates, int piece)
        : envelope_(envelope), rates_(rates), piece_(piece)
    {
    }

    [[nodiscard]] std::vector<ContactArc> operator()(TraceRecord& record)
    {
        profile::PieceShape const& shape = envelope_.profile().pieces[static_cast<std::size_t>(piece_)].shape;
        std::vector<SmoothRange> const ranges = smooth_ranges(envelope_.motion());
        std::vector<ContactArc> arcs;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            SmoothRange const& r = ranges[i];
            CutRange const range(r, critical_angles(shape, piece_, envelope_.motion(), rates_[i], r.a, r.b, record));
            if (auto const* curve = std::get_if<profile::CurvePiece>(&shape))
                CurveTracer<Motion>(envelope_, *curve, piece_, range)(arcs);
            else
                ClosedFormTracer<Motion>(envelope_, piece_, range)(arcs);
        }
        join_continuing(arcs, piece_);
        return arcs;
    }

  private:
    Envelope<Motion> const& envelope_;
    std::vector<motion::RatesModel> const& rates_;
    int piece_;
};

}  // namespace hdconj::envelope
