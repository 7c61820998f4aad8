// SPDX-License-Identifier: GPL-3.0-or-later
// A result as Python holds it, read as one that is stored: h5py reads the files.
#pragma once

#include <nanobind/nanobind.h>

#include "io/layout/stored_group.hpp"

namespace hdconj::python {

/// A Group of the package (python/hdconj/_tree.py). Calls need the lock of the interpreter.
class PythonGroup final : public io::layout::StoredGroup
{
  public:
    explicit PythonGroup(nanobind::object group) : group_(std::move(group)) {}

    using StoredGroup::attribute;
    [[nodiscard]] bool holds(std::string const& name) const override;
    [[nodiscard]] bool has_attribute(std::string const& name) const override;
    [[nodiscard]] io::layout::AttributeValue attribute(std::string const& name,
                                                       io::layout::AttributeValue const& like) const override;
    [[nodiscard]] io::layout::StoredValues dataset(std::string const& name, std::size_t kind,
                                                   std::size_t rank) const override;
    [[nodiscard]] std::unique_ptr<StoredGroup> group(std::string const& name) const override;

  private:
    nanobind::object group_;
};

}  // namespace hdconj::python
