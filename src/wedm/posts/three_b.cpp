// SPDX-License-Identifier: GPL-3.0-or-later
// 3B of fast-wire controllers: B<X> B<Y> B<J> G{X|Y} L{1..4}, whole micrometres, incremental from the start hole, one
// face per file; both files have the same number of lines. J counts along the longer direction; L1 to L4 is the
// quadrant that the line goes into. By convention a line D stops the machine, whatever its switches say, and DD ends
// the program.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "grid.hpp"
#include "hdconj/units.hpp"
#include "post.hpp"
#include "reading.hpp"

namespace hdconj::wedm::three_b {
namespace {

constexpr int decimals_of_um = 3;

int quadrant(UnitPoint const& step)
{
    if (step.x > 0 && step.y >= 0)
        return 1;
    if (step.x <= 0 && step.y > 0)
        return 2;
    return step.x < 0 && step.y <= 0 ? 3 : 4;
}

std::string text_of(std::vector<WireBlock> const& blocks, UnitPoint WireBlock::*face)
{
    std::string text;
    for (std::size_t i = 1; i < blocks.size(); ++i) {
        UnitPoint const step = blocks[i].*face - blocks[i - 1].*face;
        long long const x = std::llabs(step.x), y = std::llabs(step.y);
        text += fmt::format("B{} B{} B{} G{} L{}\n", x, y, x >= y ? x : y, x >= y ? 'X' : 'Y', quadrant(step));
        if (blocks[i].tag == WireTag::stop)
            text += "D\n";
    }
    return text + "DD\n";
}

std::vector<WireText> write(WireProgram const& program, std::string const& stem)
{
    WireGrid const grid(decimals_of_um);
    std::vector<WireText> files;
    for (auto const& pass : program.passes) {
        // The start hole need not be on the grid: places are rounded as seen from there.
        auto const blocks = blocks_of(program, pass, WirePlanes::faces, grid, pass.moves.front().lower);
        std::size_t const count = blocks.size() - 1;
        files.push_back({pass_file(stem, "lower", pass, "3b"), text_of(blocks, &WireBlock::lower), pass.number, count});
        files.push_back({pass_file(stem, "upper", pass, "3b"), text_of(blocks, &WireBlock::upper), pass.number, count});
    }
    return files;
}

/// "B4938 B0 B4938 GX L1"
Vec2 step_of(WireLine const& line)
{
    auto const parts = parts_of(line.text(), ' ');
    constexpr std::size_t words = 5;
    bool const right = parts.size() == words && parts[0].starts_with('B') && parts[1].starts_with('B') &&
                       parts[2].starts_with('B') && (parts[3] == "GX" || parts[3] == "GY") && parts[4].size() == 2 &&
                       parts[4][0] == 'L' && parts[4][1] >= '1' && parts[4][1] <= '4';
    if (!right)
        line.refuse("no block of 3B");
    long long const x = line.whole(parts[0].substr(1)), y = line.whole(parts[1].substr(1)),
                    j = line.whole(parts[2].substr(1));
    if (x < 0 || y < 0 || j != (parts[3] == "GX" ? x : y) || (j == x ? j < y : j < x))
        line.refuse("the count does not fit the line");
    constexpr std::array<std::array<double, 2>, 4> sign = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    auto const& s = sign.at(static_cast<std::size_t>(parts[4][1] - '1'));
    return {s[0] * um * static_cast<double>(x), s[1] * um * static_cast<double>(y)};
}

/// One face and its stops.
std::pair<std::vector<Vec2>, std::vector<std::size_t>> read_one(WireText const& file, Vec2 const& start)
{
    std::vector<Vec2> path = {start};
    std::vector<std::size_t> stops;
    bool ended = false;
    for (auto const& line : lines_of(file)) {
        if (ended)
            line.refuse("a line behind DD");
        ended = line.text() == "DD";
        if (line.text() == "D")
            stops.push_back(path.size() - 1);
        else if (!ended)
            path.emplace_back(path.back() + step_of(line));
    }
    return {path, stops};
}

/// A file does not say where its start hole is: that is given to the machine beside it.
std::vector<FacePath> read(std::vector<WireText> const& files, WireProgram const& program)
{
    std::vector<FacePath> paths;
    constexpr std::size_t faces = 2;
    for (std::size_t i = 0; i + 1 < files.size(); i += faces) {
        Vec2 const start = program.passes.at(i / faces).moves.front().lower;
        auto const [lower, stops] = read_one(files[i], start);
        auto const [upper, upper_stops] = read_one(files[i + 1], start);
        if (stops != upper_stops)
            refuse_to_write(files[i].name, "the faces stop at different blocks");
        paths.push_back({files[i].name, lower, upper, stops});
    }
    return paths;
}

}  // namespace

WirePost post()
{
    return {.dialect = {"3b", "3B in whole micrometres, one file for each face", ""},
            .alphabet = "BGXYLD0123456789 ",
            .own_limits = true,
            .unit = [](WireProgram const&) { return WireGrid(decimals_of_um).unit(); },
            .write = write,
            .exact = exact_passes,
            .read = read};
}

}  // namespace hdconj::wedm::three_b
