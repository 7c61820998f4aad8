// SPDX-License-Identifier: GPL-3.0-or-later
// The text of data/calculix/compare.py, put into the program when it is built.
#pragma once

#include <string_view>

namespace hdconj::io {

extern std::string_view const compare_script;

}  // namespace hdconj::io
