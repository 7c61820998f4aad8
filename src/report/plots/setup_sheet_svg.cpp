// SPDX-License-Identifier: GPL-3.0-or-later
// The setup sheet as a picture: three drawings above the tables. Written without gnuplot, so that it stands beside the
// files on every machine.
#include <algorithm>

#include "plot.hpp"
#include "report/text/setup_sheet.hpp"
#include "sheet_svg.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::report {
namespace {

constexpr double page_width = 210, page_height = 297, margin = 12;
constexpr double small = 2.9;        // height of letters in drawings [mm]
constexpr double box = 58, gap = 6;  // of the drawings [mm]
constexpr double boxes_top = 30;     // [mm]
constexpr double line_mm = 0.02;     // what thinning may move a line on the paper
constexpr char const* centred = "text-anchor=\"middle\"";

/// The wire's centre in the lower face from the start hole on, leads included.
std::vector<Vec2> wire_path(WireProgram const& program)
{
    std::vector<Vec2> path;
    for (WireMove const& move : program.passes.front().moves)
        path.push_back(move.lower);
    return path;
}

/// The parts of @p points that @p view shows, on the paper.
Polylines shown(std::vector<Vec2> const& points, PaperView const& view)
{
    Polylines lines(1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool const next_to = view.shows(points[i]) || (i > 0 && view.shows(points[i - 1])) ||
                             (i + 1 < points.size() && view.shows(points[i + 1]));
        if (next_to)
            lines.back().push_back(view.on_paper(points[i]));
        else if (!lines.back().empty())
            lines.emplace_back();
    }
    return thinned(lines, line_mm);
}

void draw(SheetSvg& svg, std::vector<Vec2> const& points, PaperView const& view, char const* colour, double width)
{
    for (auto const& line : shown(points, view))
        if (!line.empty())
            svg.line(line, colour, width, "clip-path=\"url(#start)\"");
}

std::vector<Vec2> closed(std::vector<Vec2> points)
{
    points.push_back(points.front());
    return points;
}

/// An arrow head at @p tip, on the paper.
void arrow_head(SheetSvg& svg, Vec2 const& tip, Vec2 const& along, char const* colour)
{
    constexpr double length = 3, half_width = 1.1;
    Vec2 const unit = along.normalized(), across = left_of(unit);
    svg.fill({tip, tip - length * unit + half_width * across, tip - length * unit - half_width * across}, colour);
}

void box_title(SheetSvg& svg, Vec2 const& corner, std::string_view words)
{
    svg.text(corner + Vec2(box / 2, -1.5), small, words, centred);
    svg.line({corner, corner + Vec2(box, 0), corner + Vec2(box, box), corner + Vec2(0, box), corner}, ink::grey, 0.15);
}

/// Start, stop and end of the path in @p view.
void draw_marks(SheetSvg& svg, WireProgram const& program, PaperView const& view, bool named)
{
    auto const& moves = program.passes.front().moves;
    constexpr double dot = 0.9;
    auto const mark = [&](Vec2 const& at, double radius, char const* words) {
        svg.circle(view.on_paper(at), radius, ink::vermilion, 0.35);
        if (named)
            svg.text(view.on_paper(at) + Vec2(radius + 1, 1), small, words,
                     "fill=\"#d55e00\" stroke=\"#ffffff\" stroke-width=\"1\" paint-order=\"stroke\"");
    };
    double const hole = view.scale() * program.start_hole_radius;
    mark(moves.front().lower, std::max(dot, program.closed() ? hole : dot), program.closed() ? "start hole" : "start");
    if (!program.closed())
        mark(moves.back().lower, dot, "end");
    for (WireMove const& move : moves)
        if (move.tag == WireTag::stop)
            mark(move.lower, dot, to_string(program.stop).data());
}

void draw_plan(SheetSvg& svg, WireProgram const& program, Vec2 const& corner)
{
    auto const path = wire_path(program);
    double reach = 0;
    for (auto const* const points : {&program.nominal.lower, &path})
        for (Vec2 const& p : *points)
            reach = std::max(reach, p.cwiseAbs().maxCoeff());
    constexpr double air = 1.12;
    PaperView const view{corner, box, Vec2::Zero(), air * reach};
    box_title(svg, corner, program.closed() ? "from above" : "set-up 1, from above");
    Vec2 const axis = Vec2(reach / 3, 0), up = left_of(axis);
    for (Vec2 const& end : {axis, up}) {
        svg.line({view.on_paper(Vec2::Zero()), view.on_paper(end)}, ink::grey, 0.25);
        arrow_head(svg, view.on_paper(end), view.on_paper(end) - view.on_paper(Vec2::Zero()), ink::grey);
    }
    svg.text(view.on_paper(axis) + Vec2(1, 1), small, "x", "fill=\"#888888\"");
    svg.text(view.on_paper(up) + Vec2(1, 1), small, "y", "fill=\"#888888\"");
    svg.line(thinned(shown(closed(program.nominal.lower), view).front(), line_mm), ink::black, 0.2);
    svg.line(shown(path, view).front(), ink::blue, 0.2);
    draw_marks(svg, program, view, false);
    // the direction, beside a third of the path
    std::size_t const at = path.size() / 3, before = at - std::min<std::size_t>(at, path.size() / 30);
    double const beside = program.external ? 1.06 : 0.86;
    Vec2 const tip = view.on_paper(beside * path[at]), tail = view.on_paper(beside * path[before]);
    svg.line({tail, tip}, ink::blue, 0.5);
    arrow_head(svg, tip, tip - tail, ink::blue);
}

void draw_start(SheetSvg& svg, WireProgram const& program, Vec2 const& corner)
{
    auto const& moves = program.passes.front().moves;
    Vec2 const hole = moves[0].lower, land = moves[1].lower;
    constexpr double reach = 0.95;  // in lengths of the lead-in
    PaperView const view{corner, box, 0.5 * (hole + land), reach * (land - hole).norm()};
    box_title(svg, corner, "start, enlarged");
    if (program.nominal.upper != program.nominal.lower)
        draw(svg, closed(program.nominal.upper), view, ink::vermilion, 0.25);
    draw(svg, closed(program.nominal.lower), view, ink::black, 0.3);
    draw(svg, wire_path(program), view, ink::blue, 0.25);
    draw_marks(svg, program, view, true);
    Vec2 const middle = view.on_paper(0.5 * (hole + land));
    arrow_head(svg, middle, view.on_paper(land) - view.on_paper(hole), ink::blue);
}

/// Guides, faces and the wire between, the lean exaggerated.
void draw_side(SheetSvg& svg, WireProgram const& program, WireFigures const& figures, Vec2 const& corner)
{
    box_title(svg, corner, "planes from the side, not to scale");
    LargerFace const larger = figures.larger_face();
    double const lean = larger == LargerFace::neither ? 0 : larger == LargerFace::upper ? 3 : -3;  // [mm] of paper
    constexpr double wall = 20, lower = 40, upper = 20, low_guide = 53, high_guide = 7, block = 12;
    auto const at = [&](double x, double y) -> Vec2 { return corner + Vec2(x, y); };
    double const slope = lean / (lower - upper), foot = wall - lean / 2, head = wall + lean / 2;
    double const from = program.external ? foot - block : foot, to = program.external ? head - block : head;
    svg.fill({at(foot, lower), at(head, upper), at(program.external ? to : head + block, upper),
              at(program.external ? from : foot + block, lower)},
             "#d8d8d8");
    svg.text(at(program.external ? foot - block / 2 : foot + block / 2, (upper + lower) / 2 + 1), small, "part",
             centred);
    svg.line({at(foot - slope * (low_guide - lower), low_guide), at(head + slope * (upper - high_guide), high_guide)},
             ink::blue, 0.4);
    constexpr double words = 35;
    auto const plane = [&](double y, char const* colour, std::string const& first, std::string const& second) {
        svg.line({at(4, y), at(words - 1, y)}, colour, 0.2, "stroke-dasharray=\"1.5,1\"");
        svg.text(at(words, y - 0.3), small, first);
        svg.text(at(words, y + small + 0.2), small, second, second.ends_with("ER") ? "font-weight=\"bold\"" : "");
    };
    plane(high_guide, ink::blue, "upper guide",
          fmt::format("z = {:g}", program.machine.thickness + program.machine.upper_guide));
    plane(upper, ink::black, "upper face",
          larger == LargerFace::neither ? "same"
          : larger == LargerFace::upper ? "LARGER"
                                        : "SMALLER");
    plane(lower, ink::black, "lower face", "z = 0");
    plane(low_guide, ink::blue, "lower guide", fmt::format("z = {:g}", 0 - program.machine.lower_guide));
}

void write_tables(SheetSvg& svg, SetupSheet const& sheet, double top)
{
    std::size_t lines = 0, longest = 1;
    constexpr std::size_t between = 2;  // columns, in characters
    for (auto const& table : sheet.tables) {
        std::size_t line = 0;
        for (std::size_t const width : table.widths())
            line += width + between;
        longest = std::max(longest, line);
        lines += table.rows.size() + 2;
    }
    constexpr double widest_letter = 0.61, largest = 3, leading = 1.4;  // of the letters' height; [mm]; of it
    double const size = std::min({largest, (page_width - 2 * margin) / (widest_letter * static_cast<double>(longest)),
                                  (page_height - margin - top) / (leading * static_cast<double>(lines))});
    double y = top;
    for (auto const& table : sheet.tables) {
        svg.text({margin, y}, size, table.heading, "font-weight=\"bold\"");
        auto const widths = table.widths();
        for (auto const& row : table.rows) {
            y += leading * size;
            double x = margin;
            for (std::size_t i = 0; i < row.size(); ++i) {
                svg.text({x, y}, size, row[i], "style=\"font-family:'DejaVu Sans Mono',monospace\"");
                x += widest_letter * size * static_cast<double>(widths[i] + between);
            }
        }
        y += 2 * leading * size;
    }
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string setup_sheet_svg(WireSetUps const& programs, std::vector<WireFile> const& files)
{
    using namespace report;
    auto const sheet = setup_sheet(programs, files);
    WireProgram const& program = programs.front();
    SheetSvg svg(page_width, page_height);
    constexpr double title = 6, title_at = 18;
    svg.text({margin, title_at}, title, sheet.title, "font-weight=\"bold\"");
    Vec2 const left(margin, boxes_top), step(box + gap, 0);
    svg.clip("start", left + step, box);
    draw_plan(svg, program, left);
    draw_start(svg, program, left + step);
    draw_side(svg, program, measured(program), left + 2 * step);
    constexpr double below = 10;
    write_tables(svg, sheet, boxes_top + box + below);
    return svg.page();
}

}  // namespace hdconj
