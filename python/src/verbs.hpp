// SPDX-License-Identifier: GPL-3.0-or-later
// The verbs of the program as Python calls them.
#pragma once

#include <nanobind/nanobind.h>

#include "hdconj/error.hpp"

namespace hdconj::python {

/// Adds the verbs, and the class of their results, to @p module.
void add_verbs(nanobind::module_& module);

/// Adds scenes, plans and faults.
void add_scene(nanobind::module_& module);

/// Makes exceptions of the library those of hdconj._errors.
void add_errors(nanobind::module_& module);

/// A fault as (path, line, value, reason, remedy, origin, set).
[[nodiscard]] nanobind::tuple fault_tuple(Fault const& fault);

}  // namespace hdconj::python
