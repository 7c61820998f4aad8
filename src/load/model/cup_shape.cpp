// SPDX-License-Identifier: GPL-3.0-or-later
#include "cup_shape.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "hdconj/base/parallel.hpp"

namespace hdconj::load {
namespace {

/// The bearing's seat in the cup, and one wall beside its edges.
elastic::Seat seat_of_bearing(LoadModel const& model)
{
    std::vector<double> const& z = model.drive.bearing_z;
    double const wall = std::max(model.section.wall, model.section.ring_wall);
    return {model.middle + z.front() - wall, model.middle + z.back() + wall};
}

/// Whether the wall changes at the height @p z above the cup's bottom by a ramp, which has sharp corners.
bool at_ramp(elastic::CupSection const& cup, double z)
{
    double const wall = std::min(cup.wall, cup.ring_wall);
    bool const rear = cup.rear_fillet == 0 && z > cup.ring_begin - cup.rear_ramp - wall && z < cup.ring_begin,
               front = cup.front_fillet == 0 && z > cup.ring_end && z < cup.ring_end + cup.front_ramp + wall;
    return cup.wall != cup.ring_wall && (rear || front);
}

/// Enters the corners of the elements as nodes. @returns where each of them stands in the mesh
std::vector<elastic::SectionPoint> enter_section(LoadModel const& model, CupShape& shape)
{
    elastic::SectionMesh const& mesh = model.solid.mesh();
    elastic::Seat const seat = seat_of_bearing(model);
    std::vector<int> number(mesh.nodes.size(), -1);
    std::vector<elastic::SectionPoint> places;
    constexpr double xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        std::vector<int> cell;
        for (std::size_t c = 0; c < 4; ++c) {
            auto const node = static_cast<std::size_t>(mesh.elements[e][c]);
            if (number[node] < 0) {
                number[node] = static_cast<int>(shape.r.size());
                shape.r.push_back(mesh.nodes[node].x());
                shape.z.push_back(mesh.nodes[node].y() - model.middle);
                places.push_back({e, xi[c], eta[c]});
                bool const inside = e < mesh.wall_elements() && e % static_cast<std::size_t>(mesh.layers) == 0;
                if (inside && xi[c] < 0 && seat.covers(mesh.nodes[node].y()))
                    shape.seat.push_back(number[node]);
            }
            cell.push_back(number[node]);
        }
        shape.cells.push_back(std::move(cell));
    }
    return places;
}

void enter_stress(LoadModel const& model, elastic::HarmonicField const& field, int threads, CupShape& shape)
{
    std::size_t const points = shape.r.size();
    std::vector<Vec2> const corners{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    Eigen::MatrixXd const stress = elastic::recovered_stress(model.solid.mesh(), field, corners, shape.phi, threads);
    std::vector<double> around(points, 0);
    for (std::vector<int> const& cell : shape.cells)
        for (int const node : cell)
            around[static_cast<std::size_t>(node)] += 1;
    for (std::size_t e = 0; e < shape.cells.size(); ++e)
        for (std::size_t c = 0; c < 4; ++c) {
            auto const point = static_cast<std::size_t>(shape.cells[e][c]);
            for (std::size_t a = 0; a < shape.phi.size(); ++a)
                shape.stress[a * points + point] +=
                    stress(static_cast<Eigen::Index>(4 * e + c), static_cast<Eigen::Index>(a)) / around[point];
        }
}

}  // namespace

elastic::HarmonicField cup_field(LoadModel const& model, Eigen::MatrixXd const& forces, int threads)
{
    DriveStations const& layout = model.drive.stations;
    PointResponse::Loads const loads = model.drive.response->loads(forces, model.drive.phase, threads);
    auto const count = static_cast<Eigen::Index>(layout.turn(0));  // turns stand last
    Eigen::MatrixXd even = loads.even.topRows(count), odd = loads.odd.topRows(count);
    // a moment is the forces that do its work: turn = (V + n U)/r
    for (Eigen::Index k = 0; k < even.cols(); ++k)
        for (std::size_t slice = 0; slice < layout.slices; ++slice) {
            auto const turn = static_cast<Eigen::Index>(layout.turn(slice));
            auto const radial = static_cast<Eigen::Index>(layout.radial(slice)),
                       tangential = static_cast<Eigen::Index>(layout.tangential(slice));
            double const n = model.unit->harmonics[static_cast<std::size_t>(k)];
            even(tangential, k) += loads.even(turn, k) / model.radius;
            odd(tangential, k) += loads.odd(turn, k) / model.radius;
            even(radial, k) += n * loads.even(turn, k) / model.radius;
            odd(radial, k) += n * loads.odd(turn, k) / model.radius;
        }
    return elastic::harmonic_field(*model.unit, even, odd, threads);
}

Eigen::MatrixXd spread_over_slices(DriveStations const& stations, Eigen::MatrixXd const& forces)
{
    constexpr double of_end = 1.0 / 4, of_inner = 1.0 / 24;  // to a neighbour
    Eigen::MatrixXd result = forces;
    auto const move = [&](std::size_t from, std::size_t to, double part) {
        auto const moved = part * forces.row(static_cast<Eigen::Index>(from));
        result.row(static_cast<Eigen::Index>(from)) -= moved;
        result.row(static_cast<Eigen::Index>(to)) += moved;
    };
    std::size_t const last = stations.slices - 1;
    for (std::size_t const first : {stations.radial(0), stations.tangential(0), stations.axial(0), stations.turn(0)})
        for (std::size_t k = 0; k < last; ++k) {
            move(first + k, first + k + 1, k == 0 ? of_end : of_inner);
            move(first + k + 1, first + k, k + 1 == last ? of_end : of_inner);
        }
    return result;
}

CupShape cup_shape(LoadModel const& model, elastic::HarmonicField const& field, int threads)
{
    constexpr int angles = 180;
    CupShape shape;
    std::vector<elastic::SectionPoint> const places = enter_section(model, shape);
    shape.phi = elastic::even_angles(angles, 1);
    std::size_t const points = places.size();
    for (auto* values : {&shape.u_r, &shape.u_t, &shape.u_z, &shape.stress})
        values->assign(points * shape.phi.size(), 0);
    enter_stress(model, field, threads, shape);
    elastic::HarmonicWaves const waves(field.harmonics, shape.phi, threads);
    constexpr std::size_t grain = 32;
    parallel_for(points, threads, grain, [&](std::size_t p) {
        Eigen::Matrix3Xd const u = elastic::displacements_at(model.solid.mesh(), field, places[p], waves);
        for (std::size_t a = 0; a < shape.phi.size(); ++a) {
            auto const column = static_cast<Eigen::Index>(a);
            shape.u_r[a * points + p] = u(0, column);
            shape.u_z[a * points + p] = u(1, column);
            shape.u_t[a * points + p] = u(2, column);
        }
    });
    return shape;
}

CupStress cup_stress(LoadModel const& model, elastic::HarmonicField const& field, int threads)
{
    constexpr int angles = 90;
    constexpr double sharp = 0.5;  // elements a quarter as large give up to a quarter more, smaller ones still more
    elastic::SectionMesh const& mesh = model.solid.mesh();
    CupStress result;
    result.peak = elastic::stress_peak(mesh, field, elastic::even_angles(angles, model.drive.response->sectors()),
                                       seat_of_bearing(model), threads);
    if (!(result.peak.stress > 0))
        return result;
    result.at = elastic::position(mesh, result.peak.place);
    double const side = result.peak.place.xi;
    Eigen::MatrixXd const corners =
        elastic::recovered_stress(mesh, field, {{side, -1}, {side, 1}}, {result.peak.phi}, threads);
    auto const first = 2 * static_cast<Eigen::Index>(result.peak.place.element);
    result.unresolved = std::max(0.0, corners.middleRows<2>(first).maxCoeff() - result.peak.stress);
    if (at_ramp(model.section, result.at.y()))
        result.unresolved = std::max(result.unresolved, sharp * result.peak.stress);
    return result;
}

}  // namespace hdconj::load
