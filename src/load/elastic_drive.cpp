// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/load/elastic_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "hdconj/elastic/complementarity.hpp"
#include "hdconj/numeric/dense.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

int grid_of(ElasticDrive const& drive, FlankContact const& c)
{
    int const grid = drive.response.grid();
    int const at = c.tooth * drive.steps_per_tooth % grid;
    return at < 0 ? at + grid : at;
}

/// A flank contact as components of stations.
struct Footing
{
    int at;
    std::size_t station[3];
    double share[3];
};

Footing footing(ElasticDrive const& drive, FlankContact const& c)
{
    DriveStations const& s = drive.stations;
    return {grid_of(drive, c), {s.radial(c.slice), s.tangential(c.slice), s.turn(c.slice)}, {c.c_r, c.c_t, c.c_turn}};
}

double between(PointResponse const& response, Footing const& a, Footing const& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            sum += a.share[i] * b.share[j] * response(a.station[i], b.station[j], a.at - b.at);
    return sum;
}

struct BearingNode
{
    std::size_t height;
    std::size_t angle;
    int at;
};

std::vector<BearingNode> bearing_nodes(ElasticDrive const& drive)
{
    std::vector<BearingNode> nodes;
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w)
        for (std::size_t j = 0; j < drive.stations.bearing; ++j)
            nodes.push_back({j, w, drive.bearing_steps[w]});
    return nodes;
}

/// Where a contact stands: in which row around the ring, and at which of its places.
struct Site
{
    std::size_t row;
    std::size_t place;
};

/// Contacts to begin with, and the points of the line of balls that stand off.
struct Start
{
    std::vector<int> contacts;
    std::vector<bool> off;
};

/// Those of the same problem with contacts at every other place only, each for its neighbours too, which begins with every fourth, and so on: each of these problems takes an eighth of
/// the next one's time. What a start says wrong costs steps and changes no result. Empty where there are few places, or the thinned problem has no solution.
/// @param first   contact that is the first of the bearing
/// @param places  of the bearing around the sector
/// @param turn    to begin with [rad]
Start start_of(Complementarity const& problem, std::optional<BallLine> const& line, std::size_t first, std::vector<Site> const& sites, std::size_t places, double turn, int threads)
{
    constexpr std::size_t few = 32;
    if (places < few)
        return {};
    std::vector<int> kept, of_bearing;
    std::vector<Site> thinned;
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
        if (sites[i].place % 2 != 0)
            continue;
        kept.push_back(static_cast<int>(i));
        if (i >= first)
            of_bearing.push_back(static_cast<int>(i - first));
        thinned.push_back({sites[i].row, sites[i].place / 2});
    }
    Complementarity thin{principal_part(problem.compliance, kept, threads), problem.approach(kept), {}, problem.total};
    if (problem.border.size() > 0)
        thin.border = problem.border(kept);
    std::optional<BallLine> balls;
    if (line)
        balls = BallLine{line->phi, line->held, line->stiffness, line->lift(of_bearing, Eigen::all)};
    std::size_t const flanks = kept.size() - of_bearing.size();
    Start result = start_of(thin, balls, flanks, thinned, (places + 1) / 2, turn, threads);
    ComplementarityOptions options;
    options.scalar = turn;
    options.threads = threads;
    options.start = std::move(result.contacts);
    std::vector<int> contacts;
    try
    {
        if (balls)
        {
            BallContact const found = solve_on_balls(thin, static_cast<Index>(flanks), *balls, options, result.off);
            contacts = found.contacts.contacts;
            result.off.clear();
            for (double const force : found.force)
                result.off.push_back(!(force > 0));
        }
        else
            contacts = solve_complementarity(thin, options).contacts;
    }
    catch (NumericalError const&)
    {
        return {};  // the whole problem will say what is wrong, if it is its own
    }
    std::set<std::pair<std::size_t, std::size_t>> closed;
    for (int const i : contacts)
    {
        auto const whole = static_cast<std::size_t>(kept[static_cast<std::size_t>(i)]);
        auto const [row, place] = sites[whole];
        std::size_t const around = whole < first ? std::numeric_limits<std::size_t>::max() : places;   // teeth about the minor axis are far from each other
        for (std::size_t const near : {place, place + 1 < around ? place + 1 : 0, place > 0 ? place - 1 : around - 1})
            closed.insert({row, near});
    }
    result.contacts.clear();
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (closed.contains({sites[i].row, sites[i].place}))
            result.contacts.push_back(static_cast<int>(i));
    return result;
}

}  // namespace

