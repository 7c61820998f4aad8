// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "refusal.hpp"
#include "scratch_folder.hpp"
#include "targets.hpp"

namespace hdconj::fuzz {
namespace {

void validate_figures(Inspection const& inspection)
{
    for (FlankFigures const& flank : inspection.flanks)
        for (Uncertain const& figure : {flank.position, flank.total, flank.slope, flank.crowning, flank.form})
            if (!std::isfinite(figure.value))
                throw Find("a figure of a flank is not finite");
    for (PointDeviation const& point : inspection.points)
        if (!std::isfinite(point.deviation) || !std::isfinite(point.arc_length))
            throw Find("a deviation is not finite");
}

}  // namespace

void point_file(Bytes input)
{
    std::string_view const text = text_of(input);
    for (char const* name : {"fuzzed.csv", "fuzzed.dxf"}) {
        write_scratch(name, text);
        PointReading const reading = examine_points(scratch_folder() / name);
        validate_faults(reading.faults);
        if (!reading.faults.empty())
            continue;
        Scene const scene = builtin_scene({"solver.threads=1"});
        for (Registration const registration :
             {Registration::datum, Registration::turn, Registration::least_squares, Registration::minimum_zone})
            accepted([&] {
                validate_figures(inspect_points(scene, reading.measured,
                                                {InspectedPart::flexspline, std::nullopt, 0, registration}));
            });
    }
}

}  // namespace hdconj::fuzz
