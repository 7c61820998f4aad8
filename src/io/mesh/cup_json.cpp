// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "elastic/bent_cup.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/mesh_files.hpp"
#include "hdconj/units.hpp"
#include "hdconj/version.hpp"

namespace hdconj {

std::string summary_json(elastic::BentCup const& cup, BentCupError const& error,
                         std::vector<WrittenFile> const& written)
{
    using Json = nlohmann::ordered_json;
    constexpr int format_version = 1, indent = 2;
    elastic::WaveGeneratorContact const& contact = cup.contact();
    double widest = 0;
    for (double const gap : contact.ball_gap)
        widest = std::max(widest, gap);
    Json files = Json::object();
    for (WrittenFile const& file : written)
        files[file.kind] = {{"path", file.file.string()}, {"seconds", file.seconds}};
    Json const object = {{"format", "hdconj-export"},
                         {"format_version", format_version},
                         {"program_version", program_version()},
                         {"git_revision", git_revision()},
                         {"cup",
                          {{"coning_major_deg", cup.coning(0) * per_deg},
                           {"coning_major_error_deg", error.coning_major * per_deg},
                           {"wave_generator_force_N", contact.total_force},
                           {"wave_generator_force_error_N", error.force},
                           {"ball_gap_um", widest * per_um}}},
                         {"files", files}};
    return object.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace hdconj
