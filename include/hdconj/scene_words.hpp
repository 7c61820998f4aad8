// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Enumerations of a scene, and the words that stand for their values in scenes, options and results.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hdconj {

/// Model of the relative motion between flexspline tooth and circular spline.
enum class Kinematics
{
    exact,        ///< inextensible neutral curve, arc length solved
    first_order,  ///< thesis (2-16), (2-19)
    material      ///< w and v given in the undeformed angle: the linear inextensional mode
};

/// How the slices make the tooth surface of the circular spline (design 3.4).
enum class ToothSurface
{
    tilted,    ///< the outline that is conjugate at z = 0, in all slices
    ruled,     ///< straight lines between the conjugate outlines of the two end planes
    per_slice  ///< each slice has its own conjugate outline
};

/// What tilts the teeth of the circular spline by an angle.
enum class TiltKind
{
    radial,  ///< moves the outline along its radii by z tan(angle)
    draft    ///< offsets the outline along its normals by z tan(angle)
};

/// How the flexspline cones along the axis.
enum class ConingModel
{
    linear,  ///< amplitude linear along the axis
    elastic  ///< displacements of the elastic cup
};

/// Whether gaps are computed where the wall has moved to along the axis.
enum class AxialShift
{
    mapped,  ///< the teeth in a plane are those sections that have moved into it
    none     ///< sections stay in their planes
};

/// Which ring of teeth turns while the drive runs; the other one is held.
enum class RunningMember
{
    flexspline,      ///< the cup turns, the circular spline is held
    circular_spline  ///< the circular spline turns, the cup is held
};

/// What a wire can cut.
enum class WirePart
{
    circular_spline,
    flexspline  ///< upright teeth outside, in two set-ups
};

/// How a wire program stops before the slug drops.
enum class WireStop
{
    always,   ///< M0, program stop
    optional  ///< M1: only where the control's switch for optional stops is on
};

/// The words of an enumeration, in the order of its values.
template <class Enumeration>
inline constexpr std::array<std::string_view, 0> words_of{};
/// Words of Kinematics.
template <>
inline constexpr std::array<std::string_view, 3> words_of<Kinematics>{"exact", "first-order", "material"};
/// Words of ToothSurface.
template <>
inline constexpr std::array<std::string_view, 3> words_of<ToothSurface>{"tilted", "ruled", "per-slice"};
/// Words of TiltKind.
template <>
inline constexpr std::array<std::string_view, 2> words_of<TiltKind>{"radial", "draft"};
/// Words of ConingModel.
template <>
inline constexpr std::array<std::string_view, 2> words_of<ConingModel>{"linear", "elastic"};
/// Words of AxialShift.
template <>
inline constexpr std::array<std::string_view, 2> words_of<AxialShift>{"mapped", "none"};
/// Words of WirePart.
template <>
inline constexpr std::array<std::string_view, 2> words_of<WirePart>{"circular-spline", "flexspline"};
/// Words of RunningMember.
template <>
inline constexpr std::array<std::string_view, 2> words_of<RunningMember>{"flexspline", "circular-spline"};
/// Words of WireStop.
template <>
inline constexpr std::array<std::string_view, 2> words_of<WireStop>{"M0", "M1"};

/// An enumeration that has words.
template <class Enumeration>
concept Worded = !words_of<Enumeration>.empty();

/// The word of @p value in a scene.
template <Worded Enumeration>
[[nodiscard]] constexpr std::string_view to_string(Enumeration value)
{
    return words_of<Enumeration>.at(static_cast<std::size_t>(value));
}

/// The word of @p value; empty without one.
template <Worded Enumeration>
[[nodiscard]] constexpr std::string_view to_string(std::optional<Enumeration> value)
{
    return value ? to_string(*value) : std::string_view{};
}

/// The value that @p word stands for; nothing for a word that the enumeration does not have.
template <Worded Enumeration>
[[nodiscard]] constexpr std::optional<Enumeration> from_word(std::string_view word)
{
    constexpr auto const& words = words_of<Enumeration>;
    auto const found = std::find(words.begin(), words.end(), word);
    if (found == words.end())
        return std::nullopt;
    return static_cast<Enumeration>(found - words.begin());
}

/// Every model of the kinematics.
inline constexpr std::array all_kinematics{Kinematics::exact, Kinematics::first_order, Kinematics::material};

}  // namespace hdconj
