// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "hdconj/base/suggest.hpp"
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/schema.hpp"
#include "verb.hpp"

namespace hdconj::cli {

bool is_known_verb(CLI::App const& program, std::string_view word)
{
    std::vector<std::string_view> verbs{"study"};
    for (auto const* const verb : program.get_subcommands([](CLI::App const*) { return true; })) {
        verbs.push_back(verb->get_name());
        if (verb->get_name() == word)
            return true;
    }
    std::cerr << "hdconj: unknown verb '" << word << "'";
    if (auto const meant = nearest(word, verbs)) {
        std::cerr << "; did you mean 'hdconj " << *meant << "'?\n";
    } else {
        std::cerr << "; known:";
        for (auto const verb : verbs)
            std::cerr << ' ' << verb;
        std::cerr << ". A scene file comes after the verb.\n";
    }
    return false;
}

void suggest_options(CLI::App const& program, std::vector<std::string> const& unexpected, std::string const& scene)
{
    auto const chosen = program.get_subcommands();
    CLI::App const& verb = chosen.empty() ? program : *chosen.front();
    std::vector<std::string_view> options, keys;
    for (auto const* const option : verb.get_options())
        for (auto const& name : option->get_lnames())
            options.emplace_back(name);
    bool const has_scene = std::find(options.begin(), options.end(), "set") != options.end();
    bool const begins_with_option = unexpected.front().starts_with('-');  // a word behind it is its value
    for (auto const& table : scene::scene_schema())
        for (auto const& key : table.keys)
            keys.emplace_back(key.spec.key);
    for (std::string const& given : unexpected) {
        if (begins_with_option && !given.starts_with('-'))
            continue;
        if (has_scene && !given.starts_with('-') && given.find('=') != std::string::npos) {
            std::cerr << "Write --set before each key, such as --set " << given << ".\n";
            return;
        }
        if (!program.get_subcommands([&](CLI::App const* each) { return each->get_name() == given; }).empty()) {
            std::cerr << "A command runs one verb: write hdconj " << given << " as a command of its own.\n";
            return;
        }
        if (has_scene && !given.starts_with('-')) {
            std::cerr << "One scene is read, and '" << scene
                      << "' was taken for it. A list is one word with commas, such as 0,0.1,0.2.\n";
            return;
        }
        if (!given.starts_with("--"))
            continue;
        std::string const word = given.substr(2, given.find('=') - 2);
        if (auto const meant = nearest(word, options)) {
            std::cerr << "Did you mean --" << *meant << "?\n";
        } else if (auto const key = nearest(word, keys); key && has_scene) {
            for (auto const& table : scene::scene_schema())
                for (auto const& each : table.keys)
                    if (each.spec.key == *key)
                        std::cerr << "Did you mean the key " << table.path << '.' << *key
                                  << " of the scene, such as --set " << table.path << '.' << *key << "=VALUE?\n";
        }
    }
}

std::vector<std::string> wrong_values(CLI::App& program)
{
    auto const chosen = program.get_subcommands();
    std::vector<std::string> found;
    for (CLI::Option* const option : (chosen.empty() ? program : *chosen.front()).get_options()) {
        CLI::Validator const* check = nullptr;
        try {
            check = option->get_validator();
        } catch (CLI::OptionNotFound const&) {
            continue;  // any value will do
        }
        for (std::string value : option->results())
            if (std::string const fault = (*check)(value); !fault.empty())
                found.push_back(option->get_name() + ": " + fault);
    }
    return found;
}

int refuse_command(std::vector<std::string> const& wrong, std::vector<std::string> const& given)
{
    std::cerr << fmt::format("{}\nRun with --help for more information.\n", fmt::join(wrong, "\n"));
    if (std::ranges::find(given, "--json") != given.end()) {
        Faults faults;
        for (std::string const& each : wrong)
            faults.push_back({"command line", 0, "", each, "see --help of the verb"});
        std::cout << check_json("", faults, nullptr) << '\n';
    }
    return exit_input;
}

}  // namespace hdconj::cli
