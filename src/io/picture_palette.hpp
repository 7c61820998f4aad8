// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Colours that stay apart for colour-blind eyes and in grey print; private to src/io.
#pragma once

namespace hdconj::picture {

inline constexpr char const* black = "#000000";
inline constexpr char const* dark_grey = "#5f5f5f";
inline constexpr char const* grey = "#9a9a9a";
inline constexpr char const* light_grey = "#c4c4c4";
inline constexpr char const* paper = "#f1efe9";
inline constexpr char const* blue = "#0072b2";
inline constexpr char const* light_blue = "#9ccbe6";
inline constexpr char const* pale_blue = "#dbe9f3";
inline constexpr char const* green = "#009e73";
inline constexpr char const* orange = "#e69f00";
inline constexpr char const* vermilion = "#d55e00";
inline constexpr char const* light_vermilion = "#efb790";
inline constexpr char const* purple = "#cc79a7";

}  // namespace hdconj::picture
