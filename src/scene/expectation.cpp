// SPDX-License-Identifier: GPL-3.0-or-later
// What a key takes, in words.
#include <cmath>

#include "base/text.hpp"
#include "validate_value.hpp"

namespace hdconj::scene {
namespace {

/// "at least 4 [x, y], in mm"
std::string rows_expectation(ParameterSpec const& spec)
{
    std::string forms;
    for (auto const form : spec.words)
        forms += (forms.empty() ? "" : " or ") + std::string(form);
    bool const has_angles = forms.find("_deg") != std::string::npos;
    std::string const least = std::isfinite(spec.at_least) ? "at least " + number_text(spec.at_least) + " " : "";
    return least + forms + (has_angles ? ", in mm and degrees" : ", in mm");
}

std::string base_expectation(ParameterSpec const& spec)
{
    switch (spec.quantity) {
        case Quantity::length:
            return "a length in mm";
        case Quantity::positive_length:
            return std::isfinite(spec.at_least) ? "a length in mm" : "a length in mm above 0";
        case Quantity::nonnegative_length:
            return "a length in mm, 0 or more";
        case Quantity::angle_deg:
            return "an angle in degrees";
        case Quantity::number:
            return "a number";
        case Quantity::count:
            return "a whole number";
        case Quantity::word:
            return spec.words.empty() ? "a word in quotes" : quoted_list(spec.words);
        case Quantity::length_or_word:
            return "a length in mm, or " + quoted_list(spec.words);
        case Quantity::file:
            return "a file name in quotes";
        case Quantity::text:
            return "text in quotes";
        case Quantity::rows:
            return "a list of " + rows_expectation(spec);
    }
    return "another value";
}

}  // namespace

std::string expectation(ParameterSpec const& spec)
{
    std::string const base = base_expectation(spec);
    bool const below = std::isfinite(spec.at_least);
    bool const above = std::isfinite(spec.at_most);
    if (spec.quantity == Quantity::rows)
        return base;
    if (below && above)
        return base + " from " + number_text(spec.at_least) + " to " + number_text(spec.at_most);
    if (below)
        return base + ", at least " + number_text(spec.at_least);
    return above ? base + ", at most " + number_text(spec.at_most) : base;
}

std::string write_instead(ParameterSpec const& spec, std::string_view example)
{
    std::string const text = "write " + expectation(spec);
    bool const says_enough = spec.quantity == Quantity::word && !spec.words.empty();
    return example.empty() || says_enough ? text
                                          : text + ", such as " + std::string(spec.key) + " = " + std::string(example);
}

}  // namespace hdconj::scene
