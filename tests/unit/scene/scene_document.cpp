// SPDX-License-Identifier: GPL-3.0-or-later
// docs/reference/scene.md says what the schema and the families say: each key there is a key here, and the other way
// round.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "scene/validation.hpp"
#include "support/catch.hpp"

namespace hdconj::test::scene_document_cases {

namespace {

/// A heading of the document and the rows of the table below it.
struct Section
{
    std::string heading;
    std::string meaning;
    std::vector<std::string> rows;
};

std::string row_of(scene::ParameterSpec const& spec, std::string const& absent)
{
    return "| `" + std::string(spec.key) + "` | " + scene::expectation(spec) + " | " + absent + " | " +
           std::string(spec.meaning) + " |";
}

std::string when_absent(scene::KeySpec const& key)
{
    if (key.spec.required)
        return "required";
    return key.standard ? "`" + scene::value_text(*key.standard) + "`" : "see meaning";
}

std::string capital(std::string_view text)
{
    std::string result(text);
    bool const is_small = !result.empty() && result.front() >= 'a' && result.front() <= 'z';
    if (is_small)
        result.front() = static_cast<char>(result.front() - 'a' + 'A');
    return result;
}

Section section_of(scene::TableSpec const& table)
{
    std::string const presence = table.presence == scene::Presence::required   ? "Required: "
                                 : table.presence == scene::Presence::optional ? "May be absent: "
                                                                               : "";
    Section section{"## [" + std::string(table.path) + "]", capital(presence + std::string(table.meaning)) + ".", {}};
    for (auto const& key : table.keys)
        section.rows.push_back(row_of(key.spec, when_absent(key)));
    return section;
}

Section section_of(scene::TableSpec const& table, scene::FamilyDescription const& family)
{
    Section section{"### [" + std::string(table.path) + "] family = \"" + std::string(family.name) + "\"",
                    capital(family.meaning) + ".",
                    {}};
    for (auto const& spec : family.parameters)
        section.rows.push_back(row_of(spec, spec.required ? "required" : "may be absent"));
    return section;
}

std::vector<Section> expected_sections()
{
    std::vector<Section> sections;
    for (auto const& table : scene::scene_schema()) {
        sections.push_back(section_of(table));
        auto const families = table.families == scene::FamilyKind::profile ? profile::profile_families()
                              : table.families == scene::FamilyKind::wave_generator
                                  ? wavegen::wave_generator_families()
                                  : std::vector<scene::FamilyDescription>{};
        // both teeth take the same families: they are told once
        for (auto const& family : families) {
            if (table.path != "circular_spline.profile")
                sections.push_back(section_of(table, family));
        }
    }
    return sections;
}

std::vector<std::string> document_lines()
{
    std::ifstream file(HDCONJ_SOURCE_DIR "/docs/reference/scene.md");
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

/// "heading|row" of every table row that names a key.
std::multiset<std::string> documented_rows()
{
    std::multiset<std::string> rows;
    std::string heading;
    for (auto const& line : document_lines()) {
        if (line.starts_with("#")) {
            heading = line;
        } else if (line.starts_with("| `")) {
            rows.insert(heading + "\n" + line);
        }
    }
    return rows;
}

std::multiset<std::string> expected_rows()
{
    std::multiset<std::string> rows;
    for (auto const& section : expected_sections()) {
        for (auto const& row : section.rows)
            rows.insert(section.heading + "\n" + row);
    }
    return rows;
}

std::vector<std::string> difference(std::multiset<std::string> const& a, std::multiset<std::string> const& b)
{
    std::vector<std::string> only;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
    return only;
}

}  // namespace

TEST_CASE("every key of the schema is in docs/reference/scene.md, word for word", "[scene]")
{
    CHECK(difference(expected_rows(), documented_rows()) == std::vector<std::string>{});
}

TEST_CASE("every key of docs/reference/scene.md is in the schema", "[scene]")
{
    CHECK_FALSE(documented_rows().empty());
    CHECK(difference(documented_rows(), expected_rows()) == std::vector<std::string>{});
}

TEST_CASE("prints the tables for docs/reference/scene.md", "[.][scene-tables]")
{
    for (auto const& section : expected_sections()) {
        std::cout << section.heading << "\n\n" << section.meaning << "\n\n";
        std::cout << "| key | takes | when absent | meaning |\n|---|---|---|---|\n";
        for (auto const& row : section.rows)
            std::cout << row << '\n';
        std::cout << '\n';
    }
}

}  // namespace hdconj::test::scene_document_cases
