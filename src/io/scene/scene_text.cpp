// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_text.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"

namespace hdconj::io {
namespace {

Fault fault_of_file(std::string const& name, std::string reason, std::string remedy)
{
    return {name, 0, "", std::move(reason), std::move(remedy)};
}

Fault unreadable(std::string const& name, int error)
{
    switch (error) {
        case ENOENT:
            return fault_of_file(name, "there is no such file", "check the name; `hdconj init` writes a scene to edit");
        case EACCES:
            return fault_of_file(name, "no permission to read it", "make it readable, such as with chmod u+r");
        case EISDIR:
            return fault_of_file(name, "this is a folder", "name a scene file in it");
        default:
            return fault_of_file(name, std::string("cannot be read: ") + std::strerror(error), "check the file");
    }
}

}  // namespace

Fault too_large(std::string const& name)
{
    return fault_of_file(name, "larger than " + std::to_string(largest_scene >> 20) + " MiB: not a scene",
                         "name a scene file; `hdconj init` writes one");
}

std::string read_scene_text(std::filesystem::path const& file)
{
    std::string const name = file.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw InputError(unreadable(name, EISDIR));
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> const stream(std::fopen(name.c_str(), "rb"), &std::fclose);
    if (!stream)
        throw InputError(unreadable(name, errno));
    constexpr std::size_t block = 1 << 16;
    std::array<char, block> buffer{};
    std::string text;
    while (std::size_t const count = std::fread(buffer.data(), 1, block, stream.get())) {
        text.append(buffer.data(), count);
        if (text.size() > largest_scene)
            throw InputError(too_large(name));
    }
    if (std::ferror(stream.get()) != 0)
        throw InputError(unreadable(name, errno));
    return text;
}

}  // namespace hdconj::io
