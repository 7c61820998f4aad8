// SPDX-License-Identifier: GPL-3.0-or-later
// Responses that are kept for other drives: found by exact values, computed once, the same bits as without.
#include "elastic/kept_results.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include "elastic/bent_cup.hpp"
#include "hdconj/elastic_cup.hpp"
#include "support/catch.hpp"

namespace hdconj::test::kept_results_cases {

namespace {

/// Keeps responses while it lives.
struct Keeping
{
    explicit Keeping(std::size_t count) { keep_elastic_bodies(count); }
    ~Keeping() { keep_elastic_bodies(0); }
    Keeping(Keeping const&) = delete;
    Keeping& operator=(Keeping const&) = delete;
};

std::shared_ptr<elastic::UnitFields const> fields_of(elastic::CupSection const& section, double z, int highest = 4,
                                                     elastic::Quadrature quadrature = elastic::Quadrature::reduced)
{
    elastic::FourierSolid const solid(elastic::section_mesh(section), quadrature);
    std::vector<elastic::Station> const stations{
        elastic::wall_station(solid.mesh(), z, 0.5, elastic::Direction::radial)};
    return elastic::unit_fields(solid, {}, stations, elastic::harmonics_of(2, highest));
}

elastic::BearingSurface surface_of(double thickness)
{
    elastic::Bearing bearing;
    bearing.ring.emplace();
    bearing.ring->thickness = thickness;
    elastic::CamSeries const cam = elastic::cam_series({0.25, 0.1, -0.25, -0.1, 0.2, 0.0, -0.2, 0.1}, 2, false);
    return elastic::bearing_surface(bearing, 24, cam, elastic::bearing_circles(bearing, 3));
}

bool are_same(elastic::BearingSurface const& a, elastic::BearingSurface const& b)
{
    return a.cosine == b.cosine && a.sine == b.sine && a.reaction_cosine == b.reaction_cosine &&
           a.reaction_sine == b.reaction_sine && a.reaction_to_lift == b.reaction_to_lift &&
           a.reaction_to_load == b.reaction_to_load && a.compliance->compliance(1) == b.compliance->compliance(1);
}

}  // namespace

TEST_CASE("unit fields of the same body are computed once", "[kept_results]")
{
    elastic::CupSection const section;
    auto const alone = fields_of(section, 9);
    CHECK(fields_of(section, 9) != alone);  // nothing is kept before it is asked for
    Keeping const keeping(3);
    std::size_t const computed = elastic_body_count().computed, reused = elastic_body_count().reused;
    auto const first = fields_of(section, 9);
    CHECK(first->moved == alone->moved);
    CHECK(fields_of(section, 9) == first);
    CHECK(elastic_body_count().computed == computed + 1);
    CHECK(elastic_body_count().reused == reused + 1);
}

TEST_CASE("unit fields are found by exact values only", "[kept_results]")
{
    Keeping const keeping(10);
    elastic::CupSection const section;
    auto const first = fields_of(section, 9);
    elastic::CupSection other = section;
    other.length = std::nextafter(section.length, 100.0);
    CHECK(fields_of(other, 9) != first);
    other = section;
    other.material.poissons_ratio = 0.29;
    CHECK(fields_of(other, 9) != first);
    other = section;
    other.tooth_layer = 0.5;
    auto const toothed = fields_of(other, 9);
    CHECK(toothed != first);
    other.tooth_share = 0.4;
    CHECK(fields_of(other, 9) != toothed);
    CHECK(fields_of(section, std::nextafter(9.0, 10.0)) != first);
    CHECK(fields_of(section, 9, 6) != first);
    CHECK(fields_of(section, 9, 4, elastic::Quadrature::full) != first);
    CHECK(fields_of(section, 9) == first);
}

TEST_CASE("the body that was asked for longest ago is dropped", "[kept_results]")
{
    Keeping const keeping(2);
    elastic::CupSection const section;
    auto const first = fields_of(section, 8), second = fields_of(section, 9);
    CHECK(fields_of(section, 8) == first);
    CHECK(fields_of(section, 10) != second);  // in the place of the second
    CHECK(fields_of(section, 8) == first);
    CHECK(fields_of(section, 9) != second);
}

TEST_CASE("a bearing whose ring is kept has the same bits", "[kept_results]")
{
    elastic::BearingSurface const thin = surface_of(1.2), thick = surface_of(1.5);
    CHECK_FALSE(are_same(thin, thick));
    Keeping const keeping(2);
    CHECK(are_same(surface_of(1.2), thin));
    std::size_t const computed = elastic_body_count().computed;
    CHECK(are_same(surface_of(1.2), thin));
    CHECK(elastic_body_count().computed == computed);
    CHECK(are_same(surface_of(1.5), thick));
    CHECK(elastic_body_count().computed == computed + 1);
}

TEST_CASE("a cup on the same bearing and cam is computed once", "[kept_results]")
{
    elastic::CupSection const section;
    elastic::Bearing bearing;
    bearing.ring.emplace();
    elastic::CamSeries const cam = elastic::cam_series({0.25, 0.1, -0.25, -0.1, 0.2, 0.0, -0.2, 0.1}, 2, false);
    elastic::CamSeries larger = cam;
    larger.cosine[1] += 1e-3;
    elastic::BentCupGrid const grid{8, 3};
    auto const alone = elastic::solved_cup(section, bearing, cam, grid, 1);
    Keeping const keeping(3);
    auto const first = elastic::solved_cup(section, bearing, cam, grid, 1);
    CHECK(first->field().even == alone->field().even);
    CHECK(elastic::solved_cup(section, bearing, cam, grid, 1) == first);
    CHECK(elastic::solved_cup(section, bearing, larger, grid, 1) != first);
    bearing.fit = 1e-3;
    CHECK(elastic::solved_cup(section, bearing, cam, grid, 1) != first);
}

}  // namespace hdconj::test::kept_results_cases
