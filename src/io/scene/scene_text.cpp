// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "hdconj/read_scene.hpp"

namespace hdconj::io {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool continues_code_point(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

/// Index of the byte where column @p column of @p line begins.
std::size_t byte_of(std::string_view line, std::size_t column)
{
    std::size_t current = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        current += continues_code_point(line[i]) ? 0 : 1;
        if (current == column)
            return i;
    }
    return line.size();
}

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

TextLines::TextLines(std::string_view text) : text_(text), starts_{0}
{
    if (text_.starts_with(byte_order_mark))
        text_.remove_prefix(byte_order_mark.size());
    for (std::size_t at = text_.find('\n'); at != std::string_view::npos; at = text_.find('\n', at + 1))
        starts_.push_back(at + 1);
}

std::string_view TextLines::line(std::size_t number) const
{
    if (number == 0 || number > starts_.size())
        return {};
    std::size_t const begin = starts_[number - 1];
    std::string_view found = text_.substr(begin, std::min(text_.find('\n', begin), text_.size()) - begin);
    while (!found.empty() && found.back() == '\r')
        found.remove_suffix(1);
    return found;
}

std::string TextLines::columns(std::size_t number, std::size_t first, std::size_t last) const
{
    auto const whole = line(number);
    std::size_t const begin = byte_of(whole, first);
    std::size_t const end = std::max(begin, byte_of(whole, last));
    return std::string(whole.substr(begin, end - begin));
}

}  // namespace hdconj::io
