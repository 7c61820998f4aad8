// SPDX-License-Identifier: GPL-3.0-or-later
#include "branches.hpp"

#include <algorithm>
#include <numeric>

namespace hdconj::rig {

std::vector<LoadBranch> branches_of(std::vector<double> const& torque, double reversal)
{
    std::vector<LoadBranch> branches;
    std::size_t begin = 0, low = 0, high = 0;
    int sense = 0;
    for (std::size_t i = 0; i < torque.size(); ++i) {
        high = torque[i] > torque[high] ? i : high;
        low = torque[i] < torque[low] ? i : low;
        if (sense >= 0 && torque[high] - torque[i] > reversal) {
            if (high > begin)
                branches.push_back({begin, high, true});
            begin = high;
            low = i;
            sense = -1;
        } else if (sense <= 0 && torque[i] - torque[low] > reversal) {
            if (low > begin)
                branches.push_back({begin, low, false});
            begin = low;
            high = i;
            sense = 1;
        }
    }
    if (begin + 1 < torque.size())
        branches.push_back({begin, torque.size() - 1, torque.back() > torque[begin]});
    return branches;
}

std::vector<std::size_t> by_torque(Samples const& samples, LoadBranch const& branch)
{
    std::vector<std::size_t> at(branch.last - branch.first + 1);
    std::iota(at.begin(), at.end(), branch.first);
    std::ranges::stable_sort(at, {}, [&](std::size_t i) { return samples.torque[i]; });
    return at;
}

}  // namespace hdconj::rig
