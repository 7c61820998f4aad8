// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_group.hpp"

namespace hdconj::io::hdf5 {
namespace {

constexpr std::size_t most_values = std::size_t{1} << 28;  // a damaged shape must not ask for all memory

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

}  // namespace

bool StoredFile::holds(std::string const& name) const
{
    return H5Lexists(place_, name.c_str(), H5P_DEFAULT) > 0;
}

bool StoredFile::has_attribute(std::string const& name) const
{
    return H5Aexists(place_, name.c_str()) > 0;
}

layout::AttributeValue StoredFile::attribute(std::string const& name, layout::AttributeValue const& like) const
{
    return std::visit(
        [&](auto const& given) -> layout::AttributeValue {
            using Value = std::decay_t<decltype(given)>;
            if constexpr (std::is_same_v<Value, bool>)
                return number_of<int>(place_, name.c_str()) != 0;
            else if constexpr (std::is_arithmetic_v<Value>)
                return number_of<Value>(place_, name.c_str());
            else if constexpr (std::is_same_v<Value, std::string>)
                return text_of(place_, name.c_str());
            else
                return list_of(place_, name.c_str());
        },
        like);
}

layout::StoredValues StoredFile::dataset(std::string const& name, std::size_t kind, std::size_t rank) const
{
    Opened const opened(place_, name.c_str(), rank);
    require(opened.count() <= most_values, "a dataset claims more values than any result has");
    layout::Shape shape(opened.shape.begin(), opened.shape.end());
    if (kind == 0)
        return {std::move(shape), values_of<double>(opened, H5T_NATIVE_DOUBLE)};
    if (kind == 1)
        return {std::move(shape), values_of<int>(opened, H5T_NATIVE_INT)};
    return {std::move(shape), texts_of(place_, name.c_str())};
}

std::unique_ptr<layout::StoredGroup> StoredFile::group(std::string const& name) const
{
    return std::make_unique<StoredFile>(Group(H5Gopen2(place_, name.c_str(), H5P_DEFAULT), "open a group"));
}

}  // namespace hdconj::io::hdf5

namespace hdconj {

StoredOutline read_outline(std::filesystem::path const& file)
{
    using namespace io::hdf5;
    StoredKind const result{"no result file of hdconj", "make one: hdconj solve -o FILE.h5", nullptr};
    return read_stored(file, result, [](File const& opened) { return io::layout::stored_outline(StoredFile(opened)); });
}

}  // namespace hdconj
