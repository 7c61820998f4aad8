// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/parameters.hpp"

#include "base/text.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// The value under @p key; null when absent or of another type.
template <class Value>
Value const* value_under(FamilyChoice const& choice, std::string_view key)
{
    auto const found = choice.given.find(key);
    return found == choice.given.end() ? nullptr : std::get_if<Value>(&found->second.value);
}

/// A list, cut short after about one line.
std::string rows_text(NumberRows const& rows)
{
    constexpr std::size_t most = 60;
    std::string text = "[";
    for (auto const& row : rows) {
        if (text.size() > most)
            return text + ", ...]";
        text += text.size() > 1 ? ", [" : "[";
        for (std::size_t i = 0; i < row.size(); ++i)
            text += (i > 0 ? ", " : "") + number_text(row[i]);
        text += "]";
    }
    return text + "]";
}

}  // namespace

std::string value_text(ParameterValue const& value)
{
    if (auto const* number = std::get_if<double>(&value))
        return number_text(*number);
    if (auto const* rows = std::get_if<NumberRows>(&value))
        return rows_text(*rows);
    return in_quotes(printable(std::get<std::string>(value)));
}

std::optional<double> FamilyChoice::number(std::string_view key) const
{
    auto const* const value = value_under<double>(*this, key);
    return value != nullptr ? std::optional(*value) : std::nullopt;
}

double FamilyChoice::number_or(std::string_view key, double otherwise) const
{
    return number(key).value_or(otherwise);
}

std::optional<std::string> FamilyChoice::word(std::string_view key) const
{
    auto const* const value = value_under<std::string>(*this, key);
    return value != nullptr ? std::optional(*value) : std::nullopt;
}

NumberRows const& FamilyChoice::rows(std::string_view key) const
{
    static NumberRows const none;
    auto const* const value = value_under<NumberRows>(*this, key);
    return value != nullptr ? *value : none;
}

int FamilyChoice::line_of(std::string_view key) const
{
    auto const found = given.find(key);
    return found == given.end() ? line : found->second.line;
}

std::string FamilyChoice::text_of(std::string_view key) const
{
    auto const found = given.find(key);
    return found == given.end() ? std::string{} : value_text(found->second.value);
}

Fault parameter_fault(FamilyChoice const& choice, std::string_view key, std::string reason, std::string remedy)
{
    return {choice.path + "." + std::string(key), choice.line_of(key), choice.text_of(key), std::move(reason),
            std::move(remedy)};
}

}  // namespace hdconj::scene
