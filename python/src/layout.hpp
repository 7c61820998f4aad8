// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of a result as Python objects.
#pragma once

#include <nanobind/nanobind.h>

#include "result.hpp"

namespace hdconj::python {

/// The root group of @p result as (attributes, datasets, links, groups, figures): a dictionary of values; of (values,
/// units, meaning, dimensions); of names; of such groups; and a list of (name, value, error, units, meaning,
/// is_attribute). Numbers are arrays of NumPy that cannot be written to. They view the memory of @p result where the
/// layout says that the values are there, and else a copy.
/// @param owner  the Python object of @p result, which the views keep alive
[[nodiscard]] nanobind::object layout_of(Result const& result, nanobind::handle owner);

/// Text in UTF-8; bytes that are none, as in names of files, become surrogates as Python's own file names have them.
[[nodiscard]] nanobind::str text_of(std::string const& text);

}  // namespace hdconj::python
