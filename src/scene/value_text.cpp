// SPDX-License-Identifier: GPL-3.0-or-later
#include "value_text.hpp"

#include <cstddef>
#include <string>

#include "base/text.hpp"

namespace hdconj::scene {

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

std::string value_text(ParameterValue const& value)
{
    if (auto const* number = std::get_if<double>(&value))
        return number_text(*number);
    if (auto const* rows = std::get_if<NumberRows>(&value))
        return rows_text(*rows);
    return in_quotes(printable(std::get<std::string>(value)));
}

}  // namespace hdconj::scene
