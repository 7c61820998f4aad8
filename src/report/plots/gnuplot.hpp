// SPDX-License-Identifier: GPL-3.0-or-later
// Runs gnuplot; private to src/report.
#pragma once

#include <stdexcept>
#include <string>

namespace hdconj::report::gnuplot {

/// True when a program `gnuplot` is on the PATH.
[[nodiscard]] bool is_installed();

/// What to do where it is not.
inline constexpr char const* missing =
    "pictures are drawn by gnuplot, which is not on the PATH (Debian: apt install gnuplot-nox)";

/// gnuplot cannot be run, or refuses a script.
class GnuplotError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// Runs @p script and returns what it draws on its standard output. Nothing touches the disk under a name.
/// @throws GnuplotError with gnuplot's own words
[[nodiscard]] std::string draw(std::string const& script);

}  // namespace hdconj::report::gnuplot
