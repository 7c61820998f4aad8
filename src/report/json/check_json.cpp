// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

Json fault_object(Fault const& fault)
{
    return {{"path", fault.path},     {"line", fault.line},           {"value", fault.value},
            {"reason", fault.reason}, {"remedy", fault.remedy},       {"origin", fault.origin},
            {"set", fault.set},       {"kind", kind_word(fault.kind)}};
}

void add_plan(Json& object, Plan const& plan)
{
    object["stages"] = list_of(plan.stages, [](PlannedStage const& planned) -> Json {
        return {{"stage", to_string(planned.stage)}, {"reason", planned.reason}};
    });
    object["absent"] = list_of(plan.absent, [](AbsentEffect const& effect) -> Json {
        return {{"effect", effect.name}, {"remedy", effect.remedy}};
    });
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string check_json(std::string const& scene_name, Faults const& faults, Plan const* plan, Notes const& notes)
{
    report::Json object{{"format", "hdconj-check"},
                        {"format_version", 1},
                        {"scene", scene_name},
                        {"faults", report::list_of(faults, report::fault_object)}};
    if (plan != nullptr) {
        report::add_plan(object, *plan);
        object["judgement"] = report::notes_object(notes);
    }
    return report::indented(object);
}

std::string failure_json(std::string const& scene_name, std::exception const& error)
{
    report::Json said{{"code", "failed"},      {"stage", ""},  {"place", ""},
                      {"cause", error.what()}, {"remedy", ""}, {"set", report::Json::array()}};
    if (auto const* of_file = dynamic_cast<FileError const*>(&error))
        said.update({{"place", of_file->file()}, {"cause", of_file->cause()}, {"remedy", of_file->remedy()}});
    if (auto const* known = dynamic_cast<NumericalError const*>(&error))
        said = {{"code", code_word(known->code())}, {"stage", known->stage()},   {"place", known->place()},
                {"cause", known->cause()},          {"remedy", known->remedy()}, {"set", known->set()}};
    return report::indented({{"scene", scene_name}, {"error", said}});
}

}  // namespace hdconj
