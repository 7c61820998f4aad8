// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/read_scene.hpp"

#include <nlohmann/json.hpp>

#include "note_json.hpp"

namespace hdconj {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(Faults const& faults)
{
    Json list = Json::array();
    for (auto const& fault : faults) {
        list.push_back({{"path", fault.path},
                        {"line", fault.line},
                        {"value", fault.value},
                        {"reason", fault.reason},
                        {"remedy", fault.remedy},
                        {"origin", fault.origin},
                        {"set", fault.set},
                        {"kind", kind_word(fault.kind)}});
    }
    return list;
}

void add_plan(Json& object, Plan const& plan)
{
    object["stages"] = Json::array();
    for (auto const& planned : plan.stages)
        object["stages"].push_back({{"stage", to_string(planned.stage)}, {"reason", planned.reason}});
    object["absent"] = Json::array();
    for (auto const& effect : plan.absent)
        object["absent"].push_back({{"effect", effect.name}, {"remedy", effect.remedy}});
}

std::string text_of(Json const& object)
{
    constexpr int indent = 2;
    // A value may hold bytes that are no UTF-8; they are replaced, not thrown at.
    return object.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string check_json(std::string const& scene_name, Faults const& faults, Plan const* plan, Notes const& notes)
{
    Json object{{"format", "hdconj-check"}, {"format_version", 1}, {"scene", scene_name}, {"faults", json_of(faults)}};
    if (plan != nullptr) {
        add_plan(object, *plan);
        object["judgement"] = io::json_of(notes);
    }
    return text_of(object);
}

std::string failure_json(std::string const& scene_name, std::exception const& error)
{
    Json said{{"code", "failed"},      {"stage", ""},  {"place", ""},
              {"cause", error.what()}, {"remedy", ""}, {"set", Json::array()}};
    if (auto const* of_file = dynamic_cast<FileError const*>(&error))
        said.update({{"place", of_file->file()}, {"cause", of_file->cause()}, {"remedy", of_file->remedy()}});
    if (auto const* known = dynamic_cast<NumericalError const*>(&error))
        said = {{"code", code_word(known->code())}, {"stage", known->stage()},   {"place", known->place()},
                {"cause", known->cause()},          {"remedy", known->remedy()}, {"set", known->set()}};
    return text_of({{"scene", scene_name}, {"error", said}});
}

}  // namespace hdconj
