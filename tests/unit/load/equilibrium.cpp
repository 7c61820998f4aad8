// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Flanks, bearing and torque together: the bordered problem as a load poses it, on small drives of random contacts.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>

#include "load/elastic_drive.hpp"
#include "load/equilibrium.hpp"
#include "numeric/complementarity.hpp"
#include "support/catch.hpp"
#include "support/oracle/nnls.hpp"

namespace hdconj::test::equilibrium_cases {

using Eigen::Index;

namespace {

constexpr double kkt = 1e-10;

/// One slice and one circle of the bearing, at some of the angles of the grid; an inextensional ring with something of
/// its own at each station.
load::ElasticDrive small_ring(int sectors, int highest, int grid, int teeth, std::vector<int> const& bearing_steps)
{
    std::vector<load::HarmonicResponse> harmonics;
    for (int n = 0; n <= highest; n += sectors) {
        double const u = n == 0 ? 0.3 : 1.0 / (n * n), v = n == 0 ? 0 : -1.0 / (n * n * n),
                     w = n == 0 ? 0.2 : 1.0 / (n * n * n * n) + 0.01;
        Eigen::MatrixXd s = Eigen::MatrixXd::Zero(4, 4);
        // the bearing and the tooth's foot on one wall: the same up to what is local
        s << u + 0.02, u, v, 0, u, u + 0.02, v, 0, v, v, w, 0, 0, 0, 0, 0.1;
        harmonics.push_back({n, 1e-4 * s});
    }
    load::add_turns(harmonics, {1}, {2}, 20.0);
    std::vector<load::RingStation> const stations{{load::RingStation::Parity::cosine, 0.01},
                                                  {load::RingStation::Parity::cosine, 0.1},
                                                  {load::RingStation::Parity::sine, 0.1},
                                                  {load::RingStation::Parity::cosine, 0.1},
                                                  {load::RingStation::Parity::sine, 0.1}};
    load::ElasticDrive drive{{1, 1},
                             std::make_shared<load::PointResponse>(stations, harmonics, sectors, grid, 1),
                             {},
                             {},
                             grid * sectors / teeth,
                             bearing_steps,
                             {},
                             0,
                             teeth,
                             {1.0},
                             {206e3, 0.3},
                             {206e3, 0.3},
                             0.2,
                             {}};
    drive.needed = Eigen::MatrixXd::Zero(1, static_cast<Index>(bearing_steps.size()));
    drive.bearing_compliance = load::bearing_compliance(drive, 1);
    return drive;
}

/// Eight teeth of which four are a sector.
load::ElasticDrive small_drive()
{
    return small_ring(2, 8, 8, 8, {0, 2, 4, 6});
}

/// Forty teeth and contacts of the bearing at every angle of the whole turn, on a cam that is not quite even.
load::ElasticDrive round_drive(std::mt19937& random)
{
    constexpr int grid = 80;
    std::vector<int> steps(grid);
    std::iota(steps.begin(), steps.end(), 0);
    load::ElasticDrive drive = small_ring(1, grid / 2, grid, grid / 2, steps);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (Index i = 0; i < grid; ++i)
        drive.needed(0, i) =
            0.02 * std::cos(4 * std::numbers::pi * static_cast<double>(i) / grid) + 1e-4 * unit(random);
    return drive;
}

struct Problem
{
    load::ElasticDrive drive = small_drive();
    load::LinearGaps gaps;
    double torque = 0;
};

void randomise(std::mt19937& random, Problem& p)
{
    std::uniform_real_distribution<double> unit(0, 1);
    auto const between = [&](double a, double b) { return a + (b - a) * unit(random); };
    for (Index i = 0; i < p.drive.needed.cols(); ++i)
        p.drive.needed(0, i) = between(-0.02, 0.02);
    p.gaps = {};
    p.gaps.turn = between(-0.001, 0.001);
    int const count = 1 + static_cast<int>(8 * unit(random));
    for (int i = 0; i < count; ++i) {
        load::FlankContact c;
        c.space = static_cast<std::size_t>(i);
        c.flank = unit(random) < 0.5 ? 0 : 1;
        c.tooth = i % 4;
        double const lean = between(0.1, 1.2);
        double const side = c.flank == 1 ? 1 : -1;
        c.c_t = side * std::cos(lean);
        c.c_r = std::sin(lean);
        c.c_turn = between(-1, 1);
        c.lever = side * 20 * std::cos(lean);
        c.gap = between(-0.005, 0.02);
        c.curvature = 10;
        p.gaps.contacts.push_back(c);
        p.gaps.displacement.push_back(between(-0.01, 0.01));
        p.gaps.compliance.own.push_back(between(1e-6, 1e-5));
        p.gaps.compliance.offset.push_back(between(-0.002, 0));
        if (i > 0 && unit(random) < 0.3)
            p.gaps.compliance.couplings.push_back(
                {static_cast<std::size_t>(i - 1), static_cast<std::size_t>(i), 0.5e-6});
    }
    p.torque = between(-2000, 2000);
    bool const carried = std::any_of(p.gaps.contacts.begin(), p.gaps.contacts.end(),
                                     [&](load::FlankContact const& c) { return c.lever * p.torque > 0; });
    if (!carried)
        p.torque = -p.torque;
}

/// Gaps of flanks and bearing under forces, by series of the whole ring and not by the matrix that the solver made.
Eigen::VectorXd gaps_under(Problem const& p, std::vector<double> const& flank, Eigen::MatrixXd const& bearing,
                           double turn)
{
    load::Equilibrium state;
    state.flank = flank;
    state.bearing = bearing;
    auto const series = load::displacements(p.drive, load::forces_on_cup(p.drive, p.gaps.contacts, state));
    std::size_t const flanks = flank.size();
    Eigen::VectorXd gap(static_cast<Index>(flanks) + bearing.cols());
    std::vector<double> const way = p.gaps.compliance(flank);
    for (std::size_t i = 0; i < flanks; ++i) {
        load::FlankContact const& c = p.gaps.contacts[i];
        double const phi = 2 * std::numbers::pi * c.tooth / p.drive.flexspline_teeth;
        double const moved = c.c_r * load::series_at(p.drive, series[1], phi).value +
                             c.c_t * load::series_at(p.drive, series[2], phi).value +
                             c.c_turn * load::series_at(p.drive, series[4], phi).value;
        gap[static_cast<Index>(i)] = c.gap + p.gaps.displacement[i] - moved + way[i] - c.lever * (turn - p.gaps.turn);
    }
    for (Index w = 0; w < bearing.cols(); ++w) {
        double const phi = p.drive.response->step() * p.drive.bearing_steps[static_cast<std::size_t>(w)];
        gap[static_cast<Index>(flanks) + w] = load::series_at(p.drive, series[0], phi).value - p.drive.needed(0, w);
    }
    return gap;
}

/// The same problem as plain numbers, column by column from unit forces.
numeric::Complementarity as_matrix(Problem const& p)
{
    std::size_t const flanks = p.gaps.contacts.size(), count = flanks + 4;
    auto const under = [&](std::optional<std::size_t> unit, double turn) {
        std::vector<double> flank(flanks, 0);
        Eigen::MatrixXd bearing = Eigen::MatrixXd::Zero(1, 4);
        if (unit && *unit < flanks)
            flank[*unit] = 1;
        else if (unit)
            bearing(0, static_cast<Index>(*unit - flanks)) = 1;
        return gaps_under(p, flank, bearing, turn);
    };
    numeric::Complementarity problem;
    Eigen::VectorXd const free = under({}, 0);
    problem.approach = -free;
    problem.border = Eigen::VectorXd::Zero(static_cast<Index>(count));
    for (std::size_t i = 0; i < flanks; ++i)
        problem.border[static_cast<Index>(i)] = p.gaps.contacts[i].lever;
    problem.total = p.torque / p.drive.response->sectors();
    problem.compliance.resize(static_cast<Index>(count), static_cast<Index>(count));
    for (std::size_t i = 0; i < count; ++i)
        problem.compliance.col(static_cast<Index>(i)) = under(i, 0) - free;
    problem.compliance = (0.5 * (problem.compliance + problem.compliance.transpose())).eval();
    return problem;
}

Eigen::VectorXd forces_of(load::Equilibrium const& found)
{
    Eigen::VectorXd f(static_cast<Index>(found.flank.size()) + found.bearing.cols());
    for (std::size_t i = 0; i < found.flank.size(); ++i)
        f[static_cast<Index>(i)] = found.flank[i];
    f.tail(found.bearing.cols()) = found.bearing.row(0).transpose();
    return f;
}

/// Turn eliminated: non-negative least squares at a turn, and the turn at which they carry the torque (b . f grows with
/// it, piece by piece in a straight line).
Eigen::VectorXd by_least_squares(numeric::Complementarity const& p)
{
    auto const at = [&](double s) { return hdconj::test::nnls(p.compliance, p.approach + s * p.border); };
    auto const excess = [&](double s) { return p.border.dot(at(s)) - p.total; };
    double low = -1e-3, high = 1e-3;
    while (excess(low) > 0)
        low *= 2;
    while (excess(high) < 0)
        high *= 2;
    double at_low = excess(low), at_high = excess(high);
    int side = 0;
    for (int i = 0; i < 200 && high - low > 1e-17; ++i) {
        double s = (low * at_high - high * at_low) / (at_high - at_low);
        if (!(s > low && s < high))
            s = 0.5 * (low + high);
        double const value = excess(s);
        if (std::abs(value) <= 1e-13 * std::abs(p.total))
            return at(s);
        if (value > 0) {
            high = s;
            at_high = value;
            at_low = side == 1 ? at_low / 2 : at_low;
            side = 1;
        } else {
            low = s;
            at_low = value;
            at_high = side == -1 ? at_high / 2 : at_high;
            side = -1;
        }
    }
    return at(0.5 * (low + high));
}

}  // namespace

TEST_CASE("flanks and bearing balance ten thousand torques", "[load]")
{
    std::mt19937 random(20261122);
    Problem p;
    double worst = 0;
    int most = 0;
    for (int i = 0; i < 10000; ++i) {
        randomise(random, p);
        load::Equilibrium const found = load::equilibrium(p.drive, p.gaps, p.torque, nullptr, 1);
        REQUIRE(found.complementarity <= kkt);
        most = std::max(most, found.steps);
        if (i % 20 != 0)
            continue;
        // every law by another path: series of the ring in place of the solver's matrix
        Eigen::VectorXd const f = forces_of(found), g = gaps_under(p, found.flank, found.bearing, found.turn);
        double balance = 0;
        for (std::size_t k = 0; k < found.flank.size(); ++k)
            balance += p.gaps.contacts[k].lever * found.flank[k] * p.drive.response->sectors();
        double const length = 0.05, force = f.maxCoeff();
        CHECK(f.minCoeff() >= 0);
        worst = std::max({worst, -g.minCoeff() / length, std::abs(balance - p.torque) / (20 * force)});
        for (Index k = 0; k < f.size(); ++k)
            worst = std::max(worst, std::min(f[k] / force, std::abs(g[k]) / length));
    }
    CAPTURE(worst, most);
    CHECK(worst <= kkt);
    CHECK(most < 1000);
}

TEST_CASE("a torque on flanks and bearing is carried as least squares say", "[load]")
{
    std::mt19937 random(41);
    Problem p;
    for (int i = 0; i < 200; ++i) {
        randomise(random, p);
        CAPTURE(i, p.torque, p.gaps.contacts.size());
        numeric::Complementarity const problem = as_matrix(p);
        Eigen::VectorXd const expected = by_least_squares(problem);
        load::Equilibrium const found = load::equilibrium(p.drive, p.gaps, p.torque, nullptr, 1);
        CHECK((forces_of(found) - expected).cwiseAbs().maxCoeff() <= 1e-9 * expected.maxCoeff());
        // no forces that carry the torque have less energy, and the fallback's energy falls in each of its steps
        numeric::ComplementarityOptions projected;
        projected.first = numeric::ContactMethod::projected;
        numeric::ComplementaritySolution const slow = numeric::solve_complementarity(problem, projected);
        CHECK((slow.force - expected).cwiseAbs().maxCoeff() <= 1e-9 * expected.maxCoeff());
        CHECK(std::is_sorted(slow.energies.rbegin(), slow.energies.rend()));
    }
}

TEST_CASE("what a problem begins with changes no bit of its answer", "[load]")
{
    std::mt19937 random(5050);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 20; ++trial) {
        INFO("trial " << trial);
        load::ElasticDrive const drive = round_drive(random);
        load::Equilibrium const free = load::equilibrium(drive, {}, std::nullopt, nullptr, 1);
        load::Equilibrium const again = load::equilibrium(drive, {}, std::nullopt, &free, 1);
        CHECK(free.complementarity < kkt);
        CHECK(free.bearing == again.bearing);
        CHECK(again.steps == 1);

        // teeth all around, nearest about the major axis; without forces to begin with, and with those of the answer
        load::LinearGaps gaps;
        for (int i = 0; i < 40; ++i) {
            load::FlankContact c;
            c.space = static_cast<std::size_t>(i);
            c.flank = 1;
            c.tooth = i - 20;
            c.c_t = 0.8;
            c.c_r = 0.6;
            c.lever = 16;
            c.gap = 1e-5 * (i - 20) * (i - 20) + 1e-4 * unit(random);
            c.curvature = 10;
            gaps.contacts.push_back(c);
            gaps.displacement.push_back(0);
            gaps.compliance.own.push_back(1e-5);
            gaps.compliance.offset.push_back(0);
        }
        load::Equilibrium unloaded = free;
        unloaded.flank.assign(gaps.contacts.size(), 0);
        load::Equilibrium const loaded = load::equilibrium(drive, gaps, 5000.0, &unloaded, 1);
        load::Equilibrium const known = load::equilibrium(drive, gaps, 5000.0, &loaded, 1);
        CHECK(loaded.complementarity < kkt);
        CHECK(loaded.flank == known.flank);
        CHECK(loaded.bearing == known.bearing);
        CHECK(loaded.turn == known.turn);
        CHECK(known.steps == 1);
        CHECK(std::count_if(loaded.flank.begin(), loaded.flank.end(), [](double force) { return force > 0; }) > 3);
    }
}

}  // namespace hdconj::test::equilibrium_cases
