// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_settle.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "hdconj/load/drive_series.hpp"
#include "hdconj/load/round_edges.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj::detail {
namespace {

constexpr double search_share = 0.15;      // of the module: contacts with a smaller gap are in the problem
constexpr double settled_share = 4e-6;     // of the module: gap of the loaded shape against that of the linear model (1 nm on type-50)
constexpr double near_share = 3;           // of the aim
constexpr double worse = 3;                // mismatch against that of the round before: contacts have changed, what was before says nothing
constexpr int first_look_at_turn = 6;      // round: the first ones may overshoot, with few contacts
constexpr double depth_share = 4e-4;       // of the module: depth of a strip (0.1 um on type-50, where Hertz strips have it at 18 N/mm)

/// A way to go through rounds.
struct Attempt
{
    double depth;      ///< of strips, by the standard one
    int first_mixing;  ///< round from which on the next one is guessed from several: contacts have been found by then
    int most_rounds;
};

/// Where two strips of a flank are just about to be one, rounds go to and fro between one and two: at another depth they are not. And a balance that is not stable,
/// such as a tip about to snap over an edge, draws guessed rounds back to it for ever: plain ones leave it for the next that is.
constexpr Attempt attempts[] = {{1, 3, 25}, {0.5, 3, 25}, {1, 40, 60}, {2, 3, 25}, {0.25, 3, 25}};

std::string place_of(double torque)
{
    return "torque of " + std::to_string(torque / 1000) + " N m";
}

auto flank_of(FlankContact const& c)
{
    return std::tuple(c.space, c.flank, c.slice);
}

/// Forces of @p before, handed to the contacts of @p now that are nearest on the same flank.
std::vector<double> handed_on(std::vector<FlankContact> const& before, std::vector<double> const& force, std::vector<FlankContact> const& now)
{
    std::vector<double> result(now.size(), 0);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        if (!(force[i] > 0))
            continue;
        auto const first = std::lower_bound(now.begin(), now.end(), before[i], [](auto const& a, auto const& b) { return flank_of(a) < flank_of(b); });
        auto best = now.end();
        for (auto c = first; c != now.end() && flank_of(*c) == flank_of(before[i]); ++c)
            if (best == now.end() || std::abs(c->way - before[i].way) < std::abs(best->way - before[i].way))
                best = c;
        if (best != now.end())
            result[static_cast<std::size_t>(best - now.begin())] += force[i];
    }
    return result;
}

/// Largest difference between the gaps of a shape and those that the forces were solved for.
double mismatch(std::vector<FlankContact> const& contacts, std::vector<double> const& force, LocalCompliance const& compliance)
{
    std::vector<double> const way = compliance(force);
    double worst = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        double const gap = contacts[i].gap + way[i];
        worst = std::max(worst, force[i] > 0 ? std::abs(gap) : -gap);
    }
    return worst;
}

/// Shapes that rounds began with and the forces that they came to, to guess the one shape that gives itself (Anderson's mixing): the combination of the last rounds that
/// would leave the least change of displacement.
class Rounds
{
  public:
    void add(LoadWork const& work, LoadedShape const& from, double turn_from, Eigen::MatrixXd const& to, double turn_to)
    {
        std::vector<std::vector<double>> const series = displacements(work.drive, to, work.bench.threads);
        Eigen::VectorXd change(static_cast<Eigen::Index>(series.size() * series.front().size()) + 1);
        Eigen::Index i = 0;
        for (std::size_t station = 0; station < series.size(); ++station)
        {
            // turns of teeth as what they move their tips by
            double const scale = station >= work.drive.stations.turn(0) ? work.scene().drive.module : 1;
            for (std::size_t k = 0; k < series[station].size(); ++k)
                change[i++] = scale * (series[station][k] - from.series[station][k]);
        }
        change[i] = (turn_to - turn_from) * work.bench.geometry.r_m;
        forces_.push_back(to);
        turn_.push_back(turn_to);
        change_.push_back(std::move(change));
        if (forces_.size() > depth)
        {
            forces_.erase(forces_.begin());
            turn_.erase(turn_.begin());
            change_.erase(change_.begin());
        }
    }

    void forget()
    {
        forces_.clear();
        turn_.clear();
        change_.clear();
    }

    /// Forces and turn to go on from.
    [[nodiscard]] std::pair<Eigen::MatrixXd, double> mixed() const
    {
        std::size_t const last = forces_.size() - 1;
        auto const others = static_cast<Eigen::Index>(last);
        Eigen::MatrixXd steps(change_[last].size(), others);
        for (std::size_t i = 0; i < last; ++i)
            steps.col(static_cast<Eigen::Index>(i)) = change_[i + 1] - change_[i];
        Eigen::VectorXd const share = others > 0 ? Eigen::VectorXd(steps.colPivHouseholderQr().solve(change_[last])) : Eigen::VectorXd();
        std::pair<Eigen::MatrixXd, double> result{forces_[last], turn_[last]};
        for (std::size_t i = 0; i < last; ++i)
        {
            double const s = share[static_cast<Eigen::Index>(i)];
            result.first -= s * (forces_[i + 1] - forces_[i]);
            result.second -= s * (turn_[i + 1] - turn_[i]);
        }
        return result;
    }

