// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/numeric/bernstein_roots.hpp"

#include <limits>

namespace hdconj::numeric {

CoefficientProof prove_signs(std::span<double const> c, double noise, double slope_noise)
{
    CoefficientProof proof;
    auto const sign = [&](double value) { return value > noise ? 1 : value < -noise ? -1 : 0; };
    proof.left = sign(c.front());
    proof.right = sign(c.back());
    int before = proof.left;
    int uncertain = 0;  // since the last certain sign
    int changes = 0;
    bool certain = proof.left != 0 && proof.right != 0;
    bool clear = certain;
    for (double value : c) {
        proof.largest = std::max(proof.largest, std::abs(value));
        int const now = sign(value);
        if (now == 0) {
            ++uncertain;
            certain = false;
            continue;
        }
        // one uncertain coefficient between different signs leaves one change whatever its sign; others may add two
        clear = clear && uncertain <= (now != before ? 1 : 0);
        changes += now != before;
        before = now;
        uncertain = 0;
    }
    proof.one_sign = certain && changes == 0;
    proof.crossing = clear && changes == 1 && slope_noise == 0;
    if (proof.one_sign || proof.crossing)
        return proof;
    double const n = static_cast<double>(c.size() - 1);
    double const doubt = 2 * noise + (n > 0 ? slope_noise / n : 0);
    double least = std::numeric_limits<double>::infinity();
    int direction = 0;
    for (std::size_t i = 1; i < c.size(); ++i) {
        double const step = c[i] - c[i - 1];
        int const way = step > doubt ? 1 : step < -doubt ? -1 : 0;
        if (way == 0 || (direction != 0 && way != direction))
            return proof;
        direction = way;
        least = std::min(least, std::abs(step) - doubt);
    }
    proof.direction = direction;
    proof.slope = n * least;
    return proof;
}

BernsteinRoots bernstein_roots(std::span<double const> c, double noise)
{
    BernsteinRoots roots;
    auto const f = [&](double t) { return bernstein_value(c, t); };
    auto const record = [&](RootCluster const& cluster) {
        auto const i = static_cast<std::size_t>(roots.count);
        if (i >= roots.t.size()) {
            roots.complete = false;
            return;
        }
        roots.t[i] = cluster.near_double ? 0.5 * (cluster.lo + cluster.hi) : root_in(cluster, f);
        roots.width[i] = cluster.near_double ? cluster.hi - cluster.lo : 0;
        ++roots.count;
    };
    RootClusters<decltype(record)> clusters(record);
    BernsteinWork work{};
    std::copy(c.begin(), c.end(), work.begin());
    bernstein_isolate(std::span<double>(work.data(), c.size()), 0, 1, noise, 0, clusters);
    clusters.finish();
    return roots;
}

}  // namespace hdconj::numeric
