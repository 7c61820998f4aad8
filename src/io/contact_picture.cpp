// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_scripts.hpp"
#include "hdconj/io/contact_files.hpp"
#include "picture_file.hpp"

namespace hdconj {

ContactPictures contact_picture_names(std::filesystem::path const& file)
{
    return {picture_part(file, "tilt"), picture_part(file, "map"), picture_part(file, "flank")};
}

void check_contact_pictures(std::filesystem::path const& file)
{
    auto const [tilt, map, flank] = contact_picture_names(file);
    for (auto const& each : {tilt, map, flank}) {
        check_picture(each);
    }
}

std::vector<WrittenFile> write_contact_pictures(ContactStudy const& study, std::filesystem::path const& file)
{
    check_contact_pictures(file);
    auto const format = format_of(file);
    auto const [tilt, map, flank] = contact_picture_names(file);
    std::vector<WrittenFile> written;
    if (has_tilt_curve(study)) {
        written.push_back(drawn("picture_tilt", tilt_script(study, format), tilt));
    }
    if (!study.map.gap.empty()) {
        written.push_back(drawn("picture_map", map_script(study, format), map));
        written.push_back(drawn("picture_flank", flank_script(study, format), flank));
    }
    return written;
}

}  // namespace hdconj
