// SPDX-License-Identifier: GPL-3.0-or-later
// The files of web/ that make the page, as text that the build turns into a source.
#pragma once

#include <span>
#include <string_view>

namespace hdconj::report {

struct PagePart
{
    std::string_view name, text;
};
extern std::span<PagePart const> const page_parts;

}  // namespace hdconj::report
