// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Options whose value is a list with commas, such as `--tilt 0,0.1,0.2`.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
class Option;
}

namespace hdconj::cli {

/// Adds such an option. The parser's own lists would drop empty items without a word; here they are refused.
/// @param take   gets each item, in order
/// @param fault  what is wrong with an item, or nothing; null: any item will do
CLI::Option* add_list(CLI::App& verb, std::string const& name, std::function<void(std::string const&)> take, std::function<std::string(std::string const&)> fault,
                      std::string const& meaning);

}  // namespace hdconj::cli
