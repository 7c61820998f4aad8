// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a test does where a machine lacks what it needs.
#pragma once

#include <string>

namespace hdconj::test {

/// Says that @p what was not tried: ctest reports the test as skipped, unless a check of it has failed. In CI (the
/// environment has CI) it is a failure instead, but for what tests/not_tried.txt lists.
void not_tried(std::string const& what);

}  // namespace hdconj::test
