// SPDX-License-Identifier: GPL-3.0-or-later
// The contour that the wire can cut, offset by the machine: G41 or G42 with D, the number of the pass. The offset comes
// on over the first half of the straight way in, and goes off over the second half of the way out. Only where both
// faces are the same: no machine offsets two contours with one radius in two planes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "control_offset.hpp"
#include "grid.hpp"
#include "post.hpp"
#include "reading.hpp"
#include "wedm/passes.hpp"
#include "wedm/pitch_pass.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::wedm::iso_2d {
namespace {

constexpr std::size_t longest_comment = 78;

/// Rounding by half a unit turns a move of length l by up to unit/l, and the wire at the offset beside it shifts by
/// offset unit/l along the move: in a contour finer than this it would go backwards.
double least_length(WireProgram const& program, WirePass const& pass)
{
    constexpr double margin = 8;
    return std::max(least_block(program.decimals), std::sqrt(margin * pass.offset * program_unit(program)));
}

OffsetContour contour_of(WireProgram const& program, WirePass const& pass)
{
    return offset_contour(pass, least_length(program, pass), share_of_moves * program.tolerance);
}

/// How far the path that a control makes of @p points is off that of @p pass [mm].
double off_the_path(WireProgram const& program, WirePass const& pass, std::vector<Vec2> const& points)
{
    constexpr double share = 0.1;  // of a unit, for chords of arcs
    std::vector<Vec2> wire;
    for (std::size_t i = 1; i + 1 < pass.moves.size(); ++i)
        wire.push_back(pass.moves[i].lower);
    return distance_of_lines(path_of_control(points, pass.offset, !pass.reversed, share * program_unit(program)), wire);
}

/// @p points as they are written. @throws NumericalError with ErrorCode::no_room where a control would not follow the
/// wire's path to the tolerance
std::vector<UnitPoint> rounded(WireProgram const& program, WirePass const& pass, std::vector<Vec2> const& points)
{
    WireGrid const grid(program.decimals);
    std::vector<UnitPoint> units;
    std::vector<Vec2> written;
    for (auto const& point : points) {
        units.push_back(grid.units(point));
        written.emplace_back(grid.unit() * static_cast<double>(units.back().x),
                             grid.unit() * static_cast<double>(units.back().y));
    }
    double const off = off_the_path(program, pass, written);
    if (program.tolerance > 0 && off > program.tolerance)
        throw no_room(fmt::format("pass {}", pass.number),
                      fmt::format("the path that a control makes of the rounded contour is up to {:.6g} mm off the "
                                  "wire's path, more than the tolerance of {:.6g} mm",
                                  off, program.tolerance));
    return units;
}

std::string text_of(WireProgram const& program, WirePass const& pass, OffsetContour const& contour)
{
    WireGrid const grid(program.decimals);
    auto const points = rounded(program, pass, contour.points);
    std::string text = "%\n(hdconj 2-D, contour that the wire can cut, the machine offsets it)\n";
    for (auto const& line : heading(program, &pass))
        text += "(" + comment_text(line, longest_comment) + ")\n";
    text += fmt::format("(set D{} to {:.6f} mm, the radius that the wire cuts)\n", pass.number, pass.offset);
    text += "G17 G21 G90 G40 G49 G61 G94\nF2.0\n";
    std::size_t const last = points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        if (i == 1)
            text += fmt::format("{} D{} ", pass.reversed ? "G42" : "G41", pass.number);
        else if (i == last)
            text += "G40 ";
        grid.put(text, i == 0 ? "G00 X" : "G01 X", " Y", points[i]);
        text += '\n';
        if (std::ranges::find(contour.stops, i) != contour.stops.end())
            text += two_digit_stop(program) + '\n';
    }
    return text + "M02\n%\n";
}

std::vector<WireText> write(WireProgram const& program, std::string const& stem)
{
    std::vector<WireText> files;
    for (auto const& pass : program.passes) {
        auto const contour = contour_of(program, pass);
        files.push_back({pass_file(stem, "2d", pass, "iso"), text_of(program, pass, contour), pass.number,
                         contour.points.size() - 1});
    }
    return files;
}

std::vector<FacePath> exact(WireProgram const& program)
{
    std::vector<FacePath> paths;
    for (auto const& pass : program.passes) {
        auto const contour = contour_of(program, pass);
        paths.push_back({fmt::format("pass {}", pass.number), contour.points, contour.points, contour.stops});
    }
    return paths;
}

FacePath read_one(WireText const& file, WireProgram const& program)
{
    FacePath path{file.name, {}, {}};
    bool offset = false;
    for (auto const& line : lines_of(file)) {
        if (line.text() == "%")
            continue;
        auto const words = words_of(line, line.text());
        note_stop(line, words, program, path);
        bool off = false;
        for (auto const& word : words) {
            bool const on = word.letter == 'G' && (word.digits == "41" || word.digits == "42");
            off = off || (word.letter == 'G' && word.digits == "40");
            offset = (offset || on) && !off;
        }
        if (is_straight_move(words)) {
            if (!off && offset == path.lower.empty())
                line.refuse("the offset is not on from the first move to the last one");
            path.lower.push_back(point_of(line, words));
        }
    }
    if (offset)
        refuse_to_write(file.name, "the offset is not switched off");
    path.upper = path.lower;
    return path;
}

double drift(WireProgram const& program, std::vector<FacePath> const& read)
{
    double most = 0;
    for (std::size_t i = 0; i < read.size(); ++i)
        most = std::max(most, off_the_path(program, program.passes.at(i), read[i].lower));
    return most;
}

}  // namespace

WirePost post()
{
    return {.dialect = {"iso-2d", "cuttable contour for the machine's own offset, two axes", "LinuxCNC", true},
            .alphabet = "%GXYDFM0123456789.- ",
            .own_limits = true,
            .unit = program_unit,
            .write = write,
            .exact = exact,
            .read = read_each<read_one>,
            .drift = drift};
}

}  // namespace hdconj::wedm::iso_2d
