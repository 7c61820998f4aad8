// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "hdconj/io/wire_files.hpp"
#include "summary_figures.hpp"
#include "summary_page.hpp"
#include "wire_post.hpp"

namespace hdconj {
namespace {

constexpr double nothing = 1e-9;     // [mm] rounding of the points compared
constexpr double negligible = 1e-4;  // [mm] what the wire's ellipse may matter before it is named

std::string mm(double value)
{
    return fmt::format("{:.6f} mm", value);
}

void write_wire(Page& page, WireProgram const& program, WireFigures const& figures)
{
    auto const& machine = program.machine;
    page.line("{}: wire program, {} points per face, {} sync marks", program.name, program.nominal.lower.size(), program.nominal.sync.size());
    page.figure("wire diameter", fmt::format("{:g} mm", program.wire_diameter), "as the scene says");
    page.figure("spark gap", fmt::format("{:g} mm", program.spark_gap), "as the scene says");
    page.figure("workpiece", fmt::format("{:g} mm", machine.thickness), "lower face z = 0, upper face z = T");
    page.figure("guides", fmt::format("{:g} mm", machine.guide_distance()),
                fmt::format("H: {:g} mm below the lower face, {:g} mm above the upper one", machine.lower_guide, machine.upper_guide));
    page.line("\nfaces");
    page.figure("lower, radii", mm(figures.lower.inner), fmt::format("to {:.6f} mm", figures.lower.outer));
    page.figure("upper, radii", mm(figures.upper.inner), fmt::format("to {:.6f} mm; {}", figures.upper.outer, upper_face_words(figures)));
    page.figure("face shift", mm(figures.face_shift),
                fmt::format("largest |U - L| of the contour, least {:.6f} mm; T tan(tilt) of a radial tilt", figures.least_shift));
    page.figure("guide offset", mm(figures.guide_shift), fmt::format("largest, H tan(tilt); wire leans {:.6f} deg", figures.tilt * degree_per_radian));
    page.figure("error of the contours", um(program.contour_error, "<= "),
                figures.face_shift > 0 ? "of the radii; of the face shift twice that; guide offset and lean, lengths and travel are those of the moves as written" : "of the radii; lengths and travel are those of the moves as written");
    if (program.cup_error > 0) {
        page.figure("error, bent sections", um(program.cup_error, "+- "), "as cup and bearing are resolved; the contours move with them");
    }
    if (figures.ellipse > negligible) {
        page.line("  WARNING: a wire that leans so much cuts an ellipse, {} wider in the plane of a face than is reckoned with", um(figures.ellipse));
    }
}

void write_passes(Page& page, WireProgram const& program, WireFigures const& figures)
{
    page.line("\npasses\n  {:>4}{:>12}{:>11}{:>11}{:>9}{:>13}{:>15}{:>15}", "pass", "offset mm", "stock mm", "direction", "blocks", "length mm",
              "shortest mm", "residual um");
    for (std::size_t i = 0; i < program.passes.size(); ++i) {
        auto const& pass = program.passes[i];
        auto const& each = figures.passes[i];
        page.line("  {:>4}{:>12.6f}{:>11.6f}{:>11}{:>9}{:>13.3f}{:>15.6f}{:>15.3f}", pass.number, pass.offset, pass.stock,
                  pass.reversed ? "reversed" : "first", each.blocks, each.length, each.shortest, each.residual * um_per_mm);
    }
    if (!program.closed()) {
        return;
    }
    auto const& start = program.passes.front().moves.front().lower;
    page.figure("start hole", fmt::format("({:.4f}, {:.4f})", start.x(), start.y()), "mm, wire vertical");
}

void write_set_up(Page& page, WireProgram const& program)
{
    auto const at = [](Vec2 const& p) { return fmt::format("({:.4f}, {:.4f})", p.x(), p.y()); };
    auto const& moves = program.passes.front().moves;
    page.line("\n{}", set_up_words(program));
    int const last = (program.set_up.first + program.set_up.spaces - 1) % program.teeth;
    page.figure("start", at(moves.front().lower), "mm, outside the blank, wire vertical");
    page.figure("end", at(moves.back().lower), "mm, outside the blank");
    double overlap = 0;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        overlap += moves[i].tag == WireTag::overlap ? (moves[i].lower - moves[i - 1].lower).norm() : 0;
    }
    page.figure("hands over", fmt::format("{:g} mm", overlap),
                fmt::format("overlap beyond the middle of the tip land behind space {}; begins in that before space {}", last, program.set_up.first));
}

/// The path is as far off the exact parallel as it cuts the faces wrong.
double residual_error(WireProgram const& program)
{
    return std::max(program.tolerance, measured(program).face_error) + program.contour_error;
}

void write_residuals(Page& page, WireSetUps const& programs)
{
    std::size_t places = 0, meshing = 0;
    Residual const* highest = nullptr;
    for (auto const& program : programs) {
        for (auto const& each : program.residuals) {
            ++places;
            meshing += each.meshing ? 1 : 0;
            highest = highest == nullptr || each.height > highest->height ? &each : highest;
        }
    }
    if (highest == nullptr) {
        page.line("  no residual material: the wire reaches all of the contour");
        return;
    }
    page.line("  residual material at {} places, {} of them in a zone that meshes", places, meshing);
    page.figure("highest", um(highest->height),
                fmt::format("+- {}, pass {}, tooth space {}, {} face ({:.4f}, {:.4f}) mm{}", um(residual_error(programs.front())), highest->pass, highest->tooth, highest->upper ? "upper" : "lower",
                            highest->where.x(), highest->where.y(), highest->meshing ? ", in the meshing zone" : ""));
}

/// What the checks found; nothing where no check was made.
void write_checks(Page& page, WireProgram const& program, WireFigures const& figures)
{
    if (program.tolerance <= 0) {
        return;
    }
    page.line("\nchecked");
    page.figure("cut off the faces", um(figures.face_error), fmt::format("residuals apart; tolerance {}", um(program.tolerance)));
    page.figure("chord at the guides", um(figures.guide_chord), "of straight moves");
    if (figures.face_shift > 0) {
        page.figure("cut between the faces", um(figures.middle_error), "off the true sections, residuals apart");
        page.figure("rulings", um(figures.ruling_error > nothing ? figures.ruling_error : 0), fmt::format("of the surface off straight lines ({}); matched edges turn by {:.4f} deg",
                                                                    program.surface, figures.normal_angle * degree_per_radian));
        page.figure("constant taper", um(figures.constant_taper_error), fmt::format("+- {}; what G51 would be wrong by on the flanks of the upper face", um(taper_known_to(program, figures))));
    }
    page.figure("travel", fmt::format("{:.3f} mm", figures.travel), fmt::format("of a guide along an axis; upper against lower guide {:.3f} mm", figures.uv_travel));
}

void write_wire_files_list(Page& page, std::vector<WireFile> const& files)
{
    if (files.empty()) {
        return;
    }
    std::size_t widest = 0;
    for (auto const& file : files) {
        widest = std::max(widest, file.name.size());
    }
    auto const dialects = wire_dialects();
    page.line("\n  {:<{}}{:>9}{:>11}{:>12}   {}", "file", widest, "blocks", "bytes", "drift um", "read by");
    for (auto const& file : files) {
        auto const dialect = std::find_if(dialects.begin(), dialects.end(), [&](auto const& each) { return each.name == file.dialect; });
        page.line("  {:<{}}{:>9}{:>11}{:>12.2g}   {}", file.name, widest, file.blocks, file.bytes, file.drift * um_per_mm,
                  dialect != dialects.end() && dialect->verified() ? dialect->verified_by : "not verified on hardware");
    }
    page.line("  drift: largest distance of the path read back from the exact one, all along it, both faces");
}

}  // namespace

std::string summary_text(WireSetUps const& programs, std::vector<WireFile> const& files)
{
    Page page;
    auto const& first = programs.front();
    write_wire(page, first, measured(first));
    for (auto const& program : programs) {
        if (!program.closed()) {
            write_set_up(page, program);
        }
        write_passes(page, program, measured(program));
    }
    write_residuals(page, programs);
    write_checks(page, first, measured(first));
    for (auto const& warning : first.warnings) {
        page.line("  WARNING: {}", warning);
    }
    write_wire_files_list(page, files);
    return page.text();
}

}  // namespace hdconj
