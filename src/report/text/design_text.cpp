// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a designed drive.
#include <algorithm>

#include "base/text.hpp"
#include "figures/number_text.hpp"
#include "hdconj/design_files.hpp"
#include "summary_page.hpp"

namespace hdconj::report {
namespace {

void write_dimensions(Page& page, Design const& design)
{
    page.line("{:<42}{:<9}{:>14} {:<8}{:<18}{:<11}{}", "dimension", "symbol", "value", "", "range", "from",
              "rule; source");
    for (auto const& row : design.rows) {
        bool const list = std::holds_alternative<scene::NumberRows>(row.value);
        page.line("{:<42}{:<9}{:>14} {:<8}{:<18}{:<11}{}{}", row.name, row.symbol, list ? "" : row.written(),
                  row.unit == "1" ? "" : row.unit, row.range_text(), to_string(row.origin), row.rule,
                  row.source == "wish" ? "" : "; " + row.source);
        if (list)
            page.line("  {}", row.written());
    }
}

void write_mesh(Page& page, Design const& design)
{
    page.line("\nradial deformations tried, each with the least tip circle that works");
    page.line("  {:>12}{:>12}{:>12}{:>9}{:>9}{:>9}  {}", "2 w_0/(m u)", "w_0 mm", "r_a mm", "land m", "teeth", "lost",
              "why not");
    double const taken = design.row("wave_generator.radial_deformation").number();
    for (MeshTrial const& trial : design.mesh)
        page.line("{:<2}{:>12}{:>12}{:>12}{:>9}{:>9}{:>9}  {}", trial.w0 == taken ? "*" : "",
                  figures::fixed(trial.ratio, 2), short_number(trial.w0), short_number(trial.tip_radius),
                  figures::fixed(trial.land, 3), figures::fixed(trial.flank_contact, 2), figures::fixed(trial.lost, 3),
                  trial.refusal);
    page.line("  *: taken; teeth: of a lobe in flank contact; lost: angle lost by undercut over angle used");
}

void write_walls(Page& page, Design const& design)
{
    if (design.walls.empty())
        return;
    page.line("\nwalls tried, with the largest von Mises stress in the cup");
    page.line("  {:>9}{:>16}{:>14}{:>8}  {}", "delta mm", "assembled MPa", "loaded MPa", "+-", "why not");
    for (WallTrial const& trial : design.walls)
        page.line("  {:>9}{:>16}{:>14}{:>8}  {}", short_number(trial.wall), figures::fixed(trial.assembled, 1),
                  figures::fixed(trial.loaded, 1), short_number(trial.error, 2), trial.refusal);
}

void write_differences(Page& page, Design const& design)
{
    if (design.differences.empty())
        return;
    page.line("\ndifferences from {}", design.other);
    page.line("  {:<36}{:>10}{:>12}  {}", "key", "here", "there", "why");
    auto const shown = [](std::string const& value) { return value.empty() ? "absent" : value; };
    for (auto const& each : design.differences)
        page.line("  {:<36}{:>10}{:>12}  {}", each.key, shown(each.here), shown(each.type_50), each.why);
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(Design const& design)
{
    report::Page page;
    report::write_dimensions(page, design);
    report::write_mesh(page, design);
    report::write_walls(page, design);
    report::write_differences(page, design);
    return page.text();
}

}  // namespace hdconj
