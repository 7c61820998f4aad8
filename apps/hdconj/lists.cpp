// SPDX-License-Identifier: GPL-3.0-or-later
#include "lists.hpp"

#include <CLI/CLI.hpp>
#include <string_view>
#include <vector>

namespace hdconj::cli {
namespace {

std::vector<std::string> items_of(std::string_view list)
{
    std::vector<std::string> items;
    for (auto comma = list.find(','); comma != std::string_view::npos; comma = list.find(',')) {
        items.emplace_back(list.substr(0, comma));
        list.remove_prefix(comma + 1);
    }
    items.emplace_back(list);
    return items;
}

}  // namespace

CLI::Option* add_list(CLI::App& verb, std::string const& name, std::function<void(std::string const&)> take, std::function<std::string(std::string const&)> fault,
                      std::string const& meaning)
{
    auto const each = [take = std::move(take)](std::vector<std::string> const& lists) {
        for (auto const& list : lists) {
            for (auto const& item : items_of(list)) {
                take(item);
            }
        }
    };
    auto const judge = [fault = std::move(fault)](std::string const& list) -> std::string {
        auto const items = items_of(list);
        for (auto const& item : items) {
            if (item.empty() && items.size() > 1) {
                return "an item of '" + list + "' is empty (write one comma between two items, and none at the ends)";
            }
            if (std::string said = fault ? fault(item) : ""; !said.empty()) {
                return said;
            }
        }
        return {};
    };
    // one word each time: what stands behind it is the scene
    return verb.add_option_function<std::vector<std::string>>(name, each, meaning)->check(judge)->allow_extra_args(false);
}

}  // namespace hdconj::cli
