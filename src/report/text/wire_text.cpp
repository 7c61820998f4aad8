// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "figures/number_text.hpp"
#include "figures/wire_figures.hpp"
#include "hdconj/wire_files.hpp"
#include "summary_page.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::report {
namespace {

constexpr double negligible = 1e-4;  // [mm] an ellipse of the wire that is not worth a line

using figures::MeasuredProgram;

void write_face(Page& page, char const* label, FaceRadii const& radii, std::string const& words)
{
    Told const told(figures::face_figures(), radii);
    page.figure(label, told.with_unit("inner_radius"), "to " + told.with_unit("outer_radius") + words);
}

void write_wire(Page& page, MeasuredProgram const& first)
{
    auto const& [program, found] = first;
    auto const rows = figures::wire_figures();
    Told const told(rows, first);
    auto const line = [&](char const* name, std::string const& note) { page.figure(rows[name], first, note); };
    page.line("{}: wire program, {} points per face, {} sync marks", program.name, program.nominal.lower.size(),
              told("sync_marks"));
    line("wire_diameter", "as the scene says");
    line("spark_gap", "as the scene says");
    line("thickness", "lower face z = 0, upper face z = T");
    line("guide_distance", fmt::format("H: {} below the lower face, {} above the upper one",
                                       told.with_unit("lower_guide"), told.with_unit("upper_guide")));
    page.line("\nfaces");
    write_face(page, "lower, radii", found.lower, "");
    write_face(page, "upper, radii", found.upper, "; " + wedm::upper_face_words(found));
    line("face_shift", fmt::format("largest |U - L| of the contour, least {}; T tan(tilt) of a radial tilt",
                                   told.with_unit("least_face_shift")));
    line("guide_offset", "largest, H tan(tilt); wire tilt " + told.with_unit("largest_wire_tilt"));
    page.figure(rows["contour_error"].text.label, "<= " + told.with_unit("contour_error"),
                found.face_shift > 0 ? "of the radii; of the face shift twice that; guide offset and lean, lengths "
                                       "and travel are those of the moves as written"
                                     : "of the radii; lengths and travel are those of the moves as written");
    if (program.cup_error > 0) {
        page.figure(rows["cup_error"].text.label, "+- " + told.with_unit("cup_error"),
                    "of the computed cup and bearing; the contours move by as much");
    }
    if (found.ellipse > negligible)
        line("wire_ellipse",
             "that a leaning wire cuts in the plane of a face, longer than wide; the path allows for it");
}

void write_passes(Page& page, WireProgram const& program, WireFigures const& found)
{
    page.line("\npasses\n  {:>4}{:>12}{:>11}{:>11}{:>9}{:>13}{:>15}{:>15}", "pass", "offset mm", "stock mm",
              "direction", "blocks", "length mm", "shortest mm", "residual um");
    for (std::size_t i = 0; i < program.passes.size(); ++i) {
        figures::MeasuredPass const pass{program.passes[i], found.passes[i]};
        Told const told(figures::pass_figures(), pass);
        page.line("  {:>4}{:>12}{:>11}{:>11}{:>9}{:>13}{:>15}{:>15}", told("pass"), told("offset"), told("stock"),
                  pass.pass.reversed ? "reversed" : "first", told("blocks"), told("length"), told("shortest_block"),
                  found.passes[i].residuals > 0 ? told("residual") : "<= " + told.error("residual"));
    }
    if (!program.closed())
        return;
    auto const& start = program.passes.front().moves.front().lower;
    page.figure("start hole", fmt::format("({:.4f}, {:.4f})", start.x(), start.y()), "mm, wire vertical");
}

void write_set_up(Page& page, WireProgram const& program)
{
    auto const at = [](Vec2 const& p) { return fmt::format("({:.4f}, {:.4f})", p.x(), p.y()); };
    auto const& moves = program.passes.front().moves;
    page.line("\n{}", wedm::set_up_words(program));
    int const last = (program.set_up.first + program.set_up.spaces - 1) % program.teeth;
    page.figure("start", at(moves.front().lower), "mm, outside the blank, wire vertical");
    page.figure("end", at(moves.back().lower), "mm, outside the blank");
    double overlap = 0;
    for (std::size_t i = 1; i < moves.size(); ++i)
        overlap += moves[i].tag == WireTag::overlap ? (moves[i].lower - moves[i - 1].lower).norm() : 0;
    page.figure("hands over", fmt::format("{:g} mm", overlap),
                fmt::format("overlap beyond the middle of the tip land behind space {}; begins in that before space {}",
                            last, program.set_up.first));
}

void write_residuals(Page& page, WireSetUps const& programs)
{
    std::size_t places = 0, meshing = 0;
    Residual const* highest = nullptr;
    std::string const known = figures::um_text(programs.front().residual_error);
    for (auto const& program : programs) {
        for (auto const& each : program.residuals) {
            ++places;
            meshing += each.meshing ? 1 : 0;
            highest = highest == nullptr || each.height > highest->height ? &each : highest;
        }
    }
    if (highest == nullptr) {
        page.line("  no residual material above {}: the wire reaches all of the contour to within that", known);
        return;
    }
    page.line("  residual material at {} places, {} of them in a zone that meshes", places, meshing);
    auto const rows = figures::residual_figures();
    Told const told(rows, *highest);
    page.figure(rows["height"], *highest,
                fmt::format("+- {}, pass {}, tooth space {}, {} face ({}, {}) mm{}", known, told("pass"), told("tooth"),
                            highest->upper ? "upper" : "lower", told("x"), told("y"),
                            highest->meshing ? ", in the meshing zone" : ""));
}

/// What the checks found; nothing where no check was made.
void write_checks(Page& page, MeasuredProgram const& first)
{
    auto const& [program, found] = first;
    if (program.tolerance <= 0)
        return;
    auto const rows = figures::wire_check_figures(), travels = figures::wire_figures();
    Told const told(rows, first);
    auto const line = [&](char const* name, std::string const& note) { page.figure(rows[name], first, note); };
    page.line("\nchecked");
    line("face_error", "apart from residual material; tolerance " + told.with_unit("tolerance"));
    line("guide_chord", "of straight moves");
    if (found.face_shift > 0) {
        std::string const edges = "matched edges turn by " + told.with_unit("matched_edges_turn");
        if (std::isnan(found.middle_error)) {
            page.figure(rows["middle_error"].text.label, "not checked",
                        "the outline has no slice between its ends; solve it with slices.count = 3 or more");
            page.figure(rows["ruling_error"].text.label, "not determined", edges);
        } else {
            line("middle_error", "off the true sections, apart from residual material");
            line("ruling_error",
                 fmt::format("of the surface off straight lines ({}); {}", to_string(program.surface), edges));
        }
        if (std::isnan(found.constant_taper_error))
            page.figure(rows["constant_taper_error"].text.label, "not determined", "G51 would cut the flanks away");
        else
            line("constant_taper_error", fmt::format("+- {}; what G51 would be wrong by on the walls of the upper face",
                                                     told.with_unit("constant_taper_known_to")));
    }
    page.figure(travels["travel"], first,
                "of a guide along an axis; upper against lower guide " + Told(travels, first).with_unit("uv_travel"));
}

/// @param between  whether the faces differ, so that there is a figure of the cut between them
void write_wire_files_list(Page& page, std::vector<WireFile> const& files, bool between)
{
    if (files.empty())
        return;
    std::size_t widest = 0;
    for (auto const& file : files)
        widest = std::max(widest, file.name.size());
    page.line("\n  {:<{}}{:>9}{:>11}{:>10}{:>9}   {}", "file", widest, "blocks", "bytes", "drift um", "cut um",
              "read by");
    for (auto const& file : files) {
        Told const told(figures::wire_file_figures(), file);
        page.line("  {:<{}}{:>9}{:>11}{:>10}{:>9}   {}", file.name, widest, told("blocks"), told("bytes"),
                  told("drift"), told("cut_error"), file.verified() ? file.verified_by : "not verified on hardware");
    }
    page.line("  drift: largest distance of the path read back from the exact one, all along it, both faces");
    page.line("  cut: what the cut off the faces and the drift come to, at most{}",
              between ? "; between the faces the drift adds to the figure above" : "");
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(WireSetUps const& programs, std::vector<WireFile> const& files)
{
    report::Page page;
    figures::MeasuredProgram const first(programs.front());
    report::write_wire(page, first);
    for (auto const& program : programs) {
        if (!program.closed())
            report::write_set_up(page, program);
        report::write_passes(page, program, measured(program));
    }
    report::write_residuals(page, programs);
    report::write_checks(page, first);
    for (auto const& warning : figures::wire_warnings(first.program, files))
        page.line("  WARNING: {}", warning);
    report::write_notes(page, first.program.notes);
    report::write_judgement(page, first.program.judgement);
    report::write_wire_files_list(page, files, first.figures.face_shift > 0);
    for (auto const& dialect : first.program.left_out)
        page.line("  left out: {}", dialect);
    return page.text();
}

}  // namespace hdconj
