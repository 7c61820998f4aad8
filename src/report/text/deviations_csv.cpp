// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "figures/inspect_figures.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/units.hpp"

namespace hdconj {

void write_deviations(Inspection const& inspection, std::filesystem::path const& file)
{
    std::string text = "line,z [mm],tooth,flank,arc length [mm],deviation [um],uncertainty [um],fate\n";
    for (PointDeviation const& point : inspection.points)
        fmt::format_to(std::back_inserter(text), "{},{:g},{},{},{:.9f},{:.7f},{:.2g},{}\n", point.line, point.z,
                       point.tooth, figures::flank_word(point.right), point.arc_length, point.deviation * per_um,
                       inspection.placement.deviation_error * per_um, to_string(point.fate));
    file::write_text_atomically(file, text);
}

void write_pitch(Inspection const& inspection, std::filesystem::path const& file)
{
    Drive const& drive = inspection.scene.drive;
    bool const spline = inspection.options.part == InspectedPart::circular_spline;
    double const pitch_radius = drive.module * (spline ? drive.circular_spline_teeth : drive.flexspline_teeth) / 2;
    NominalFigures const& plane = inspection.nominal.front();
    double const to_pitch = pitch_radius / plane.reference_radius;
    std::string text = "tooth,place [um],uncertainty [um]\n";
    std::vector<FlankFigures> const& flanks = inspection.flanks;
    for (std::size_t i = 0; i + 1 < flanks.size(); ++i) {
        FlankFigures const& left = flanks[i];
        FlankFigures const& right = flanks[i + 1];
        if (left.z != plane.z || right.z != plane.z || left.tooth != right.tooth)
            continue;
        double const place = (left.position.value + right.position.value) / 2 * to_pitch;
        double const error = std::hypot(left.position.error, right.position.error) / 2 * to_pitch;
        fmt::format_to(std::back_inserter(text), "{},{:.6f},{}\n", left.tooth, place * per_um,
                       std::isfinite(error) ? fmt::format("{:.2g}", error * per_um) : "");
    }
    file::write_text_atomically(file, text);
}

}  // namespace hdconj
