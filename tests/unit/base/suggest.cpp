// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/base/suggest.hpp"
#include "base/text.hpp"
#include "support/catch.hpp"

namespace hdconj::test::suggest_cases {

TEST_CASE("edit distance counts insertions, deletions, replacements and swaps", "[scene]")
{
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("abc", "") == 3);
    CHECK(edit_distance("abc", "abc") == 0);
    CHECK(edit_distance("abc", "acb") == 1);
    CHECK(edit_distance("ab", "ba") == 1);
    CHECK(edit_distance("abcd", "abd") == 1);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("ca", "abc") == 3);  // no letter is edited twice
}

TEST_CASE("edit distance is symmetric and never above the longer word", "[scene]")
{
    std::vector<std::string_view> const words{"module", "modul", "wall", "waves", "width", "", "x", "tip_line_from"};
    for (auto const a : words) {
        for (auto const b : words) {
            CHECK(edit_distance(a, b) == edit_distance(b, a));
            CHECK(edit_distance(a, b) <= std::max(a.size(), b.size()));
            CHECK((edit_distance(a, b) == 0) == (a == b));
        }
    }
}

TEST_CASE("the nearest word is near", "[scene]")
{
    std::vector<std::string_view> const words{"module", "wall", "waves", "angle_deg", "first-order", "exact"};
    CHECK(nearest("modul", words) == "module");
    CHECK(nearest("wals", words) == "wall");
    CHECK(nearest("wave", words) == "waves");
    CHECK(nearest("angle", words) == "angle_deg");
    CHECK(nearest("First_Order", words) == "first-order");
    CHECK(nearest("exact", words) == "exact");
    CHECK_FALSE(nearest("colour", words).has_value());
    CHECK_FALSE(nearest("", words).has_value());
    CHECK_FALSE(nearest("x", words).has_value());
    CHECK_FALSE(nearest(std::string(100000, 'w'), words).has_value());
}

TEST_CASE("numbers in messages are short and exact", "[scene]")
{
    CHECK(number_text(0.0671) == "0.0671");
    CHECK(number_text(200) == "200");
    CHECK(number_text(100000) == "100000");
    CHECK(number_text(0) == "0");
    CHECK(number_text(1e-6) == "1e-06");
    CHECK(number_text(-0.5) == "-0.5");
    CHECK(number_text(0.1 + 0.2) == "0.30000000000000004");
}

TEST_CASE("text in messages is safe to print", "[scene]")
{
    CHECK(printable("a\x1b[31m") == "a\\x1b[31m");
    CHECK(printable("gr\xc3\xbc\xc3\x9f", 3) == "gr...");
    CHECK(printable("gr\xc3\xbc\xc3\x9f", 4) == "gr\xc3\xbc...");
    CHECK(printable("short") == "short");
}

}  // namespace hdconj::test::suggest_cases
