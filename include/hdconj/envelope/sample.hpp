// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Samples an envelope arc so that its polygon stays within a chord error, with no more points than that needs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hdconj/envelope/chord_bound.hpp"
#include "hdconj/envelope/chord_measure.hpp"
#include "hdconj/envelope/contact_batch.hpp"
#include "hdconj/envelope/envelope.hpp"
#include "hdconj/envelope/sampled_arc.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj {

namespace detail {

/// One arc being sampled. Three looks: some twenty points, refined where neighbours turn too much for their chords' errors to be trusted; for a long
/// polygon some hundred more, where those of the first look say; and the polygon.
template<RelativeMotion Motion>
class ArcSampler
{
  public:
    ArcSampler(Envelope<Motion> const& envelope, ContactArc const& arc, double from, double to, double chord, int threads, ChordTest test)
        : envelope_(envelope), arc_(arc), window_(arc), batch_(contact_batch(envelope, arc)), chord_(chord), threads_(threads), test_(test)
    {
        // the share of the smooth parameter that [from, to] covers is not needed: a parameter that is smooth at both of its own
        // ends is enough, and it is only at true ends that the arc's speed has a root singularity
        window_.u_begin = std::min(from, to);
        window_.u_end = std::max(from, to);
        if (window_.u_begin != arc.u_begin)
            window_.begins = BranchEnd::continues;
        if (window_.u_end != arc.u_end)
            window_.ends = BranchEnd::continues;
    }

    /// Points in order of u.
    [[nodiscard]] SampledArc operator()()
    {
        ChordMeasure measure = first_look();
        constexpr std::size_t closer = 256;
        constexpr double worth_a_closer_look = 4;   // chords a point of it
        if (measure.total() > worth_a_closer_look * closer)
        {
            place(measure, closer);
            look_(points_, threads_);
            measure = ChordMeasure(stations_, look_.errors, chord_);
        }
        return polygon(measure);
    }

  private:
    [[nodiscard]] EnvelopePoint at(double s) const { return envelope_.point(arc_, arc_parameter_to_u(window_, s)); }

    ChordMeasure first_look()
    {
        constexpr std::size_t first_points = 17;
        constexpr double trusted_turn = 0.06;
        constexpr int deepest = 40;
        struct Station
        {
            double s;
            EnvelopePoint e;
            int depth;
        };
        std::vector<Station> found;
        for (std::size_t i = 0; i < first_points; ++i)
        {
            double const s = static_cast<double>(i) / (first_points - 1);
            found.push_back({s, at(s), 0});
        }
        double const whole = (found.back().e.p - found.front().e.p).norm();
        for (std::size_t i = 0; i + 1 < found.size();)
        {
            Station const& a = found[i];
            Station const& b = found[i + 1];
            double const turn = std::abs(std::atan2(cross(a.e.n, b.e.n), a.e.n.dot(b.e.n)));
            double const length = (b.e.p - a.e.p).norm();
            bool const uneven = length > whole / 4 && length > chord_;
            if ((turn > trusted_turn || uneven) && chord_error(a.e, b.e) > chord_ && a.depth < deepest)
            {
                int const depth = a.depth + 1;
                double const s = 0.5 * (a.s + b.s);
                found[i].depth = depth;
                found.insert(found.begin() + static_cast<std::ptrdiff_t>(i) + 1, {s, at(s), depth});
            }
            else
            {
                ++i;
            }
        }
        evaluations_ += found.size();
        std::vector<double> stations;
        std::vector<double> errors;
        for (std::size_t i = 0; i < found.size(); ++i)
        {
            stations.push_back(found[i].s);
            if (i > 0)
                errors.push_back(chord_error(found[i - 1].e, found[i].e));
        }
        return {std::move(stations), errors, chord_};
    }

