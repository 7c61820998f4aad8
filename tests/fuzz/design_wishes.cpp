// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "design/mesh_search.hpp"
#include "design/wall_search.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/read_scene.hpp"
#include "refusal.hpp"
#include "targets.hpp"

namespace hdconj::fuzz {
namespace {

/// Lines "wish value"; a wish that nobody knows is passed over.
DesignWishes wishes_of(std::string const& text)
{
    DesignWishes wishes;
    std::istringstream lines(text);
    for (std::string wish, value; lines >> wish >> value;) {
        double const number = std::strtod(value.c_str(), nullptr);
        if (wish == "ratio")
            wishes.ratio = number;
        else if (wish == "diameter")
            wishes.diameter = number;
        else if (wish == "module")
            wishes.module = number;
        else if (wish == "length-ratio")
            wishes.length_ratio = number;
        else if (wish == "torque")
            wishes.torque = number;
        else if (wish == "family")
            wishes.family = value;
        else if (wish == "material")
            wishes.material = value;
        else if (wish == "fatigue")
            wishes.fatigue = number;
        else if (wish == "youngs-modulus")
            wishes.youngs_modulus = number;
        else if (wish == "poissons-ratio")
            wishes.poissons_ratio = number;
        else if (wish == "clearance")
            wishes.clearance = number;
    }
    return wishes;
}

/// All that a design needs but for the searches: rows, a scene of them, its text read back.
void check_rows(DesignWishes const& wishes)
{
    constexpr double wall = 0.014;  // over the pitch diameter
    Design design;
    design.wishes = wishes;
    design::Sheet const sheet = design::sheet_of(wishes, wall);
    design.rows = sheet.rows();
    for (auto const& row : design::mesh_rows(sheet, wishes, 1, sheet["d_r"] / 2))
        design.rows.push_back(row);
    for (auto const& row : design.rows)
        if (std::holds_alternative<double>(row.value) && !std::isfinite(row.number()))
            throw Find("a dimension that is no number: " + row.name);
    if (!accepted([&] { design.scene = design::scene_of(design.rows); })) {
        if (wishes.clearance > 0)  // may be wider than the space between two teeth, which the search refuses
            return;
        throw Find("wishes without a fault make a scene with faults");
    }
    if (!differences(design, parse_scene(scene_text(design), "designed")).empty())
        throw Find("the scene read back is another one");
}

}  // namespace

void design_wishes(Bytes input)
{
    DesignWishes const wishes = wishes_of(std::string(text_of(input)));
    Faults const faults = check_design(wishes);
    validate_faults(faults);
    if (faults.empty())
        check_rows(wishes);
}

}  // namespace hdconj::fuzz
