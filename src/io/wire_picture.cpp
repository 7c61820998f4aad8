// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include "hdconj/io/wire_files.hpp"
#include "picture_file.hpp"
#include "wire_scripts.hpp"

namespace hdconj {
namespace {

/// NAME.svg becomes NAME-what.svg.
std::filesystem::path named(std::filesystem::path const& file, char const* what)
{
    auto name = file.stem();
    name += std::string("-") + what;
    name += file.extension();
    return file.parent_path() / name;
}

}  // namespace

WirePictures wire_picture_names(std::filesystem::path const& file)
{
    return {named(file, "tooth"), named(file, "ring"), named(file, "residual")};
}

void check_wire_pictures(std::filesystem::path const& file)
{
    auto const [tooth, ring, residual] = wire_picture_names(file);
    for (auto const& each : {tooth, ring, residual}) {
        check_picture(each);
    }
}

std::vector<WrittenFile> write_wire_pictures(WireProgram const& program, std::filesystem::path const& file)
{
    check_wire_pictures(file);
    auto const format = format_of(file);
    auto const [tooth, ring, residual] = wire_picture_names(file);
    std::vector<WrittenFile> written;
    auto const write = [&](char const* kind, auto const& script_of, std::filesystem::path const& to) {
        auto const begin = std::chrono::steady_clock::now();
        draw_picture(script_of(program, format), to);
        written.push_back({kind, to, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()});
    };
    write("picture_tooth", wire_tooth_script, tooth);
    write("picture_ring", wire_ring_script, ring);
    if (!program.residuals.empty()) {
        write("picture_residual", wire_residual_script, residual);
    }
    return written;
}

}  // namespace hdconj
