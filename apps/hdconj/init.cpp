// SPDX-License-Identifier: GPL-3.0-or-later
// hdconj init: the built-in scene as a file to edit.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/scene_toml.hpp"
#include "words.hpp"

namespace hdconj::cli {
namespace {

struct InitOptions
{
    std::string file = "hdconj.toml";
    bool force = false;
};

int run_init(CommonOptions const& common, InitOptions const& own)
{
    if (own.file == "-") {
        std::cout << builtin_scene_text();
        return exit_done;
    }
    std::error_code ignored;
    if (std::filesystem::is_directory(own.file, ignored)) {
        throw InputError(Fault{own.file, 0, "", "this is a folder", "name a file in it"});
    }
    if (!own.force && std::filesystem::exists(std::filesystem::symlink_status(own.file, ignored))) {
        throw InputError(Fault{own.file, 0, "", "this file is there already", "use --force to write over it"});
    }
    write_text_atomically(own.file, builtin_scene_text());
    if (!common.quiet) {
        std::cerr << "wrote " << own.file << "; next: hdconj check " << own.file << '\n';
    }
    return exit_done;
}

}  // namespace

void add_init(CLI::App& program, CommonOptions& common)
{
    auto* const verb = program.add_subcommand("init", "write the built-in scene to edit");
    auto const own = std::make_shared<InitOptions>();
    verb->add_option("FILE", own->file, "where to; - for standard output")->check(name_fault)->capture_default_str();
    verb->add_flag("--force", own->force, "write over a file that is there");
    verb->add_flag("--quiet", common.quiet, "no talk on standard error");
    verb->callback([&common, own] { common.action = [&common, own] { return run_init(common, *own); }; });
}

}  // namespace hdconj::cli
