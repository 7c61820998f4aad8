// SPDX-License-Identifier: GPL-3.0-or-later
// Every slice over a full turn under its own motion, and how far its points must be moved to clear.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "contact/flank_grid.hpp"
#include "contact/study/contact_context.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/distance/any_full_turn.hpp"

namespace hdconj::contact {

/// Outline points of each slice that are looked at over a full turn, and the way they are moved to clear.
struct ClearanceSet
{
    std::vector<std::vector<Vec2>> point;  ///< (k,p) [mm]
    std::vector<std::vector<Vec2>> way;    ///< (k,p)
    double known = 0;                      ///< how far a point may be from the true outline [mm]
    FlankGrid const* flank = nullptr;      ///< whose points these are, right then left: what lies between counts too
};

/// Slice k of a set, moved.
struct MovedSlice
{
    std::vector<Vec2> point;
    FlankGrid flank;  ///< of this slice, where the set has flanks: see moved_into_material()
};
[[nodiscard]] MovedSlice moved_slice(ClearanceSet const& set, std::size_t k, double distance);

/// One or both flanks as one list per slice: of a symmetric pair the right one stands for both. Keeps a pointer to @p
/// grid.
[[nodiscard]] ClearanceSet flank_set(FlankGrid const& grid, bool both);

/// The bottom of the tooth space with the side clearance @p given [mm], which moves the bottom as far as the flanks.
/// Points are evenly spaced from one flank end to the other; the last one is the middle of the bottom. To clear, they
/// are moved along the centre line. The walls that root clearance puts behind the flank ends are left out: a deeper
/// bottom does not move their lower ends, which belong to the flanks.
[[nodiscard]] ClearanceSet root_set(conjugate::MatchedOutline const& outline, double given, Tolerance const& tolerance);

/// The deepest place of one slice.
struct Deepest
{
    distance::TurnMinimum turn;
    Vec2 where = Vec2::Zero();
};

/// (k,p)
using TurnMinima = std::vector<std::vector<distance::TurnMinimum>>;

/// Full turns of a set at one distance: of its points, and the deepest place of each slice.
struct TurnsOfSet
{
    TurnMinima minima;
    std::vector<Deepest> deepest;
};

/// Full-turn clearances of all points of all slices, each slice under its own motion.
class SliceClearances
{
  public:
    explicit SliceClearances(ContactContext const& context) : SliceClearances(context, context.maker) {}
    /// In the planes of @p maker, which outlives this.
    SliceClearances(ContactContext const& context, surface::ToothSurfaceBuilder& maker);

    [[nodiscard]] motion::AnyMotion const& motion(std::size_t k) const { return maker_.motion(of(k)).motion; }

    /// Minimum of every point moved by @p distance; only those that @p wanted names, the others are left out
    /// (infinite).
    [[nodiscard]] TurnMinima operator()(ClearanceSet const& set, double distance,
                                        std::vector<std::vector<std::uint8_t>> const* wanted = nullptr) const;

    /// The deepest place of slice @p k, whose points' own minima are @p minima, between the points too where it may
    /// fall below @p below: found as smallest_gap() does. Dips that chords show to be shallower than a quarter of
    /// clearance_accuracy() are left out.
    [[nodiscard]] Deepest deepest(ClearanceSet const& set, std::size_t k, double distance,
                                  std::vector<distance::TurnMinimum> const& minima, double below) const;

    /// The smallest distance of all slices, between the points too.
    [[nodiscard]] double worst(ClearanceSet const& set, double distance, TurnMinima const& minima) const;

    /// The deepest place of each slice, between the points too where it may fall below @p below.
    [[nodiscard]] std::vector<Deepest> lowest(ClearanceSet const& set, double distance, TurnMinima const& minima,
                                              double below = std::numeric_limits<double>::infinity()) const;

  private:
    [[nodiscard]] std::size_t of(std::size_t k) const { return std::min(k, turns_.size() - 1); }

    ContactContext const& context_;
    surface::ToothSurfaceBuilder& maker_;
    double pitch_;
    std::vector<std::unique_ptr<distance::FullTurnClearance<motion::AnyMotion>>> turns_;
};

/// Least distance by which @p set must be moved so that no tooth enters it, to clearance_accuracy() or what its points
/// are known to.
/// @param at_zero  full turns of the set that is not moved: its minima; gets the deepest places where no point is
/// entered
/// @throws NumericalError where moving it does not clear
[[nodiscard]] double least_offset(SliceClearances const& clearances, ClearanceSet const& set, TurnsOfSet& at_zero,
                                  Tolerance const& tolerance);

/// The deepest place of slice @p k as a result.
[[nodiscard]] Closest closest(SliceClearances const& clearances, std::size_t k, Deepest const& deepest);

}  // namespace hdconj::contact
