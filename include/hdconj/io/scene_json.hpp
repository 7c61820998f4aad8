// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `hdconj check --json` prints.
#pragma once

#include <string>

#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/plan.hpp"

namespace hdconj {

/// One JSON object: "scene", "faults" [{"path", "line", "value", "reason", "remedy", "origin"}], and, when there is a
/// plan, "stages" [{"stage", "reason"}] and "absent" [{"effect", "remedy"}]. @p plan may be null.
[[nodiscard]] std::string check_json(std::string const& scene_name, Faults const& faults, Plan const* plan);

}  // namespace hdconj
