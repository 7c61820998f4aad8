// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a refusal must say, whatever was refused.
#pragma once

#include <cctype>
#include <string>
#include <string_view>

#include "hdconj/error.hpp"
#include "targets.hpp"

namespace hdconj::fuzz {

/// Each fault names its key or file and says why.
inline void validate_faults(Faults const& faults)
{
    for (Fault const& fault : faults) {
        if (fault.path.empty() || fault.reason.empty())
            throw Find("a fault without place or reason: " + describe({fault}));
    }
    if (!faults.empty() && describe(faults).empty())
        throw Find("faults without a message");
}

/// @p word stands in @p text on its own.
[[nodiscard]] inline bool has_word(std::string_view text, std::string_view word)
{
    auto const letter = [&](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
    };
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        if ((at == 0 || !letter(at - 1)) && !letter(at + word.size()))
            return true;
    }
    return false;
}

/// "stage: place: cause", none of them empty, and no number in it that is none.
inline void validate_failure(NumericalError const& error)
{
    std::string const text = error.what();
    std::size_t const place = text.find(": ");
    std::size_t const cause = place == std::string::npos ? place : text.find(": ", place + 2);
    bool const complete = place != 0 && cause != std::string::npos && cause > place + 2 && cause + 2 < text.size();
    if (!complete)
        throw Find("a failure without stage, place or cause: " + text);
    if (has_word(text, "nan") || has_word(text, "inf"))
        throw Find("a failure at a place that is none: " + text);
}

/// Runs @p work; true when it ended without a refusal. A refusal is judged, every other exception goes on.
template <class Work>
bool accepted(Work&& work)
{
    try {
        work();
        return true;
    } catch (InputError const& error) {
        if (error.faults().empty())
            throw Find("refused without a fault");
        validate_faults(error.faults());
    } catch (NumericalError const& error) {
        validate_failure(error);
    }
    return false;
}

}  // namespace hdconj::fuzz
