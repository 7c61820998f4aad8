// SPDX-License-Identifier: GPL-3.0-or-later
#include "program_words.hpp"

#include <fmt/format.h>

#include <array>

namespace hdconj::wedm {

std::vector<std::string> heading(WireProgram const& program, WirePass const* pass)
{
    WireFigures const figures = measured(program);
    std::vector<std::string> lines = {"part " + program.name};
    if (pass != nullptr)
        lines.push_back(fmt::format("pass {} of {}, wire centre {:.6f} mm from the part", pass->number,
                                    program.passes.size(), pass->offset));
    lines.push_back(fmt::format("wire {:g} mm, spark gap {:g} mm, workpiece {:g} mm", program.wire_diameter,
                                program.spark_gap, program.machine.thickness));
    lines.push_back(fmt::format("lower guide {:g} mm below, upper guide {:g} mm above it", program.machine.lower_guide,
                                program.machine.upper_guide));
    lines.push_back(fmt::format("lower face z 0: radii {:.4f} to {:.4f} mm", figures.lower.inner, figures.lower.outer));
    lines.push_back(fmt::format("upper face z {:g}: radii {:.4f} to {:.4f} mm, {}", program.machine.thickness,
                                figures.upper.inner, figures.upper.outer, upper_face_words(figures)));
    if (!program.closed())
        lines.push_back(set_up_words(program));
    return lines;
}

std::string upper_face_words(WireFigures const& figures)
{
    LargerFace const larger = figures.larger_face();
    return larger == LargerFace::neither ? "as the lower face"
           : larger == LargerFace::lower ? "SMALLER than the lower face"
                                         : "LARGER than the lower face";
}

std::string set_up_words(WireProgram const& program)
{
    auto const& set_up = program.set_up;
    return fmt::format("set-up {} of {}: {} spaces from {} clockwise, part turned {} deg", set_up.number, set_up.of,
                       set_up.spaces, set_up.first, set_up.turned ? 180 : 0);
}

std::string_view to_string(WireTag tag)
{
    constexpr std::array<std::string_view, 6> words{"thread", "lead_in", "contour", "stop", "overlap", "lead_out"};
    return words.at(static_cast<std::size_t>(tag));
}

}  // namespace hdconj::wedm
