// SPDX-License-Identifier: GPL-3.0-or-later
// Everything side by side and not rounded: as many digits as give the same number back. What other posts and reviewers
// start from.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <initializer_list>

#include "grid.hpp"
#include "post.hpp"
#include "reading.hpp"
#include "wedm/planes.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::wedm::csv {
namespace {

constexpr char const* path_columns =
    "pass,move,tag,tooth,x_lower,y_lower,x_upper,y_upper,x_lower_guide,y_lower_guide,x_upper_guide,y_upper_guide\n";
constexpr char const* contour_columns = "point,sync,x_lower,y_lower,x_upper,y_upper\n";
constexpr std::size_t longest_heading = 78;

/// Shortest digits that give @p value back, without an exponent.
void put(std::string& text, double value)
{
    constexpr std::size_t longest = 400;
    std::array<char, longest> digits = {};
    double const shown = value == 0 ? 0.0 : value;  // never -0
    auto const end = std::to_chars(digits.data(), digits.data() + digits.size(), shown, std::chars_format::fixed);
    text += ',';
    text.append(digits.data(), end.ptr);
}

void put(std::string& text, std::initializer_list<Vec2> points)
{
    for (Vec2 const& point : points) {
        put(text, point.x());
        put(text, point.y());
    }
    text += '\n';
}

std::string head(WireProgram const& program)
{
    std::string text;
    for (auto const& line : heading(program, nullptr))
        text += "# " + comment_text(line, longest_heading) + "\n";
    return text;
}

std::string path_text(WireProgram const& program)
{
    std::string text = head(program) + path_columns;
    for (auto const& pass : program.passes) {
        for (std::size_t i = 0; i < pass.moves.size(); ++i) {
            auto const& move = pass.moves[i];
            auto const guides = guides_of(program.machine, {move.lower, move.upper});
            text += fmt::format("{},{},{},{}", pass.number, i, to_string(move.tag), move.tooth);
            put(text, {move.lower, move.upper, guides.lower, guides.upper});
        }
    }
    return text;
}

std::string contour_text(WireProgram const& program)
{
    auto const& nominal = program.nominal;
    std::string text = head(program) + contour_columns;
    std::size_t next = 0;
    for (std::size_t k = 0; k < nominal.lower.size(); ++k) {
        bool const sync = next < nominal.sync.size() && nominal.sync[next] == k;
        next += sync ? 1 : 0;
        text += fmt::format("{},{}", k, sync ? 1 : 0);
        put(text, {nominal.lower[k], nominal.upper[k]});
    }
    return text;
}

std::vector<WireText> write(WireProgram const& program, std::string const& stem)
{
    std::size_t blocks = 0;
    for (auto const& pass : program.passes)
        blocks += pass.moves.size() - 1;
    return {{stem + "_path.csv", path_text(program), 0, blocks},
            {stem + "_contour.csv", contour_text(program), 0, program.nominal.lower.size()}};
}

/// Calls @p take(line, cells) for each row behind the names of the columns.
template <class Take>
void rows_of(WireText const& file, std::string_view columns, Take take)
{
    bool inside = false;
    columns.remove_suffix(1);
    std::size_t const width = parts_of(columns, ',').size();
    for (auto const& line : lines_of(file)) {
        if (inside) {
            auto const cells = parts_of(line.text(), ',');
            if (cells.size() != width)
                line.refuse(fmt::format("{} columns in place of {}", cells.size(), width));
            take(line, cells);
        }
        inside = inside || line.text() == columns;
    }
}

/// The wire by its faces, the wire by its guides, for each pass; and the contour.
std::vector<FacePath> read(std::vector<WireText> const& files, WireProgram const& program)
{
    std::vector<FacePath> paths, by_guides;
    rows_of(files.at(0), path_columns, [&](WireLine const& line, std::vector<std::string_view> const& cells) {
        auto const pass = static_cast<std::size_t>(line.whole(cells[0]));
        auto const at = [&](std::size_t first) {
            return Vec2(line.number(cells[first]), line.number(cells[first + 1]));
        };
        if (paths.size() < pass) {
            paths.push_back({"faces", {}, {}});
            by_guides.push_back({"guides", {}, {}});
        }
        constexpr std::size_t lower = 4, upper = 6, lower_guide = 8, upper_guide = 10;
        for (auto* const path : {&paths.back(), &by_guides.back()})
            if (cells[2] == to_string(WireTag::stop))
                path->stops.push_back(path->lower.size());
        paths.back().lower.push_back(at(lower));
        paths.back().upper.push_back(at(upper));
        auto const faces = faces_of(program.machine, {at(lower_guide), at(upper_guide)});
        by_guides.back().lower.push_back(faces.lower);
        by_guides.back().upper.push_back(faces.upper);
    });
    paths.insert(paths.end(), by_guides.begin(), by_guides.end());
    auto& contour = paths.emplace_back(FacePath{"contour", {}, {}});
    rows_of(files.at(1), contour_columns, [&](WireLine const& line, std::vector<std::string_view> const& cells) {
        constexpr std::size_t lower = 2, upper = 4;
        contour.lower.emplace_back(line.number(cells[lower]), line.number(cells[lower + 1]));
        contour.upper.emplace_back(line.number(cells[upper]), line.number(cells[upper + 1]));
    });
    return paths;
}

std::vector<FacePath> exact(WireProgram const& program)
{
    auto paths = exact_passes(program);
    auto const again = paths;
    paths.insert(paths.end(), again.begin(), again.end());
    paths.push_back({"contour", program.nominal.lower, program.nominal.upper});
    return paths;
}

}  // namespace

WirePost post()
{
    constexpr std::size_t any = 10000;
    // Faces come back as they are; through the guides with the rounding of a few operations at a hundred millimetres.
    constexpr double rounding = 1e-12;
    return {.dialect = {"csv", "wire in both faces and both guides, and the contour, not rounded", "NumPy"},
            .longest_line = any,
            .unit = [](WireProgram const&) { return 0.0; },
            .allowed = rounding,
            .write = write,
            .exact = exact,
            .read = read};
}

}  // namespace hdconj::wedm::csv
