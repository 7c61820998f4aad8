// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of a wire program. The program writes no HDF5 of it; the Python package shows it.
#include "columns.hpp"
#include "figures/wire_figures.hpp"
#include "results.hpp"

namespace hdconj::io {
namespace {

using layout::column;
using layout::Writer;

void write_pass(Writer const& place, WirePass const& pass, PassFigures const& figures)
{
    layout::write_attributes(place, figures::pass_figures(), {pass, figures});
    place.points("lower", column(pass.moves, &WireMove::lower), "wire centre in the lower face", "move");
    place.points("upper", column(pass.moves, &WireMove::upper), "wire centre in the upper face", "move");
    place.integers("tooth", column(pass.moves, &WireMove::tooth), {"1", "tooth space; -1: none", {"move"}});
}

void write_program(Writer const& place, WireProgram const& program)
{
    figures::MeasuredProgram const measured(program);
    place.attribute("name", program.name);
    layout::write_attributes(place, figures::wire_figures(), measured);
    place.points("lower", program.nominal.lower, "contour of the part in the lower face", "contour",
                 layout::Owner::result);
    place.points("upper", program.nominal.upper, "contour of the part in the upper face", "contour",
                 layout::Owner::result);
    for (std::size_t i = 0; i < program.passes.size(); ++i)
        place.group(fmt::format("pass_{}", program.passes[i].number),
                    [&](Writer const& group) { write_pass(group, program.passes[i], measured.figures.passes.at(i)); });
}

}  // namespace

void layout::write_result(Writer const& root, WireSetUps const& programs)
{
    root.texts("xy", {"x", "y"}, "coordinate of a point", "xy");
    for (auto const& program : programs)
        root.group(fmt::format("set_up_{}", program.set_up.number),
                   [&](Writer const& place) { write_program(place, program); });
}

}  // namespace hdconj::io
