// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/note.hpp"

#include <fmt/format.h>

namespace hdconj {

std::string describe(Notes const& notes)
{
    if (notes.empty())
        return {};
    std::size_t const warnings = warnings_of(notes);
    std::string text = fmt::format("judgement: {} warning{}, {} of information\n", warnings, warnings == 1 ? "" : "s",
                                   notes.size() - warnings);
    for (auto const& note : notes)
        text += fmt::format("  {} [{}] {}: {}; {}\n", note.severity == Severity::warning ? "WARNING" : "note",
                            to_string(note.code), note.place, note.cause, note.advice);
    return text;
}

}  // namespace hdconj
