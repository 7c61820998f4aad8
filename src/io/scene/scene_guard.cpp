// SPDX-License-Identifier: GPL-3.0-or-later
// What must not go to the TOML parser, because it would nest tables until the stack ends or fill the memory.
#include <algorithm>
#include <optional>

#include "hdconj/read_scene.hpp"
#include "scene_text.hpp"

namespace hdconj::io {
namespace {

/// Dotted parts of one key: a scene needs two. The parser nests a table for each, and its depth is the stack's.
constexpr int most_dots = 16;

/// A scene has a few dozen keys.
constexpr int most_keys = 10000;

/// Index behind the string that begins at @p i; the end of the line when a string of one line does not end on it.
std::size_t behind_string(std::string_view text, std::size_t i)
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

struct Complaint
{
    std::size_t at;
    std::string reason;
    std::string remedy;
};

/// Follows a TOML text far enough to tell keys from strings and comments, up to its first error.
class Guard
{
  public:
    explicit Guard(std::string_view text) : text_(text) {}

    std::optional<Complaint> complaint()
    {
        while (at_ < text_.size()) {
            step();
            if (dots_ > most_dots) {
                return Complaint{at_, "a key has more than " + std::to_string(most_dots) + " dots",
                                 "write keys such as flexspline.profile.addendum"};
            }
            if (keys_ > most_keys) {
                return Complaint{at_, "more than " + std::to_string(most_keys) + " keys: not a scene",
                                 "name a scene file; `hdconj init` writes one"};
            }
        }
        return std::nullopt;
    }

  private:
    /// Takes the token at at_.
    void step()
    {
        char const c = text_[at_];
        if (c == '"' || c == '\'') {
            at_ = behind_string(text_, at_);
        } else if (c == '#') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else {
            keys_ += c == '=' ? 1 : 0;
            bool const ends_key = std::string_view("=,{}[]\n").find(c) != std::string_view::npos;
            dots_ = c == '.' ? dots_ + 1 : ends_key ? 0 : dots_;
            ++at_;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int dots_ = 0;
    int keys_ = 0;
};

}  // namespace

Faults unparsable(std::string_view text, std::string const& name)
{
    if (text.size() > largest_scene)
        return {too_large(name)};
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        return {{name, 0, "", "this text is in UTF-16", "save it as UTF-8"}};
    if (text.find('\0') != std::string_view::npos)
        return {{name, 0, "", "this is a binary file, not a scene", "name a scene file; `hdconj init` writes one"}};
    if (auto const complaint = Guard(text).complaint()) {
        auto const before = text.substr(0, std::min(complaint->at, text.size()));
        int const line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
        return {{name, line, "", complaint->reason, complaint->remedy}};
    }
    return {};
}

}  // namespace hdconj::io
