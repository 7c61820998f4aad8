// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_gaps.hpp"

#include <cmath>

#include "hdconj/base/parallel.hpp"
#include "numeric/least_between.hpp"

namespace hdconj::contact {
namespace {

/// Length of a flank in one plane on which the gap is at most @p limit at either end of a step between points, with the
/// two steps beside point @p at.
double length_within(std::vector<Vec2> const& line, std::vector<double> const& gap, std::size_t at, double limit)
{
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (i == at || i + 1 == at || gap[i] <= limit || gap[i + 1] <= limit)
            length += (line[i + 1] - line[i]).norm();
    return length;
}

}  // namespace

std::vector<OpenGap> open_gaps(GapField const& field, std::vector<std::size_t> const& spaces, int flank, double turn,
                               double limit, int threads)
{
    constexpr double flattest = 0.05;
    FlankGrid const& grid = field.grid();
    auto const& points = grid.point[static_cast<std::size_t>(flank)];
    std::vector<OpenGap> result(spaces.size());
    constexpr std::size_t grain = 1;
    parallel_for(spaces.size(), threads, grain, [&](std::size_t s) {
        std::vector<std::vector<double>> gap(grid.slices(), std::vector<double>(grid.points()));
        std::vector<SmallestGap> smallest;
        std::vector<double> low;
        std::size_t lowest = 0;
        for (std::size_t k = 0; k < grid.slices(); ++k) {
            field.along(spaces[s], flank, k, turn, gap[k].data());
            smallest.push_back(smallest_on_line(field, {spaces[s], flank, k, 0}, gap[k].data(), turn,
                                                std::numeric_limits<double>::infinity()));
            low.push_back(smallest.back().gap);
            if (low[k] < low[lowest])
                lowest = k;
        }
        OpenGap& open = result[s];
        open.lowest = open.least = low[lowest];
        open.second = low.front();
        for (std::size_t k = 2; k < low.size(); k += 2)
            open.second = std::min(open.second, low[k]);
        GapField::Index const& where = smallest[lowest].where;
        Vec2 const normal = field.touch(where, turn).normal;
        open.lever = std::max(std::abs(cross(points[where.slice][where.point], normal)), flattest * field.reach());
        std::vector<numeric::BetweenPlaces> const between = numeric::between_places(low);
        for (std::size_t k = 0; k < between.size(); ++k) {
            numeric::BetweenPlaces const& here = between[k];
            open.least = std::min(open.least, here.least);
            double const depth = limit - here.least;
            if (!(depth > 0) || std::min(low[k], low[k + 1]) <= limit)
                continue;
            // c t^2/2 = depth to either side of the lowest place
            double const across = std::min(1.0, 2 * std::sqrt(2 * depth / here.curvature));
            std::size_t const nearer = low[k] < low[k + 1] ? k : k + 1;
            open.missed +=
                across * (grid.z[k + 1] - grid.z[k]) *
                length_within(points[nearer], gap[nearer], smallest[nearer].where.point, low[nearer] + depth);
        }
    });
    return result;
}

}  // namespace hdconj::contact
