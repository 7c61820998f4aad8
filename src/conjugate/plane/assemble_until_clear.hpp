// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The boundary put together from ever finer polygons until no tooth enters it.
#pragma once

#include <string>

#include "hdconj/error.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// Polygons decide which branch is outside; where they misjudge two that lie closer than their own error, the full-turn
/// check sees it and they are made finer.
/// @param chord     chord error of the first polygons [mm]
/// @param assemble  puts the boundary together from polygons of a chord error, and checks it into out.check
/// @param wanted    smallest clearance that will do, asked for after each check [mm]
/// @param frame     of the place in the message
/// @throws NumericalError when the finest polygons leave a tooth inside
template <class Assemble, class Wanted>
void assemble_until_clear(Solution const& out, double chord, Assemble&& assemble, Wanted&& wanted,
                          std::string const& frame)
{
    constexpr int attempts = 5;
    for (int attempt = 1; attempt <= attempts; ++attempt, chord /= 64) {
        assemble(chord);
        if (!out.check || out.check->smallest_clearance >= wanted())
            return;
    }
    throw NumericalError(
        ErrorCode::interference, "interference",
        "near (" + std::to_string(out.check->where.x()) + ", " + std::to_string(out.check->where.y()) + ") mm" + frame,
        "a tooth enters the outline by " + std::to_string(wanted() - out.check->smallest_clearance) + " mm");
}

}  // namespace hdconj::conjugate
