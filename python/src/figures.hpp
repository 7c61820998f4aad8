// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a result without its arrays.
#pragma once

#include <nanobind/nanobind.h>

#include "result.hpp"

namespace hdconj::python {

/// Every figure of @p result as (group, name, value, error, units), groups as paths such as "load/case_000". Of a
/// column it is the last entry. The error is None where the figure has none, and not a number where it was not
/// estimated. Nothing else of the result is copied: it takes a third of the time of layout_of().
[[nodiscard]] nanobind::list figures_of(Result const& result);

}  // namespace hdconj::python
