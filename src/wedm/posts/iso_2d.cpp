// SPDX-License-Identifier: GPL-3.0-or-later
// The nominal contour, offset by the machine: G41 or G42 with D, the number of the pass. The offset is switched on and
// off on the straight leads. Only where both faces are the same: no machine offsets two contours with one radius in two
// planes.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "grid.hpp"
#include "post.hpp"
#include "reading.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::wedm::iso_2d {
namespace {

constexpr std::size_t longest_comment = 78;

struct Foot
{
    std::size_t segment = 0;  ///< from contour point `segment` to the next one
    double share = 0;
    Vec2 point = Vec2::Zero();
};

/// Point of the closed @p contour nearest to @p from.
Foot foot_of(std::vector<Vec2> const& contour, Vec2 const& from)
{
    Foot best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < contour.size(); ++k) {
        Vec2 const a = contour[k], along = contour[(k + 1) % contour.size()] - a;
        double const length = along.squaredNorm();
        double const share = length > 0 ? std::clamp((from - a).dot(along) / length, 0.0, 1.0) : 0.0;
        Vec2 const point = a + share * along;
        if ((from - point).squaredNorm() < nearest) {
            nearest = (from - point).squaredNorm();
            best = {k, share, point};
        }
    }
    return best;
}

struct NominalPath
{
    std::vector<Vec2> points;  ///< start hole, on the contour ..., start hole
    bool wire_left = true;     ///< of the direction of travel
};

/// From the start hole straight to the contour's point nearest to where the wire arrives, once around, on for the
/// overlap, and back; in a set-up that does not close to the point nearest to where the wire leaves, and out.
NominalPath path_of(WireProgram const& program, WirePass const& pass)
{
    std::vector<Vec2> around;
    double overlap = 0;
    for (std::size_t i = 1; i < pass.moves.size(); ++i) {
        auto const& move = pass.moves[i];
        if (move.tag != WireTag::lead_out)
            around.push_back(move.lower);
        if (move.tag == WireTag::overlap)
            overlap += (move.lower - pass.moves[i - 1].lower).norm();
    }
    bool const forward = !pass.reversed;
    auto contour = program.nominal.lower;
    if (!forward)
        std::reverse(contour.begin(), contour.end());
    Foot const foot = foot_of(contour, around.front());
    std::size_t const count = contour.size();
    NominalPath path;
    Vec2 const start = pass.moves.front().lower;
    path.points = {start, foot.point};
    auto const add = [&](Vec2 const& point) {
        if (point != path.points.back())
            path.points.push_back(point);
    };
    Foot const last = program.closed() ? foot : foot_of(contour, around.back());
    std::size_t const corners = program.closed() ? count : (last.segment + count - foot.segment) % count;
    for (std::size_t k = 1; k <= corners; ++k)
        add(contour[(foot.segment + k) % count]);
    add(last.point);
    for (std::size_t k = 1; program.closed() && overlap > 0 && k <= count; ++k) {
        Vec2 const along = contour[(foot.segment + k) % count] - path.points.back();
        double const length = along.norm();
        if (length > 0) {
            add(path.points.back() + along * std::min(1.0, overlap / length));
            overlap -= length;
        }
    }
    add(pass.moves.back().lower);
    Vec2 const travel = contour[(foot.segment + 1) % count] - contour[foot.segment];
    path.wire_left = cross(travel, around.front() - foot.point) > 0;
    return path;
}

std::string text_of(WireProgram const& program, WirePass const& pass)
{
    WireGrid const grid(program.decimals);
    NominalPath const path = path_of(program, pass);
    std::string text = "%\n(hdconj 2-D, contour of the part, the machine offsets it)\n";
    for (auto const& line : heading(program, &pass))
        text += "(" + comment_text(line, longest_comment) + ")\n";
    text += fmt::format("(set D{} to {:.6f} mm, the radius that the wire cuts)\n", pass.number, pass.offset);
    text += "G17 G21 G90 G40 G49 G61 G94\nF2.0\n";
    std::size_t const last = path.points.size() - 1;
    UnitPoint before;
    for (std::size_t i = 0; i <= last; ++i) {
        UnitPoint const at = grid.units(path.points[i]);
        if (i > 0 && at == before)
            continue;  // rounding of the foot against its neighbours
        if (i == 1)
            text += fmt::format("{} D{} ", path.wire_left ? "G41" : "G42", pass.number);
        else if (i == last)
            text += "G40 ";
        grid.put(text, i == 0 ? "G00 X" : "G01 X", " Y", at);
        text += '\n';
        before = at;
    }
    return text + "M02\n%\n";
}

std::vector<WireText> write(WireProgram const& program, std::string const& stem)
{
    std::vector<WireText> files;
    for (auto const& pass : program.passes)
        files.push_back({pass_file(stem, "2d", pass, "iso"), text_of(program, pass), pass.number,
                         path_of(program, pass).points.size() - 1});
    return files;
}

std::vector<FacePath> exact(WireProgram const& program)
{
    std::vector<FacePath> paths;
    WireGrid const grid(program.decimals);
    for (auto const& pass : program.passes) {
        auto const points = path_of(program, pass).points;
        FacePath path{fmt::format("pass {}", pass.number), {}, {}};
        for (std::size_t i = 0; i < points.size(); ++i)
            if (i == 0 || !(grid.units(points[i]) == grid.units(points[i - 1])))
                path.lower.push_back(points[i]);
        path.upper = path.lower;
        paths.push_back(std::move(path));
    }
    return paths;
}

FacePath read_one(WireText const& file, WireProgram const&)
{
    FacePath path{file.name, {}, {}};
    bool offset = false;
    for (auto const& line : lines_of(file)) {
        if (line.text() == "%")
            continue;
        auto const words = words_of(line, line.text());
        for (auto const& word : words)
            if (word.letter == 'G' && (word.digits == "41" || word.digits == "42" || word.digits == "40"))
                offset = word.digits != "40";
        if (is_straight_move(words))
            path.lower.push_back(point_of(line, words));
    }
    if (offset)
        refuse_to_write(file.name, "the offset is not switched off");
    path.upper = path.lower;
    return path;
}

}  // namespace

WirePost post()
{
    return {.dialect = {"iso-2d", "the part's contour with the machine's own offset, two axes", "", true},
            .alphabet = "%GXYDFM0123456789.- ",
            .unit = program_unit,
            .write = write,
            .exact = exact,
            .read = read_each<read_one>};
}

}  // namespace hdconj::wedm::iso_2d
