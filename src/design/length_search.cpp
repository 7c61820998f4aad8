// SPDX-License-Identifier: GPL-3.0-or-later
#include "length_search.hpp"

#include <cmath>

#include "base/text.hpp"
#include "wishes.hpp"

namespace hdconj::design {

std::optional<double> least_length(DesignWishes const& wishes, Talk const& talk)
{
    constexpr double parts = 20;  // of the diameter
    auto const works = [&](int number) {
        DesignWishes longer = wishes;
        longer.length_ratio = number / parts;
        if (talk)
            talk("a cup " + short_number(longer.length_ratio) + " pitch diameters long");
        return WallSearch(longer, talk).best(false).works();
    };
    int refused = static_cast<int>(std::floor(wishes.length_ratio * parts)),
        accepted = static_cast<int>(length_ratios.high * parts);
    if (refused >= accepted || !works(accepted))
        return std::nullopt;
    while (accepted - refused > 1) {
        int const middle = (refused + accepted) / 2;
        (works(middle) ? accepted : refused) = middle;
    }
    return accepted / parts;
}

}  // namespace hdconj::design
