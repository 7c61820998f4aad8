// SPDX-License-Identifier: GPL-3.0-or-later
#include "layout_reader.hpp"

#include <fmt/format.h>

#include <map>

namespace hdconj::io::hdf5 {
namespace {

constexpr std::size_t most_values = std::size_t{1} << 28;  // a damaged shape must not ask for all memory

/// Lengths of the dimensions of a group and of those around it.
using Sizes = std::map<std::string, std::size_t>;

bool holds(hid_t place, std::string const& name)
{
    return H5Lexists(place, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> list_of(hid_t place, char const* name)
{
    Attribute const attribute(H5Aopen(place, name, H5P_DEFAULT), "open attribute");
    Type const stored(H5Aget_type(attribute), "ask for a type");
    Space const space(H5Aget_space(attribute), "get dataspace");
    require(H5Tis_variable_str(stored) > 0, "an attribute holds no texts");
    std::vector<char*> texts(
        static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), "ask for a length")));
    if (!texts.empty())
        checked(H5Aread(attribute, text_type(), texts.data()), "read attribute");
    std::vector<std::string> result;
    for (char* const text : texts) {
        OwnedText const owner(text, &H5free_memory);
        result.emplace_back(text == nullptr ? "" : text);
    }
    return result;
}

/// The attribute @p name, of the type of @p like.
layout::AttributeValue attribute_of(hid_t place, char const* name, layout::AttributeValue const& like)
{
    return std::visit(
        [&](auto const& given) -> layout::AttributeValue {
            using Value = std::decay_t<decltype(given)>;
            if constexpr (std::is_same_v<Value, bool>)
                return number_of<int>(place, name) != 0;
            else if constexpr (std::is_arithmetic_v<Value>)
                return number_of<Value>(place, name);
            else if constexpr (std::is_same_v<Value, std::string>)
                return text_of(place, name);
            else
                return list_of(place, name);
        },
        like);
}

void read_dataset(hid_t place, layout::RecordedDataset const& set, layout::GroupSink& into, Sizes& sizes)
{
    Opened const opened(place, set.name.c_str(), set.rank);
    layout::Shape const shape(opened.shape.begin(), opened.shape.end());
    require(opened.count() <= most_values, "a dataset claims more values than any result has");
    for (std::size_t i = 0; i < set.rank; ++i) {
        bool const own_scale = set.rank == 1 && set.name == set.about.dims.front();
        auto const [known, is_new] = sizes.emplace(set.about.dims[i], shape[i]);
        if (own_scale)
            known->second = shape[i];
        else if (!is_new && known->second != shape[i])
            throw Misfit(fmt::format("{} has {} along {}, and others have {}", set.name, shape[i], set.about.dims[i],
                                     known->second));
    }
    if (set.kind == 0)
        into.dataset(set.name, shape, values_of<double>(opened, H5T_NATIVE_DOUBLE).data(), set.about);
    else if (set.kind == 1)
        into.dataset(set.name, shape, values_of<int>(opened, H5T_NATIVE_INT).data(), set.about);
    else
        into.dataset(set.name, shape, texts_of(place, set.name.c_str()).data(), set.about);
}

void read_group(hid_t place, layout::RecordedGroup const& pattern, layout::GroupSink& into, Sizes sizes)
{
    for (auto const& each : pattern.attributes)
        if (H5Aexists(place, each.first.c_str()) > 0)
            into.attribute(each.first, attribute_of(place, each.first.c_str(), each.second));
    for (auto const& set : pattern.datasets)
        if (holds(place, set.name))
            read_dataset(place, set, into, sizes);
    for (auto const& figure : pattern.figures)
        into.figure(figure);
    auto const enter = [&](std::string const& name, layout::RecordedGroup const& inner) {
        into.group(name, [&](layout::GroupSink& made) {
            Group const opened(H5Gopen2(place, name.c_str(), H5P_DEFAULT), "open a group");
            read_group(opened, inner, made, sizes);
        });
    };
    for (auto const& inner : pattern.groups) {
        std::string_view const name = inner.name, first = "_000";
        if (!name.ends_with(first)) {
            if (holds(place, inner.name))
                enter(inner.name, inner);
            continue;
        }
        std::string_view const stem = name.substr(0, name.size() - first.size());
        for (int i = 0; holds(place, fmt::format("{}_{:03}", stem, i)); ++i)
            enter(fmt::format("{}_{:03}", stem, i), inner);
    }
}

}  // namespace

void read_layout(hid_t place, layout::RecordedGroup const& pattern, layout::GroupSink& into)
{
    read_group(place, pattern, into, {});
}

}  // namespace hdconj::io::hdf5
