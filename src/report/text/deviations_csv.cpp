// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

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

}  // namespace hdconj
