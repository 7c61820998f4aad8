// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a wire program before anything is written. Each returns all that it finds wrong; nothing found is an empty
// list.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "faces.hpp"
#include "hdconj/wedm.hpp"

namespace hdconj::wedm {

/// What must not be cut so.
struct WireFailure
{
    WireFailure(std::string why, std::string help = {}, std::string key = {})
        : cause(std::move(why)), remedy(std::move(help)), set(std::move(key))
    {
    }

    std::string cause;   ///< with the name of the check, numbers and place
    std::string remedy;  ///< what can be done; empty where nothing is known to help
    std::string set;     ///< the same as an argument of --set; empty where no number is known
};
using WireFailures = std::vector<WireFailure>;

/// "(1.5, -2) mm"
[[nodiscard]] std::string place_text(Vec2 const& point);

/// Numbers that make no wire program: negative gap, no wire, guides inside the part, anything not finite.
[[nodiscard]] WireFailures check_numbers(WireProgram const& program);

/// As many points in both faces, sync marks increasing, no move of length zero in one face or in both; passes numbered
/// 1, 2, 3 ...; a path that closes starts and ends in one point, every path with the wire vertical.
[[nodiscard]] WireFailures check_pairing(WireProgram const& program);

/// Nominal contour and every pass at z = 0, T/2 and T: no crossing, void on the left (reversed passes: on the right).
[[nodiscard]] WireFailures check_crossings(WireProgram const& program);

/// Every contour point and move's middle of every pass keeps its offset from the nominal face, square to the wire,
/// neither less nor more, to the tolerance: the way from the path to the part, where residuals were found by the way
/// from the part to the path. Fills in face_error.
/// @param faces  the fine contour, not the program's thinned one
[[nodiscard]] WireFailures check_sweep(WireFaces const& faces, WireProgram& program);

/// True sections between the faces against the wire at their height, residuals apart; fills in middle_error and
/// ruling_error, NaN where the surface between the faces is not known.
///
/// Beyond the tolerance there can be two errors that no path avoids: the surface is not ruled (ruling_error), or its
/// normal turns along a ruling by some angle a, so that a straight wire which touches at both faces cuts d (1 -
/// cos(a/2)) too deep between them.
/// @param residual_at  of each pass (n): 1 where a residual of either face lies on the fine contour
/// @param limit        accepted error [mm]
[[nodiscard]] WireFailures check_sections(WireFaces const& faces, std::vector<std::vector<char>> const& residual_at,
                                          double limit, WireProgram& program);

/// Matched edges go the same way, in the nominal faces and in all passes: rulings do not cross. Fills in normal_angle.
[[nodiscard]] WireFailures check_rulings(WireProgram& program);

/// What a machine can do; infinity: no limit.
struct MachineLimits
{
    double tilt = std::numeric_limits<double>::infinity();  ///< of the wire [rad]
    double travel =
        std::numeric_limits<double>::infinity();  ///< of each axis of each guide from the start hole, either way [mm]
    double uv_travel = std::numeric_limits<double>::infinity();  ///< of each upper axis against the lower [mm]
    double lead_in = 0;  ///< of the program, for what to write in its place [mm]
};

/// The figures that can be measured (measured()) against the limits.
[[nodiscard]] WireFailures check_machine(MachineLimits const& limits, WireProgram& program);

/// Both ends of each pass, and the straight ways from and to them, keep clear of the nominal contour in both faces.
[[nodiscard]] WireFailures check_start(WireProgram const& program);

/// Makes all checks above and below, those first that the others rely on.
/// @throws NumericalError with all failures in one message
void check_all(WireFaces const& faces, std::vector<std::vector<char>> const& residual_at, double limit,
               MachineLimits const& limits, WireProgram& program);

/// What is no failure but may surprise a shop, in words: a pass that leaves, where it cannot follow, more than the
/// layer that the next one is to take.
[[nodiscard]] std::vector<std::string> skim_warnings(WireProgram const& program);

/// Fewest decimals, more than those of the program, with which no block along the contour of a pass is shorter than
/// least_block(); nothing where there are none.
using FittingDecimals = std::function<std::optional<int>(WirePass const&)>;

/// Blocks that are shorter than least_block(), in words, with the keys that make them longer.
[[nodiscard]] std::vector<std::string> short_block_warnings(WireProgram const& program,
                                                            FittingDecimals const& fitting = {});

/// Every tooth space is cut as the first one of the pass is, turned: nominal contour and guides of all passes without
/// stop and overlap points.
[[nodiscard]] WireFailures check_pitches(WireProgram const& program);

/// Where the nominal faces are the same bits, all moves are.
[[nodiscard]] WireFailures check_untilted(WireProgram const& program);

/// A largest distance, and how far that of a neighbouring point is from it.
struct LargestDistance
{
    double value = 0, spread = 0;
};

/// What constant taper (G51) would be wrong by: it moves every wall off the lower contour by what the tip land moves
/// between the faces, and the walls of the upper face lie off it by another distance [mm]. A wall is a flank, or what a
/// corner of the other tooth makes between land and root. One place of each edge is
/// looked at: between two the difference may be larger by about as much as theirs differ. NaN where less than half of
/// the walls is left, moved so: the rest lies nearer to another part of the lower contour and is cut away.
[[nodiscard]] LargestDistance constant_taper_error(WireFaces const& faces);

/// Chord error at the guides, where moves between @p kept points of @p path are straight as well: largest distance of a
/// point's guides from the move [mm].
[[nodiscard]] double guide_chord_error(PairedPath const& path, std::vector<std::size_t> const& kept,
                                       WireMachine const& machine);

}  // namespace hdconj::wedm
