// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_group.hpp"

namespace hdconj {

StoredOutline read_outline(std::filesystem::path const& file)
{
    using namespace io::hdf5;
    StoredKind const result{"no result file of hdconj", "make one: hdconj solve -o FILE.h5", nullptr};
    return read_stored(file, result, [](File const& opened) { return io::layout::stored_outline(StoredFile(opened)); });
}

}  // namespace hdconj
