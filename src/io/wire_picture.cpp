// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "hdconj/io/wire_files.hpp"
#include "picture_file.hpp"
#include "wire_scripts.hpp"

namespace hdconj {

WirePictures wire_picture_names(std::filesystem::path const& file, std::size_t set_ups)
{
    WirePictures names{picture_part(file, "tooth"), {}, picture_part(file, "residual")};
    for (std::size_t i = 1; i <= set_ups; ++i) {
        names.rings.push_back(picture_part(file, set_ups == 1 ? "ring" : "ring" + std::to_string(i)));
    }
    return names;
}

void check_wire_pictures(std::filesystem::path const& file, std::size_t set_ups)
{
    auto const names = wire_picture_names(file, set_ups);
    check_picture(names.tooth);
    check_picture(names.residual);
    for (auto const& ring : names.rings) {
        check_picture(ring);
    }
}

std::vector<WrittenFile> write_wire_pictures(WireSetUps const& programs, std::filesystem::path const& file)
{
    check_wire_pictures(file, programs.size());
    auto const format = format_of(file);
    auto const names = wire_picture_names(file, programs.size());
    std::vector<WrittenFile> written = {drawn("picture_tooth", wire_tooth_script(programs.front(), format), names.tooth)};
    for (std::size_t i = 0; i < programs.size(); ++i) {
        std::string const kind = "picture_ring" + (programs.size() == 1 ? "" : std::to_string(i + 1));
        written.push_back(drawn(kind, wire_ring_script(programs[i], format), names.rings[i]));
    }
    if (std::any_of(programs.begin(), programs.end(), [](auto const& program) { return !program.residuals.empty(); })) {
        written.push_back(drawn("picture_residual", wire_residual_script(programs, format), names.residual));
    }
    return written;
}

}  // namespace hdconj
