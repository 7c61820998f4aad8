// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/error.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cstddef>
#include <tuple>

#include "text.hpp"

namespace hdconj {
namespace {

/// More faults than this help nobody; the rest is counted.
constexpr std::size_t most_described = 100;

std::string place_of(Fault const& fault)
{
    std::string place = fault.origin == fault.path ? "" : fault.origin;  // a file that is the fault is named once
    if (fault.line > 0)
        place += (place.empty() ? "line " : " line ") + std::to_string(fault.line);
    return place.empty() ? place : place + ": ";
}

std::string describe_one(Fault const& fault)
{
    std::string text = place_of(fault) + fault.path;
    if (!fault.value.empty())
        text += " = " + fault.value;
    text += ": " + fault.reason;
    return fault.remedy.empty() ? text : text + " (" + fault.remedy + ")";
}

}  // namespace

InputError::InputError(Faults found) : std::runtime_error(describe(found)), faults_(std::move(found)) {}

void throw_if_any(Faults faults)
{
    if (!faults.empty())
        throw InputError(std::move(faults));
}

std::string describe(Faults const& faults)
{
    std::string text;
    std::size_t const shown = std::min(faults.size(), most_described);
    for (std::size_t i = 0; i < shown; ++i)
        text += (i == 0 ? "" : "\n") + describe_one(faults[i]);
    if (shown < faults.size())
        text += "\nand " + std::to_string(faults.size() - shown) + " more faults";
    return text;
}

void sort_by_place(Faults& faults)
{
    auto const rank = [](Fault const& fault) {
        return std::tuple{!fault.origin.empty(), fault.line > 0 ? fault.line : INT_MAX};
    };
    std::stable_sort(faults.begin(), faults.end(),
                     [&rank](Fault const& a, Fault const& b) { return rank(a) < rank(b); });
}

std::string_view kind_word(FaultKind kind)
{
    static constexpr std::array<std::string_view, 3> words{"other", "unknown", "value"};
    return words.at(static_cast<std::size_t>(kind));
}

std::string_view code_word(ErrorCode code)
{
    static constexpr std::array<std::string_view, 14> words{
        "not-converged", "not-smooth", "no-solution",     "no-land",      "no-outline", "no-flank",     "interference",
        "no-contact",    "overload",   "unsuitable-body", "no-reference", "no-room",    "failed-check", "stopped"};
    return words.at(static_cast<std::size_t>(code));
}

NumericalError::NumericalError(ErrorCode code, std::string stage, std::string place, std::string cause,
                               std::string remedy, std::vector<std::string> set)
    : std::runtime_error(stage + ": " + place + ": " + cause + (remedy.empty() ? "" : "; ") + remedy),
      code_(code),
      stage_(std::move(stage)),
      place_(std::move(place)),
      cause_(std::move(cause)),
      remedy_(std::move(remedy)),
      set_(std::move(set))
{
}

FileError::FileError(std::string file, std::string cause, std::string remedy)
    : std::runtime_error(file + ": " + cause + (remedy.empty() ? "" : " (" + remedy + ")")),
      file_(std::move(file)),
      cause_(std::move(cause)),
      remedy_(std::move(remedy))
{
}

bool NumericalError::is_infeasible() const
{
    return code_ != ErrorCode::no_reference && code_ != ErrorCode::no_room && code_ != ErrorCode::failed_check &&
           code_ != ErrorCode::stopped;
}

void NumericalError::rethrow_unless_infeasible() const
{
    if (!is_infeasible())
        throw;
}

NumericalError NumericalError::inside(std::string stage, std::string place) const
{
    return {code_, std::move(stage), std::move(place), stage_ + ": " + place_ + ": " + cause_, remedy_, set_};
}

}  // namespace hdconj
