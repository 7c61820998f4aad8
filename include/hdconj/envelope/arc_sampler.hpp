// SPDX-License-Identifier: GPL-3.0-or-later
// One arc being sampled.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hdconj/base/parallel.hpp"
#include "hdconj/envelope/chord_bound.hpp"
#include "hdconj/envelope/chord_measure.hpp"
#include "hdconj/envelope/contact_batch.hpp"
#include "hdconj/envelope/envelope.hpp"
#include "hdconj/envelope/sampled_arc.hpp"

namespace hdconj::envelope {

/// Some twenty points, refined where neighbours turn too much for their chords' errors to be trusted, or lie much
/// farther apart than others.
/// @param at     EnvelopePoint at s in [0, 1]
/// @param chord  chord error wanted of the polygon [mm]
/// @param evaluations  is added to
template <class PointAt>
[[nodiscard]] ChordMeasure probe_chords(PointAt const& at, double chord, std::size_t& evaluations)
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
    for (std::size_t i = 0; i < first_points; ++i) {
        double const s = static_cast<double>(i) / (first_points - 1);
        found.push_back({s, at(s), 0});
    }
    double const whole = (found.back().e.p - found.front().e.p).norm();
    for (std::size_t i = 0; i + 1 < found.size();) {
        Station const& a = found[i];
        Station const& b = found[i + 1];
        double const turn = std::abs(std::atan2(cross(a.e.n, b.e.n), a.e.n.dot(b.e.n)));
        double const length = (b.e.p - a.e.p).norm();
        bool const uneven = length > whole / 4 && length > chord;
        if ((turn > trusted_turn || uneven) && chord_error(a.e, b.e) > chord && a.depth < deepest) {
            int const depth = a.depth + 1;
            double const s = 0.5 * (a.s + b.s);
            found[i].depth = depth;
            found.insert(found.begin() + static_cast<std::ptrdiff_t>(i) + 1, {s, at(s), depth});
        } else {
            ++i;
        }
    }
    evaluations += found.size();
    std::vector<double> stations;
    std::vector<double> errors;
    for (std::size_t i = 0; i < found.size(); ++i) {
        stations.push_back(found[i].s);
        if (i > 0)
            errors.push_back(chord_error(found[i - 1].e, found[i].e));
    }
    return {std::move(stations), errors, chord};
}

/// One arc being sampled, in three passes. The first takes some twenty points, and more where neighbours turn too much
/// for their chord errors to be trusted. The second adds some hundred where a long polygon needs them. The third is the
/// polygon.
template <motion::RelativeMotion Motion>
class ArcSampler
{
  public:
    ArcSampler(Envelope<Motion> const& envelope, ContactArc const& arc, double from, double to, double chord,
               int threads, ChordTest test)
        : envelope_(envelope),
          arc_(arc),
          window_(arc),
          batch_(contact_batch(envelope, arc)),
          chord_(chord),
          threads_(threads),
          test_(test)
    {
        // the share of the smooth parameter that [from, to] covers is not needed: a parameter that is smooth at both of
        // its own ends is enough, and it is only at true ends that the arc's speed has a root singularity
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
        if (test_ == ChordTest::bound)
            return polygon(measured());
        std::vector<EnvelopePoint> points;
        SampledArc result = in_parts([&](std::span<EnvelopePoint const> part, std::size_t to_come) {
            make_room(points, to_come);
            points.insert(points.end(), part.begin(), part.end());
        });
        result.points = std::move(points);
        return result;
    }

    /// The polygon whose chords are estimated, in order of u, part by part as it is made: of a long one nothing is kept
    /// but what @p take keeps. Without points in the result.
    /// @param take  (points, how many are to come with them, unless chords are cut)
    template <class Take>
    SampledArc in_parts(Take&& take)
    {
        ChordMeasure const measure = measured();
        std::size_t const count = chords(measure);
        std::size_t const longest = std::min(block, count);
        std::vector<double> stations(longest + 1), errors(longest), bends(longest);
        std::vector<EnvelopePoint> points(longest + 1);
        SampledArc result;
        make_room(result.points, longest + 1);
        for (std::size_t first = 0; first < count; first += block) {
            std::size_t const size = std::min(block, count - first);
            std::size_t const known = first == 0 ? 0 : 1;
            if (first > 0) {
                stations.front() = stations[block];
                points.front() = points[block];
            }
            place(measure, count, first + known, std::span(stations).subspan(known, size + 1 - known),
                  std::span(points).subspan(known, size + 1 - known));
            chord_errors(std::span(points).first(size + 1), std::span(errors).first(size),
                         std::span(bends).first(size));
            result.points.clear();
            if (first == 0)
                result.points.push_back(points.front());
            cut_coarse_chords([&](double s) { return at(s); }, std::span(stations).first(size + 1),
                              std::span(points).first(size + 1), std::span(errors).first(size), chord_,
                              ChordTest::estimate, result);
            take(std::span<EnvelopePoint const>(result.points), count - first + 1 - known);
        }
        evaluations_ += count + 1;
        result.evaluations += evaluations_;
        result.points.clear();
        return result;
    }

