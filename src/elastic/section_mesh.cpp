// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/elastic/section_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "hdconj/numeric/error.hpp"

namespace hdconj {
namespace {

/// A line across the wall.
struct Across
{
    Vec2 inner;
    Vec2 outer;
};

[[noreturn]] void refuse(std::string const& what, std::string const& cause)
{
    throw NumericalError("elastic cup", what, cause);
}

void require(bool good, std::string const& what, std::string const& cause)
{
    if (!good)
        refuse(what, cause);
}

std::string mm(double length)
{
    return std::to_string(length) + " mm";
}

/// Lines at both ends and in the middle of each element, from the first to the last.
class Rows
{
  public:
    /// @param at  line at s in [0, 1]
    void add(double length, double longest, std::function<Across(double)> const& at)
    {
        constexpr double rounding = 1e-9;  // 8 mm in steps of 0.5 mm are 16
        constexpr double most = 10000;
        if (length <= 0)
            return;
        double const wanted = std::ceil(length / longest - rounding);
        require(wanted <= most, "mesh", "more than 10000 elements along one part of the section: the mesh is too fine for its length");
        int const count = std::max(1, static_cast<int>(wanted));
        if (lines_.empty())
            lines_.push_back(at(0));
        for (int i = 1; i <= 2 * count; ++i)
            lines_.push_back(at(i / (2.0 * count)));
    }

    void mark_straight() { straight_ = static_cast<int>(lines_.size() / 2); }

    [[nodiscard]] SectionMesh mesh(Elasticity const& material, double thickest) const
    {
        constexpr double rounding = 1e-9;  // a wall of 1 mm is one element of 1 mm
        constexpr double most_layers = 200;
        double wall = 0;
        for (Across const& line : lines_)
            wall = std::max(wall, (line.outer - line.inner).norm());
        double const wanted = std::ceil(wall / thickest - rounding);
        require(wanted <= most_layers, "mesh", "more than 200 elements across the wall: the mesh is too fine for its thickness");
        SectionMesh mesh;
        mesh.material = material;
        mesh.straight = straight_;
        mesh.layers = std::max(1, static_cast<int>(wanted));
        int const layers = mesh.layers;
        // lines between elements have corners and middles, those through their middles corners only
        for (std::size_t i = 0; i < lines_.size(); ++i)
        {
            int const steps = i % 2 == 0 ? 2 * layers : layers;
            for (int j = 0; j <= steps; ++j)
                mesh.nodes.push_back(lines_[i].inner + (lines_[i].outer - lines_[i].inner) * (static_cast<double>(j) / steps));
        }
        int const between = 2 * layers + 1, row = between + layers + 1;
        int const rows = static_cast<int>(lines_.size() / 2);
        for (int i = 0; i < rows; ++i)
        {
            int const first = i * row, middle = first + between, next = first + row;
            for (int j = 0; j < layers; ++j)
                mesh.elements.push_back({first + 2 * j, first + 2 * j + 2, next + 2 * j + 2, next + 2 * j, first + 2 * j + 1, middle + j + 1,
                                         next + 2 * j + 1, middle + j});
        }
        return mesh;
    }

    /// Nodes on the first line.
    [[nodiscard]] static int first_line(SectionMesh const& mesh) { return 2 * mesh.layers + 1; }

