// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Errors of forces that stand side by side.
#include <cmath>
#include <vector>

#include "load/grids/force_errors.hpp"
#include "support/catch.hpp"

namespace hdconj::test::force_error_cases {

using load::errors_side_by_side;

TEST_CASE("a force that agrees by chance has the error of its neighbours", "[load]")
{
    // the differences 1, 0, 3, 0 of those that act have a mean square of 2.5
    std::vector<double> const fine{4, 5, 6, 7, 0, 0, 0, 0, 0, 0, 0}, coarse{5, 5, 9, 7, 0, 0, 0, 0, 0, 0, 0};
    std::vector<double> const errors = errors_side_by_side(fine, {coarse}, 2);
    double const usual = 2 * std::sqrt(2.5);
    REQUIRE(errors.size() == fine.size());
    for (std::size_t i : {0U, 1U, 2U, 3U, 4U})
        CHECK(errors[i] == 6);  // two away from the largest difference at most
    CHECK(errors[5] == Approx(usual));
    CHECK(errors[9] == Approx(usual));
    CHECK(errors[10] == Approx(usual));
    for (std::size_t i : {6U, 7U, 8U})
        CHECK(errors[i] == 0);  // no grid has a force near them
}

TEST_CASE("a third grid counts where the finer two agree", "[load]")
{
    std::vector<double> const same{1, 1, 1}, other{9, 9, 9};
    CHECK(errors_side_by_side(same, {same, other}, 1) == std::vector<double>{2, 2, 2});
    CHECK(errors_side_by_side(same, {same}, 1) == std::vector<double>{0, 0, 0});
    CHECK(errors_side_by_side({}, {{}}, 1).empty());
    CHECK(errors_side_by_side({3}, {{5}}, 1) == std::vector<double>{2});
}

}  // namespace hdconj::test::force_error_cases
