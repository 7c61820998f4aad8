// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a result file as its layout wrote it.
#pragma once

#include "hdf5_reader.hpp"
#include "io/layout/layout_record.hpp"

namespace hdconj::io::hdf5 {

/// Writes into @p into what the open file or group @p place holds of @p pattern. What the file lacks is passed over:
/// parts that its drive does not have.
/// @throws Misfit, Failure where a value is not of the kind that the layout writes, or two datasets of a dimension
/// differ in its length
void read_layout(hid_t place, layout::RecordedGroup const& pattern, layout::GroupSink& into);

}  // namespace hdconj::io::hdf5
