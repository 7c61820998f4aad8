// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_response.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "elastic/ball_line.hpp"
#include "hdconj/base/parallel.hpp"

namespace hdconj::load {

void add_turns(std::vector<HarmonicResponse>& harmonics, std::vector<std::size_t> const& radial,
               std::vector<std::size_t> const& tangential, double radius)
{
    for (HarmonicResponse& h : harmonics) {
        Eigen::Index const old = h.response.rows();
        auto const added = static_cast<Eigen::Index>(radial.size());
        // rows of the map from stations to stations and turns
        Eigen::MatrixXd map = Eigen::MatrixXd::Zero(old + added, old);
        map.topRows(old).setIdentity();
        for (Eigen::Index i = 0; i < added; ++i) {
            auto const k = static_cast<std::size_t>(i);
            map(old + i, static_cast<Eigen::Index>(tangential[k])) = 1 / radius;
            map(old + i, static_cast<Eigen::Index>(radial[k])) = h.n / radius;
        }
        h.response = map * h.response * map.transpose();
    }
}

PointResponse::PointResponse(std::vector<RingStation> stations, std::vector<HarmonicResponse> harmonics, int sectors,
                             int grid, int threads)
    : stations_(std::move(stations)), harmonics_(std::move(harmonics)), sectors_(sectors), grid_(grid)
{
    std::size_t const count = stations_.size();
    auto const points = static_cast<std::size_t>(grid);
    for (HarmonicResponse const& h : harmonics_)
        if (h.n % sectors != 0 || static_cast<std::size_t>(h.response.rows()) != count)
            throw std::logic_error("a harmonic that does not belong to the sectors or stations of a ring");
    // Places 0 ... grid/2: the other half mirrors them, so that the table is symmetric to the last bit.
    Eigen::Index const half = grid / 2 + 1, terms = static_cast<Eigen::Index>(harmonics_.size());
    Eigen::MatrixXd cosine(half, terms), sine(half, terms);
    for (Eigen::Index k = 0; k < terms; ++k)
        for (Eigen::Index i = 0; i < half; ++i) {
            // exact for angles that are whole parts of the turn
            long const part = static_cast<long>(harmonics_[static_cast<std::size_t>(k)].n / sectors_) * i % grid;
            double const angle = 2 * std::numbers::pi * static_cast<double>(part) / grid;
            cosine(i, k) = std::cos(angle);
            sine(i, k) = 2 * part % grid == 0 ? 0 : std::sin(angle);
        }
    table_.resize(count * count * points);
    constexpr std::size_t grain = 4;
    parallel_for(count, threads, grain, [&](std::size_t a) {
        for (bool const mixed : {false, true}) {
            std::vector<std::size_t> partners;
            for (std::size_t b = 0; b <= a; ++b)
                if ((stations_[a].parity != stations_[b].parity) == mixed)
                    partners.push_back(b);
            Eigen::MatrixXd amplitude(terms, static_cast<Eigen::Index>(partners.size()));
            for (Eigen::Index k = 0; k < terms; ++k) {
                HarmonicResponse const& h = harmonics_[static_cast<std::size_t>(k)];
                double const of_a = weight(h.n) * share(h.n, a);
                for (Eigen::Index j = 0; j < amplitude.cols(); ++j) {
                    std::size_t const b = partners[static_cast<std::size_t>(j)];
                    amplitude(k, j) =
                        of_a * share(h.n, b) * h.response(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
                }
            }
            Eigen::MatrixXd const value = (mixed ? sine : cosine) * amplitude;
            // at a to a force at b, and the other way round
            double const there = mixed && stations_[a].parity == RingStation::Parity::cosine ? -1 : 1,
                         back = mixed ? -there : 1, mirror = mixed ? -1 : 1;
            for (Eigen::Index j = 0; j < value.cols(); ++j) {
                std::size_t const b = partners[static_cast<std::size_t>(j)];
                double *const to = table_.data() + (a * count + b) * points, *const from = table_.data() +
                                                                                           (b * count + a) * points;
                for (Eigen::Index i = 0; i < half; ++i) {
                    Eigen::Index const opposite = (grid - i) % grid;
                    to[opposite] = mirror * there * value(i, j);
                    from[opposite] = mirror * back * value(i, j);
                    to[i] = there * value(i, j);
                    from[i] = back * value(i, j);
                }
            }
        }
    });
}

double PointResponse::step() const
{
    return 2 * std::numbers::pi / sectors_ / grid_;
}

double PointResponse::share(int n, std::size_t station) const
{
    return elastic::mean_of_cosine(n, stations_[station].spread);
}

double PointResponse::weight(int n) const
{
    return sectors_ / (n == 0 ? 2 * std::numbers::pi : std::numbers::pi);
}

PointResponse::Loads PointResponse::loads(Eigen::MatrixXd const& force, double phase, int threads) const
{
    auto const count = static_cast<Eigen::Index>(stations_.size());
    auto const terms = static_cast<Eigen::Index>(harmonics_.size());
    Loads result{Eigen::MatrixXd::Zero(count, terms), Eigen::MatrixXd::Zero(count, terms)};
    std::vector<int> loaded;
    for (int at = 0; at < grid_; ++at)
        if (!force.col(at).isZero(0))
            loaded.push_back(at);
    constexpr std::size_t grain = 8;
    parallel_for(harmonics_.size(), threads, grain, [&](std::size_t i) {
        auto const k = static_cast<Eigen::Index>(i);
        int const n = harmonics_[i].n;
        Eigen::VectorXd cosine = Eigen::VectorXd::Zero(count);
        Eigen::VectorXd sine = cosine;
        for (int const at : loaded) {
            double const angle = n * (phase + step() * at);
            cosine += std::cos(angle) * force.col(at);
            sine += std::sin(angle) * force.col(at);
        }
        for (Eigen::Index b = 0; b < count; ++b) {
            auto const station = static_cast<std::size_t>(b);
            double const factor = weight(n) * share(n, station);
            // cos n(phi - phi_b) = cos cos + sin sin
            bool const is_sine = stations_[station].parity == RingStation::Parity::sine;
            result.even(b, k) = factor * (is_sine ? sine(b) : cosine(b));
            result.odd(b, k) = factor * (is_sine ? -cosine(b) : sine(b));
        }
    });
    return result;
}

std::vector<std::vector<double>> PointResponse::series(Eigen::MatrixXd const& force, double phase,
                                                       std::vector<std::size_t> const& wanted, int threads) const
{
    Loads const load = loads(force, phase, threads);
    std::vector<std::vector<double>> result(wanted.size(), std::vector<double>(2 * harmonics_.size(), 0));
    constexpr std::size_t grain = 16;
    parallel_for(harmonics_.size(), threads, grain, [&](std::size_t k) {
        HarmonicResponse const& h = harmonics_[k];
        auto const column = static_cast<Eigen::Index>(k);
        for (std::size_t w = 0; w < wanted.size(); ++w) {
            std::size_t const a = wanted[w];
            double const factor = share(h.n, a);
            double const even = factor * h.response.row(static_cast<Eigen::Index>(a)).dot(load.even.col(column));
            double const odd = factor * h.response.row(static_cast<Eigen::Index>(a)).dot(load.odd.col(column));
            bool const is_sine = stations_[a].parity == RingStation::Parity::sine;
            result[w][2 * k] = is_sine ? -odd : even;
            result[w][2 * k + 1] = is_sine ? even : odd;
        }
    });
    return result;
}

}  // namespace hdconj::load
