// SPDX-License-Identifier: GPL-3.0-or-later
// Each bad scene is refused for the right reason, at the right line, with a remedy; all its faults in one go.
#include <algorithm>

#include "bad_scene_checks.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj_run.hpp"

namespace hdconj::test::bad_scenes_cases {

namespace {

/// Line of the first byte in which @p text differs from the built-in scene; the edit ends on that line or below it.
int edited_line(std::string const& text)
{
    auto const original = builtin_scene_text();
    std::size_t const length = std::min(text.size(), original.size());
    auto const differs =
        std::mismatch(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length), original.begin());
    return 1 + static_cast<int>(std::count(text.begin(), differs.first, '\n'));
}

void check_edits(std::vector<BadScene> const& rows)
{
    for (auto const& row : rows) {
        SECTION(row.name)
        {
            auto const text = edited(row);
            check_row(row, text);
            auto const faults = faults_of(text);
            auto const* const fault = find_fault(faults, row.path);
            bool const on_a_line = fault != nullptr && fault->line > 0;
            CHECK((!on_a_line || fault->line <= static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1));
        }
    }
}

}  // namespace

TEST_CASE("the built-in scene has no fault", "[scene]")
{
    INFO(describe(faults_of(std::string(builtin_scene_text()))));
    CHECK(faults_of(std::string(builtin_scene_text())).empty());
}

TEST_CASE("wrong values are refused", "[scene]")
{
    check_edits(wrong_values());
}

TEST_CASE("wrong tables are refused", "[scene]")
{
    check_edits(wrong_tables());
}

TEST_CASE("wrong geometry is refused", "[scene]")
{
    check_edits(wrong_geometry());
}

TEST_CASE("what is no scene is refused", "[scene]")
{
    for (auto const& row : wrong_texts()) {
        SECTION(row.name)
        {
            check_row(row, row.to);
        }
    }
}

TEST_CASE("there are enough bad scenes, and no name stands for two", "[scene]")
{
    constexpr std::size_t enough = 60;
    std::vector<std::string> names;
    for (auto const* const table : {&wrong_values(), &wrong_tables(), &wrong_geometry(), &wrong_texts()}) {
        for (auto const& row : *table)
            names.push_back(row.name);
    }
    CHECK(names.size() >= enough);
    std::sort(names.begin(), names.end());
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST_CASE("a fault names the line and the value as it was written", "[scene]")
{
    for (auto const& row : wrong_values()) {
        bool const keeps_its_line = !row.to.empty() && row.to.find('\n') == std::string::npos && row.faults == 1;
        bool const names_the_edited_key =
            contains(row.to, " = ") && row.path.ends_with("." + row.to.substr(0, row.to.find(' ')));
        if (keeps_its_line && names_the_edited_key) {
            INFO(row.name);
            auto const text = edited(row);
            auto const faults = faults_of(text);
            REQUIRE(faults.size() == 1);
            CHECK(faults.front().line == edited_line(text));
            CHECK(faults.front().value == (contains(row.to, "{") ? "" : row.to.substr(row.to.find('=') + 2)));
        }
    }
}

TEST_CASE("eight faults are reported in one go, in order of line", "[scene]")
{
    std::string const text = R"([drive]
modul = 0.25
flexspline_teeth = 200.0
circular_spline_teeth = 202
[flexspline]
wall = "0.7"
[flexspline.profile]
family = "double-circular-arc"
addendum = -0.2250
dedendum = 0.3030
convex_radius = inf
convex_offset = 0.0982
concave_radius = 0.5145
concave_offset = "tangent"
concave_rise = 0.0671
[wave_generatr]
family = "cosine"
radial_deformation = 0.25
waves = 7
[solver]
kinematics = "exactly"
)";
    auto const faults = faults_of(text);
    INFO(describe(faults));
    std::vector<int> lines;
    for (auto const& fault : faults) {
        check_fields(fault);
        lines.push_back(fault.line);
    }
    CHECK(lines == std::vector<int>{2, 3, 6, 9, 11, 16, 19, 21});
}

TEST_CASE("missing teeth of one ring follow from the other's, and nothing else is laid to them", "[scene]")
{
    std::string const rest = R"([flexspline]
wall = 0.6
[flexspline.profile]
family = "s-tooth"
addendum = 0.32
dedendum = 0.42
deflection = 0.9
[wave_generator]
family = "ellipse"
radial_deformation = 0.38
)";
    for (auto const& [given, advice] :
         {std::pair("flexspline_teeth = 120", "write circular_spline_teeth = 122"),
          {"circular_spline_teeth = 122", "write flexspline_teeth = 120"},
          {"flexspline_teeth = 120\ncircular_spline_teeth = -122", "write a whole number from 6 to 100000"}}) {
        auto const faults = faults_of("[drive]\nmodule = 0.4\n" + std::string(given) + "\n" + rest);
        INFO(given << '\n' << describe(faults));
        REQUIRE(faults.size() == 1);
        CHECK(contains(faults.front().remedy, advice));
    }
}

TEST_CASE("geometry faults join the others when the geometry is known", "[scene]")
{
    std::string text(builtin_scene_text());
    text.replace(text.find("\"tangent\""), 9, "0.0671");
    text += "[slices]\ncount = 0\n";
    auto const faults = faults_of(text);
    INFO(describe(faults));
    CHECK(find_fault(faults, "flexspline.profile.concave_offset") != nullptr);
    CHECK(find_fault(faults, "slices.count") != nullptr);
}

TEST_CASE("values from outside cannot send control characters to a terminal", "[scene]")
{
    auto const text = describe(faults_of("\"a\\u001b[31mb\" = \"\\u001b[2J\"\n[drive]\n\"\\u0007\" = 1\n"));
    CHECK(std::none_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n'; }));
}

}  // namespace hdconj::test::bad_scenes_cases
