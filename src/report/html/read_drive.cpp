// SPDX-License-Identifier: GPL-3.0-or-later
// A drive of a report from a result file.
#include "io/hdf5/hdf5_group.hpp"
#include "stored_drive.hpp"

namespace hdconj {

ReportedDrive read_drive(std::filesystem::path const& file)
{
    using namespace io::hdf5;
    constexpr StoredKind result_file{"no result file that a report can show",
                                     "make it anew: hdconj solve, contact, load or run, each with -o FILE.h5", nullptr};
    return read_stored(file, result_file,
                       [&](File const& opened) { return report::drive_from(StoredFile(opened), file); });
}

}  // namespace hdconj