    /// Stations that cut the arc into @p count equal shares, and the points there.
    void place(ChordMeasure const& measure, std::size_t count)
    {
        stations_.resize(count + 1);
        points_.resize(count + 1);
        // blocks of fixed size; with a batch no point depends on its block
        constexpr std::size_t block = 256;
        std::size_t const blocks_worth_a_thread = batch_ ? 64 : 32;
        parallel_for((points_.size() + block - 1) / block, threads_, blocks_worth_a_thread, [&](std::size_t b) {
            std::size_t const first = b * block;
            std::size_t const size = std::min(block, points_.size() - first);
            std::span<double> const stations = std::span(stations_).subspan(first, size);
            std::span<EnvelopePoint> const points = std::span(points_).subspan(first, size);
            measure.shares(count, first, stations);
            if (!batch_)
            {
                std::transform(stations.begin(), stations.end(), points.begin(), [&](double s) { return at(s); });
                return;
            }
            std::array<double, block> u;
            std::transform(stations.begin(), stations.end(), u.begin(), [&](double s) { return arc_parameter_to_u(window_, s); });
            point_batch(envelope_, arc_, *batch_, std::span(u).first(size), points);
        });
        evaluations_ += points_.size();
    }

    [[nodiscard]] SampledArc polygon(ChordMeasure const& measure)
    {
        constexpr double margin = 1.02;
        auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(margin * measure.total())));
        std::vector<double> const& errors = look_.errors;
        auto const point_at = [&](double s) { return at(s); };
        double worst = 0;
        constexpr int attempts = 4;
        for (int attempt = 1;; ++attempt)
        {
            place(measure, count);
            look_(points_, threads_);
            worst = *std::max_element(errors.begin(), errors.end());
            if (test_ == ChordTest::estimate)
                break;
            bound_chords(point_at, stations_, points_, look_, evaluations_);
            // where many chords are a little too coarse, a few more over the whole arc are fewer than a cut in each
            worst = *std::max_element(errors.begin(), errors.end());
            auto const failing = static_cast<std::size_t>(std::count_if(errors.begin(), errors.end(), [&](double error) { return error > chord_; }));
            double const grown = std::max(static_cast<double>(count + 1), std::ceil(static_cast<double>(count) * std::sqrt(worst / chord_)));
            if (failing == 0 || attempt == attempts || !(grown < static_cast<double>(count + failing)))
                break;
            count = static_cast<std::size_t>(grown);
        }
        SampledArc result;
        result.evaluations = evaluations_;
        if (worst <= chord_)
        {
            result.chord = worst;
            result.points = std::move(points_);
        }
        else
        {
            cut_coarse_chords(point_at, stations_, points_, errors, chord_, test_, result);
        }
        return result;
    }

    Envelope<Motion> const& envelope_;
    ContactArc const& arc_;
    ContactArc window_;
    std::optional<ContactBatch> batch_;
    double chord_;
    int threads_;
    ChordTest test_;
    std::vector<double> stations_;
    std::vector<EnvelopePoint> points_;
    ChordLook look_;
    std::size_t evaluations_ = 0;
};

}  // namespace detail

/// Points equidistributed in sqrt(turn * length): for a smooth curve each chord then has the same error, which is the fewest
/// points possible up to higher order. Places that the looks before misjudged are cut again until every chord passes.
///
/// @param from, to  interval of u inside the arc; from > to gives the points in reverse order
/// Accuracy: every point is an exact contact (not interpolated); `chord` is within a few per cent of the true chord error, and by default not below it.
template<RelativeMotion Motion>
[[nodiscard]] SampledArc sample_arc(Envelope<Motion> const& envelope, ContactArc const& arc, double from, double to, double chord,
                                    int threads, ChordTest test = ChordTest::bound)
{
    SampledArc result = detail::ArcSampler<Motion>(envelope, arc, from, to, chord, threads, test)();
    for (EnvelopePoint const& e : result.points)
        result.error = std::max(result.error, e.error);
    if (from > to)
        std::reverse(result.points.begin(), result.points.end());
    return result;
}

}  // namespace hdconj