MatrixXd bearing_compliance(ElasticDrive const& drive, int threads)
{
    std::vector<BearingNode> const nodes = bearing_nodes(drive);
    auto const count = static_cast<Index>(nodes.size());
    MatrixXd g(count, count);
    constexpr std::size_t grain = 16;
    parallel_for(nodes.size(), threads, grain, [&](std::size_t col) {
        auto const j = static_cast<Index>(col);
        BearingNode const& q = nodes[col];
        for (Index i = j; i < count; ++i)
        {
            BearingNode const& p = nodes[static_cast<std::size_t>(i)];
            g(i, j) = drive.response(p.height, q.height, p.at - q.at);
            if (drive.outer_ring)
                g(i, j) += (*drive.outer_ring)(p.height, q.height, p.at - q.at);
            if (drive.between_balls)
                g(i, j) += (*drive.between_balls)(i, j);
        }
    });
    parallel_for(nodes.size(), threads, grain, [&](std::size_t col) {
        auto const j = static_cast<Index>(col);
        g.col(j).head(j) = g.row(j).head(j);
    });
    return g;
}

LineContact ElasticDrive::line_contact(FlankContact const& c) const
{
    return {flexspline, circular_spline, c.curvature, contact_depth};
}

std::vector<double> LocalCompliance::operator()(std::vector<double> const& force) const
{
    std::vector<double> way(force.size());
    for (std::size_t i = 0; i < force.size(); ++i)
        way[i] = own[i] * force[i];
    for (Coupling const& c : couplings)
    {
        way[c.first] += c.compliance * force[c.second];
        way[c.second] += c.compliance * force[c.first];
    }
    return way;
}

LocalCompliance local_compliance(ElasticDrive const& drive, std::vector<FlankContact> const& contacts, std::vector<double> const& force)
{
    constexpr double start_load = 1;  // [N/mm] at which a contact without force is linearised
    LocalCompliance result;
    auto const width = [&](FlankContact const& c) { return drive.slice_width[c.slice]; };
    auto const load = [&](std::size_t i) { return force[i] > 0 ? force[i] / width(contacts[i]) : start_load; };
    // of a line load along the normal, the part along x bends
    auto const bending = [&](FlankContact const& a, FlankContact const& b) {
        return drive.bending(a.tooth_y, b.tooth_y) * std::sqrt((1 - a.inclination * a.inclination) * (1 - b.inclination * b.inclination));
    };
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        FlankContact const& c = contacts[i];
        result.own.push_back((approach(drive.line_contact(c), load(i)) / load(i) + bending(c, c)) / width(c));
        for (std::size_t j = i; j-- > 0;)
        {
            FlankContact const& other = contacts[j];
            if (other.space != c.space || other.flank != c.flank || other.slice != c.slice)
                break;
            if (other.tooth != c.tooth)
                continue;
            // the wider strip decides from where on they are one
            LineContact const a = drive.line_contact(c), b = drive.line_contact(other);
            double const half = std::max(half_width(a, load(i)), half_width(b, load(j)));
            result.couplings.push_back({j, i, (approach_beside(a, std::abs(c.way - other.way), half) + bending(c, other)) / width(c)});
        }
    }
    return result;
}

