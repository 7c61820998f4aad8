// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_group.hpp"

#include <fmt/format.h>

#include <map>

namespace hdconj::io::layout {
namespace {

/// Lengths of the dimensions of a group and of those around it.
using Sizes = std::map<std::string, std::size_t>;

void read_dataset(StoredGroup const& place, RecordedDataset const& set, GroupSink& into, Sizes& sizes)
{
    StoredValues const stored = place.dataset(set.name, set.kind, set.rank);
    Shape const& shape = stored.shape;
    for (std::size_t i = 0; i < set.rank; ++i) {
        bool const own_scale = set.rank == 1 && set.name == set.about.dims.front();
        auto const [known, is_new] = sizes.emplace(set.about.dims[i], shape[i]);
        if (own_scale)
            known->second = shape[i];
        else if (!is_new && known->second != shape[i])
            throw Misfit(fmt::format("{} has {} along {}, and others have {}", set.name, shape[i], set.about.dims[i],
                                     known->second));
    }
    std::visit([&](auto const& values) { into.dataset(set.name, shape, values.data(), set.about); }, stored.values);
}

void read_group(StoredGroup const& place, RecordedGroup const& pattern, GroupSink& into, Sizes sizes)
{
    for (auto const& each : pattern.attributes)
        if (place.has_attribute(each.first))
            into.attribute(each.first, place.attribute(each.first, each.second));
    for (auto const& set : pattern.datasets)
        if (place.holds(set.name))
            read_dataset(place, set, into, sizes);
    for (auto const& figure : pattern.figures)
        into.figure(figure);
    auto const enter = [&](std::string const& name, RecordedGroup const& inner) {
        into.group(name, [&](GroupSink& made) { read_group(*place.group(name), inner, made, sizes); });
    };
    for (auto const& inner : pattern.groups) {
        std::string_view const name = inner.name, first = "_000";
        if (!name.ends_with(first)) {
            if (place.holds(inner.name))
                enter(inner.name, inner);
            continue;
        }
        std::string_view const stem = name.substr(0, name.size() - first.size());
        for (int i = 0; place.holds(fmt::format("{}_{:03}", stem, i)); ++i)
            enter(fmt::format("{}_{:03}", stem, i), inner);
    }
}

}  // namespace

void read_layout(StoredGroup const& place, RecordedGroup const& pattern, GroupSink& into)
{
    read_group(place, pattern, into, {});
}

}  // namespace hdconj::io::layout
