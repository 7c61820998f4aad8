// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj._core: scenes, errors and the module itself.
#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <exception>
#include <filesystem>

#include "hdconj/base/stop.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/version.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "layout.hpp"
#include "scene.hpp"
#include "verbs.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace hdconj::python {
namespace {

nb::tuple texts(std::vector<std::string> const& of)
{
    nb::list list;
    for (auto const& each : of)
        list.append(text_of(each));
    return nb::tuple(list);
}

nb::tuple faults_tuple(Faults const& faults)
{
    nb::list list;
    for (auto const& each : faults)
        list.append(fault_tuple(each));
    return nb::tuple(list);
}

void raise(char const* name, nb::handle arguments)
{
    nb::object const type = nb::module_::import_("hdconj._errors").attr(name);
    PyErr_SetObject(type.ptr(), arguments.ptr());
}

void translate(std::exception_ptr const& thrown, void*)
{
    try {
        std::rethrow_exception(thrown);
    } catch (InputError const& error) {
        raise("InputError", nb::make_tuple(faults_tuple(error.faults()), text_of(error.what())));
    } catch (NumericalError const& error) {
        std::string const code(code_word(error.code()));
        raise("NumericalError", nb::make_tuple(code, text_of(error.stage()), text_of(error.place()),
                                               text_of(error.cause()), text_of(error.remedy()), texts(error.set())));
    } catch (FileError const& error) {
        raise("FileError", nb::make_tuple(text_of(error.what())));
    } catch (Stopped const& stopped) {
        raise("StoppedError", nb::make_tuple(stopped.what()));
    }
}

/// The CSV files that a scene names: by the path of the key the name, and what the file held; None: it was not read.
nb::dict files_of(SceneHandle const& scene)
{
    nb::dict found;
    for (auto const& [path, name] : scene.file_names()) {
        auto const file = scene.as_read().files.find(name);
        nb::object content = nb::none();
        if (file != scene.as_read().files.end() && file->second != nullptr)
            content = nb::bytes(file->second->data(), file->second->size());
        found[text_of(path)] = nb::make_tuple(text_of(name), content);
    }
    return found;
}

/// As `hdconj check --json --for VERB`.
nb::str check_text(SceneHandle const& scene, std::string const& name, std::string const& verb)
{
    if (!scene.faults().empty())
        return text_of(check_json(name, scene.faults(), nullptr));
    Scene const& sound = scene.sound();
    Plan const plan = plan_of(sound, verb, "verb");
    // the limits of a design are those of a neutral curve that is known
    return text_of(check_json(name, {}, &plan, sound.wants_neutral_curve() ? Notes{} : judge(sound)));
}

}  // namespace

nb::tuple fault_tuple(Fault const& fault)
{
    return nb::make_tuple(text_of(fault.path), fault.line, text_of(fault.value), text_of(fault.reason),
                          text_of(fault.remedy), text_of(fault.origin), texts(fault.set),
                          text_of(std::string(kind_word(fault.kind))));
}

void add_errors(nb::module_&)
{
    nb::register_exception_translator(translate);
}

/// The word for what a number of a key is; empty for keys that take no number.
std::string_view number_word(scene::Quantity quantity)
{
    switch (quantity) {
        case scene::Quantity::length:
        case scene::Quantity::positive_length:
        case scene::Quantity::nonnegative_length:
        case scene::Quantity::length_or_word:
            return "length";
        case scene::Quantity::angle_deg:
            return "angle";
        case scene::Quantity::number:
            return "number";
        case scene::Quantity::count:
            return "whole number";
        case scene::Quantity::word:
        case scene::Quantity::file:
        case scene::Quantity::rows:
        case scene::Quantity::text:
            return "";
    }
    return "";
}

/// Word, unit and expectation of a key; None where no table has it.
nb::object described(std::string const& path)
{
    auto const key = scene::describe_key(path, {profile::profile_families(), wavegen::wave_generator_families()});
    if (!key)
        return nb::none();
    return nb::make_tuple(text_of(std::string(number_word(key->quantity))), text_of(std::string(key->unit)),
                          text_of(key->expectation));
}

void add_scene(nb::module_& module)
{
    nb::class_<SceneHandle>(module, "Scene")
        .def_static("load", &SceneHandle::load, "file"_a)
        .def_static("parse", &SceneHandle::parse, "text"_a, "name"_a, "folder"_a, "overrides"_a)
        .def_prop_ro("faults", [](SceneHandle const& scene) { return faults_tuple(scene.faults()); })
        .def_prop_ro("text", [](SceneHandle const& scene) { return text_of(scene.as_read().text); })
        .def_prop_ro("files", files_of)
        .def_prop_ro("name", [](SceneHandle const& scene) { return text_of(scene.as_read().drive.name); })
        .def("check_json", check_text, "name"_a, "verb"_a);
    module.def("describe_key", described, "path"_a);
    module.def("keep_elastic_bodies", keep_elastic_bodies, "count"_a);
    module.def("elastic_body_count", [] {
        ElasticBodyCount const count = elastic_body_count();
        return nb::make_tuple(count.computed, count.reused);
    });
    module.def("builtin_scene_text", [] { return std::string(builtin_scene_text()); });
    module.def(
        "write_atomically",
        [](std::filesystem::path const& target, nb::callable const& write) {
            file::write_atomically(target, [&](std::filesystem::path const& place) { write(place); });
        },
        "target"_a, "write"_a);
    module.attr("version") = std::string(program_version());
    module.attr("revision") = std::string(git_revision());
    module.attr("build") = std::string(build_description());
}

}  // namespace hdconj::python

NB_MODULE(_core, module)
{
    module.doc() = "The library behind the package hdconj; not for use by itself.";
    nanobind::set_leak_warnings(false);  // what a program holds when it ends is no leak
    hdconj::python::add_errors(module);
    hdconj::python::add_scene(module);
    hdconj::python::add_verbs(module);
}
