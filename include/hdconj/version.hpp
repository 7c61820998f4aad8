// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Identity of the program that makes a result: every file contains it, --version prints it.
#pragma once

#include <string_view>

namespace hdconj {

/// "1.0.0"
[[nodiscard]] std::string_view program_version();

/// `git describe` of the sources as built, with "-dirty" when they differ from the commit;
/// "unknown" when not built from a checkout.
[[nodiscard]] std::string_view git_revision();

/// Compiler and the flags that can change a result: "GNU 12.2.0, Release, -O3 -DNDEBUG -ffp-contract=off".
[[nodiscard]] std::string_view build_description();

}  // namespace hdconj
