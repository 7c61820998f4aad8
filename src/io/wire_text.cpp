// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "hdconj/io/wire_files.hpp"
#include "summary_figures.hpp"
#include "summary_page.hpp"
#include "wire_numbers.hpp"

namespace hdconj {
namespace {

constexpr double negligible = 1e-4;  // [mm] what the wire's ellipse may matter before it is named

std::string mm(double value)
{
    return fmt::format("{:.6f} mm", value);
}

void write_wire(Page& page, WireProgram const& program, WireNumbers const& figures)
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
    page.figure("upper, radii", mm(figures.upper.inner), fmt::format("to {:.6f} mm; {}", figures.upper.outer, figures.larger_face()));
    page.figure("face shift", mm(figures.face_shift),
                fmt::format("largest |U - L| of the contour, least {:.6f} mm; T tan(tilt) of a radial tilt", figures.least_shift));
    page.figure("guide offset", mm(figures.guide_offset), fmt::format("largest, H tan(tilt); wire leans {:.6f} deg", figures.largest_tilt * degree_per_radian));
    if (figures.ellipse > negligible) {
        page.line("  WARNING: a wire that leans so much cuts an ellipse, {} wider in the plane of a face than is reckoned with", um(figures.ellipse));
    }
}

void write_passes(Page& page, WireProgram const& program, WireNumbers const& figures)
{
    page.line("\npasses\n  {:>4}{:>12}{:>11}{:>11}{:>9}{:>13}{:>15}{:>15}", "pass", "offset mm", "stock mm", "direction", "blocks", "length mm",
              "shortest mm", "residual um");
    for (std::size_t i = 0; i < program.passes.size(); ++i) {
        auto const& pass = program.passes[i];
        auto const& each = figures.passes[i];
        page.line("  {:>4}{:>12.6f}{:>11.6f}{:>11}{:>9}{:>13.3f}{:>15.6f}{:>15.3f}", pass.number, pass.offset, pass.stock,
                  pass.reversed ? "reversed" : "first", each.blocks, each.length, each.shortest, each.residual * um_per_mm);
    }
    auto const& start = program.passes.front().moves.front().lower;
    page.figure("start hole", fmt::format("({:.4f}, {:.4f})", start.x(), start.y()), "mm, wire vertical");
}

void write_residuals(Page& page, WireProgram const& program)
{
    if (program.residuals.empty()) {
        page.line("  no residual material: the wire reaches all of the contour");
        return;
    }
    auto const& all = program.residuals;
    auto const highest = std::max_element(all.begin(), all.end(), [](auto const& a, auto const& b) { return a.height < b.height; });
    auto const meshing = std::count_if(all.begin(), all.end(), [](auto const& each) { return each.meshing; });
    page.line("  residual material at {} places, {} of them in a zone that meshes", all.size(), meshing);
    page.figure("highest", um(highest->height),
                fmt::format("pass {}, tooth space {}, {} face ({:.4f}, {:.4f}) mm{}", highest->pass, highest->tooth, highest->upper ? "upper" : "lower",
                            highest->where.x(), highest->where.y(), highest->meshing ? ", in the meshing zone" : ""));
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

std::string summary_text(WireProgram const& program, std::vector<WireFile> const& files)
{
    Page page;
    WireNumbers const figures(program);
    write_wire(page, program, figures);
    write_passes(page, program, figures);
    write_residuals(page, program);
    write_wire_files_list(page, files);
    return page.text();
}

}  // namespace hdconj
