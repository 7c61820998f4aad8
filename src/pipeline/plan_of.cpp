// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a verb by its name.
#include <utility>

#include "hdconj/contact.hpp"
#include "hdconj/load.hpp"
#include "hdconj/running.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"

namespace hdconj {
namespace {

/// What the verb would refuse. A torque may still come with the command.
Faults faults_of(Scene const& scene, std::string const& verb)
{
    if (verb == "contact")
        return check_contact(scene, {});
    if (verb == "run") {
        RunOptions options;
        if (scene.friction && !(scene.load && scene.load->torque))
            options.torque = newton_metre;
        return check_run(scene, options);
    }
    LoadOptions options;
    if (!scene.load || !scene.load->torque) {
        options.torque = newton_metre;
        options.curve = false;
    }
    return check_load(scene, options);
}

}  // namespace

Plan plan_of(Scene const& scene, std::string const& verb, std::string const& place)
{
    if (verb == "solve")
        return make_plan(scene, Verb::solve);
    if (verb != "contact" && verb != "load" && verb != "run")
        throw InputError(Fault{place, 0, verb, "is no verb whose plan is known", "write solve, contact, load or run"});
    if (scene.wants_neutral_curve())
        throw InputError(Fault{place, 0, verb, "only solve takes a scene whose neutral curve is wanted",
                               "leave it out, or use the scene that hdconj solve --completed writes"});
    throw_if_any(faults_of(scene, verb));
    if (verb == "run")
        return plan_run(scene);
    return verb == "load" ? make_plan(loaded_scene(scene), Verb::load) : make_plan(scene, Verb::contact);
}

}  // namespace hdconj
