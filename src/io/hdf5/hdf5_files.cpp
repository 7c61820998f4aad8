// SPDX-License-Identifier: GPL-3.0-or-later
// Every result as an HDF5 file.
#include "hdf5_files.hpp"

#include "hdconj/contact_files.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/running_files.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "hdf5_writer.hpp"

namespace hdconj::io {

std::string hdf5::accuracy_bytes(StoredAccuracy const& study)
{
    Silence const silence;
    Sink sink;
    NewFile made(sink);
    layout::write_result(made.root(), study);
    made.flush();
    return sink.bytes();
}

}  // namespace hdconj::io

namespace hdconj {

using io::layout::Writer;

void write_hdf5(Solution const& solution, std::filesystem::path const& file)
{
    io::hdf5::write_file(file, [&](Writer const& root) { io::layout::write_result(root, solution); });
}

void write_hdf5(ContactStudy const& study, std::filesystem::path const& file)
{
    io::hdf5::write_file(file, [&](Writer const& root) { io::layout::write_result(root, study); });
}

void write_hdf5(LoadStudy const& study, std::filesystem::path const& file, Measurement const* measured)
{
    io::hdf5::write_file(file, [&](Writer const& root) { io::layout::write_result(root, study, measured); });
}

void write_hdf5(RunStudy const& study, std::filesystem::path const& file)
{
    io::hdf5::write_file(file, [&](Writer const& root) { io::layout::write_result(root, study); });
}

void write_hdf5(WantedCurve const& found, std::filesystem::path const& file)
{
    io::hdf5::write_file(file, [&](Writer const& root) { io::layout::write_result(root, found); });
}

void write_hdf5(Inspection const& inspection, std::filesystem::path const& file)
{
    io::hdf5::write_file(file, [&](Writer const& root) { io::layout::write_result(root, inspection); });
}

}  // namespace hdconj