Equilibrium equilibrium(ElasticDrive const& drive, LinearGaps const& gaps, std::optional<double> torque, Equilibrium const* guess, int threads)
{
    std::vector<BearingNode> const nodes = bearing_nodes(drive);
    if (drive.bearing_compliance.rows() != static_cast<Index>(nodes.size()))
        throw std::logic_error("a drive without the compliance of its bearing's contacts");
    std::size_t const flanks = torque ? gaps.contacts.size() : 0;
    std::size_t const count = flanks + nodes.size();
    std::vector<Footing> feet;
    for (std::size_t i = 0; i < flanks; ++i)
        feet.push_back(footing(drive, gaps.contacts[i]));
    Complementarity problem;
    MatrixXd& a = problem.compliance;
    a.resize(static_cast<Index>(count), static_cast<Index>(count));
    problem.approach.resize(static_cast<Index>(count));
    VectorXd lever = VectorXd::Zero(static_cast<Index>(count));
    auto const first = static_cast<Index>(flanks), bearing = static_cast<Index>(nodes.size());
    constexpr std::size_t grain = 16;
    // columns of flanks from the diagonal down; a tooth pressed inwards moves away, one that the bearing presses outwards comes nearer
    parallel_for(flanks, threads, grain, [&](std::size_t col) {
        auto const j = static_cast<Index>(col);
        for (std::size_t row = col; row < flanks; ++row)
            a(static_cast<Index>(row), j) = between(drive.response, feet[row], feet[col]);
        for (std::size_t row = 0; row < nodes.size(); ++row)
        {
            double& value = a(first + static_cast<Index>(row), j);
            value = 0;
            for (std::size_t i = 0; i < 3; ++i)
                value -= feet[col].share[i] * drive.response(nodes[row].height, feet[col].station[i], nodes[row].at - feet[col].at);
        }
        a(j, j) += gaps.compliance.own[col];
    });
    if (flanks > 0)
        for (LocalCompliance::Coupling const& c : gaps.compliance.couplings)
            a(static_cast<Index>(c.second), static_cast<Index>(c.first)) += c.compliance;
    // what is above the diagonal, and the bearing's own block, which no torque changes
    constexpr std::size_t copies = 64;
    parallel_for(count, threads, copies, [&](std::size_t col) {
        auto const j = static_cast<Index>(col);
        Index const above = std::min(j, first);
        a.col(j).head(above) = a.row(j).head(above);
        if (j >= first)
            a.col(j).tail(bearing) = drive.bearing_compliance.col(j - first);
    });
    for (std::size_t i = 0; i < flanks; ++i)
    {
        FlankContact const& c = gaps.contacts[i];
        problem.approach(static_cast<Index>(i)) = -(c.gap + gaps.displacement[i] + c.lever * gaps.turn);
        lever(static_cast<Index>(i)) = c.lever;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
        problem.approach(static_cast<Index>(flanks + i)) = drive.needed(static_cast<Index>(nodes[i].height), static_cast<Index>(nodes[i].angle));

    ComplementarityOptions options;
    options.scalar = gaps.turn;
    options.threads = threads;
    if (guess != nullptr)
    {
        if (guess->flank.size() == flanks)
            for (std::size_t i = 0; i < flanks; ++i)
                if (guess->flank[i] > 0)
                    options.start.push_back(static_cast<int>(i));
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (guess->bearing(static_cast<Index>(nodes[i].height), static_cast<Index>(nodes[i].angle)) > 0)
                options.start.push_back(static_cast<int>(flanks + i));
    }
    std::vector<bool> off;   // balls that carried nothing in the like problem
    if (guess != nullptr)
        for (double const force : guess->balls)
            off.push_back(!(force > 0));
    double const sectors = drive.response.sectors();
    if (torque)
    {
        if (*torque != 0 && !((lever * *torque).maxCoeff() > 0))
            throw NumericalError("load", "torque of " + std::to_string(*torque / 1000) + " N m", "no flank of that side is near enough to carry it: the teeth pass over each other");
        problem.border = lever;
        problem.total = *torque / sectors;
    }
    // a start from which contacts on one side of the ring would have to find their way to all others
    bool const loaded = flanks > 0 && *torque != 0 && guess != nullptr && std::none_of(guess->flank.begin(), guess->flank.end(), [](double force) { return force > 0; });
    if (guess == nullptr || loaded)
    {
        std::vector<Site> sites;
        for (std::size_t i = 0; i < flanks; ++i)
        {
            FlankContact const& c = gaps.contacts[i];
            sites.push_back({drive.stations.bearing + 2 * c.slice + static_cast<std::size_t>(c.flank), c.space});
        }
        for (BearingNode const& node : nodes)
            sites.push_back({node.height, node.angle});
        Start start = start_of(problem, drive.balls, flanks, sites, drive.bearing_steps.size(), gaps.turn, threads);
        if (!start.contacts.empty())
        {
            options.start = std::move(start.contacts);
            off = std::move(start.off);
        }
    }
    Equilibrium result;
    ComplementaritySolution solved;
    if (drive.balls)
    {
        BallContact balls = solve_on_balls(problem, static_cast<Index>(flanks), *drive.balls, options, off);
        result.balls.assign(balls.force.begin(), balls.force.end());
        solved = std::move(balls.contacts);
    }
    else
        solved = solve_complementarity(problem, options);

    result.turn = torque ? solved.scalar : gaps.turn;
    result.steps = solved.iterations;
    result.complementarity = solved.residual;
    result.stiffness = torque ? sectors * solved.slope : 0;
    for (std::size_t i = 0; i < gaps.contacts.size(); ++i)
        result.flank.push_back(i < flanks ? solved.force(static_cast<Index>(i)) : 0.0);
    result.bearing = MatrixXd::Zero(static_cast<Index>(drive.stations.bearing), static_cast<Index>(drive.bearing_steps.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        result.bearing(static_cast<Index>(nodes[i].height), static_cast<Index>(nodes[i].angle)) = solved.force(static_cast<Index>(flanks + i));
    return result;
}

MatrixXd forces_on_cup(ElasticDrive const& drive, std::vector<FlankContact> const& contacts, Equilibrium const& state)
{
    MatrixXd force = MatrixXd::Zero(static_cast<Index>(drive.stations.count()), drive.response.grid());
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w)
        for (std::size_t j = 0; j < drive.stations.bearing; ++j)
            force(static_cast<Index>(j), drive.bearing_steps[w]) += state.bearing(static_cast<Index>(j), static_cast<Index>(w));
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        Footing const foot = footing(drive, contacts[i]);
        for (std::size_t j = 0; j < 3; ++j)
            force(static_cast<Index>(foot.station[j]), foot.at) -= foot.share[j] * state.flank[i];
    }
    return force;
}

std::vector<std::vector<double>> displacements(ElasticDrive const& drive, MatrixXd const& forces, int threads)
{
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < drive.stations.count(); ++i)
        all.push_back(i);
    return drive.response.series(forces, drive.phase, all, threads);
}

SeriesPlace::SeriesPlace(ElasticDrive const& drive, double phi)
{
    waves_.reserve(drive.response.harmonics().size());
    for (HarmonicResponse const& h : drive.response.harmonics())
        waves_.push_back({static_cast<double>(h.n), std::cos(h.n * phi), std::sin(h.n * phi)});
}

SeriesValue SeriesPlace::operator()(std::vector<double> const& series) const
{
    SeriesValue at;
    for (std::size_t k = 0; k < waves_.size(); ++k)
    {
        Wave const& w = waves_[k];
        at.value += series[2 * k] * w.cosine + series[2 * k + 1] * w.sine;
        at.slope += w.n * (series[2 * k + 1] * w.cosine - series[2 * k] * w.sine);
    }
    return at;
}

SeriesValue series_at(ElasticDrive const& drive, std::vector<double> const& series, double phi)
{
    return SeriesPlace(drive, phi)(series);
}

}  // namespace hdconj
