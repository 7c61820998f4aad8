// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text.hpp"

#include <cmath>
#include <cstdlib>

#include "support/catch.hpp"
#include "support/draws.hpp"

using namespace hdconj;

TEST_CASE("a bound as text is one that may be written, with at most six digits", "[text]")
{
    CHECK(at_least_text(0.025) == "0.025");
    CHECK(at_most_text(0.025) == "0.025");
    CHECK(at_least_text(5.6843418860808015e-12) == "5.68435e-12");
    CHECK(at_most_text(5.6843418860808015e-12) == "5.68434e-12");
    CHECK(at_least_text(0) == "0");
    designs::Draws draws(20261125);
    for (int i = 0; i < 1000; ++i) {
        double const bound = std::exp(draws.between(-30, 15));
        INFO(bound);
        double const high = std::strtod(at_least_text(bound).c_str(), nullptr);
        double const low = std::strtod(at_most_text(bound).c_str(), nullptr);
        CHECK(high >= bound);
        CHECK(low <= bound);
        CHECK(high - low <= 3e-5 * bound);
        CHECK(at_least_text(-bound) == "-" + at_most_text(bound));
        CHECK(at_most_text(-bound) == "-" + at_least_text(bound));
    }
}