  private:
    static constexpr std::size_t block = 256;  // points; as many as stay, with their chords, in the nearest caches

    [[nodiscard]] ChordMeasure measured()
    {
        ChordMeasure measure = probe_chords([&](double s) { return at(s); }, chord_, evaluations_);
        constexpr std::size_t closer = 256;
        constexpr double worth_a_closer_look = 4;  // chords a point of it
        if (measure.total() > worth_a_closer_look * closer) {
            place(measure, closer);
            look_(points_, threads_);
            measure = ChordMeasure(stations_, look_.errors, chord_);
        }
        return measure;
    }

    [[nodiscard]] static std::size_t chords(ChordMeasure const& measure)
    {
        constexpr double margin = 1.02;
        return static_cast<std::size_t>(std::max(1.0, std::ceil(margin * measure.total())));
    }

    [[nodiscard]] EnvelopePoint at(double s) const { return envelope_.point(arc_, arc_parameter_to_u(window_, s)); }

    /// Stations that cut the arc into @p count equal shares, and the points there.
    void place(ChordMeasure const& measure, std::size_t count)
    {
        stations_.resize(count + 1);
        points_.resize(count + 1);
        // no point depends on its block
        std::size_t const blocks_worth_a_thread = batch_ ? 32 : 8;
        parallel_for((points_.size() + block - 1) / block, threads_, blocks_worth_a_thread, [&](std::size_t b) {
            std::size_t const first = b * block;
            std::size_t const size = std::min(block, points_.size() - first);
            place(measure, count, first, std::span(stations_).subspan(first, size),
                  std::span(points_).subspan(first, size));
        });
        evaluations_ += points_.size();
    }

    /// The same, of stations @p first, @p first + 1, ... only; no more than a block of them.
    void place(ChordMeasure const& measure, std::size_t count, std::size_t first, std::span<double> stations,
               std::span<EnvelopePoint> points) const
    {
        measure.shares(count, first, stations);
        if (!batch_) {
            std::transform(stations.begin(), stations.end(), points.begin(), [&](double s) { return at(s); });
            return;
        }
        std::array<double, block + 1> u;
        std::transform(stations.begin(), stations.end(), u.begin(),
                       [&](double s) { return arc_parameter_to_u(window_, s); });
        point_batch(envelope_, arc_, *batch_, std::span<double const>(u).first(stations.size()), points);
    }

    [[nodiscard]] SampledArc polygon(ChordMeasure const& measure)
    {
        std::size_t count = chords(measure);
        std::vector<double> const& errors = look_.errors;
        auto const point_at = [&](double s) { return at(s); };
        double worst = 0;
        constexpr int attempts = 4;
        for (int attempt = 1;; ++attempt) {
            place(measure, count);
            look_(points_, threads_);
            bound_chords(point_at, stations_, points_, look_, evaluations_);
            // where many chords are a little too coarse, a few more over the whole arc are fewer than a cut in each
            worst = *std::max_element(errors.begin(), errors.end());
            auto const failing = static_cast<std::size_t>(
                std::count_if(errors.begin(), errors.end(), [&](double error) { return error > chord_; }));
            double const grown = std::max(static_cast<double>(count + 1),
                                          std::ceil(static_cast<double>(count) * std::sqrt(worst / chord_)));
            if (failing == 0 || attempt == attempts || !(grown < static_cast<double>(count + failing)))
                break;
            count = static_cast<std::size_t>(grown);
        }
        SampledArc result;
        result.evaluations = evaluations_;
        if (worst <= chord_) {
            result.chord = worst;
            result.points = std::move(points_);
        } else {
            make_room(result.points, points_.size());
            result.points.push_back(points_.front());
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

}  // namespace hdconj::envelope
