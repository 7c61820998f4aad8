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
    // cos and sin of n times every angle of the grid, exact for angles that are whole parts of the turn
    std::vector<double> cosine(points), sine(points);
    for (std::size_t i = 0; i < points; ++i) {
        double const angle = 2 * std::numbers::pi * static_cast<double>(i) / grid;
        cosine[i] = std::cos(angle);
        sine[i] = std::sin(angle);
    }
    table_.assign(count * count * points, 0);
    constexpr std::size_t grain = 4;
    parallel_for(count, threads, grain, [&](std::size_t a) {
        for (std::size_t b = 0; b < count; ++b) {
            double* const row = table_.data() + (a * count + b) * points;
            bool const mixed = stations_[a].parity != stations_[b].parity;
            double const sign = stations_[a].parity == RingStation::Parity::sine ? 1 : -1;
            for (HarmonicResponse const& h : harmonics_) {
                double const amplitude = weight(h.n) * share(h.n, a) * share(h.n, b) *
                                         h.response(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) *
                                         (mixed ? sign : 1);
                if (amplitude == 0)
                    continue;
                std::vector<double> const& wave = mixed ? sine : cosine;
                auto const order = static_cast<std::size_t>(h.n / sectors_) % points;
                std::size_t at = 0;
                for (std::size_t i = 0; i < points; ++i) {
                    row[i] += amplitude * wave[at];
                    at += order;
                    if (at >= points)
                        at -= points;
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
