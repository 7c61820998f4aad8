// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <memory>
#include <tuple>

#include "hdconj/contact_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/result_files.hpp"
#include "support/catch.hpp"
#include "support/sample_contact_study.hpp"
#include "support/sample_load_study.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::stored_outline_cases {

namespace {

void check_same(CircularSplineOutline const& read, CircularSplineOutline const& written)
{
    CHECK(read.z == written.z);
    REQUIRE(read.outline.size() == written.outline.size());
    for (std::size_t k = 0; k < read.outline.size(); ++k)
        CHECK(read.outline[k] == written.outline[k]);
    CHECK(read.landmarks == written.landmarks);
    REQUIRE(read.pieces.size() == written.pieces.size());
    for (std::size_t i = 0; i < read.pieces.size(); ++i) {
        CHECK(read.pieces[i].kind == written.pieces[i].kind);
        CHECK(read.pieces[i].segment_name == written.pieces[i].segment_name);
        CHECK(read.pieces[i].first == written.pieces[i].first);
        CHECK(read.pieces[i].last == written.pieces[i].last);
    }
}

}  // namespace

TEST_CASE("a stored outline is read back bit for bit, with its scene", "[wire]")
{
    test::TemporaryFolder const folder;
    auto solution = sample::solution();
    solution.scene.text = "[drive]\nname = \"\xc3\xa4\"\n";
    auto const table = std::make_shared<std::string const>("# \xb5\n0,1\n\n2,3");  // not all is UTF-8
    solution.scene.files = {{"a.csv", table}, {"none.csv", nullptr}};
    solution.error.cup = 0.0037;
    solution.error.side_clearance = 2e-7;
    solution.notes = {"one", "two \xc3\xa4"};
    solution.judgement = {{NoteCode::land, Severity::warning, 0.1, 0.2, "1", "here", "cause", "advice", {"a=1", "b=2"}},
                          {NoteCode::undercut, Severity::information, 3, 4, "deg", "", "why", "", {}}};
    write_hdf5(solution, folder / "a.h5");
    auto const one = read_outline(folder / "a.h5");
    CHECK(one.scene == solution.scene.text);
    REQUIRE(one.files.size() == 1);
    CHECK(*one.files.at("a.csv") == *table);
    check_same(one.solution.circular_spline, solution.circular_spline);
    Solution const& read = one.solution;
    CHECK(read.geometry.circular_spline_inner_radius == solution.geometry.circular_spline_inner_radius);
    CHECK(read.error.cup == solution.error.cup);
    CHECK(read.error.side_clearance == solution.error.side_clearance);
    CHECK(read.error.chord == solution.error.chord);
    CHECK(read.error.point == solution.error.point);
    CHECK(read.notes == solution.notes);
    REQUIRE(read.judgement.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        Note const &a = read.judgement[i], &b = solution.judgement[i];
        CHECK(std::tie(a.code, a.severity, a.figure, a.limit, a.unit, a.place, a.cause, a.advice, a.set) ==
              std::tie(b.code, b.severity, b.figure, b.limit, b.unit, b.place, b.cause, b.advice, b.set));
    }
    CHECK(one.verb.empty());
    CHECK_FALSE(one.side_clearance);
}

TEST_CASE("a stored outline of a case says so, and its side clearance", "[wire]")
{
    test::TemporaryFolder const folder;
    auto contact = sample::contact_study(5);
    auto load = sample::load_study();
    contact.cases[contact.written_case].backlash_offset = 0.03;
    load.cases[load.written_case].backlash_offset = 0.0573;
    write_hdf5(contact, folder / "contact.h5");
    write_hdf5(load, folder / "load.h5");
    auto const of_contact = read_outline(folder / "contact.h5"), of_load = read_outline(folder / "load.h5");
    check_same(of_contact.solution.circular_spline, contact.solution.circular_spline);
    CHECK(of_contact.verb == "contact");
    CHECK(of_contact.side_clearance == 0.03);
    CHECK(of_load.verb == "load");
    REQUIRE(of_contact.cases.size() == contact.cases.size());
    REQUIRE(of_load.cases.size() == load.cases.size());
    for (std::size_t i = 0; i < load.cases.size(); ++i) {
        CHECK(of_load.cases[i].interferes == load.cases[i].side_clearance_increased);
        CHECK(of_load.cases[i].side_clearance == load.cases[i].backlash_offset);
        CHECK_FALSE(of_load.cases[i].flank_clearance);
    }
    for (std::size_t i = 0; i < contact.cases.size(); ++i) {
        ContactCase const& each = contact.cases[i];
        CHECK(of_contact.cases[i].tilt == each.tilt);
        CHECK(of_contact.cases[i].flank_clearance == each.closest_flank().clearance);
        CHECK(of_contact.cases[i].interferes ==
              (each.side_clearance_increased || each.closest_flank().clearance < -each.clearance_error));
    }
    CHECK(of_load.side_clearance == 0.0573);
}

TEST_CASE("what is no result file is refused with its name", "[wire]")
{
    test::TemporaryFolder const folder;
    CHECK_THROWS_WITH(read_outline(folder / "none.h5"), ContainsSubstring("none.h5: is no result file of hdconj"));
    std::ofstream(folder / "text.h5") << "no HDF5";
    CHECK_THROWS_AS(read_outline(folder / "text.h5"), InputError);
    write_hdf5(sample::solution(), folder / "a.h5");
    auto const whole = test::content(folder / "a.h5");
    // Cut anywhere, the file is refused or read, and never ends the program.
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += whole.size() / 23) {
        std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, size);
        try {
            (void)read_outline(folder / "cut.h5");
        } catch (InputError const&) {
            ++refused;
        }
    }
    CHECK(refused >= 20);
}

}  // namespace hdconj::test::stored_outline_cases
