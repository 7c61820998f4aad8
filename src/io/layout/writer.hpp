// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of results: groups, datasets with units, meaning and named dimensions, attributes. What is stated here
// once goes into an HDF5 file (io/hdf5) and into the arrays of the Python package.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::io::layout {

/// Dimensions of a dataset, slowest first.
using Shape = std::vector<std::size_t>;

/// Names of the dimensions of a dataset, slowest first.
using Dims = std::vector<char const*>;

/// Whose the values of a dataset are.
enum class Owner
{
    writer,  ///< gone after the call: who keeps them makes a copy
    result   ///< the result's, for as long as it lives
};

/// What a reader is told of a dataset beside its numbers.
struct About
{
    char const* units;    ///< "mm", "mm^2", "rad", "s", "1", "N", "N mm", "N/mm", "N mm/rad" or "MPa"
    std::string meaning;  ///< in one line
    Dims dims;
    Owner owner = Owner::writer;
};

/// The values of a dataset, row by row.
using Values = std::variant<double const*, int const*, std::string const*>;

using AttributeValue = std::variant<double, int, bool, std::string, std::vector<std::string>>;

/// A figure of a group and where its value and error stand in it: as datasets or as attributes.
struct FigurePlace
{
    std::string name;
    std::string value;
    std::string error;  ///< "error/NAME" in the group `error`; as value: a dataset of both; empty: none
    char const* units;
    char const* meaning;
    bool is_attribute;
};

/// A group of a result that is being written.
class GroupSink
{
  public:
    GroupSink() = default;
    GroupSink(GroupSink const&) = delete;
    GroupSink& operator=(GroupSink const&) = delete;
    virtual ~GroupSink() = default;

    /// Makes the group @p name; @p fill is called with it.
    virtual void group(std::string const& name, std::function<void(GroupSink&)> const& fill) = 0;
    /// A dataset of one dimension that has the dimension's name holds its coordinates, and is written before all others
    /// that have this dimension.
    virtual void dataset(std::string const& name, Shape const& shape, Values const& values, About const& about) = 0;
    /// A second name of the dataset @p name.
    virtual void link(std::string const& name, std::string const& other) = 0;
    virtual void attribute(std::string const& name, AttributeValue const& value) = 0;
    /// Says which of these are figures; files need not know.
    virtual void figure(FigurePlace const&) {}
};

static_assert(sizeof(Vec2) == 2 * sizeof(double) && std::is_standard_layout_v<Vec2>,
              "points are written as they lie in memory");

/// Writes into one group, or the root.
class Writer
{
  public:
    /// @param place  must outlive the writer's last call
    explicit Writer(GroupSink& place) : place_(&place) {}

    /// Makes the group @p name and fills it: @p fill is called with its writer.
    template <class Fill>
    void group(std::string const& name, Fill fill) const
    {
        place_->group(name, [&](GroupSink& made) { fill(Writer(made)); });
    }
    /// A group for each of @p items, @p name with its number behind it: @p write is called with its writer and the
    /// item.
    template <class Items, class Write>
    void groups(std::string const& name, Items const& items, Write write) const
    {
        for (std::size_t i = 0; i < items.size(); ++i)
            group(fmt::format("{}_{:03}", name, i), [&](Writer const& made) { write(made, items[i]); });
    }

    void numbers(std::string const& name, std::vector<double> const& values, About const& about) const
    {
        array(name, {values.size()}, values.data(), about);
    }
    void integers(std::string const& name, std::vector<int> const& values, About const& about) const
    {
        array(name, {values.size()}, values.data(), about);
    }
    /// Shape (n,2), n by @p dim.
    void points(std::string const& name, std::vector<Vec2> const& points, char const* meaning, char const* dim,
                Owner owner = Owner::writer) const
    {
        array(name, {points.size(), 2}, points.empty() ? nullptr : points.front().data(),
              {"mm", meaning, {dim, "xy"}, owner});
    }
    /// Doubles or integers of any shape, row by row.
    template <class Number>
    void array(std::string const& name, Shape const& shape, Number const* values, About const& about) const
    {
        place_->dataset(name, shape, values, about);
    }
    void texts(std::string const& name, std::vector<std::string> const& values, char const* meaning,
               char const* dim) const
    {
        place_->dataset(name, {values.size()}, values.data(), {"1", meaning, {dim}});
    }

    void link(std::string const& name, std::string const& other) const { place_->link(name, other); }
    void attribute(std::string const& name, AttributeValue const& value) const { place_->attribute(name, value); }
    /// True and false as 1 and 0 (one byte).
    void flag(std::string const& name, bool value) const { place_->attribute(name, value); }
    void figure(FigurePlace const& which) const { place_->figure(which); }

  private:
    GroupSink* place_;
};

// What a layout writes, without the numbers: by this a file is read as the layout wrote it.

/// A dataset as its layout states it.
struct RecordedDataset
{
    std::string name;
    std::size_t kind = 0;  ///< index of the alternative of Values
    std::size_t rank = 0;
    About about;
};

/// A group as its layout states it.
struct RecordedGroup
{
    std::string name;                                                ///< empty: the root
    std::vector<std::pair<std::string, AttributeValue>> attributes;  ///< with a value of the attribute's type
    std::vector<RecordedDataset> datasets;                           ///< in the order written
    std::vector<FigurePlace> figures;
    std::vector<RecordedGroup> groups;  ///< NAME_000 stands for NAME_001 and so on too
};

/// Records what is written into it.
class LayoutRecorder final : public GroupSink
{
  public:
    /// @param group  outlives the object's last call
    explicit LayoutRecorder(RecordedGroup& group) : group_(&group) {}

    void group(std::string const& name, std::function<void(GroupSink&)> const& fill) override
    {
        RecordedGroup made;
        made.name = name;
        LayoutRecorder inner(made);
        fill(inner);
        group_->groups.push_back(std::move(made));
    }
    void dataset(std::string const& name, Shape const& shape, Values const& values, About const& about) override
    {
        group_->datasets.push_back({name, values.index(), shape.size(), about});
    }
    void link(std::string const&, std::string const&) override {}
    void attribute(std::string const& name, AttributeValue const& value) override
    {
        group_->attributes.emplace_back(name, value);
    }
    void figure(FigurePlace const& figure) override { group_->figures.push_back(figure); }

  private:
    RecordedGroup* group_;
};

}  // namespace hdconj::io::layout
