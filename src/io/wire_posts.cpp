// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "wire_grid.hpp"
#include "wire_post.hpp"

namespace hdconj {

std::vector<WirePost> const& wire_posts()
{
    static std::vector<WirePost> const posts = {dxf_post(),      xyuv_guide_post(), xyuv_face_post(), csv_post(),
                                                relative_post(), colon_post(),      three_b_post(),   iso2d_post()};
    return posts;
}

std::vector<WireDialect> wire_dialects()
{
    std::vector<WireDialect> dialects;
    for (auto const& post : wire_posts()) {
        dialects.push_back(post.dialect);
    }
    return dialects;
}

std::vector<std::string> fitting_dialects(WireProgram const& program)
{
    bool const untilted = is_untilted(program);
    std::vector<std::string> names;
    for (auto const& dialect : wire_dialects()) {
        if (untilted || !dialect.only_untilted) {
            names.emplace_back(dialect.name);
        }
    }
    return names;
}

double program_unit(WireProgram const& program)
{
    return WireGrid(program.decimals).unit();
}

std::vector<FacePath> exact_passes(WireProgram const& program)
{
    std::vector<FacePath> paths;
    for (auto const& pass : program.passes) {
        auto& path = paths.emplace_back();
        path.what = fmt::format("pass {}", pass.number);
        for (auto const& move : pass.moves) {
            path.lower.push_back(move.lower);
            path.upper.push_back(move.upper);
        }
    }
    return paths;
}

bool is_untilted(WireProgram const& program)
{
    auto const same = [](WireMove const& move) { return move.lower == move.upper; };
    return program.nominal.lower == program.nominal.upper &&
           std::all_of(program.passes.begin(), program.passes.end(),
                       [&](WirePass const& pass) { return std::all_of(pass.moves.begin(), pass.moves.end(), same); });
}

std::string comment_text(std::string const& text, std::size_t longest)
{
    std::string result;
    for (char const c : text.substr(0, longest)) {
        bool const kept = c >= ' ' && c <= '~' && c != '(' && c != ')' && c != ';';
        result += kept ? c : '-';
    }
    return result;
}

std::vector<std::string> heading(WireProgram const& program, WirePass const* pass)
{
    WireFigures const figures = measured(program);
    std::vector<std::string> lines = {"part " + program.name};
    if (pass != nullptr) {
        lines.push_back(fmt::format("pass {} of {}, wire centre {:.6f} mm from the part", pass->number, program.passes.size(), pass->offset));
    }
    lines.push_back(fmt::format("wire {:g} mm, spark gap {:g} mm, workpiece {:g} mm", program.wire_diameter, program.spark_gap,
                                program.machine.thickness));
    lines.push_back(fmt::format("lower guide {:g} mm below, upper guide {:g} mm above it", program.machine.lower_guide,
                                program.machine.upper_guide));
    lines.push_back(fmt::format("lower face z 0: radii {:.4f} to {:.4f} mm", figures.lower.inner, figures.lower.outer));
    lines.push_back(fmt::format("upper face z {:g}: radii {:.4f} to {:.4f} mm, {}", program.machine.thickness, figures.upper.inner,
                                figures.upper.outer, upper_face_words(figures)));
    if (!program.closed()) {
        lines.push_back(set_up_words(program));
    }
    return lines;
}

std::string upper_face_words(WireFigures const& figures)
{
    std::string const larger = figures.larger_face();
    return larger == "same" ? "as the lower face" : larger == "lower" ? "SMALLER than the lower face" : "LARGER than the lower face";
}

std::string set_up_words(WireProgram const& program)
{
    auto const& set_up = program.set_up;
    return fmt::format("set-up {} of {}: {} spaces from {} clockwise, part turned {} deg", set_up.number, set_up.of, set_up.spaces, set_up.first,
                       set_up.turned ? 180 : 0);
}

std::string pass_file(std::string const& stem, std::string const& what, WirePass const& pass, std::string const& ending)
{
    return fmt::format("{}_{}_pass{}.{}", stem, what, pass.number, ending);
}

}  // namespace hdconj
