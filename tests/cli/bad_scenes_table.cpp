// SPDX-License-Identifier: GPL-3.0-or-later
#include "bad_scenes_table.hpp"

#include <stdexcept>

#include "hdconj/read_scene.hpp"

namespace hdconj::test {

std::vector<BadScene> const& wrong_values()
{
    static std::vector<BadScene> const rows{
        // type
        {"number in quotes", "wall = 0.7", "wall = \"0.7\"", "flexspline.wall", "text where a length",
         "write 0.7, a number without quotes"},
        {"number with unit in quotes", "wall = 0.7", "wall = \"0.7 mm\"", "flexspline.wall", "text where",
         "without quotes or unit"},
        {"number in quotes beyond its limits", "flexspline_teeth = 200",
         "flexspline_teeth = \"99999999999999999999999\"", "drive.flexspline_teeth", "must be at most 100000",
         "a whole number from 6 to 100000"},
        {"decimal comma in quotes", "wall = 0.7", "wall = \"0,7\"", "flexspline.wall", "a decimal comma", "write 0.7"},
        {"word for number", "wall = 0.7", "wall = \"thick\"", "flexspline.wall", "text where", "wall = 0.7"},
        {"empty text for number", "wall = 0.7", "wall = \"\"", "flexspline.wall", "text where", "wall = 0.7"},
        {"date for number", "wall = 0.7", "wall = 1979-05-27", "flexspline.wall", "a date", "wall = 0.7"},
        {"time for number", "wall = 0.7", "wall = 07:32:00", "flexspline.wall", "a date or time", "wall = 0.7"},
        {"boolean for number", "wall = 0.7", "wall = true", "flexspline.wall", "true or false", "wall = 0.7"},
        {"list for number", "wall = 0.7", "wall = [0.7]", "flexspline.wall", "a list", "wall = 0.7"},
        {"table for number", "wall = 0.7", "wall = { mm = 0.7 }", "flexspline.wall", "a table", "wall = 0.7"},
        {"number for name", "name = \"type-50\"", "name = 50", "drive.name", "a number where text", "in quotes"},
        {"control character in name", "name = \"type-50\"", "name = \"a\\u001b[31m\"", "drive.name", "control",
         "leave"},
        {"number for word", "kinematics = \"exact\"", "kinematics = 1", "solver.kinematics", "a number where a word",
         "\"first-order\""},
        {"boolean for count", "threads = 0", "threads = false", "solver.threads", "true or false", "threads = 0"},
        // counts
        {"teeth with decimal point", "flexspline_teeth = 200", "flexspline_teeth = 200.0", "drive.flexspline_teeth",
         "decimal point", "write 200"},
        {"half a tooth", "flexspline_teeth = 200", "flexspline_teeth = 200.5", "drive.flexspline_teeth", "whole number",
         "whole number"},
        {"no teeth", "flexspline_teeth = 200", "flexspline_teeth = 0", "drive.flexspline_teeth", "at least 6", "200"},
        {"negative teeth", "flexspline_teeth = 200", "flexspline_teeth = -200", "drive.flexspline_teeth", "at least 6",
         "200"},
        {"absurd teeth", "flexspline_teeth = 200", "flexspline_teeth = 2000000000", "drive.flexspline_teeth", "at most",
         "200"},
        {"teeth beyond int", "flexspline_teeth = 200", "flexspline_teeth = 9223372036854775807",
         "drive.flexspline_teeth", "at most", "200"},
        {"infinite teeth", "flexspline_teeth = 200", "flexspline_teeth = inf", "drive.flexspline_teeth", "finite",
         "200"},
        {"equal tooth numbers", "circular_spline_teeth = 202", "circular_spline_teeth = 200",
         "drive.circular_spline_teeth", "positive multiple", "write 202"},
        {"far more teeth outside", "circular_spline_teeth = 202", "circular_spline_teeth = 99998",
         "drive.circular_spline_teeth", "by 49899 teeth", "write 202"},
        {"fewer teeth outside", "circular_spline_teeth = 202", "circular_spline_teeth = 198",
         "drive.circular_spline_teeth", "positive multiple", "write 202"},
        {"odd difference", "circular_spline_teeth = 202", "circular_spline_teeth = 203", "drive.circular_spline_teeth",
         "multiple of waves", "write 202"},
        {"no waves", "waves = 2", "waves = 0", "wave_generator.waves", "at least 1", "from 1 to 3"},
        {"four waves", "waves = 2", "waves = 4", "wave_generator.waves", "at most 3", "from 1 to 3"},
        {"three waves, two teeth", "waves = 2", "waves = 3", "drive.circular_spline_teeth", "multiple of waves",
         "write wave_generator.waves = 2, or here 203"},
        {"negative threads", "threads = 0", "threads = -1", "solver.threads", "at least 0", "threads = 0"},
        {"too many threads", "threads = 0", "threads = 1025", "solver.threads", "at most 1024", "1024"},
        // lengths
        {"nan", "module = 0.25", "module = nan", "drive.module", "finite", "module = 0.25"},
        {"infinity", "module = 0.25", "module = -inf", "drive.module", "finite", "module = 0.25"},
        {"zero module", "module = 0.25", "module = 0", "drive.module", "above 0", "module = 0.25"},
        {"negative module", "module = 0.25", "module = -0.25", "drive.module", "above 0", "module = 0.25"},
        {"module in metres", "module = 0.25", "module = 2.5e-7", "drive.module", "at least 0.0001", "module = 0.25"},
        {"absurd module", "module = 0.25", "module = 1e300", "drive.module", "larger than any drive", "module = 0.25"},
        {"zero wall", "wall = 0.7", "wall = 0.0", "flexspline.wall", "above 0", "wall = 0.7"},
        {"negative wall", "wall = 0.7", "wall = -0.7", "flexspline.wall", "above 0", "wall = 0.7"},
        {"denormal wall", "wall = 0.7", "wall = 1e-310", "flexspline.wall", "smaller than any length", "wall = 0.7"},
        {"wall without a hole", "wall = 0.7", "wall = 24.9", "flexspline.wall", "leaves no hole", "thinner"},
        {"nan in a family key", "addendum = 0.2250", "addendum = nan", "flexspline.profile.addendum", "finite",
         "length"},
        {"negative addendum", "addendum = 0.2250", "addendum = -0.2250", "flexspline.profile.addendum", "above 0",
         "length"},
        {"zero radius", "convex_radius = 0.2701", "convex_radius = 0", "flexspline.profile.convex_radius", "above 0",
         "length"},
        {"negative deformation", "radial_deformation = 0.25", "radial_deformation = -0.25",
         "wave_generator.radial_deformation", "above 0", "length"},
        {"hollow neutral curve", "radial_deformation = 0.25", "radial_deformation = 25",
         "wave_generator.radial_deformation", "hollow", "write less than 5"},
        {"negative backlash", "backlash_offset = 0.0", "backlash_offset = -0.01", "circular_spline.backlash_offset",
         "must be at least 0", "a length in mm, or \"auto\""},
        {"backlash above the module", "backlash_offset = 0.0", "backlash_offset = 0.3",
         "circular_spline.backlash_offset", "leaves no tooth", "module"},
        {"negative root clearance", "root_clearance = 0.0", "root_clearance = -1e-9", "circular_spline.root_clearance",
         "not be negative", "0 or more"},
        {"zero width", "width = 7.0", "width = 0", "circular_spline.width", "above 0", "width = 7.0"},
        {"absurd width", "width = 7.0", "width = 1e9", "circular_spline.width", "larger than any drive", "width = 7.0"},
        {"zero tolerance", "tolerance = 1e-6", "tolerance = 0", "solver.tolerance", "above 0", "1e-6"},
        {"tolerance below rounding", "tolerance = 1e-6", "tolerance = 1e-13", "solver.tolerance", "at least", "1e-6"},
        {"tolerance above the module", "tolerance = 1e-6", "tolerance = 0.1", "solver.tolerance", "tenth of the module",
         "at most 0.025"},
        {"tolerance nan", "tolerance = 1e-6", "tolerance = nan", "solver.tolerance", "finite", "1e-6"},
        // words
        {"unknown kinematics", "kinematics = \"exact\"", "kinematics = \"second-order\"", "solver.kinematics",
         "unknown word", "\"exact\", \"first-order\" or \"material\""},
        {"misspelt kinematics", "kinematics = \"exact\"", "kinematics = \"first_order\"", "solver.kinematics",
         "unknown word", "write \"first-order\""},
        {"unfinished kinematics", "kinematics = \"exact\"", "kinematics = \"materia\"", "solver.kinematics",
         "unknown word", "write \"material\""},
        {"capital in a word", "kinematics = \"exact\"", "kinematics = \"Exact\"", "solver.kinematics", "unknown word",
         "write \"exact\""},
        {"empty word", "kinematics = \"exact\"", "kinematics = \"\"", "solver.kinematics", "unknown word", "\"exact\""},
        {"misspelt family", "family = \"double-circular-arc\"", "family = \"double-circular-ark\"",
         "flexspline.profile.family", "unknown word", "write \"double-circular-arc\""},
        {"unknown family", "family = \"cosine\"", "family = \"spiral\"", "wave_generator.family", "unknown word",
         "\"cosine\""},
        {"misspelt word for length", "concave_offset = \"tangent\"", "concave_offset = \"tangant\"",
         "flexspline.profile.concave_offset", "unknown word", "write \"tangent\""},
        {"length in quotes where a word may be", "concave_offset = \"tangent\"", "concave_offset = \"0.68\"",
         "flexspline.profile.concave_offset", "text where", "write 0.68"},
        {"boolean for length or word", "concave_offset = \"tangent\"", "concave_offset = true",
         "flexspline.profile.concave_offset", "true or false", "\"tangent\""},
        // names
        {"misspelt key", "module = 0.25", "modul = 0.25", "drive.modul", "unknown key", "write module"},
        {"letters swapped", "module = 0.25", "moduel = 0.25", "drive.moduel", "unknown key", "write module"},
        {"hyphen for underscore", "flexspline_teeth = 200", "flexspline-teeth = 200", "drive.flexspline-teeth",
         "unknown key", "write flexspline_teeth"},
        {"misspelt family key", "addendum = 0.2250", "adendum = 0.2250", "flexspline.profile.adendum", "unknown key",
         "write addendum"},
        {"misspelt optional key", "tip_line_from = 0.1900", "tip_line = 0.1900", "flexspline.profile.tip_line",
         "unknown key", "write tip_line_from"},
        {"key twice, once misspelt", "module = 0.25", "module = 0.25\nmodul = 0.25", "drive.modul", "unknown key",
         "module is there as well"},
        {"key of another table", "wall = 0.7", "wall = 0.7\nwaves = 2", "flexspline.waves", "another table",
         "wave_generator.waves", 0},
        {"key of another family", "addendum = 0.2250", "addendum = 0.2250\npressure_angle_deg = 20",
         "flexspline.profile.pressure_angle_deg", "unknown key", "family \"straight\""},
        {"unknown key", "wall = 0.7", "wall = 0.7\ncolour = \"blue\"", "flexspline.colour", "unknown key",
         "neutral_offset"},
        {"key above all tables", "[drive]", "colour = \"blue\"\n[drive]", "colour", "unknown key", "drive"},
        {"missing key", "module = 0.25", "", "drive.module", "missing", "module = 0.25"},
        {"missing family key", "addendum = 0.2250", "", "flexspline.profile.addendum", "missing", "addendum = "},
        {"missing family", "family = \"double-circular-arc\"", "", "flexspline.profile.family", "missing",
         "double-circular-arc"},
        {"missing deformation", "radial_deformation = 0.25", "", "wave_generator.radial_deformation", "missing",
         "radial_deformation = "},
        // positions of the neutral layer and the ring
        {"neutral layer outside the wall", "wall = 0.7", "wall = 0.7\nneutral_offset = 0.36",
         "flexspline.neutral_offset", "outside the wall", "0.35"},
        {"inner diameter for radius", "wall = 0.7", "wall = 0.7\ninner_radius = 47.994", "flexspline.inner_radius",
         "about 23.997", "write about that radius"},
        {"negative inner radius", "wall = 0.7", "wall = 0.7\ninner_radius = -1", "flexspline.inner_radius", "above 0",
         "23.997"},
    };
    return rows;
}

std::vector<BadScene> const& wrong_tables()
{
    static std::vector<BadScene> const rows{
        {"misspelt table", "[flexspline]", "[flexsplin]", "flexsplin", "unknown table", "write [flexspline]"},
        {"misspelt sub-table", "[flexspline.profile]", "[flexspline.profil]", "flexspline.profil", "unknown table",
         "[flexspline.profile]"},
        {"misspelt parent of a sub-table", "[flexspline.profile]", "[flexpline.profile]", "flexpline", "unknown table",
         "write [flexspline]"},
        {"sub-table on its own", "[flexspline.profile]", "[profile]", "profile", "unknown table",
         "[flexspline.profile]", 2},
        {"unknown table", "", "[colour]\nred = 1\n", "colour", "unknown table", "known here: drive"},
        {"unknown sub-table", "[wave_generator]", "[wave_generator.ball]\n[wave_generator]", "wave_generator.ball",
         "unknown table", "no sub-tables"},
        {"hyphen in a table's name", "[wave_generator]", "[wave-generator]", "wave-generator", "unknown table",
         "[wave_generator]"},
        {"list of tables", "[drive]", "[[drive]]", "drive", "a list where", "[drive]"},
        {"value for a table", "",
         "[coning]\nmodel = \"linear\"\nbottom_to_middle = 9\n[tilt]\nangle_deg = { deg = 1 }\n", "tilt.angle_deg",
         "a table where", "angle_deg = 0.2"},
        {"effect as a flag", "[drive]", "coning = true\n[drive]", "coning", "a value where the table [coning]",
         "[coning]"},
        {"effect without keys", "", "[coning]\n", "coning.model", "missing", "\"linear\""},
        {"unknown coning model", "", "[coning]\nmodel = \"lineer\"\nbottom_to_middle = 9\n", "coning.model",
         "unknown word", "write \"linear\""},
        {"linear coning without a length", "", "[coning]\nmodel = \"linear\"\n", "coning.bottom_to_middle", "missing",
         "bottom_to_middle = 9"},
        {"cup shorter than its teeth", "", "[coning]\nmodel = \"linear\"\nbottom_to_middle = 3.5\n",
         "coning.bottom_to_middle", "through the cup's bottom", "longer cup"},
        {"negative cup", "", "[coning]\nmodel = \"linear\"\nbottom_to_middle = -9\n", "coning.bottom_to_middle",
         "above 0", "9.0"},
        {"nothing in series", "", "[compliance]\n", "compliance", "nothing yields", "shaft = 60000, in N m/rad"},
        {"shaft that does not hold", "", "[compliance]\nshaft = 0\n", "compliance.shaft", "at least", "60000"},
        {"negative flange", "", "[compliance]\nflange = -2e5\n", "compliance.flange", "at least", "200000"},
        {"body without thickness", "", "[compliance]\nouter_radius = 0\n", "compliance.outer_radius", "above 0",
         "35.0"},
        {"member with a unit", "", "[compliance]\nhub_Nm_per_rad = 1e5\n", "compliance.hub_Nm_per_rad", "unknown key",
         "write hub"},
        {"groove as narrow as the ball", "ring_thickness = 1.2",
         "ring_thickness = 1.2\nballs = 23\nball_diameter = 3\ninner_conformity = 0.5", "bearing.inner_conformity",
         "at least 0.501", "0.52"},
        {"ball without size", "ring_thickness = 1.2", "ring_thickness = 1.2\nballs = 23\nball_diameter = 0",
         "bearing.ball_diameter", "above 0", "3.0"},
        {"negative clearance", "ring_thickness = 1.2", "ring_thickness = 1.2\nclearance = -0.005", "bearing.clearance",
         "", "0.005"},
        {"tilt without angle", "", "[tilt]\nkind = \"radial\"\n", "tilt.angle_deg", "missing", "angle_deg = 0.2"},
        {"tilt of 45 degrees", "", "[tilt]\nangle_deg = 45\n", "tilt.angle_deg", "45 degrees or more",
         "between -45 and 45"},
        {"tilt of -90 degrees", "", "[tilt]\nangle_deg = -90.0\n", "tilt.angle_deg", "45 degrees or more",
         "between -45 and 45"},
        {"tilt nan", "", "[tilt]\nangle_deg = nan\n", "tilt.angle_deg", "finite", "angle_deg = 0.2"},
        {"tilt in rad", "", "[tilt]\nangle = 0.003\n", "tilt.angle", "unknown key", "write angle_deg"},
        {"unknown kind of tilt", "", "[tilt]\nangle_deg = 0.2\nkind = \"axial\"\n", "tilt.kind", "unknown word",
         "\"draft\""},
        {"draft of ruled surfaces", "",
         "[tilt]\nangle_deg = 0.2\nkind = \"draft\"\n[slices]\ncount = 9\nsurface = \"ruled\"\n", "tilt.kind",
         "one outline to offset", "\"radial\""},
        {"draft of many outlines", "",
         "[tilt]\nangle_deg = 0.2\nkind = \"draft\"\n[slices]\ncount = 9\nsurface = \"per-slice\"\n", "tilt.kind",
         "one outline to offset", "\"tilted\""},
        {"tip relief without a place", "", "[tip_relief]\namount = 0.004\n", "tip_relief.from_height", "missing",
         "from_height = 0.1"},
        {"tip relief that adds material", "", "[tip_relief]\namount = -0.004\nfrom_height = 0.1\n", "tip_relief.amount",
         "negative", "amount = 0.004"},
        {"tip relief of another tooth", "", "[tip_relief]\namount = 0.03\nfrom_height = 0.1\n", "tip_relief.amount",
         "more than a tenth of the module", "at most 0.025"},
        {"tip relief above the tip", "", "[tip_relief]\namount = 0.004\nfrom_height = 0.3\n", "tip_relief.from_height",
         "reaches from -0.303 to 0.225 mm", "such as 0.1125"},
        {"flow of the flanks without a pressure", "", "[flow]\n", "flow.pressure", "missing", "pressure = 2700"},
        {"flow pressure of another unit", "", "[flow]\npressure = 2.7e9\n", "flow.pressure", "at most 100000",
         "10 to 100000"},
        {"flow pressure that is a word", "", "[flow]\npressure = \"steel\"\n", "flow.pressure", "number", "2700"},
        {"end reliefs that overlap", "", "[end_relief]\namount = 0.004\nlength = 3.6\n", "end_relief.length",
         "would overlap", "at most 3.5"},
        {"end relief of no length", "", "[end_relief]\namount = 0.004\nlength = 0\n", "end_relief.length", "above 0",
         "length = 2.0"},
        {"end relief of another tooth", "", "[end_relief]\namount = 0.1\nlength = 2\n", "end_relief.amount",
         "more than a tenth of the module", "at most 0.025"},
        {"too few places of teeth", "", "[errors.flexspline]\npitch = [0.001, 0.002]\n", "errors.flexspline.pitch",
         "2 places for 200 teeth", "one number for each tooth"},
        {"places of teeth twice", "[drive]", "[errors.circular_spline]\npitch_deviation = 0.001\npitch = [0]\n[drive]",
         "errors.circular_spline.pitch_deviation", "the list pitch says", "remove one", 2},
        {"large eccentricity", "", "[errors.circular_spline]\neccentricity = 0.03\n",
         "errors.circular_spline.eccentricity", "more than a tenth of the module", "at most 0.025"},
        {"negative pitch deviation", "", "[errors.flexspline]\npitch_deviation = -0.001\n",
         "errors.flexspline.pitch_deviation", "negative", "pitch_deviation = 0.002"},
        {"form of the profile out of order", "", "[errors]\nprofile_form = [[0, 0], [0.1, 0], [0.05, 0], [0.2, 0]]\n",
         "errors.profile_form", "do not grow", "each height once"},
        {"form of the profile with too few rows", "", "[errors]\nprofile_form = [[0, 0], [0.1, 0]]\n",
         "errors.profile_form", "2", "4"},
        {"errors of another ring", "", "[errors.bearing]\neccentricity = 0.001\n", "errors.bearing", "unknown", ""},
        {"profile of the flexspline in two tables", "[drive]",
         "[errors]\nprofile_slope = 0.002\n[errors.flexspline]\nprofile_slope = 0.001\n[drive]",
         "errors.flexspline.profile_slope", "says the same", "remove one"},
        {"form of the circular spline out of order", "",
         "[errors.circular_spline]\nprofile_form = [[0, 0], [0.1, 0], [0.05, 0], [0.2, 0]]\n",
         "errors.circular_spline.profile_form", "do not grow", "each height once"},
        {"steep profile of the circular spline", "", "[errors.circular_spline]\nprofile_slope = -0.03\n",
         "errors.circular_spline.profile_slope", "more than a tenth of the module", "at most 0.025"},
        {"wave generator far from its axis", "", "[errors.wave_generator]\neccentricity = 0.03\n",
         "errors.wave_generator.eccentricity", "more than a tenth of the module", "at most 0.025"},
        {"deviation of the cam beyond a turn", "",
         "[errors.wave_generator]\ncam_deviation = [[0, 0], [90, 0.001], [180, 0], [360, 0]]\n",
         "errors.wave_generator.cam_deviation", "a whole turn or more", "360 degrees"},
        {"deviation of the cam out of order", "",
         "[errors.wave_generator]\ncam_deviation = [[0, 0], [90, 0.001], [80, 0], [270, 0]]\n",
         "errors.wave_generator.cam_deviation", "angles do not grow", "growing order"},
        {"file of the cam that is not there", "", "[errors.wave_generator]\ncam_deviation = \"no.csv\"\n",
         "errors.wave_generator.cam_deviation", "cannot be read", "CSV file"},
        {"no slices", "", "[slices]\ncount = 0\n", "slices.count", "at least 1", "count = 9"},
        {"too many slices", "", "[slices]\ncount = 1001\n", "slices.count", "at most 1000", "1000"},
        {"slices with decimal point", "", "[slices]\ncount = 9.0\n", "slices.count", "decimal point", "write 9"},
        {"unknown surface", "", "[slices]\ncount = 9\nsurface = \"per_slice\"\n", "slices.surface", "unknown word",
         "write \"per-slice\""},
        {"slices without width", "[circular_spline]\nwidth = 7.0", "[slices]\ncount = 9\n[circular_spline]",
         "circular_spline.width", "missing", "width = 7.0"},
    };
    return rows;
}

std::vector<BadScene> const& wrong_geometry()
{
    static std::vector<BadScene> const rows{
        {"arcs that do not meet", "concave_offset = \"tangent\"", "concave_offset = 0.0671",
         "flexspline.profile.concave_offset", "do not meet", "0.683525", 0},
        {"arcs that nearly meet", "concave_offset = \"tangent\"", "concave_offset = 0.671",
         "flexspline.profile.concave_offset", "do not meet", "0.683525", 0},
        {"tip line above the addendum", "tip_line_from = 0.1900", "tip_line_from = 0.2251",
         "flexspline.profile.tip_line_from", "above the tip", "below the addendum", 0},
        {"tooth wider than its pitch", "convex_offset = 0.0982", "convex_offset = -0.2", "flexspline.profile",
         "wider than", "thinner", 0},
        {"tip circle outside the tooth space", "inner_radius = 25.025", "inner_radius = 27.0",
         "circular_spline.inner_radius", "", "write", 0},
        {"outer radius below the root circle", "", "[compliance]\nouter_radius = 25.3\n", "compliance.outer_radius",
         "root circle at", "such as 36", 0},
        {"tip circle inside the flexspline", "inner_radius = 25.025", "inner_radius = 20.0",
         "circular_spline.inner_radius", "", "write", 0},
    };
    return rows;
}

std::vector<BadScene> const& wrong_texts()
{
    static std::vector<BadScene> const rows{
        {"empty", "", "", "scene", "empty", "hdconj init"},
        {"blanks", "", " \n\t\n", "scene", "empty", "hdconj init"},
        {"comments only", "", "# a scene\n# to be\n", "scene", "empty", "hdconj init"},
        {"unit", "", "[flexspline]\nwall = 0.7 mm\n", "wall", "column", "0.7 without a unit"},
        {"decimal comma", "", "[flexspline]\nwall = 0,7\n", "wall", "column", "0.7, with a decimal point"},
        {"word without quotes", "", "[solver]\nkinematics = exact\n", "kinematics", "column",
         "\"exact\", text needs quotes"},
        {"value forgotten", "", "[flexspline]\nwall =\n", "wall", "column", "value after the = sign"},
        {"key twice", "", "[drive]\nmodule = 1\nmodule = 2\n", "module", "stands twice", "keep one"},
        {"table twice", "", "[drive]\nmodule = 1\n[drive]\n", "scene", "stands twice", "keep one"},
        {"bracket forgotten", "", "[drive\nmodule = 1\n", "scene", "bracket ]", "[table]"},
        {"header without a name", "", "# a\n[}rive]\nmodule = 1\n", "scene", "column", "[table]"},
        {"header of a list without a name", "", "[[ ]]\n", "scene", "column", "[table]"},
        {"prose", "", "dear hdconj, please solve this drive\n", "scene", "neither", "key = value"},
        {"string not ended", "", "[drive]\nname = \"type\n", "name", "column", "double quotes"},
        {"number beyond 64 bits", "", "[drive]\nmodule = 99999999999999999999999999\n", "module", "column",
         "key = value"},
        {"json", "", "{\"drive\": {\"module\": 0.25}}\n", "scene", "column", "key = value"},
        {"not UTF-8", "", "[drive]\nname = \"\xff\xfe\xfd\"\n", "name", "utf-8", "UTF-8"},
        {"Latin-1 comment", "", "# gr\xfc\xdf\n[drive]\n", "scene", "utf-8", "UTF-8"},
        {"UTF-16", "", std::string("\xff\xfe[\0d\0]\0", 8), "scene", "UTF-16", "UTF-8"},
        {"binary", "", std::string("\x89HDF\r\n\x1a\n\0\0\0\0", 12), "scene", "binary", "hdconj init"},
        {"nested lists", "", "a = " + std::string(100000, '[') + "\n", "a", "nested", "key = value"},
        {"nested tables in a line", "",
         [] {
             std::string text = "a = ";
             for (int i = 0; i < 5000; ++i) {
                 text += "{a=";
             }
             return text;
         }(),
         "a", "nested", "key = value"},
        {"key with a million dots", "",
         [] {
             std::string text = "a";
             for (int i = 0; i < 1000000; ++i)
                 text += ".a";
             return text + " = 1\n";
         }(),
         "scene", "dots", "flexspline.profile.addendum"},
        {"header with a million dots", "",
         [] {
             std::string text = "[a";
             for (int i = 0; i < 1000000; ++i)
                 text += " . \"a\"";
             return text + "]\n";
         }(),
         "scene", "dots", "flexspline.profile.addendum"},
        {"a million keys", "",
         [] {
             std::string text;
             for (int i = 0; i < 1000000; ++i)
                 text += "k" + std::to_string(i) + "=1\n";
             return text;
         }(),
         "scene", "keys", "hdconj init"},
        {"17 MiB", "", std::string(std::size_t{17} << 20, '#'), "scene", "16 MiB", "hdconj init"},
    };
    return rows;
}

std::string edited(std::string text, BadScene const& row)
{
    if (row.from.empty())
        return text + row.to;
    std::size_t const at = text.find(row.from);
    if (at == std::string::npos)
        throw std::runtime_error("the scene has no '" + row.from + "'");
    return text.replace(at, row.from.size(), row.to);
}

std::string edited(BadScene const& row)
{
    return edited(std::string(builtin_scene_text()), row);
}

}  // namespace hdconj::test
