// SPDX-License-Identifier: GPL-3.0-or-later
// Fanuc type: X, Y absolute in the lower face, U, V the upper face against the lower one in the same block, both from
// rounded faces, so that X + U is the rounded upper face. No comments: what they look like differs between controls.
#include <fmt/format.h>

#include "grid.hpp"
#include "post.hpp"
#include "reading.hpp"

namespace hdconj::wedm::relative_uv {
namespace {

std::string text_of(WireProgram const& program, WirePass const& pass)
{
    WireGrid const grid(program.decimals);
    auto const blocks = blocks_of(program, pass, WirePlanes::faces, grid);
    std::string text = fmt::format("%\nO{:04}\nG90 G21\nG92", pass.number);
    grid.put(text, " X", " Y", blocks.front().lower);
    text += '\n';
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        auto const& block = blocks[i];
        UnitPoint const lean = block.upper - block.lower;
        grid.put(text, "G01 X", " Y", block.lower);
        grid.put(text, " U", " V", lean);
        text += block.tag == WireTag::stop ? fmt::format("\n{}\n", two_digit_stop(program)) : "\n";
    }
    return text + "M02\n%\n";
}

FacePath read_one(WireText const& file, WireProgram const& program)
{
    FacePath path{file.name, {}, {}};
    for (auto const& line : lines_of(file)) {
        if (line.text() == "%")
            continue;
        auto const words = words_of(line, line.text());
        note_stop(line, words, program, path);
        if (!has_word(words, 'X'))
            continue;
        bool const start = path.lower.empty();
        if (!start && !is_straight_move(words))
            line.refuse("coordinates without G01");
        Vec2 const lower = point_of(line, words);
        Vec2 const lean = start ? Vec2(0, 0) : point_of(line, words, 'U', 'V');
        path.lower.push_back(lower);
        path.upper.emplace_back(lower + lean);
    }
    return path;
}

}  // namespace

WirePost post()
{
    return {.dialect = {"relative-uv",
                        "ISO of the Fanuc type: X, Y of the lower face, U, V from there to the upper face", ""},
            .alphabet = "%OGXYUVM0123456789.- ",
            .unit = program_unit,
            .write = [](WireProgram const& program,
                        std::string const& stem) { return write_each(program, stem, "rel", "iso", text_of); },
            .exact = exact_passes,
            .read = read_each<read_one>};
}

}  // namespace hdconj::wedm::relative_uv
