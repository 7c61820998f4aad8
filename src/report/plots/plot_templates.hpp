// SPDX-License-Identifier: GPL-3.0-or-later
// The files templates/NAME.gp as text, which the build turns into a source.
#pragma once

#include <span>
#include <string_view>

namespace hdconj::report {

struct PlotTemplate
{
    std::string_view name, text;
};
extern std::span<PlotTemplate const> const plot_templates;

}  // namespace hdconj::report
