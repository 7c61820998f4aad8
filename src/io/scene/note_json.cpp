// SPDX-License-Identifier: GPL-3.0-or-later
#include "note_json.hpp"

#include <cmath>

namespace hdconj::io {

nlohmann::ordered_json json_of(Notes const& notes)
{
    using Json = nlohmann::ordered_json;
    auto const number = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
    Json list = Json::array();
    for (auto const& note : notes)
        list.push_back({{"code", to_string(note.code)},
                        {"severity", to_string(note.severity)},
                        {"figure", number(note.figure)},
                        {"limit", number(note.limit)},
                        {"unit", note.unit},
                        {"place", note.place},
                        {"cause", note.cause},
                        {"advice", note.advice},
                        {"set", note.set}});
    return list;
}

}  // namespace hdconj::io
