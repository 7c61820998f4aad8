// SPDX-License-Identifier: GPL-3.0-or-later
#include "gap_on_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace hdconj::io {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Weight of each value of a rising sequence in the trapezium rule; a single one weighs 1.
std::vector<double> weights(std::vector<double> const& at)
{
    std::vector<double> result(at.size(), at.size() == 1 ? 1.0 : 0.0);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        double const half = (at[i + 1] - at[i]) / 2;
        result[i] += half;
        result[i + 1] += half;
    }
    return result;
}

/// Between which values @p x lies: index of the lower and share of the upper one. Ends are held on to.
struct Between
{
    std::size_t lower = 0, upper = 0;
    double share = 0;
};

Between between(std::vector<double> const& at, double x)
{
    auto const above = std::upper_bound(at.begin(), at.end(), x);
    if (above == at.begin())
        return {};
    std::size_t const lower = static_cast<std::size_t>(above - at.begin()) - 1;
    if (above == at.end())
        return {lower, lower, 0};
    return {lower, lower + 1, (x - at[lower]) / (at[lower + 1] - at[lower])};
}

double gap_at(GapMap const& map, FlankOfMap const& flank, double z, double station)
{
    Between const slice = between(map.z, z), point = between(map.station, station);
    auto const row = [&](std::size_t k) {
        return (1 - point.share) * map.at(flank.space, flank.flank, k, point.lower) +
               point.share * map.at(flank.space, flank.flank, k, point.upper);
    };
    return (1 - slice.share) * row(slice.lower) + slice.share * row(slice.upper);
}

/// Index into the map for each tooth space, counted clockwise from the y axis of the circular spline.
std::vector<std::size_t> spaces_of(GapMap const& map, double wave_generator)
{
    auto const count = map.angle.size();
    double const pitch = 2 * std::numbers::pi / static_cast<double>(count);
    std::vector<std::size_t> found(count, count);
    for (std::size_t s = 0; s < count; ++s) {
        auto const number = std::llround((map.angle[s] + wave_generator) / pitch);
        auto const wrapped =
            ((number % static_cast<long long>(count)) + static_cast<long long>(count)) % static_cast<long long>(count);
        found[static_cast<std::size_t>(wrapped)] = s;
    }
    if (std::find(found.begin(), found.end(), count) != found.end())
        throw std::logic_error("the tooth spaces of a gap map are not a whole ring");
    return found;
}

}  // namespace

FlankOfMap fullest_flank(GapMap const& map, double contact_gap)
{
    auto const slice_weight = weights(map.z), point_weight = weights(map.station);
    FlankOfMap best;
    double most = 0, least_gap = std::numeric_limits<double>::infinity();
    for (int const flank : {GapMap::right, GapMap::left}) {
        for (std::size_t s = 0; s < map.angle.size(); ++s) {
            double area = 0, smallest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < map.z.size(); ++k) {
                for (std::size_t p = 0; p < map.station.size(); ++p) {
                    double const gap = map.at(s, flank, k, p);
                    area += gap <= contact_gap ? slice_weight[k] * point_weight[p] : 0;
                    smallest = std::min(smallest, gap);
                }
            }
            if (area > most || (area == most && smallest < least_gap)) {
                best = {s, flank, area > 0};
                most = area;
                least_gap = smallest;
            }
        }
        if (most > 0)
            break;
    }
    return best;
}

FlankStations::FlankStations(CircularSplineOutline const& spline, int flank)
{
    if (spline.landmarks.size() != landmark_count || spline.outline.empty())
        throw std::logic_error("an outline without landmarks has no flanks");
    land_ = spline.landmarks[flank == GapMap::left ? 0 : 4];
    end_ = spline.landmarks[flank == GapMap::left ? 1 : 3];
    station_ = lengths(spline.outline[spline.outline.size() / 2]);
    double const whole = station_.back();
    for (double& station : station_)
        station = whole > 0 ? station / whole : 0;
}

std::vector<double> FlankStations::lengths(std::vector<Vec2> const& outline) const
{
    int const step = end_ > land_ ? 1 : -1;
    std::vector<double> result = {0.0};
    for (int i = land_; i != end_; i += step) {
        Vec2 const chord = outline.at(static_cast<std::size_t>(i + step)) - outline.at(static_cast<std::size_t>(i));
        result.push_back(result.back() + chord.norm());
    }
    return result;
}

std::optional<double> FlankStations::at(std::size_t index) const
{
    int const here = static_cast<int>(index);
    if (here < std::min(land_, end_) || here > std::max(land_, end_))
        return {};
    return station_[static_cast<std::size_t>(std::abs(here - land_))];
}

std::vector<double> FlankStations::along(std::vector<Vec2> const& outline, std::vector<double> const& stations) const
{
    auto const length = lengths(outline);
    std::vector<double> result;
    for (double const station : stations) {
        Between const points = between(station_, station);
        result.push_back((1 - points.share) * length[points.lower] + points.share * length[points.upper]);
    }
    return result;
}

std::vector<double> gaps_of(Surface const& surface, ContactStudy const& study, bool ring)
{
    auto const& spline = study.solution.circular_spline;
    auto const& map = study.map;
    std::array<FlankStations, 2> const flanks = {FlankStations(spline, GapMap::left),
                                                 FlankStations(spline, GapMap::right)};
    std::vector<std::size_t> const spaces =
        ring ? spaces_of(map, study.cases.at(study.written_case).state.wave_generator)
             : std::vector<std::size_t>{fullest_flank(map, study.contact_gap).space};
    std::vector<double> gaps;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        auto const& origin = surface.origin[i];
        double gap = nothing;
        for (int const flank : {GapMap::left, GapMap::right})
            if (auto const station = flanks[static_cast<std::size_t>(flank)].at(origin.index))
                gap = gap_at(map, {spaces.at(origin.space), flank, false}, surface.points[i][2], *station);
        gaps.push_back(gap);
    }
    return gaps;
}

}  // namespace hdconj::io
