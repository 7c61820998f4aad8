// SPDX-License-Identifier: GPL-3.0-or-later
// Points of all branches while another job runs beside them.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "base/deferred_tasks.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/stop.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "records.hpp"

namespace hdconj::conjugate {

/// Indices of @p sizes from the largest on, equal ones in their order.
[[nodiscard]] inline std::vector<std::size_t> largest_first(std::vector<double> const& sizes)
{
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
    return order;
}

/// Fewest branches of @p envelope whose points are worth a thread, for branches as long as the tooth is high. @param
/// chord  [mm]
[[nodiscard]] inline std::size_t branches_worth_a_thread(envelope::AnyEnvelope const& envelope, double chord)
{
    // chords of points that are made in rows; that are made one by one; and of contacts that are roots
    constexpr double in_rows = 8192, one_by_one = in_rows / 8, roots = in_rows / 16;
    profile::Profile const& tooth = envelope.profile();
    double const enough = profile::has_curves(tooth)               ? roots
                          : motion::cosine_form(envelope.motion()) ? in_rows
                                                                   : one_by_one;
    double const chords_of_a_flank = std::sqrt((tooth.addendum + tooth.dedendum) / chord);
    return static_cast<std::size_t>(std::ceil(enough / chords_of_a_flank));
}

/// Every branch of @p envelope as it is written into results, sampled to the chord error @p chord [mm], while one
/// thread calls @p beside(jobs), which has little in loops; it leaves to
/// @p jobs what others may help with, and closes them when it throws. The same bits for every number of threads.
/// @param shown        the tooth as results show it: made by whoever finds no branch left
/// @param evaluations  gets what was added
/// @throws what @p beside or the lowest of its jobs throws
template <class Beside>
[[nodiscard]] std::vector<BranchRecord> records_beside(envelope::AnyEnvelope const& envelope,
                                                       std::vector<envelope::Branch> const& branches, double chord,
                                                       int threads, std::size_t& evaluations, ToothOutline const& shown,
                                                       Beside const& beside)
{
    std::vector<BranchRecord> records(branches.size());
    std::vector<std::size_t> made(branches.size(), 0);
    // who helps at the end is no work that would be worth a thread
    std::size_t const team = std::clamp<std::size_t>((1 + branches.size()) / branches_worth_a_thread(envelope, chord),
                                                     1, static_cast<std::size_t>(threads));
    std::vector<double> chords(branches.size(), 0);
    if (team > 1) {
        std::size_t const grain =
            profile::has_curves(envelope.profile()) ? 2 : 64;  // a contact with a curve takes some microseconds
        parallel_for(branches.size(), static_cast<int>(team), grain, [&](std::size_t i) {
            for (envelope::ContactArc const& arc : branches[i].arcs)
                chords[i] += envelope::expected_chords(envelope, arc, chord);
        });
    }
    std::vector<std::size_t> const order = largest_first(chords);
    DeferredTasks jobs;
    StopScope const whole(nullptr);  // threads wait for the tasks that the first iteration makes: it is not left out
    std::atomic<std::size_t> next_shown = 0;
    parallel_for(1 + order.size() + team, static_cast<int>(team), 1, [&](std::size_t k) {
        if (k == 0)
            return beside(jobs);
        if (k > order.size()) {
            for (std::size_t b = next_shown.fetch_add(1); b < shown.blocks(); b = next_shown.fetch_add(1))
                shown(b);
            return jobs.help();
        }
        std::size_t const i = order[k - 1];
        records[i] = branch_record(envelope, branches[i], chord, made[i]);
    });
    jobs.finish();
    for (std::size_t const count : made)
        evaluations += count;
    return records;
}

}  // namespace hdconj::conjugate
