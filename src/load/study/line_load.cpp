// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_load.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hdconj::load {
namespace {

/// Integral from z.front() to @p at.
double integral(std::span<double const> z, std::span<double const> value, double at)
{
    double sum = 0;
    for (std::size_t k = 0; k + 1 < z.size() && z[k] < at; ++k) {
        double const length = std::min(at, z[k + 1]) - z[k];
        double const slope = (value[k + 1] - value[k]) / (z[k + 1] - z[k]);
        sum += length * (value[k] + 0.5 * slope * length);
    }
    return sum;
}

}  // namespace

double largest_mean(std::span<double const> z, std::span<double const> value, double width)
{
    if (z.size() < 2)
        return value.front();
    if (width >= z.back() - z.front())
        return integral(z, value, z.back()) / (z.back() - z.front());
    double largest = 0;
    auto const look_at = [&](double begin) {
        begin = std::clamp(begin, z.front(), z.back() - width);
        largest = std::max(largest, (integral(z, value, begin + width) - integral(z, value, begin)) / width);
    };
    for (std::size_t k = 0; k < z.size(); ++k) {
        look_at(z[k]);
        look_at(z[k] - width);
        if (k == 0 || k + 1 == z.size())
            continue;
        double const rise = (value[k] - value[k - 1]) / (z[k] - z[k - 1]);
        double const fall = (value[k] - value[k + 1]) / (z[k + 1] - z[k]);
        if (rise > 0 && fall > 0)  // equal values at both ends of the interval
            look_at(z[k] - width * fall / (rise + fall));
    }
    return largest;
}

double largest_between(std::span<double const> z, std::span<double const> value, double from, double to)
{
    double largest = 0;
    for (std::size_t k = 0; k < z.size(); ++k) {
        if (from <= z[k] && z[k] <= to)
            largest = std::max(largest, value[k]);
        for (double const end : {from, to})
            if (k > 0 && z[k - 1] < end && end < z[k])
                largest = std::max(largest, std::lerp(value[k - 1], value[k], (end - z[k - 1]) / (z[k] - z[k - 1])));
    }
    return largest;
}

std::vector<double> shares_at_ends(std::span<double const> z, double width)
{
    std::vector<double> shares(z.size(), 0), hat(z.size(), 0);
    if (z.size() < 2)
        return shares;
    double const reach = std::min(width, 0.5 * (z.back() - z.front()));
    for (std::size_t k = 0; k < z.size(); ++k) {
        hat[k] = 1;
        double const all = integral(z, hat, z.back());
        shares[k] = (integral(z, hat, z.front() + reach) + all - integral(z, hat, z.back() - reach)) / all;
        hat[k] = 0;
    }
    return shares;
}

}  // namespace hdconj::load
