// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of figures, one after the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace hdconj::figures {

/// The rows of several tables in one.
template <class Row, std::size_t... count>
[[nodiscard]] constexpr auto joined(std::array<Row, count> const&... tables)
{
    std::array<Row, (count + ...)> all{};
    auto end = all.begin();
    ((end = std::ranges::copy(tables, end).out), ...);
    return all;
}

}  // namespace hdconj::figures
