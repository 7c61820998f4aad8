// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of figures against the pages that describe the files.
#include <set>

#include "figures/accuracy_figures.hpp"
#include "figures/inspect_figures.hpp"
#include "figures/load_figures.hpp"
#include "figures/measured_figures.hpp"
#include "figures/running_figures.hpp"
#include "figures/summary_figures.hpp"
#include "figures/wire_figures.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

using namespace hdconj;

namespace {

/// Adds what a table names to the keys of JSON and the columns of HDF5; a name stands once in a table.
template <class Record>
void collect(figures::Rows<Record> const& rows, std::set<std::string>& keys, std::set<std::string>& columns)
{
    std::set<std::string> own_keys, own_columns;
    auto const add = [](bool there, std::set<std::string>& own, std::string const& name) {
        INFO(name);
        CHECK((!there || own.insert(name).second));
    };
    for (auto const& row : rows) {
        INFO(row.name);
        CHECK(std::string(row.meaning).size() > 3);
        CHECK(row.value != nullptr);
        add(row.is_in(figures::json_value), own_keys, row.json_key());
        add(row.is_in(figures::json_error) && !row.apart, own_keys, row.json_key_of_error());
        add(row.is_in(figures::hdf5_value), own_columns, row.name);
        add(row.is_in(figures::hdf5_error) && !row.apart, own_columns, row.column_of_error());
    }
    keys.merge(own_keys);
    columns.merge(own_columns);
}

}  // namespace

TEST_CASE("docs/reference/json.md and docs/reference/hdf5.md name every figure of the tables", "[figures]")
{
    std::set<std::string> keys, columns, of_json, summary;
    collect(figures::contact_study_figures(), keys, columns);
    collect(figures::state_figures(), keys, columns);
    collect(figures::case_figures(), keys, columns);
    collect(figures::slice_figures(), keys, columns);
    collect(figures::best_tilt_figures(), keys, columns);
    collect(figures::load_study_figures(), keys, columns);
    collect(figures::loaded_state_figures(4), keys, columns);
    collect(figures::load_case_figures(), keys, columns);
    collect(figures::assembled_cup_figures(4), keys, columns);
    collect(figures::measured_curve_figures(), keys, columns);
    collect(figures::zone_figures(), keys, columns);
    collect(figures::undecided_figures(), keys, columns);
    // attributes of HDF5 with the names of JSON
    collect(figures::geometry_figures(), summary, of_json);
    collect(figures::clearance_figures(), summary, of_json);
    collect(figures::error_figures(), summary, of_json);
    // JSON alone
    std::set<std::string> none;
    collect(figures::closest_figures(), keys, none);
    collect(figures::drive_figures(), keys, none);
    collect(figures::work_figures(), keys, none);
    collect(figures::wire_figures(), keys, none);
    collect(figures::wire_check_figures(), keys, none);
    collect(figures::face_figures(), keys, none);
    collect(figures::pass_figures(), keys, none);
    collect(figures::residual_figures(), keys, none);
    collect(figures::wire_file_figures(), keys, none);
    collect(figures::inspection_figures(), keys, columns);
    collect(figures::placement_figures(), keys, columns);
    collect(figures::nominal_figures(), keys, columns);
    collect(figures::flank_rows(), keys, columns);
    collect(figures::tooth_rows(), keys, columns);
    collect(figures::side_rows(), keys, columns);
    collect(figures::pitch_rows(), keys, columns);
    collect(figures::plane_rows(), keys, columns);
    collect(figures::eccentricity_rows(), keys, columns);
    collect(figures::run_study_figures(), keys, columns);
    collect(figures::run_sequence_figures(true), keys, columns);
    collect(figures::run_position_rows(true), keys, columns);
    collect(figures::run_order_rows(), keys, columns);
    collect(figures::efficiency_rows(), keys, columns);
    collect(figures::run_loss_figures(), keys, columns);
    collect(figures::back_driving_figures(), keys, columns);
    collect(figures::level_figures(), keys, none);
    collect(figures::advice_figures(), keys, none);
    keys.merge(std::set<std::string>(summary));
    for (auto const& figure : figures::record_figures())
        columns.insert(figure.figure.name);
    CHECK(keys.size() > 200);
    CHECK(columns.size() > 100);
    auto const json = test::content(HDCONJ_SOURCE_DIR "/docs/reference/json.md");
    for (auto const& key : keys)
        CHECK_THAT(json, ContainsSubstring("`" + key + "`"));
    auto const hdf5 = test::content(HDCONJ_SOURCE_DIR "/docs/reference/hdf5.md");
    for (auto const& column : columns) {
        INFO(column);
        CHECK(hdf5.find(column) != std::string::npos);
    }
}
