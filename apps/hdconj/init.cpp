// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `init`: the built-in scene as a file to edit.
#include <filesystem>
#include <iostream>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/read_scene.hpp"
#include "verb.hpp"

namespace hdconj::cli {
namespace {

struct InitArguments
{
    std::string file = "hdconj.toml";
    bool force = false;
};

int run_init(CommonOptions const& common, InitArguments const& own)
{
    if (own.file == "-") {
        std::cout << builtin_scene_text();
        return exit_done;
    }
    refuse(occupied(own.file, own.force));
    file::write_text_atomically(own.file, builtin_scene_text());
    if (!common.quiet)
        std::cerr << "wrote " << own.file << "; next: hdconj check " << own.file << '\n';
    return exit_done;
}

}  // namespace

void add_init(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] = add_verb(program, common, "init", "write the built-in scene to edit", run_init);
    verb.add_option("FILE", own.file, "where to; - for standard output [hdconj.toml]")->check(is_name);
    verb.add_flag("--force", own.force, "write over a file that is there");
    verb.add_flag("-q,--quiet", common.quiet, "no talk on standard error");
}

}  // namespace hdconj::cli
