// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "column_units.hpp"
#include "file/csv.hpp"
#include "hdconj/base/suggest.hpp"
#include "hdconj/scene/schema.hpp"

namespace hdconj::scene {
namespace {

using Kind = RawValue::Kind;

/// Nothing when a value is right.
using Verdict = std::optional<Refusal>;

bool is_numeric(Quantity quantity)
{
    return quantity != Quantity::word && quantity != Quantity::file && quantity != Quantity::text &&
           quantity != Quantity::rows;
}

std::string kind_name(Kind kind)
{
    constexpr std::array names{"true or false", "a number", "a number", "text", "a date or time", "a list", "a table"};
    return names.at(static_cast<std::size_t>(kind));
}

std::string quantity_name(ParameterSpec const& spec)
{
    constexpr std::array names{"a length",    "a length",       "a length", "an angle in degrees",
                               "a number",    "a whole number", "a word",   "a length or a word",
                               "a file name", "a list",         "text"};
    return names.at(static_cast<std::size_t>(spec.quantity));
}

/// "at least 4 ", or empty.
std::string least_rows(ParameterSpec const& spec)
{
    return std::isfinite(spec.at_least) ? "at least " + number_text(spec.at_least) + " " : "";
}

std::string base_expectation(ParameterSpec const& spec)
{
    // in the order of Quantity
    constexpr std::array<std::string_view, 11> plain{
        "a length in mm", "a length in mm above 0", "a length in mm, 0 or more", "an angle in degrees",   "a number",
        "a whole number", "a word in quotes",       "a length in mm, or ",       "a file name in quotes", "a list of ",
        "text in quotes"};
    if (spec.quantity == Quantity::word && !spec.words.empty())
        return quoted_list(spec.words);
    bool const positive = spec.quantity == Quantity::positive_length;
    Quantity const said = positive && std::isfinite(spec.at_least) ? Quantity::length : spec.quantity;
    return std::string(plain.at(static_cast<std::size_t>(said))) +
           (said == Quantity::length_or_word ? quoted_list(spec.words)
            : said == Quantity::rows         ? least_rows(spec) + row_form(spec)
                                             : "");
}

Verdict validate_bounds(ParameterSpec const& spec, double value, std::string const& remedy)
{
    if (value < spec.at_least)
        return Refusal{"must be at least " + number_text(spec.at_least), remedy};
    if (value > spec.at_most)
        return Refusal{"must be at most " + number_text(spec.at_most), remedy};
    return std::nullopt;
}

Verdict validate_length(ParameterSpec const& spec, double value, std::string const& remedy)
{
    if (spec.quantity == Quantity::positive_length && value <= 0)
        return Refusal{"must be above 0", remedy};
    if (spec.quantity == Quantity::nonnegative_length && value < 0)
        return Refusal{"must not be negative", remedy};
    if (std::abs(value) > bounds::largest_length)
        return Refusal{"larger than any drive (" + number_text(bounds::largest_length) + " mm)", remedy};
    bool const has_own_bound = std::isfinite(spec.at_least);
    if (spec.quantity == Quantity::positive_length && !has_own_bound && value < bounds::least_length)
        return Refusal{"smaller than any length of a drive (" + number_text(bounds::least_length) + " mm)", remedy};
    return std::nullopt;
}

Verdict validate_whole(double value, Kind kind, std::string const& remedy)
{
    if (kind == Kind::integer)
        return std::nullopt;
    bool const is_whole = value == std::floor(value) && std::abs(value) <= bounds::most_teeth;
    if (is_whole)
        return Refusal{"a count is written without a decimal point", "write " + number_text(value)};
    return Refusal{"must be a whole number", remedy};
}

Verdict validate_number(ParameterSpec const& spec, RawValue const& value, std::string const& remedy)
{
    if (!std::isfinite(value.number))
        return Refusal{"not a finite number", remedy};
    Verdict verdict;
    if (spec.quantity == Quantity::count)
        verdict = validate_whole(value.number, value.kind, remedy);
    else if (is_length(spec.quantity))
        verdict = validate_length(spec, value.number, remedy);
    return verdict ? verdict : validate_bounds(spec, value.number, remedy);
}

/// What a number with @p unit behind it is multiplied by to be in the unit of @p spec; nothing where that is not known.
std::optional<double> factor_to(ParameterSpec const& spec, std::string const& unit)
{
    if (unit.empty())
        return 1;
    if (is_length(spec.quantity))
        return factor_of_unit(unit, ColumnQuantity::length);
    if (spec.quantity == Quantity::angle_deg)
        return factor_of_unit(unit, ColumnQuantity::angle);
    bool const is_own = file::lower_case(unit, " .") == file::lower_case(unit_of_number(spec), " ");
    return is_own ? std::optional(1.0) : std::nullopt;
}

/// "lengths are in mm"
std::string unit_rule(ParameterSpec const& spec)
{
    if (is_length(spec.quantity))
        return "lengths are in mm";
    if (spec.quantity == Quantity::angle_deg)
        return "angles are in degrees";
    std::string_view const unit = unit_of_number(spec);
    return unit.empty() ? "it has no unit" : "it is in " + std::string(unit);
}

Refusal text_for_number(ParameterSpec const& spec, std::string const& text, std::string const& otherwise)
{
    std::string const reason = "text where " + quantity_name(spec) + " belongs";
    auto const found = leading_number(text);
    if (!found)
        return {reason, otherwise};
    auto const factor = factor_to(spec, found->rest);
    if (!factor)
        return {reason, otherwise + ", without quotes or unit: " + unit_rule(spec)};
    RawValue meant;
    meant.number = in_other_unit(found->value, *factor);
    meant.kind = meant.number == std::floor(meant.number) ? Kind::integer : Kind::number;
    if (auto const beyond = validate_number(spec, meant, otherwise))
        return {reason + ", and " + beyond->reason, beyond->remedy};
    if (found->rest.empty() && text.find(',') != std::string::npos)
        return {"a decimal comma", "write " + number_text(found->value) + ", with a decimal point"};
    if (found->rest.empty())
        return {reason, "write " + number_text(found->value) + ", a number without quotes"};
    return {reason, "write " + number_text(meant.number) + ", a number without quotes or unit: " + unit_rule(spec)};
}

Verdict validate_word(ParameterSpec const& spec, std::string const& text, std::string const& remedy)
{
    bool const free = spec.words.empty();
    if (free || std::find(spec.words.begin(), spec.words.end(), text) != spec.words.end())
        return std::nullopt;
    auto const meant = nearest(text, spec.words);
    return Refusal{"unknown word",
                   meant ? "write " + in_quotes(*meant) + "; known: " + quoted_list(spec.words) : remedy};
}

Verdict validate_free_text(std::string const& text, std::string const& remedy)
{
    constexpr std::size_t longest = 4096;
    if (text.size() > longest)
        return Refusal{"longer than " + std::to_string(longest) + " bytes", remedy};
    bool const has_control =
        std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    return has_control ? Verdict(Refusal{"contains control characters", "leave them out; " + remedy}) : std::nullopt;
}

Verdict validate_text(ParameterSpec const& spec, std::string const& text, std::string const& remedy)
{
    switch (spec.quantity) {
        case Quantity::word:
            return validate_word(spec, text, remedy);
        case Quantity::length_or_word:
            return leading_number(text) ? Verdict(text_for_number(spec, text, remedy))
                                        : validate_word(spec, text, remedy);
        case Quantity::file:
            return text.empty() ? Verdict(Refusal{"an empty file name", remedy}) : validate_free_text(text, remedy);
        case Quantity::text:
            return validate_free_text(text, remedy);
        case Quantity::rows:
            return Refusal{"text where a list belongs", remedy};
        default:
            return text_for_number(spec, text, remedy);
    }
}

Verdict refusal_of(ParameterSpec const& spec, RawValue const& value, std::string const& remedy)
{
    bool const is_number = value.kind == Kind::integer || value.kind == Kind::number;
    if (value.kind == Kind::text)
        return validate_text(spec, value.text, remedy);
    if (is_number && is_numeric(spec.quantity))
        return validate_number(spec, value, remedy);
    return Refusal{kind_name(value.kind) + " where " + quantity_name(spec) + " belongs", remedy};
}

}  // namespace

std::vector<std::string_view> row_forms(ParameterSpec const& spec)
{
    std::vector<std::string_view> forms = spec.words;
    std::erase(forms, row_file);
    return forms;
}

std::string row_form(ParameterSpec const& spec)
{
    std::string forms;
    for (auto const form : row_forms(spec))
        forms += (forms.empty() ? "" : " or ") + std::string(form);
    bool const has_angles = forms.find("_deg") != std::string::npos;
    for (auto const& [form, unit] : {std::pair("[torque]", "in N m"), std::pair("[speed]", "in rpm"),
                                     std::pair("[temperature]", "in degrees Celsius")})
        if (forms == form)
            return forms + ", " + unit;
    return forms + (has_angles ? ", in mm and degrees" : ", in mm");
}

std::string expectation(ParameterSpec const& spec)
{
    std::string const base = base_expectation(spec);
    bool const below = std::isfinite(spec.at_least);
    bool const above = std::isfinite(spec.at_most);
    if (spec.quantity == Quantity::rows)
        return base + (takes_file(spec) ? ", or a file " + std::string(row_file) : "");
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

bool takes_file(ParameterSpec const& spec)
{
    return std::ranges::find(spec.words, row_file) != spec.words.end();
}

Fault fault_at(RawEntry const& entry, std::string path, Refusal refusal, FaultKind kind)
{
    return {std::move(path),
            entry.line,
            entry.value.written,
            std::move(refusal.reason),
            std::move(refusal.remedy),
            entry.origin,
            {},
            kind};
}

std::variant<Parameter, Faults> validate_value(ParameterSpec const& spec, std::string_view example,
                                               RawEntry const& entry, std::string const& path, Scene& scene)
{
    if (spec.quantity == Quantity::rows && entry.value.kind == Kind::array)
        return validate_rows(spec, entry, path);
    if (spec.quantity == Quantity::rows && entry.value.kind == Kind::text && takes_file(spec))
        return rows_of_file(spec, entry, path, scene);
    if (refusal_of(spec, entry.value, ""))  // the remedy takes longer than the check
        return Faults{fault_at(entry, path, *refusal_of(spec, entry.value, write_instead(spec, example)))};
    if (entry.value.kind == Kind::text)
        return Parameter{entry.value.text, entry.line,
                         spec.quantity == Quantity::file ? content_of(scene, entry.value.text) : nullptr};
    return Parameter{entry.value.number, entry.line};
}

}  // namespace hdconj::scene
