// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `init`: the built-in scene, or a ready drive, as a file to edit.
#include <filesystem>
#include <iostream>

#include "arguments.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/read_scene.hpp"
#include "verb.hpp"

namespace hdconj::cli {
namespace {

struct InitArguments
{
    std::string file = "hdconj.toml";
    std::string like;  ///< name of a ready drive; empty: the built-in scene
    bool force = false;
};

/// A ready drive is made by the rules when it is asked for: there is no second copy of it.
std::string text_of(InitArguments const& own)
{
    return own.like.empty() ? std::string(builtin_scene_text()) : scene_text(design_drive(ready_wishes(own.like)));
}

std::vector<std::string_view> ready_names()
{
    std::vector<std::string_view> names;
    for (auto const& drive : ready_drives())
        names.push_back(drive.name);
    return names;
}

int run_init(CommonOptions const& common, InitArguments const& own)
{
    if (own.file == "-") {
        std::cout << text_of(own);
        return exit_done;
    }
    refuse(occupied(own.file, own.force));
    file::write_text_atomically(own.file, text_of(own));
    if (!common.quiet)
        std::cerr << "wrote " << own.file << "; next: hdconj check " << own.file << '\n';
    return exit_done;
}

}  // namespace

void add_init(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "init", "write a scene to edit: the built-in one, or a ready drive", run_init);
    verb.add_option("FILE", own.file, "where to; - for standard output [hdconj.toml]")->check(is_name);
    add_option(verb, "--like", own.like,
               "a ready drive in place of the built-in one: size-14, size-17, size-20, size-25 or size-32", "WORD",
               one_of(ready_names()));
    verb.add_flag("--force", own.force, "write over a file that is there");
    verb.add_flag("-q,--quiet", common.quiet, "no talk on standard error");
    verb.footer(
        "A ready drive has the ratio 100, a cup half as long as its pitch diameter, a rated torque, and all\n"
        "dimensions as `hdconj design` makes them. They are this program's own, and no maker's.");
}

}  // namespace hdconj::cli
