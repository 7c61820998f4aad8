// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_lines.hpp"

#include <algorithm>

namespace hdconj {

double squared_distance(Vec2 const& point, Vec2 const& a, Vec2 const& b)
{
    Vec2 const along = b - a;
    double const length = along.squaredNorm();
    double const at = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (point - a - at * along).squaredNorm();
}

namespace {

void keep_between(std::vector<Vec2> const& line, std::size_t first, std::size_t last, double tolerance,
                  std::vector<Vec2>& kept)
{
    std::size_t furthest = first;
    double distance = tolerance * tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
        double const here = squared_distance(line[i], line[first], line[last]);
        if (here > distance) {
            distance = here;
            furthest = i;
        }
    }
    if (furthest != first) {
        keep_between(line, first, furthest, tolerance, kept);
        kept.push_back(line[furthest]);
        keep_between(line, furthest, last, tolerance, kept);
    }
}

}  // namespace

std::vector<Vec2> thinned(std::vector<Vec2> const& polyline, double tolerance)
{
    if (polyline.size() < 3) {
        return polyline;
    }
    std::vector<Vec2> kept = {polyline.front()};
    keep_between(polyline, 0, polyline.size() - 1, tolerance, kept);
    kept.push_back(polyline.back());
    return kept;
}

std::string gnuplot_quoted(std::string text)
{
    std::string quoted = "'";
    for (char const c : text) {
        constexpr unsigned char first_printable = ' ', del = 0x7f;
        bool const control = static_cast<unsigned char>(c) < first_printable || static_cast<unsigned char>(c) == del;
        quoted += control ? " " : c == '\'' ? "''" : std::string(1, c);
    }
    return quoted + "'";
}

}  // namespace hdconj
