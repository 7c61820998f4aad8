// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "hdconj/error.hpp"
#include "kept_results.hpp"

namespace hdconj::elastic {
namespace {

int nearest_node(SectionMesh const& mesh, Vec2 const& to)
{
    auto const nearest = std::min_element(mesh.nodes.begin(), mesh.nodes.end(), [&](Vec2 const& a, Vec2 const& b) {
        return (a - to).squaredNorm() < (b - to).squaredNorm();
    });
    return static_cast<int>(nearest - mesh.nodes.begin());
}

void require_sound(Bearing const& bearing)
{
    if (!(bearing.width >= 0) || !std::isfinite(bearing.width))
        refuse_bearing("width", "must be 0 or more");
    if (!std::isfinite(bearing.fit) || !std::isfinite(bearing.cam_oversize))
        refuse_bearing("fit", "must be finite, and so must the cam's oversize");
    if (!bearing.ring)
        return;
    if (bearing.width <= 0)
        refuse_bearing("width", "an elastic outer ring has a width above 0");
    if (!(bearing.ring->thickness > 0))
        refuse_bearing("outer ring", "must be thicker than 0");
    if (bearing.ring->radial_stiffness && !(*bearing.ring->radial_stiffness > 0))
        refuse_bearing("radial stiffness of the balls", "must be above 0");
}

/// What the outer ring does in one harmonic, whatever the cam: under 1 N/rad on each circle of its surface, and where
/// the cam lifts the line of balls by 1 mm.
struct RingResponse
{
    Eigen::MatrixXd compliance;           ///< between the circles [mm/(N/rad)]
    Eigen::VectorXd rise;                 ///< of the circles for 1 mm of the cam
    double reaction;                      ///< of the line of balls for 1 mm of the cam [N/rad]
    Eigen::RowVectorXd reaction_to_load;  ///< for a load on each circle
};

/// @param supports  the first holds the line of balls radially
std::shared_ptr<std::vector<RingResponse> const> ring_responses(FourierSolid const& solid, Supports const& supports,
                                                                std::vector<Station> const& stations,
                                                                std::vector<int> const& harmonics, int threads)
{
    auto const depends_on = [&](Dependencies& dependencies) {
        dependencies.add(solid);
        dependencies.add(supports);
        dependencies.add(stations);
        dependencies.add(harmonics);
    };
    return kept_or_made<std::vector<RingResponse>>(depends_on, [&] {
        Eigen::MatrixXd const shares = station_shares(solid, stations);
        Eigen::Index const ball = unknown_of(supports.front().node, Direction::radial);
        double const spring = supports.front().stiffness;
        std::vector<RingResponse> result(harmonics.size());
        for_each_harmonic(solid, supports, harmonics, threads, [&](std::size_t i, HarmonicSolver const& solver) {
            Eigen::MatrixXd const loaded = solver(shares);
            Eigen::MatrixXd const c = shares.transpose() * loaded;
            Eigen::VectorXd lift = Eigen::VectorXd::Zero(solid.unknowns());
            lift[ball] = spring < 0 ? 1 : spring;
            Eigen::VectorXd const lifted = spring < 0 ? solver.moved(lift) : solver(lift);
            result[i] = {(c + c.transpose()) / 2, shares.transpose() * lifted, solver.force_on(ball, lifted)[0],
                         solver.force_on(ball, loaded)};
        });
        return result;
    });
}

/// Puts the outer ring between the cam, the series @p cosine and @p sine with @p waves, and the surface.
void add_ring(BearingSurface& surface, Bearing const& bearing, double inner_radius, int waves,
              Eigen::VectorXd const& cosine, Eigen::VectorXd const& sine, int threads)
{
    std::vector<double> const& z = surface.z;
    BearingRing const& ring = *bearing.ring;
    if (ring.thickness >= inner_radius)
        refuse_bearing("outer ring", "is thicker than the cup's inner radius");
    double const half = bearing.width / 2, r = inner_radius - ring.thickness;
    // a circle must not fall between nodes that its neighbours share
    double const apart = z.size() > 1 ? bearing.width / static_cast<double>(z.size() - 1) : bearing.width;
    MeshSize const standard = mesh_size(inner_radius),
                   size{std::min(standard.along, 1.5 * apart), std::max(standard.across, ring.thickness / 4)};
    FourierSolid const solid(
        ring_mesh({r, bearing.middle - half}, {inner_radius, bearing.middle + half}, ring.material, size));
    int const balls = nearest_node(solid.mesh(), {r, bearing.middle});
    double const spring = ring.radial_stiffness ? *ring.radial_stiffness * r : -1;
    constexpr int most = std::numeric_limits<int>::max();
    Supports const supports{{balls, Direction::radial, spring},
                            {balls, Direction::axial, -1, ring.axially_held ? most : 1},
                            {balls, Direction::tangential, -1, 0}};
    std::vector<Station> stations;
    for (double const at : z)
        stations.push_back(wall_station(solid.mesh(), at, 1, Direction::radial));
    Eigen::Index const terms = cosine.size();
    surface.reaction_cosine = surface.reaction_sine = surface.reaction_to_lift = Eigen::VectorXd::Zero(terms);
    surface.reaction_to_load = Eigen::MatrixXd::Zero(terms, static_cast<Eigen::Index>(z.size()));
    std::vector<int> harmonics = harmonics_of(waves, waves * static_cast<int>(terms - 1));
    auto const of_ring = ring_responses(solid, supports, stations, harmonics, threads);
    std::vector<Eigen::MatrixXd> compliance;
    for (std::size_t i = 0; i < harmonics.size(); ++i) {
        auto const k = static_cast<Eigen::Index>(i);
        RingResponse const& of = (*of_ring)[i];
        compliance.push_back(of.compliance);
        surface.cosine.col(k) = of.rise * cosine[k];
        surface.sine.col(k) = of.rise * sine[k];
        surface.reaction_cosine[k] = of.reaction * cosine[k];
        surface.reaction_sine[k] = of.reaction * sine[k];
        surface.reaction_to_lift[k] = of.reaction;
        surface.reaction_to_load.row(k) = of.reaction_to_load;
    }
    surface.compliance.emplace(std::vector<Direction>(z.size(), Direction::radial), std::move(harmonics),
                               std::move(compliance));
}

}  // namespace

void refuse_bearing(std::string const& place, std::string const& cause, std::string const& remedy)
{
    throw NumericalError(ErrorCode::unsuitable_body, "bearing", place, cause, remedy);
}

double CamSeries::at(double phi) const
{
    double sum = 0;
    for (std::size_t k = 0; k < cosine.size(); ++k) {
        double const angle = static_cast<double>(k) * waves * phi;
        sum += cosine[k] * std::cos(angle) + sine[k] * std::sin(angle);
    }
    return sum;
}

CamSeries cam_series(std::vector<double> const& samples, int waves, bool even)
{
    std::size_t const count = samples.size();
    if (count < 2 || count % 2 != 0)
        refuse_bearing("cam", "needs an even number of samples");
    CamSeries series{waves, even, std::vector<double>(count / 2 + 1, 0), std::vector<double>(count / 2 + 1, 0)};
    for (std::size_t k = 0; k <= count / 2; ++k) {
        for (std::size_t j = 0; j < count; ++j) {
            double const angle = 2 * std::numbers::pi * static_cast<double>(k * j % count) / static_cast<double>(count);
            series.cosine[k] += samples[j] * std::cos(angle);
            series.sine[k] += even ? 0 : samples[j] * std::sin(angle);
        }
        double const weight = (k == 0 || 2 * k == count ? 1.0 : 2.0) / static_cast<double>(count);
        series.cosine[k] *= weight;
        series.sine[k] *= 2 * k == count ? 0 : weight;
    }
    return series;
}

std::vector<double> bearing_circles(Bearing const& bearing, int count)
{
    require_sound(bearing);
    if (bearing.width <= 0 || count < 2)
        return {bearing.middle};
    std::vector<double> z;
    for (int j = 0; j < count; ++j)
        z.push_back(bearing.middle + bearing.width * (static_cast<double>(j) / (count - 1) - 0.5));
    return z;
}

BearingSurface bearing_surface(Bearing const& bearing, double inner_radius, CamSeries const& cam,
                               std::vector<double> const& z, int threads)
{
    require_sound(bearing);
    auto const terms = static_cast<Eigen::Index>(cam.cosine.size());
    auto const circles = static_cast<Eigen::Index>(z.size());
    Eigen::VectorXd cosine = Eigen::Map<Eigen::VectorXd const>(cam.cosine.data(), terms);
    Eigen::VectorXd const sine = Eigen::Map<Eigen::VectorXd const>(cam.sine.data(), terms);
    cosine[0] += bearing.cam_oversize;
    BearingSurface surface{z,
                           std::nullopt,
                           Eigen::MatrixXd::Ones(circles, 1) * cosine.transpose(),
                           Eigen::MatrixXd::Ones(circles, 1) * sine.transpose(),
                           {},
                           {},
                           {},
                           {}};
    if (bearing.ring)
        add_ring(surface, bearing, inner_radius, cam.waves, cosine, sine, threads);
    surface.cosine.col(0).array() += bearing.fit;
    return surface;
}

}  // namespace hdconj::elastic
