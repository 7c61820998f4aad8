// SPDX-License-Identifier: GPL-3.0-or-later
// A stored result, wherever it is stored, and how it is read as its layout wrote it.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "hdconj/result_files.hpp"
#include "writer.hpp"

namespace hdconj::io::layout {

/// What is read is no result of the kind that is wanted; what() is for the user.
class Misfit : public std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// @throws Misfit with @p cause where it does not hold
inline void require(bool holds, char const* cause)
{
    if (!holds)
        throw Misfit(cause);
}

/// A dataset, row by row.
struct StoredValues
{
    Shape shape;
    std::variant<std::vector<double>, std::vector<int>, std::vector<std::string>> values;
};

/// A group of a stored result. What is asked of it and not as asked for is a Misfit, or what the storage throws.
class StoredGroup
{
  public:
    StoredGroup() = default;
    StoredGroup(StoredGroup const&) = delete;
    StoredGroup& operator=(StoredGroup const&) = delete;
    virtual ~StoredGroup() = default;

    /// Whether there is a dataset or a group @p name.
    [[nodiscard]] virtual bool holds(std::string const& name) const = 0;
    [[nodiscard]] virtual bool has_attribute(std::string const& name) const = 0;
    /// The attribute @p name, of the type of @p like.
    [[nodiscard]] virtual AttributeValue attribute(std::string const& name, AttributeValue const& like) const = 0;
    /// The dataset @p name. @param kind  index of the alternative of Values @param rank  number of dimensions
    [[nodiscard]] virtual StoredValues dataset(std::string const& name, std::size_t kind, std::size_t rank) const = 0;
    [[nodiscard]] virtual std::unique_ptr<StoredGroup> group(std::string const& name) const = 0;

    template <class Value>
    [[nodiscard]] Value attribute(std::string const& name) const
    {
        return std::get<Value>(attribute(name, AttributeValue(Value())));
    }
    /// The values of a dataset of doubles, integers or texts.
    template <class Value>
    [[nodiscard]] std::vector<Value> list(std::string const& name) const
    {
        constexpr std::size_t kind = std::is_same_v<Value, double> ? 0 : std::is_same_v<Value, int> ? 1 : 2;
        return std::get<std::vector<Value>>(dataset(name, kind, 1).values);
    }
};

/// Writes into @p into what @p place, a root or a group, holds of @p pattern. What it lacks is passed over: parts that
/// its drive does not have.
/// @throws Misfit where a value is not of the kind that the layout writes, or two datasets of a dimension differ in its
/// length
void read_layout(StoredGroup const& place, RecordedGroup const& pattern, GroupSink& into);

/// What the files held that the scene of the root @p result names; empty in older files, which do not keep it.
[[nodiscard]] scene::NamedTexts files_of(StoredGroup const& result);

/// Scene and circular spline of the root @p result. @throws Misfit where its parts contradict each other
[[nodiscard]] StoredOutline stored_outline(StoredGroup const& result);

}  // namespace hdconj::io::layout
