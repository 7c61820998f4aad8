// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the format before: every file has each renamed figure under both names, with one value. The names come from
// the page that describes them.
#include <hdf5.h>

#include <nlohmann/json.hpp>
#include <set>

#include "hdconj_run.hpp"
#include "support/catch.hpp"
#include "support/former_names.hpp"
#include "support/read_hdf5.hpp"

namespace hdconj::test::former_name_cases {

using nlohmann::json;

namespace {

/// Names that were found under both forms.
using Seen = std::set<Renamed>;

/// Calls @p same with both names of a figure wherever @p keys have one of them. @p same fails where one is missing.
template <class Keys, class Same>
void check_names(Keys const& keys, std::vector<Renamed> const& names, Seen& seen, Same same)
{
    for (std::string const& key : keys) {
        for (auto const& each : names) {
            for (auto const& stem : {each.name, each.former}) {
                if (auto const end = end_of(key, stem)) {
                    same(each.name + *end, each.former + *end);
                    seen.insert(each);
                }
            }
        }
    }
}

void check_json(json const& value, std::vector<Renamed> const& names, Seen& seen)
{
    if (value.is_object()) {
        std::set<std::string> keys;
        for (auto const& [key, item] : value.items())
            keys.insert(key);
        check_names(keys, names, seen, [&](std::string const& name, std::string const& former) {
            INFO(name << " and " << former);
            CHECK(value.at(name) == value.at(former));
        });
    }
    if (value.is_structured())
        for (auto const& item : value)
            check_json(item, names, seen);
}

herr_t add_path(hid_t, char const* path, H5L_info_t const*, void* paths)
{
    static_cast<std::set<std::string>*>(paths)->insert(path);
    return 0;
}

double attribute(hid_t place, std::string const& name)
{
    double value = 0;
    io::hdf5::Attribute const opened(H5Aopen(place, name.c_str(), H5P_DEFAULT), "open attribute");
    io::hdf5::checked(H5Aread(opened, H5T_NATIVE_DOUBLE, &value), "read attribute");
    return value;
}

/// Datasets below @p group, and attributes of the group.
void check_hdf5(hid_t file, char const* group, std::vector<Renamed> const& names, Seen& seen)
{
    io::hdf5::Group const place(H5Gopen2(file, group, H5P_DEFAULT), "open group");
    std::set<std::string> paths;
    REQUIRE(H5Lvisit(place, H5_INDEX_NAME, H5_ITER_INC, add_path, &paths) >= 0);
    for (auto const& path : paths) {
        auto const folder = path.substr(0, path.rfind('/') + 1);
        check_names(std::set{path.substr(folder.size())}, names, seen, [&](auto const& name, auto const& former) {
            INFO(group << "/" << folder << ": " << name << " and " << former);
            REQUIRE(has_link(place, (folder + name).c_str()));
            REQUIRE(has_link(place, (folder + former).c_str()));
            CHECK(read(place, (folder + name).c_str()).values == read(place, (folder + former).c_str()).values);
        });
    }
    for (auto const& each : names) {
        for (std::string const end : {"", "_mm"}) {
            if (H5Aexists(place, (each.name + end).c_str()) > 0) {
                CHECK(attribute(place, each.name + end) == attribute(place, each.former + end));
                seen.insert(each);
            }
        }
    }
}

json summary_of(std::string const& command, TemporaryFolder const& folder)
{
    auto const done = hdconj_run(command, folder.path());
    INFO(done.err);
    REQUIRE(done.status == 0);
    json summary = json::parse(done.out);
    CHECK(summary.at("format_version") == 2);
    return summary;
}

void check_verb(std::string const& verb, std::string const& arguments, std::vector<Renamed> const& of_hdf5)
{
    TemporaryFolder const folder;
    auto const summary = summary_of(verb + " " + arguments + " -o a.h5 --json --quiet", folder);
    Seen in_json, in_hdf5;
    check_json(summary.at(verb), renamed(verb), in_json);
    check_hdf5(open_file(folder / "a.h5"), ("/" + verb).c_str(), of_hdf5, in_hdf5);
    CHECK(in_json.size() == renamed(verb).size());
    CHECK(in_json.size() > 5);
    for (auto const& each : of_hdf5) {
        INFO(each.name);
        CHECK((in_hdf5.contains(each) || each.former == "tip_widened"));  // which is of JSON alone
    }
}

}  // namespace

TEST_CASE("contact: former names have the values of the new ones", "[contact][former]")
{
    check_verb("contact",
               "'" HDCONJ_SOURCE_DIR
               "/data/scenes/type-50-coned.toml' --set slices.count=3 "
               "--set contact.flank_points=40 --surface tilted --revolution 2 --tilt 0,0.1 --best",
               renamed("contact", {{"flank_position", "station"}}));
}

TEST_CASE("load: former names have the values of the new ones", "[load][former]")
{
    check_verb("load",
               "--set slices.count=3 --points 2 --measured '" HDCONJ_SOURCE_DIR
               "/data/measured/torque-twist.csv' --torque-constant 0.119 --counts-per-turn 2000",
               renamed("load", {{"flank_position", "height"}}));
}

TEST_CASE("accuracy: former names have the values of the new ones", "[accuracy][former]")
{
    TemporaryFolder const folder;
    auto const names = renamed("accuracy");
    auto const summary =
        summary_of("accuracy --quick --sample 0 --study tolerance --error 1e-5 --json --quiet -o a", folder);
    Seen seen;
    check_json(summary, names, seen);
    CHECK(seen.size() == names.size());
    auto const file = open_file(folder / "a/records.h5");
    Seen in_hdf5;
    check_hdf5(file, "/", names, in_hdf5);
    CHECK(in_hdf5.size() == 2);  // normal_speed and reference_interference: the others are of JSON alone
}

TEST_CASE("accuracy: records of format version 1 are read", "[accuracy][former]")
{
    TemporaryFolder const folder;
    auto const measured = summary_of("accuracy --quick --sample 0 --study number-type --json --quiet -o a", folder);
    {  // as version 1 had it: former names alone
        io::hdf5::File const file(H5Fopen((folder / "a/records.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open");
        REQUIRE(H5Ldelete(file, "/records/normal_speed", H5P_DEFAULT) >= 0);
        REQUIRE(H5Adelete(file, "reference_interference_mm") >= 0);
        io::hdf5::Attribute const version(H5Aopen(file, "format_version", H5P_DEFAULT), "open attribute");
        int const one = 1;
        REQUIRE(H5Awrite(version, H5T_NATIVE_INT, &one) >= 0);
    }
    auto const stored = summary_of("accuracy --from a/records.h5 --json", folder);
    CHECK(stored.at("convergence_series") == measured.at("convergence_series"));
    CHECK(stored.at("reference_interference_mm") == measured.at("reference_interference_mm"));
}

}  // namespace hdconj::test::former_name_cases
