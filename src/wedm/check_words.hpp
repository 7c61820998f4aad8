// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Words of what a check finds wrong; private to src/wedm.
#pragma once

#include <locale>
#include <sstream>
#include <string>

#include "hdconj/geometry/vec2.hpp"
#include "hdconj/wedm/wire_program.hpp"

namespace hdconj::detail {

/// "12.3456": enough digits to find the place.
inline std::string text(double value)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(6);
    out << value;
    return out.str();
}

inline std::string text(Vec2 const& p)
{
    return "(" + text(p.x()) + ", " + text(p.y()) + ") mm";
}

inline std::string name(WirePass const& pass)
{
    return "pass " + std::to_string(pass.number);
}

}  // namespace hdconj::detail
