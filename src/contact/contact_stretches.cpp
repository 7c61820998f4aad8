// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::contact {

namespace {

/// The edges of contact, met one after the other along a flank.
template <class Excess>
class Edges
{
  public:
    Edges(Excess const& excess, double s, double at_s)
        : excess_(excess), s_(s), at_s_(at_s), open_(at_s <= 0), begin_(s)
    {
    }

    /// On to @p to, @p way further along the flank: halved where an end may lie between.
    void go_on(double to, double at_to, double way, int halvings)
    {
        // an arc is longer than its chord by less than this for any flank of a tooth
        constexpr double longer = 1.25;
        bool const same = (at_s_ <= 0) == (at_to <= 0);
        if (halvings > 0 && !(same && std::abs(at_s_) + std::abs(at_to) > longer * way)) {
            double const middle = 0.5 * (s_ + to);
            go_on(middle, excess_(middle), way / 2, halvings - 1);
            go_on(to, at_to, way / 2, halvings - 1);
            return;
        }
        if (!same) {
            double const edge = numeric::bracketed_root(excess_, s_, to, at_s_, at_to).x;
            if (open_)
                found_.push_back({begin_, edge});
            begin_ = edge;
            open_ = !open_;
        }
        s_ = to;
        at_s_ = at_to;
    }

    /// Ends where it stands.
    [[nodiscard]] std::vector<ContactStretch> found() &&
    {
        if (open_ && s_ > begin_)
            found_.push_back({begin_, s_});
        return std::move(found_);
    }

  private:
    Excess const& excess_;
    double s_, at_s_;
    bool open_;
    double begin_;
    std::vector<ContactStretch> found_;
};

}  // namespace

std::vector<ContactStretch> contact_stretches(GapField const& field, std::size_t space, int flank, std::size_t slice,
                                              double turn, double limit, std::size_t stride)
{
    constexpr int halvings = 3;  // between two stations
    FlankGrid const& grid = field.grid();
    auto const& line = grid.point[static_cast<std::size_t>(flank)][slice];
    std::vector<double> gap;
    field.along(space, flank, slice, turn, gap);
    auto const excess = [&](double s) { return field.gap_between(space, flank, slice, s, turn) - limit; };
    Edges edges(excess, grid.place(flank, 0), gap.front() - limit);
    for (std::size_t j = 0, next = 0; j + 1 < line.size(); j = next) {
        next = std::min(j + stride, line.size() - 1);
        edges.go_on(grid.place(flank, next), gap[next] - limit, (line[next] - line[j]).norm(), halvings);
    }
    return std::move(edges).found();
}

double area_per_length(FlankGrid const& grid, int flank, std::size_t slice,
                       std::vector<ContactStretch> const& stretches)
{
    auto const f = static_cast<std::size_t>(flank);
    auto const& line = grid.line[f].empty() ? grid.point[f] : grid.line[f];
    auto const& normal = grid.line[f].empty() ? grid.normal[f] : grid.line_normal[f];
    std::size_t const low = slice > 0 ? slice - 1 : slice, high = std::min(slice + 1, grid.slices() - 1);
    auto const speed = [&](std::size_t i) {
        return high > low ? normal[slice][i].dot(line[high][i] - line[low][i]) / (grid.z[high] - grid.z[low]) : 0.0;
    };
    double sum = 0;
    for (ContactStretch const& stretch : stretches) {
        auto i = static_cast<std::size_t>(stretch.from);
        for (double s = stretch.from; s < stretch.to && i + 1 < line[slice].size(); ++i) {
            double const end = std::min(stretch.to, static_cast<double>(i + 1));
            double const v = 0.5 * (speed(i) + speed(i + 1));
            sum += (end - s) * (line[slice][i + 1] - line[slice][i]).norm() * std::sqrt(1 + v * v);
            s = end;
        }
    }
    return sum;
}

}  // namespace hdconj::contact