  private:
    std::vector<Across> lines_;
    int straight_ = 0;
};

void require_sound(Elasticity const& material)
{
    require(material.youngs_modulus > 0 && std::isfinite(material.youngs_modulus), "Young's modulus", "must be positive and finite");
    require(material.poissons_ratio >= 0 && material.poissons_ratio < 0.5, "Poisson's ratio",
            "must be from 0 to below 0.5: at 0.5 the material keeps its volume, which these elements cannot express");
}

void require_sound(MeshSize const& size)
{
    require(size.along > 0 && size.across > 0, "mesh", "element sizes must be positive");
}

/// How long a change of the wall is: a ramp, or an arc of radius @p fillet.
double change_length(double ramp, double fillet, double thin, double thick)
{
    return fillet > 0 ? std::sqrt(std::max(0.0, (thick - thin) * (2 * fillet - thick + thin))) : ramp;
}

double rear_length(CupSection const& cup)
{
    return change_length(cup.rear_ramp, cup.rear_fillet, cup.wall, cup.ring_wall);
}

double front_length(CupSection const& cup)
{
    return change_length(cup.front_ramp, cup.front_fillet, cup.wall, cup.ring_wall);
}

void require_sound(CupSection const& cup)
{
    for (double const fillet : {cup.rear_fillet, cup.front_fillet})
    {
        require(fillet >= 0, "fillet at the tooth ring", "its radius must not be negative");
        require(fillet == 0 || cup.ring_wall >= cup.wall, "fillet at the tooth ring", "the ring is thinner than the wall beside it: there is nothing to round");
        require(fillet == 0 || fillet >= cup.ring_wall - cup.wall, "fillet at the tooth ring",
                "its radius " + mm(fillet) + " is less than the wall grows by, " + mm(cup.ring_wall - cup.wall));
    }
    require(cup.wall > 0 && cup.ring_wall > 0 && cup.bottom > 0, "walls", "must be thicker than 0");
    require(cup.clamp_radius > 0, "flange", "must have a radius above 0");
    require(cup.rear_ramp >= 0 && cup.front_ramp >= 0, "ramps", "must not be negative");
    require(cup.corner_radius > std::max(cup.wall, cup.bottom), "corner at the bottom",
            "its outer radius " + mm(cup.corner_radius) + " must be larger than the walls that meet there, " + mm(cup.wall) + " and " + mm(cup.bottom));
    double const fillet = cup.inner_radius + cup.wall - cup.corner_radius;
    require(cup.clamp_radius < fillet, "flange",
            "its radius " + mm(cup.clamp_radius) + " reaches the corner fillet, which begins at " + mm(fillet));
    require(cup.ring_begin - rear_length(cup) > cup.corner_radius, "tooth ring",
            "its rear ramp begins at " + mm(cup.ring_begin - rear_length(cup)) + ", inside the corner fillet of " + mm(cup.corner_radius));
    require(cup.tooth_layer >= 0 && std::isfinite(cup.tooth_layer), "layer of teeth", "must not be of negative height");
    require(cup.tooth_share > 0 && cup.tooth_share <= 1, "layer of teeth", "its share of steel must be above 0 and at most 1");
    require(cup.ring_end > cup.ring_begin, "tooth ring", "must end in front of where it begins");
    require(cup.length >= cup.ring_end, "tooth ring", "ends at " + mm(cup.ring_end) + ", beyond the cup's length of " + mm(cup.length));
    bool const has_step = cup.wall != cup.ring_wall;
    require(!has_step || rear_length(cup) > 0, "rear ramp", "must be longer than 0 where the wall changes");
    require(!has_step || cup.length == cup.ring_end || front_length(cup) > 0, "front ramp", "must be longer than 0 where the wall changes");
    require(cup.length == cup.ring_end || cup.length >= cup.ring_end + front_length(cup), "front ramp",
            "ends at " + mm(cup.ring_end + front_length(cup)) + ", beyond the cup's length of " + mm(cup.length));
}

}  // namespace

SectionMesh section_mesh(CupSection const& cup, MeshSize const& size)
{
    require_sound(cup.material);
    require_sound(size);
    require_sound(cup);
    double const r = cup.inner_radius;
    double const fillet = r + cup.wall - cup.corner_radius;
    Rows rows;
    rows.add(fillet - cup.clamp_radius, 2 * size.along, [&](double s) {
        double const at = cup.clamp_radius + (fillet - cup.clamp_radius) * s;
        return Across{{at, cup.bottom}, {at, 0}};
    });
    double const quarter = std::numbers::pi / 2;
    rows.add(quarter * (cup.corner_radius - cup.wall / 2), 1.5 * size.along, [&](double s) {
        Vec2 const centre(fillet, cup.corner_radius);
        Vec2 const out(std::sin(quarter * s), -std::cos(quarter * s));
        double const wall = cup.bottom + (cup.wall - cup.bottom) * s;
        return Across{centre + (cup.corner_radius - wall) * out, centre + cup.corner_radius * out};
    });
    rows.mark_straight();
    auto const part = [&](double from, double to, double wall_from, double wall_to) {
        rows.add(to - from, wall_from == wall_to ? 1.1 * size.along : size.along, [&](double s) {
            double const z = from + (to - from) * s;
            return Across{{r, z}, {r + wall_from + (wall_to - wall_from) * s, z}};
        });
    };
    // from the foot of an arc upward, or towards it from above
    auto const rounded = [&](double foot, double radius, bool upward) {
        constexpr double arc_rows = 3;  // at least: bending of a wall whose thickness curves
        double const angle = std::acos(std::max(0.0, 1 - (cup.ring_wall - cup.wall) / radius));
        rows.add(angle * radius, std::min(size.along, angle * radius / arc_rows), [&, foot, radius, upward, angle](double s) {
            double const a = angle * (upward ? s : 1 - s);
            double const z = foot + (upward ? 1 : -1) * radius * std::sin(a);
            return Across{{r, z}, {r + cup.wall + radius * (1 - std::cos(a)), z}};
        });
    };
    double const rear = cup.ring_begin - rear_length(cup), front = cup.ring_end + front_length(cup);
    part(cup.corner_radius, rear, cup.wall, cup.wall);
    if (cup.rear_fillet > 0)
        rounded(rear, cup.rear_fillet, true);
    else
        part(rear, cup.ring_begin, cup.wall, cup.ring_wall);
    rows.add(cup.ring_end - cup.ring_begin, size.along, [&](double s) {
        double const z = cup.ring_begin + (cup.ring_end - cup.ring_begin) * s;
        return Across{{r, z}, {r + cup.ring_wall, z}};
    });
    if (cup.length > cup.ring_end)
    {
        if (cup.front_fillet > 0)
            rounded(front, cup.front_fillet, false);
        else
            part(cup.ring_end, front, cup.ring_wall, cup.wall);
        part(front, cup.length, cup.wall, cup.wall);
    }
    SectionMesh mesh = rows.mesh(cup.material, size.across);
    for (int i = 0; i < Rows::first_line(mesh); ++i)
        mesh.clamped.push_back(i);
    if (cup.tooth_layer > 0)
        add_outer_layer(mesh, cup.ring_begin, cup.ring_end, cup.tooth_layer, size.across, tooth_stress_matrix(cup.material, cup.tooth_share));
    return mesh;
}

void add_outer_layer(SectionMesh& mesh, double low, double high, double height, double thickest, StressMatrix const& stress)
{
    constexpr double rounding = 1e-9;  // of heights that were divided and added up again
    require(height > 0 && std::isfinite(height), "layer of teeth", "its height must be above 0");
    auto const layers = static_cast<std::size_t>(mesh.layers);
    std::size_t const rows = mesh.elements.size() / layers;
    auto const at = [&](int node) { return mesh.nodes[static_cast<std::size_t>(node)]; };
    // nodes on which the next elements stand, line by line of the rows: below, in the middle of and above each
    std::vector<int> base;
    for (auto row = static_cast<std::size_t>(mesh.straight); row < rows; ++row)
    {
        QuadraticElement const& q = mesh.elements[row * layers + layers - 1];
        if (at(q[1]).y() < low - rounding || at(q[2]).y() > high + rounding)
            continue;
        if (base.empty())
            base.push_back(q[1]);
        base.push_back(q[5]);
        base.push_back(q[2]);
    }
    require(!base.empty(), "layer of teeth", "no wall between " + mm(low) + " and " + mm(high) + " to stand on");
    mesh.outer = OuterLayer{mesh.elements.size(), stress};
    int const steps = std::max(1, static_cast<int>(std::ceil(height / thickest - rounding)));
    for (int step = 0; step < steps; ++step)
    {
        std::vector<int> top;
        std::vector<int> between;  // of lines between elements only
        for (std::size_t i = 0; i < base.size(); ++i)
        {
            Vec2 const foot = at(base[i]);
            Vec2 const out(height / steps, 0);
            if (i % 2 == 0)
            {
                between.push_back(static_cast<int>(mesh.nodes.size()));
                mesh.nodes.push_back(foot + out / 2);
            }
            top.push_back(static_cast<int>(mesh.nodes.size()));
            mesh.nodes.push_back(foot + out);
        }
        for (std::size_t i = 0; i + 2 < base.size(); i += 2)
            mesh.elements.push_back({base[i], top[i], top[i + 2], base[i + 2], between[i / 2], top[i + 1], between[i / 2 + 1], base[i + 1]});
        base = std::move(top);
    }
}

SectionMesh ring_mesh(Vec2 const& lower, Vec2 const& upper, Elasticity const& material, MeshSize const& size)
{
    require_sound(material);
    require_sound(size);
    require(lower.x() > 0 && upper.x() > lower.x() && upper.y() > lower.y(), "ring", "its section is empty or reaches the axis");
    Rows rows;
    rows.add(upper.y() - lower.y(), size.along, [&](double s) {
        double const z = lower.y() + (upper.y() - lower.y()) * s;
        return Across{{lower.x(), z}, {upper.x(), z}};
    });
    return rows.mesh(material, size.across);
}

std::array<double, 8> shape_functions(double x, double y)
{
    return {(1 - x) * (1 - y) * (-x - y - 1) / 4, (1 + x) * (1 - y) * (x - y - 1) / 4, (1 + x) * (1 + y) * (x + y - 1) / 4,
            (1 - x) * (1 + y) * (-x + y - 1) / 4, (1 - x * x) * (1 - y) / 2,           (1 + x) * (1 - y * y) / 2,
            (1 - x * x) * (1 + y) / 2,            (1 - x) * (1 - y * y) / 2};
}

std::array<Vec2, 8> shape_slopes(double x, double y)
{
    return {Vec2((1 - y) * (2 * x + y) / 4, (1 - x) * (x + 2 * y) / 4),  Vec2((1 - y) * (2 * x - y) / 4, (1 + x) * (2 * y - x) / 4),
            Vec2((1 + y) * (2 * x + y) / 4, (1 + x) * (x + 2 * y) / 4),  Vec2((1 + y) * (2 * x - y) / 4, (1 - x) * (2 * y - x) / 4),
            Vec2(-x * (1 - y), -(1 - x * x) / 2),                        Vec2((1 - y * y) / 2, -y * (1 + x)),
            Vec2(-x * (1 + y), (1 - x * x) / 2),                         Vec2(-(1 - y * y) / 2, -y * (1 - x))};
}

Vec2 position(SectionMesh const& mesh, SectionPoint const& point)
{
    auto const n = shape_functions(point.xi, point.eta);
    QuadraticElement const& element = mesh.elements[point.element];
    Vec2 at = Vec2::Zero();
    for (std::size_t a = 0; a < n.size(); ++a)
        at += n[a] * mesh.nodes[static_cast<std::size_t>(element[a])];
    return at;
}

SectionPoint wall_point(SectionMesh const& mesh, double z, double depth)
{
    require(depth >= 0 && depth <= 1, "place in the wall", "its depth must be from 0 (inner surface) to 1 (outer surface)");
    auto const layers = static_cast<std::size_t>(mesh.layers);
    std::size_t const rows = mesh.wall_elements() / layers;
    auto const height = [&](std::size_t row, int corner) {
        return mesh.nodes[static_cast<std::size_t>(mesh.elements[row * layers][static_cast<std::size_t>(corner)])].y();
    };
    auto const first = static_cast<std::size_t>(mesh.straight);
    double const low = height(first, 0), high = height(rows - 1, 3);
    constexpr double rounding = 1e-12;  // of heights that were divided and added up again
    double const slack = (high - low) * rounding;
    require(z >= low - slack && z <= high + slack, "z = " + mm(z), "is outside the straight wall, which reaches from " + mm(low) + " to " + mm(high));
    std::size_t row = first;
    while (row + 1 < rows && z > height(row, 3))
        ++row;
    double const bottom = height(row, 0), top = height(row, 3);
    double const across = depth * static_cast<double>(layers);
    std::size_t const layer = std::min(layers - 1, static_cast<std::size_t>(across));
    return {row * layers + layer, 2 * (across - static_cast<double>(layer)) - 1, std::clamp(2 * (z - bottom) / (top - bottom) - 1, -1.0, 1.0)};
}

}  // namespace hdconj
