// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/parameters.hpp"

#include <utility>

#include "base/text.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "value_text.hpp"

namespace hdconj::scene {

std::optional<double> FamilyChoice::number(std::string_view key) const
{
    auto const found = given.find(key);
    if (found == given.end())
        return std::nullopt;
    auto const* const value = std::get_if<double>(&found->second.value);
    return value != nullptr ? std::optional<double>(*value) : std::nullopt;
}

double FamilyChoice::number_or(std::string_view key, double otherwise) const
{
    return number(key).value_or(otherwise);
}

std::optional<std::string> FamilyChoice::word(std::string_view key) const
{
    auto const found = given.find(key);
    if (found == given.end())
        return std::nullopt;
    auto const* const value = std::get_if<std::string>(&found->second.value);
    return value != nullptr ? std::optional<std::string>(*value) : std::nullopt;
}

NumberRows const& FamilyChoice::rows(std::string_view key) const
{
    static NumberRows const none;
    auto const found = given.find(key);
    if (found == given.end())
        return none;
    auto const* const value = std::get_if<NumberRows>(&found->second.value);
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
