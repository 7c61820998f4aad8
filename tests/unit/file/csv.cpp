// SPDX-License-Identifier: GPL-3.0-or-later
#include "file/csv.hpp"

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::csv_cases {

using Lines = std::vector<std::pair<std::string, int>>;

TEST_CASE("a CSV file is read line by line without mark, blanks and comments", "[csv]")
{
    TemporaryFolder const folder;
    std::ofstream(folder / "table.csv") << "\xef\xbb\xbf# drive 7\n\nx [mm], y\n  # more\n1, 2\r\n \t\n3, 4";
    Lines lines;
    auto const keep = [&](std::string_view line, int number) {
        lines.emplace_back(file::trimmed(line), number);
        return true;
    };
    CHECK_FALSE(file::read_csv(folder / "table.csv", 1000, keep));
    CHECK(lines == Lines{{"x [mm], y", 3}, {"1, 2", 5}, {"3, 4", 7}});
    int count = 0;
    CHECK_FALSE(file::read_csv(folder / "table.csv", 1000, [&](std::string_view, int) { return ++count < 2; }));
    CHECK(count == 2);
}

TEST_CASE("what is no CSV file is not read", "[csv]")
{
    TemporaryFolder const folder;
    std::ofstream(folder / "table.csv") << "1, 2\n3, 4\n";
    auto const never = [](std::string_view, int) -> bool { throw std::logic_error("a line of an unreadable file"); };
    CHECK(file::read_csv(folder.path(), 1000, never) == file::Unreadable::is_folder);
    CHECK(file::read_csv(folder / "none.csv", 1000, never) == file::Unreadable::not_opened);
    CHECK(file::read_csv("/dev/zero", 1000, never) == file::Unreadable::endless);
    CHECK(file::read_csv(folder / "table.csv", 9, never) == file::Unreadable::too_large);
}

TEST_CASE("fields, numbers, headings and units of a table", "[csv]")
{
    CHECK(file::fields_of("a; \"b\" ;;c ", ';') == std::vector<std::string_view>{"a", "b", "", "c"});
    CHECK(file::number_in("+1.5e3") == 1500.0);
    for (auto const* none : {"", "1,5", "1 2", "nan", "inf", "--1"})
        CHECK_FALSE(file::number_in(none));
    file::Heading const torque = file::heading_of("Torque (N m)"), bare = file::heading_of(" x ");
    CHECK(torque.name == "Torque");
    CHECK(torque.unit == "N m");
    CHECK(bare.name == "x");
    CHECK_FALSE(bare.unit);
    CHECK(file::lower_case("N M", " ") == "nm");
    constexpr std::array units = {file::ColumnUnit{"mm", 1}, file::ColumnUnit{"um", 1e-3}};
    CHECK(file::factor_of(units, "um") == 1e-3);
    CHECK_FALSE(file::factor_of(units, "inch"));
}

}  // namespace hdconj::test::csv_cases
