// SPDX-License-Identifier: GPL-3.0-or-later
#include "setup_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "figures/number_text.hpp"
#include "figures/wire_figures.hpp"
#include "summary_page.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::report {
namespace {

using figures::MeasuredProgram;

std::string point_text(Vec2 const& p)
{
    return fmt::format("x {:.4f}, y {:.4f} mm", p.x(), p.y());
}

SheetTable part_table(MeasuredProgram const& first)
{
    WireProgram const& program = first.program;
    Told const told(figures::wire_figures(), first);
    auto const radii = [](FaceRadii const& of) {
        Told const face(figures::face_figures(), of);
        return "radii " + face("inner_radius") + " to " + face.with_unit("outer_radius");
    };
    SheetTable table{"Part",
                     {{"part", program.name},
                      {"teeth", fmt::format("{}, {}", program.teeth, program.external ? "outside" : "inside")},
                      {"workpiece", told.with_unit("thickness") +
                                        " thick; its lower face, z = 0, is the end towards the cup's bottom"},
                      {"lower face", radii(first.figures.lower)},
                      {"upper face", radii(first.figures.upper) + "; " + wedm::upper_face_words(first.figures)}}};
    if (!is_untilted(program))
        table.rows.push_back(
            {"face shift", told.with_unit("face_shift") + " at most between matched points of both faces"});
    return table;
}

SheetTable wire_table(MeasuredProgram const& first)
{
    Told const told(figures::wire_figures(), first);
    bool const upright = is_untilted(first.program);
    return {"Wire and guides",
            {{"wire", told.with_unit("wire_diameter") + ", spark gap " + told.with_unit("spark_gap")},
             {"lower guide", told.with_unit("lower_guide") + " below the lower face"},
             {"upper guide", told.with_unit("upper_guide") + " above the upper face"},
             {"wire leans", upright ? "nowhere: it stays vertical"
                                    : told.with_unit("largest_wire_tilt") + " at most, guides apart by " +
                                          told.with_unit("guide_offset") + " seen along the axis"},
             {"travel", told.with_unit("travel") + " of a guide along an axis" +
                            (upright ? "" : "; U and V " + told.with_unit("uv_travel"))}}};
}

/// Where the passes stop, or that they do not.
std::string stop_text(WireProgram const& program)
{
    for (WirePass const& pass : program.passes)
        for (WireMove const& move : pass.moves)
            if (move.tag == WireTag::stop)
                return fmt::format("{} in pass {} at {}, before what is cut off drops{}", to_string(program.stop),
                                   pass.number, point_text(move.lower),
                                   program.stop == WireStop::optional ? "; switch optional stops on" : "");
    return "none: hold what is cut off before it drops";
}

SheetTable set_up_table(WireProgram const& program)
{
    auto const& moves = program.passes.front().moves;
    SheetTable table{"Set-up", {}};
    auto const row = [&](char const* label, std::string value) { table.rows.push_back({label, std::move(value)}); };
    if (!program.closed()) {
        table.heading = fmt::format("Set-up {} of {}", program.set_up.number, program.set_up.of);
        row("teeth cut", wedm::set_up_words(program));
        row("start", point_text(moves.front().lower) + ", outside the blank, wire vertical");
        row("end", point_text(moves.back().lower) + ", outside the blank");
    } else {
        row("start hole", point_text(moves.front().lower) +
                              fmt::format(", radius {:g} mm, wire vertical", program.start_hole_radius));
    }
    row("direction", fmt::format("pass 1 {}, seen from above", program.external ? "clockwise" : "counter-clockwise"));
    row("stop", stop_text(program));
    return table;
}

SheetTable pass_table(WireSetUps const& programs)
{
    SheetTable table{"Passes", {{"set-up", "pass", "offset D mm", "stock mm", "direction", "blocks", "length mm"}}};
    for (WireProgram const& program : programs) {
        WireFigures const found = measured(program);
        for (std::size_t i = 0; i < program.passes.size(); ++i) {
            figures::MeasuredPass const pass{program.passes[i], found.passes[i]};
            Told const told(figures::pass_figures(), pass);
            table.rows.push_back({std::to_string(program.set_up.number), told("pass"), told("offset"), told("stock"),
                                  pass.pass.reversed ? "reversed" : "as pass 1", told("blocks"), told("length")});
        }
    }
    return table;
}

/// One row for each dialect.
SheetTable file_table(std::vector<WireFile> const& files)
{
    SheetTable table{"Files", {{"dialect", "files", "", "cut um", "read back by"}}};
    for (std::size_t i = 0; i < files.size();) {
        std::size_t next = i;
        while (next < files.size() && files[next].dialect == files[i].dialect)
            ++next;
        Told const told(figures::wire_file_figures(), files[i]);
        table.rows.push_back(
            {files[i].dialect, files[i].name, next > i + 1 ? fmt::format("and {} more", next - i - 1) : "",
             told("cut_error"),
             files[i].verified() ? std::string(files[i].verified_by) : "not verified on hardware: run it dry first"});
        i = next;
    }
    return table;
}

/// Lines of @p text, broken at blanks, that the page has room for.
std::vector<std::string> broken(std::string const& text)
{
    constexpr std::size_t longest = 90;
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (lines.back().size() + 1 + word.size() > longest)
            lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

/// What the cut of any file may be off both faces.
std::string cut_text(MeasuredProgram const& first, std::vector<WireFile> const& files)
{
    Told const told(figures::wire_check_figures(), first);
    auto const worst = std::ranges::max_element(files, {}, &WireFile::cut_error);
    std::string const text = "at most " + told.with_unit("face_error") + " off the faces, corners apart; ";
    std::string const drift = worst == files.end() ? ""
                                                   : Told(figures::wire_file_figures(), *worst).with_unit("cut_error") +
                                                         " with the drift of files; ";
    return text + drift + "tolerance " + told.with_unit("tolerance");
}

/// What the cut is off the true sections between the faces.
std::string between_text(MeasuredProgram const& first)
{
    if (std::isnan(first.figures.middle_error))
        return "the cut between the faces was NOT CHECKED";
    return "at most " + Told(figures::wire_check_figures(), first).with_unit("middle_error") +
           " off the true sections between the faces, corners apart";
}

SheetTable check_table(WireSetUps const& programs, MeasuredProgram const& first, std::vector<WireFile> const& files)
{
    SheetTable table{"Known before cutting", {}};
    if (first.program.tolerance > 0) {
        table.rows.push_back({"cut", cut_text(first, files)});
        if (!is_untilted(first.program))
            table.rows.push_back({"between", between_text(first)});
    }
    double highest = 0;
    for (WireProgram const& program : programs)
        for (Residual const& residual : program.residuals)
            highest = std::max(highest, residual.pass == programs.front().passes.back().number ? residual.height : 0);
    std::string const known = figures::um_text(first.program.residual_error);
    table.rows.push_back(
        {"corners", highest > 0
                        ? fmt::format("the last pass leaves up to {:.3g} +- {} that the round wire cannot reach",
                                      highest * per_um, known)
                        : "the wire reaches all of the contour to within " + known});
    auto const warnings = figures::wire_warnings(first.program, files);
    for (auto const& warning : warnings)
        for (std::string label = "WARNING"; auto const& line : broken(warning))
            table.rows.push_back({std::exchange(label, ""), line});
    if (warnings.empty())
        table.rows.push_back({"warnings", "none"});
    for (auto const& note : first.program.notes)
        for (std::string label = "note"; auto const& line : broken(note))
            table.rows.push_back({std::exchange(label, ""), line});
    return table;
}

/// Files in the order of the dialects, whatever set-up they belong to.
std::vector<WireFile> by_dialect(std::vector<WireFile> files)
{
    std::vector<std::string_view> order;
    for (auto const& dialect : wire_dialects())
        order.push_back(dialect.name);
    std::ranges::stable_sort(files, {}, [&](WireFile const& file) {
        return std::ranges::find(order, std::string_view(file.dialect)) - order.begin();
    });
    return files;
}

}  // namespace

std::vector<std::size_t> SheetTable::widths() const
{
    std::vector<std::size_t> widest;
    for (auto const& row : rows) {
        widest.resize(std::max(widest.size(), row.size()), 0);
        for (std::size_t i = 0; i < row.size(); ++i)
            widest[i] = std::max(widest[i], row[i].size());
    }
    return widest;
}

SetupSheet setup_sheet(WireSetUps const& programs, std::vector<WireFile> const& files)
{
    MeasuredProgram const first(programs.front());
    SetupSheet sheet{first.program.name + ": wire setup sheet", {part_table(first), wire_table(first)}};
    std::ranges::transform(programs, std::back_inserter(sheet.tables), set_up_table);
    sheet.tables.push_back(pass_table(programs));
    if (!files.empty())
        sheet.tables.push_back(file_table(by_dialect(files)));
    sheet.tables.push_back(check_table(programs, first, files));
    return sheet;
}

}  // namespace hdconj::report

namespace hdconj {

std::string setup_sheet_text(WireSetUps const& programs, std::vector<WireFile> const& files)
{
    auto const sheet = report::setup_sheet(programs, files);
    report::Page page;
    page.line("{}", sheet.title);
    for (auto const& table : sheet.tables) {
        page.line("\n{}", table.heading);
        auto const widths = table.widths();
        for (auto const& row : table.rows) {
            std::string line;
            for (std::size_t i = 0; i < row.size(); ++i)
                line += fmt::format("  {:<{}}", row[i], i + 1 < row.size() ? widths[i] : 0);
            page.line("{}", line);
        }
    }
    return page.text();
}

}  // namespace hdconj
