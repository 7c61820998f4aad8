// SPDX-License-Identifier: GPL-3.0-or-later
// Two contours in one block, lower : upper, incremental. The controller that is known to read it takes a missing word
// for 0, an M anywhere for an M block, and half lines of 100 characters, 200 000 blocks and 5 000 000 bytes at most:
// every block has all its words, there are no comments, a stop is a block of its own, and what would not fit is
// refused.
#include <fmt/format.h>

#include "grid.hpp"
#include "post.hpp"
#include "reading.hpp"

namespace hdconj::wedm::two_plane {
namespace {

constexpr std::size_t most_blocks = 200000;
constexpr std::size_t most_bytes = 5000000;
constexpr std::size_t longest_half = 100;

std::string text_of(WireProgram const& program, WirePass const& pass)
{
    WireGrid const grid(program.decimals);
    auto const blocks = blocks_of(program, pass, WirePlanes::faces, grid);
    std::string text = "G91;\nG92";
    grid.put(text, " X", " Y", blocks.front().lower);
    text += ";\n";
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        UnitPoint const lower = blocks[i].lower - blocks[i - 1].lower;
        UnitPoint const upper = blocks[i].upper - blocks[i - 1].upper;
        grid.put(text, "G01 X", " Y", lower);
        grid.put(text, ":G01 X", " Y", upper);
        text += blocks[i].tag == WireTag::stop ? fmt::format(";\n{};\n", two_digit_stop(program)) : ";\n";
    }
    return text + "M02;\n";
}

std::vector<WireText> write(WireProgram const& program, std::string const& stem)
{
    auto files = write_each(program, stem, "twoplane", "nc", text_of);
    for (auto const& file : files) {
        if (file.blocks > most_blocks || file.text.size() > most_bytes)
            throw no_room(file.name, fmt::format("{} blocks, {} bytes; controllers of this dialect take {} and {}",
                                                 file.blocks, file.text.size(), most_blocks, most_bytes));
    }
    return files;
}

Vec2 step_of(WireLine const& line, std::string_view half)
{
    if (half.size() >= longest_half)
        line.refuse(fmt::format("more than {} characters", longest_half));
    auto const words = words_of(line, half);
    if (!is_straight_move(words))
        line.refuse("no G01");
    return point_of(line, words);
}

FacePath read_one(WireText const& file, WireProgram const& program)
{
    FacePath path{file.name, {}, {}};
    for (auto const& line : lines_of(file)) {
        auto const text = line.text();
        if (!text.ends_with(';'))
            line.refuse("no ';' at the end");
        auto const block = text.substr(0, text.size() - 1);
        auto const colon = block.find(':');
        if (colon != std::string_view::npos) {
            if (path.lower.empty())
                line.refuse("a move before G92");
            path.lower.emplace_back(path.lower.back() + step_of(line, block.substr(0, colon)));
            path.upper.emplace_back(path.upper.back() + step_of(line, block.substr(colon + 1)));
        } else if (auto const words = words_of(line, block); block.starts_with("M")) {
            note_stop(line, words, program, path);
        } else if (block.starts_with("G92")) {
            path.lower.push_back(point_of(line, words));
            path.upper.push_back(path.lower.back());
        }
    }
    return path;
}

}  // namespace

WirePost post()
{
    return {.dialect = {"two-plane",
                        "blocks lower:upper, incremental, as Chinese slow and medium wire controllers take them", ""},
            .alphabet = "GXYM0123456789.-:; ",
            .own_limits = true,
            .unit = program_unit,
            .write = write,
            .exact = exact_passes,
            .read = read_each<read_one>};
}

}  // namespace hdconj::wedm::two_plane
