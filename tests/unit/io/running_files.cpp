// SPDX-License-Identifier: GPL-3.0-or-later
// What is not known of a running drive, in its files and summary.
#include "hdconj/running_files.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "io/hdf5/hdf5_handle.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"
#include "support/sample_solution.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::running_files_cases {

namespace {

/// One sequence under torque that has no estimate of errors.
RunStudy study_of(RunSequence sequence)
{
    sequence.torque = 40e3;
    sequence.planned = 16;
    sequence.estimated = false;
    RunStudy study;
    study.solution = sample::solution();
    study.sequences.push_back(std::move(sequence));
    return study;
}

double attribute(hid_t file, char const* name)
{
    double value = -1;
    io::hdf5::Attribute const attribute(H5Aopen_by_name(file, "running/sequence_000", name, H5P_DEFAULT, H5P_DEFAULT),
                                        name);
    io::hdf5::checked(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), name);
    return value;
}

nlohmann::json json_of(RunStudy const& study)
{
    return nlohmann::json::parse(summary_json(study))["running"]["sequences"][0];
}

}  // namespace

TEST_CASE("errors that were not estimated are 0 in HDF5 and null in JSON", "[running]")
{
    RunSequence sequence;
    sequence.positions.resize(16);
    sequence.peak_to_peak = sequence.peak_to_peak_error = 1e-4;
    sequence.rms = sequence.rms_error = 2e-5;
    sequence.mean_torque = sequence.mean_torque_error = 600;
    sequence.torque_ripple = sequence.torque_ripple_error = 50;
    RunStudy const study = study_of(sequence);
    test::TemporaryFolder const folder;
    write_hdf5(study, folder / "a.h5");
    auto const file = test::open_file(folder / "a.h5");
    CHECK(attribute(file, "planned_positions") == 16);
    CHECK(attribute(file, "peak_to_peak_rad") == 1e-4);
    CHECK(attribute(file, "mean_torque_Nmm") == 600);
    for (char const* name :
         {"peak_to_peak_error_rad", "rms_error_rad", "mean_torque_error_Nmm", "torque_ripple_error_Nmm"})
        CHECK(attribute(file, name) == 0);
    CHECK(json_of(study)["peak_to_peak_error_arcsec"].is_null());
    CHECK_THAT(summary_text(study), ContainsSubstring(", 16 positions, "));
}

TEST_CASE("figures of a part of a sequence have a mark, and those of two positions are not determined", "[running]")
{
    double const unknown = std::numeric_limits<double>::quiet_NaN();
    RunSequence sequence;
    sequence.positions.resize(2);
    sequence.peak_to_peak = sequence.rms = sequence.mean_torque = sequence.torque_ripple = unknown;
    RunStudy const study = study_of(sequence);
    nlohmann::json const json = json_of(study);
    for (char const* name : {"peak_to_peak_arcsec", "rms_arcsec", "mean_torque_Nm", "torque_ripple_Nm"})
        CHECK(json[name].is_null());
    CHECK(json["planned_positions"] == 16);
    CHECK(json["positions"].size() == 2);
    std::string const text = summary_text(study);
    CHECK_THAT(text, ContainsSubstring(", 2 of 16 positions, 40 N m\n  transmission error        not determined"));
    CHECK_THAT(text, ContainsSubstring("wave generator torque     not determined, ripple not determined"));
    test::TemporaryFolder const folder;
    write_hdf5(study, folder / "a.h5");
    CHECK(std::isnan(attribute(test::open_file(folder / "a.h5"), "mean_torque_Nmm")));
}

}  // namespace hdconj::test::running_files_cases
