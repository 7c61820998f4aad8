// SPDX-License-Identifier: GPL-3.0-or-later
#include "columns_on_demand.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "hdconj/base/parallel.hpp"

namespace hdconj::numeric {

using Eigen::Index;
using Eigen::VectorXd;

ColumnsOnDemand::ColumnsOnDemand(VectorXd diagonal, Index rest, Fill fill)
    : diagonal_(std::move(diagonal)), fill_(std::move(fill)), columns_(static_cast<std::size_t>(first() + rest))
{
}

bool ColumnsOnDemand::require(std::vector<Index> const& which, int threads)
{
    constexpr std::size_t grain = 4;
    auto const column = [&](Index j) -> VectorXd& { return columns_[static_cast<std::size_t>(j)]; };
    std::vector<Index> missing;
    for (Index const j : which)
        if (column(j).size() == 0)
            missing.push_back(j);
    std::vector<unsigned char> finite(missing.size());
    parallel_for(missing.size(), threads, grain, [&](std::size_t i) {
        Index const j = missing[i];
        VectorXd values(j < first() ? static_cast<Index>(columns_.size()) : first());
        fill_(j, values);
        finite[i] = values.allFinite();
        column(j) = std::move(values);
    });
    return std::ranges::all_of(finite, [](unsigned char each) { return each != 0; });
}

std::size_t ColumnsOnDemand::computed() const
{
    return static_cast<std::size_t>(std::ranges::count_if(columns_, [](VectorXd const& c) { return c.size() > 0; }));
}

}  // namespace hdconj::numeric
