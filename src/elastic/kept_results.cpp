// SPDX-License-Identifier: GPL-3.0-or-later
#include "kept_results.hpp"

#include <atomic>

#include "hdconj/elastic_cup.hpp"

namespace hdconj {
namespace {

std::atomic<std::size_t> most{0}, computed{0}, reused{0};

}  // namespace

void keep_elastic_bodies(std::size_t count)
{
    most = count;
}

ElasticBodyCount elastic_body_count()
{
    return {computed, reused};
}

namespace elastic {

std::size_t most_kept()
{
    return most;
}

void count_result(bool is_reused)
{
    ++(is_reused ? reused : computed);
}

void Dependencies::add(Vec2 const& point)
{
    add(point.x());
    add(point.y());
}

void Dependencies::add(QuadraticElement const& element)
{
    for (int const node : element)
        add(node);
}

void Dependencies::add(Elasticity const& material)
{
    add(material.youngs_modulus);
    add(material.poissons_ratio);
}

void Dependencies::add(SectionMesh const& mesh)
{
    add(mesh.nodes);
    add(mesh.elements);
    add(mesh.layers);
    add(mesh.straight);
    add(mesh.clamped);
    add(mesh.material);
    add(mesh.wall_elements());
    if (mesh.outer)
        for (Eigen::Index i = 0; i < mesh.outer->stress.size(); ++i)
            add(mesh.outer->stress.data()[i]);
}

void Dependencies::add(FourierSolid const& solid)
{
    add(solid.mesh());
    add(solid.quadrature());
}

void Dependencies::add(Station const& station)
{
    add(station.place.element);
    add(station.place.xi);
    add(station.place.eta);
    add(station.direction);
}

void Dependencies::add(Support const& support)
{
    add(support.node);
    add(support.direction);
    add(support.stiffness);
    add(support.last_harmonic);
}

void Dependencies::add(CupSection const& section)
{
    static_assert(sizeof(CupSection) == 15 * sizeof(double) + sizeof(Elasticity), "every member belongs here");
    for (double const length :
         {section.inner_radius, section.length, section.wall, section.ring_wall, section.ring_begin, section.ring_end,
          section.rear_ramp, section.front_ramp, section.rear_fillet, section.front_fillet, section.tooth_layer,
          section.tooth_share, section.bottom, section.corner_radius, section.clamp_radius})
        add(length);
    add(section.material);
}

void Dependencies::add(Bearing const& bearing)
{
    static_assert(sizeof(Bearing) == 4 * sizeof(double) + sizeof(std::optional<BearingRing>) &&
                      sizeof(BearingRing) == 2 * sizeof(double) + sizeof(std::optional<double>) + sizeof(Elasticity),
                  "every member belongs here");
    for (double const length : {bearing.middle, bearing.width, bearing.fit, bearing.cam_oversize})
        add(length);
    add(bearing.ring.has_value());
    if (bearing.ring) {
        add(bearing.ring->thickness);
        add(bearing.ring->axially_held);
        add(bearing.ring->radial_stiffness);
        add(bearing.ring->material);
    }
}

void Dependencies::add(CamSeries const& cam)
{
    add(cam.waves);
    add(cam.even);
    add(cam.cosine);
    add(cam.sine);
}

}  // namespace elastic
}  // namespace hdconj