  private:
    static constexpr std::size_t depth = 5;
    std::vector<Eigen::MatrixXd> forces_;
    std::vector<double> turn_;
    std::vector<Eigen::VectorXd> change_;
};

/// Rounds of one attempt: whether @p now is settled, else what gaps still differ by [mm].
struct Outcome
{
    bool settled;
    double mismatch;
};

Outcome settle(LoadWork const& work, double torque, Attempt const& attempt, Loaded& now)
{
    double last = std::numeric_limits<double>::infinity();
    bool mixes = false;
    Rounds rounds;
    for (int round = 0; round <= attempt.most_rounds; ++round)
    {
        LinearGaps gaps;
        gaps.turn = now.state.turn;
        GapField const field = work.field(now.shape, work.edges);
        gaps.contacts = flank_contacts(field, work.search(gaps.turn, work.reach(), attempt.depth), work.bench.threads);
        std::vector<double> const force = handed_on(now.contacts, now.state.flank, gaps.contacts);
        gaps.compliance = local_compliance(work.drive, gaps.contacts, force);
        if (round > 0)
        {
            double const here = mismatch(gaps.contacts, force, gaps.compliance);
            if (!mixes && here <= work.settled())
            {
                now.residual = here;
                return {true, here};
            }
            // only forces whose own shape was looked at are a result: near the end every other round goes to it
            mixes = round >= attempt.first_mixing && !(mixes && here <= near_share * work.settled());
            if (here > last * worse)
                rounds.forget();
            last = here;
        }
        Equilibrium guess = now.state;
        guess.flank = force;
        gaps.displacement.resize(gaps.contacts.size());
        constexpr std::size_t grain = 64;
        parallel_for(gaps.contacts.size(), work.bench.threads, grain, [&](std::size_t i) { gaps.displacement[i] = normal_displacement(work.drive, now.shape, gaps.contacts[i]); });
        now.state = equilibrium(work.drive, gaps, torque, &guess, work.bench.threads);
        double const pitch = 2 * std::numbers::pi / work.scene().drive.circular_spline_teeth;
        if (round >= first_look_at_turn && std::abs(now.state.turn) > pitch)
            throw NumericalError("load", place_of(torque), "the flexspline turns by more than a pitch, " + std::to_string(now.state.turn * 180 / std::numbers::pi)
                                                              + " deg: the teeth pass over each other; it is more than they can carry");
        ++now.rounds;
        now.steps += now.state.steps;
        now.contacts = std::move(gaps.contacts);
        now.forces = forces_on_cup(work.drive, now.contacts, now.state);
        if (round >= attempt.first_mixing - 1)
            rounds.add(work, now.shape, gaps.turn, now.forces, now.state.turn);
        if (mixes)
            std::tie(now.forces, now.state.turn) = rounds.mixed();
        now.shape = loaded_shape(work.bench, work.drive, now.forces);
    }
    return {false, last};
}

}  // namespace

double edge_radius(Scene const& scene)
{
    constexpr double standard = 0.04;  // of the module
    return scene.load && scene.load->edge_radius ? *scene.load->edge_radius : standard * scene.drive.module;
}

LoadWork::LoadWork(ContactBench const& bench_, ElasticDrive const& drive_, FlankGrid const& flanks_)
    : bench(bench_), drive(drive_), flanks(flanks_),
      edges(with_round_edges(flanks_, edge_radius(bench_.scene), std::numbers::pi / bench_.scene.drive.circular_spline_teeth))
{
}

double LoadWork::reach() const
{
    return search_share * scene().drive.module;
}

double LoadWork::settled() const
{
    return settled_share * scene().drive.module;
}

FlankSearch LoadWork::search(double turn, double limit, double depth) const
{
    auto const whole = static_cast<std::size_t>(scene().drive.circular_spline_teeth);
    // the sector around the major axis, so that a picture of it shows the mesh in one piece
    std::size_t const first = (whole - spaces()) / 2;
    return {turn, limit, first, spaces(), drive.phase, scene().drive.flexspline_teeth, scene().drive.circular_spline_teeth, depth * depth_share * scene().drive.module};
}

GapField LoadWork::field(LoadedShape const& shape, FlankGrid const& grid) const
{
    return {bench.tooth, grid, shape.places, scene().drive.flexspline_teeth, scene().drive.circular_spline_teeth, drive.phase};
}

Loaded settled_at(LoadWork const& work, double torque, Loaded const& start)
{
    std::string const place = place_of(torque);
    Loaded now = start;
    now.rounds = now.steps = 0;
    double mismatch = 0;
    try
    {
        for (Attempt const& attempt : attempts)
        {
            Outcome const outcome = settle(work, torque, attempt, now);
            if (outcome.settled)
                return now;
            mismatch = outcome.mismatch;
        }
    }
    catch (NumericalError const& error)
    {
        std::string const what = error.what();
        if (what.starts_with("load: "))
            throw;
        throw NumericalError("load", place, what);
    }
    throw NumericalError("load", place, "forces and loaded shape do not settle: after " + std::to_string(now.rounds) + " rounds gaps still differ by " + std::to_string(mismatch * 1e3)
                                            + " um; write a larger load.edge_radius, or another circular_spline.backlash_offset");
}

}  // namespace hdconj::detail
