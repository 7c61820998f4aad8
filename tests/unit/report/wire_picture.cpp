// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/wire_files.hpp"
#include "support/catch.hpp"
#include "support/gnuplot.hpp"
#include "support/sample_wire_program.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::wire_picture_cases {

namespace {

std::size_t count(std::string const& text, std::string const& part)
{
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

}  // namespace

TEST_CASE("a wire program is drawn as tooth and ring and as a map of what is left", "[wire]")
{
    if (test::no_gnuplot())
        return;
    test::TemporaryFolder const folder;
    auto program = sample::wire_ring();
    auto const two = write_wire_pictures({program}, folder / "a.svg");
    REQUIRE(two.size() == 2);
    auto const tooth = test::content(folder / "a-tooth.svg");
    CHECK_THAT(tooth, ContainsSubstring("contour of the part, upper face") && ContainsSubstring("tooth space 2") &&
                          ContainsSubstring("earlier passes") && ContainsSubstring("face shift 24.43"));
    CHECK_THAT(test::content(folder / "a-ring.svg"), ContainsSubstring("start hole") && ContainsSubstring(">stop<"));
    program.residuals = sample::residuals();
    auto const three = write_wire_pictures({program}, folder / "b.png");
    REQUIRE(three.size() == 3);
    for (auto const& each : three)
        CHECK(test::content(each.file).substr(1, 3) == "PNG");
    CHECK(three[2].kind == "picture_residual");
    write_wire_pictures({program}, folder / "c.svg");
    auto const map = test::content(folder / "c-residual.svg");
    CHECK(count(map, "meshes") == 2);
    CHECK(test::content(folder / "c-tooth.svg").find("tooth space 2,") == std::string::npos);
    CHECK_THROWS_AS(check_wire_pictures(folder / "a.jpg"), InputError);
    CHECK_THROWS_AS(check_wire_pictures(folder / "no" / "a.svg"), FileError);
    test::EmptyPath const nothing;
    CHECK_THROWS_AS(check_wire_pictures(folder / "a.svg"), FileError);
}

TEST_CASE("a part without teeth is drawn whole", "[wire]")
{
    if (test::no_gnuplot())
        return;
    test::TemporaryFolder const folder;
    write_wire_pictures({sample::square_hole()}, folder / "a.svg");
    CHECK_THAT(test::content(folder / "a-tooth.svg"), ContainsSubstring("the whole part"));
}

}  // namespace hdconj::test::wire_picture_cases
