// SPDX-License-Identifier: GPL-3.0-or-later
// A designed drive as a scene with a comment on every key.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>

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

/// @p text as one word of a shell.
std::string shell_word(std::string const& text)
{
    auto const is_plain = [](unsigned char c) {
        return c >= 0x80 || std::isalnum(c) != 0 || (c != 0 && std::strchr("-_.+/:,@%", c) != nullptr);
    };
    if (!text.empty() && std::ranges::all_of(text, is_plain))
        return text;
    std::string quoted = "'";
    for (char const c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

/// The command that makes the drive again.
std::string command_of(DesignWishes const& wishes)
{
    std::string command = "hdconj design";
    auto const add = [&](char const* option, std::optional<double> value, double unit = 1) {
        if (value)
            command += fmt::format(" {} {}", option, number_text(*value / unit));
    };
    add("--ratio", wishes.ratio);
    add("--diameter", wishes.diameter);
    add("--module", wishes.module);
    add("--length-ratio", wishes.length_ratio);
    add("--torque", wishes.torque, newton_metre);
    command += " --family " + wishes.family;
    if (wishes.material != DesignWishes().material)
        command += " --material " + shell_word(wishes.material);
    add("--fatigue", wishes.fatigue);
    add("--youngs-modulus", wishes.youngs_modulus);
    add("--poissons-ratio", wishes.poissons_ratio);
    add("--land", wishes.land);
    add("--clearance", wishes.clearance);
    add("--safety", wishes.safety);
    return command;
}

std::string heading(Design const& design)
{
    return fmt::format(
        "# {}: a drive by the rules of the thesis (Tables 2-1, 4-1 to 4-3) and by computation.\n"
        "# {}\n"
        "# Lengths in mm. A comment says symbol, name, rule with its range, and source.\n",
        design.wishes.name, command_of(design.wishes));
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
