// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hdconj/scene/suggest.hpp"

namespace hdconj::cli {
namespace {

bool is_number(std::string const& given, double& value)
{
    char* end = nullptr;
    value = std::strtod(given.c_str(), &end);
    return !given.empty() && *end == '\0' && end != given.c_str();
}

}  // namespace

std::string name_fault(std::string const& given)
{
    return given.empty() ? "an empty name (write a name, or leave the option out)" : "";
}

std::string word_fault(std::string const& given, std::vector<std::string_view> const& words)
{
    if (std::find(words.begin(), words.end(), given) != words.end()) {
        return {};
    }
    std::string known;
    for (auto const word : words) {
        known += (known.empty() ? "" : ", ") + std::string(word);
    }
    auto const meant = nearest(given, words);
    return "unknown word '" + given + "' (" + (meant ? "write " + std::string(*meant) + "; " : "") + "known: " + known + ")";
}

std::string angle_fault(std::string const& given, std::string const& remedy)
{
    double value = 0;
    return is_number(given, value) ? "" : "'" + given + "' is no angle (write " + remedy + ")";
}

std::string angle_fault(std::string const& given)
{
    return angle_fault(given, "angles in degrees such as 0,0.1,0.2");
}

double angle_deg(std::string const& given)
{
    return std::strtod(given.c_str(), nullptr);
}

std::string number_fault(std::string const& given, std::string const& remedy)
{
    double value = 0;
    return is_number(given, value) && std::isfinite(value) ? "" : "'" + given + "' is no finite number (" + remedy + ")";
}

std::string positive_fault(std::string const& given, std::string const& remedy)
{
    std::string const fault = number_fault(given, remedy);
    return fault.empty() && !(std::strtod(given.c_str(), nullptr) > 0) ? "'" + given + "' is not above 0 (" + remedy + ")" : fault;
}

}  // namespace hdconj::cli
