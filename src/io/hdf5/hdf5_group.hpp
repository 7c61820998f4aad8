// SPDX-License-Identifier: GPL-3.0-or-later
// A group of an HDF5 file as a stored result.
#pragma once

#include <optional>

#include "hdf5_reader.hpp"
#include "io/layout/stored_group.hpp"

namespace hdconj::io::hdf5 {

/// An open file or group. Beside Misfit, Failure says that the library cannot read on.
class StoredFile final : public layout::StoredGroup
{
  public:
    /// @param place  outlives the object
    explicit StoredFile(hid_t place) : place_(place) {}
    explicit StoredFile(Group own) : own_(std::move(own)), place_(*own_) {}

    using StoredGroup::attribute;
    [[nodiscard]] bool holds(std::string const& name) const override;
    [[nodiscard]] bool has_attribute(std::string const& name) const override;
    [[nodiscard]] layout::AttributeValue attribute(std::string const& name,
                                                   layout::AttributeValue const& like) const override;
    [[nodiscard]] layout::StoredValues dataset(std::string const& name, std::size_t kind,
                                               std::size_t rank) const override;
    [[nodiscard]] std::unique_ptr<StoredGroup> group(std::string const& name) const override;

  private:
    std::optional<Group> own_;
    hid_t place_;
};

}  // namespace hdconj::io::hdf5
