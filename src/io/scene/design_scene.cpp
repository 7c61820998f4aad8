// SPDX-License-Identifier: GPL-3.0-or-later
// A designed drive as a scene with a comment on every key.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"

namespace hdconj {
namespace {

/// The table of a key: "flexspline.cup" of "flexspline.cup.length".
std::string_view table_of(std::string_view key)
{
    return key.substr(0, key.rfind('.'));
}

std::string comment_on(DesignRow const& row)
{
    std::string text = row.symbol.empty() ? row.name : row.symbol + ", " + row.name;
    text += ": " + row.rule;
    if (row.range)
        text += " = " + row.range_text() + (row.unit.empty() ? "" : " " + row.unit);
    text += row.source.empty() || row.source == "wish" ? "" : "; " + row.source;
    if (row.origin == DesignOrigin::assumption || row.origin == DesignOrigin::limited)
        text += "; " + std::string(to_string(row.origin));
    return row.remark.empty() ? text : text + "; " + row.remark;
}

std::string heading(Design const& design)
{
    DesignWishes const& wishes = design.wishes;
    std::string command = fmt::format("hdconj design --ratio {}", number_text(wishes.ratio));
    if (wishes.diameter)
        command += " --diameter " + number_text(*wishes.diameter);
    if (wishes.module)
        command += " --module " + number_text(*wishes.module);
    command += " --length-ratio " + number_text(wishes.length_ratio);
    if (wishes.torque)
        command += " --torque " + number_text(*wishes.torque / newton_metre);
    return fmt::format(
        "# {}: a drive by the rules of the thesis (Tables 2-1, 4-1 to 4-3) and by computation.\n"
        "# {} --family {} --land {} --clearance {} --safety {}\n"
        "# Lengths in mm. A comment says symbol, name, rule with its range, and source.\n",
        wishes.name, command, wishes.family, number_text(wishes.land), number_text(wishes.clearance),
        number_text(wishes.safety));
}

}  // namespace

std::string scene_text(Design const& design)
{
    std::string text = heading(design);
    for (auto const& table : scene::scene_schema()) {
        std::string lines;
        for (auto const& row : design.rows)
            if (!row.key.empty() && table_of(row.key) == table.path)
                lines += fmt::format("{:<34}# {}\n", row.key.substr(table.path.size() + 1) + " = " + row.written(),
                                     comment_on(row));
        if (!lines.empty())
            text += fmt::format("\n[{}]\n{}", table.path, lines);
    }
    return text;
}

}  // namespace hdconj
