// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_text.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "hdconj/io/scene_reading.hpp"

namespace hdconj::detail {
namespace {

/// Dotted parts of one key: a scene needs two. The parser nests a table for each, and its depth is the stack's.
constexpr int most_dots = 16;

/// A scene has a few dozen keys.
constexpr int most_keys = 10000;

Fault fault_of_file(std::string const& name, std::string reason, std::string remedy)
{
    return {name, 0, "", std::move(reason), std::move(remedy)};
}

Fault too_large(std::string const& name)
{
    return fault_of_file(name, "larger than " + std::to_string(largest_scene >> 20) + " MiB: not a scene",
                         "name a scene file; `hdconj init` writes one");
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

/// Follows a TOML text far enough to tell keys from strings and comments; counts keys and the dots of each.
class KeyCounter
{
  public:
    /// Why the keys of @p text are too many or too deep; empty when they are not.
    std::string complaint(std::string_view text)
    {
        for (std::size_t i = 0; i < text.size() && dots_ <= most_dots && keys_ <= most_keys;) {
            i = step(text, i);
        }
        if (dots_ > most_dots) {
            return "a key has more than " + std::to_string(most_dots) + " dots";
        }
        return keys_ > most_keys ? "more than " + std::to_string(most_keys) + " keys: not a scene" : "";
    }

  private:
    /// Index behind the token at @p i.
    std::size_t step(std::string_view text, std::size_t i)
    {
        char const c = text[i];
        if (c == '"' || c == '\'') {
            return behind_string(text, i);
        }
        if (c == '#') {
            return std::min(text.find('\n', i), text.size());
        }
        keys_ += c == '=' ? 1 : 0;
        if (c == '.') {
            ++dots_;
        } else if (std::string_view("=,{}[]\n").find(c) != std::string_view::npos) {
            dots_ = 0;
        }
        return i + 1;
    }

    static std::size_t behind_string(std::string_view text, std::size_t i)
    {
        char const quote = text[i];
        std::string const triple(3, quote);
        bool const is_multi_line = text.substr(i, 3) == triple;
        std::size_t at = i + (is_multi_line ? 3 : 1);
        while (at < text.size()) {
            if (quote == '"' && text[at] == '\\') {
                at += 2;
            } else if (is_multi_line ? text.substr(at, 3) == triple : text[at] == quote) {
                return at + (is_multi_line ? 3 : 1);
            } else if (!is_multi_line && text[at] == '\n') {
                return at;
            } else {
                ++at;
            }
        }
        return text.size();
    }

    int dots_ = 0;
    int keys_ = 0;
};

bool is_utf16(std::string_view text)
{
    return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

}  // namespace

std::string read_scene_text(std::filesystem::path const& file)
{
    std::string const name = file.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
        throw InputError(unreadable(name, EISDIR));
    }
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> const stream(std::fopen(name.c_str(), "rb"), &std::fclose);
    if (!stream) {
        throw InputError(unreadable(name, errno));
    }
    constexpr std::size_t block = 1 << 16;
    std::array<char, block> buffer{};
    std::string text;
    while (std::size_t const count = std::fread(buffer.data(), 1, block, stream.get())) {
        text.append(buffer.data(), count);
        if (text.size() > largest_scene) {
            throw InputError(too_large(name));
        }
    }
    if (std::ferror(stream.get()) != 0) {
        throw InputError(unreadable(name, errno));
    }
    return text;
}

Faults unparsable(std::string_view text, std::string const& name)
{
    if (text.size() > largest_scene) {
        return {too_large(name)};
    }
    if (is_utf16(text)) {
        return {fault_of_file(name, "this text is in UTF-16", "save it as UTF-8")};
    }
    if (text.find('\0') != std::string_view::npos) {
        return {
            fault_of_file(name, "this is a binary file, not a scene", "name a scene file; `hdconj init` writes one")};
    }
    std::string const complaint = KeyCounter().complaint(text);
    if (!complaint.empty()) {
        return {fault_of_file(name, complaint, "write keys such as flexspline.profile.addendum")};
    }
    return {};
}

}  // namespace hdconj::detail
