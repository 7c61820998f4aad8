// SPDX-License-Identifier: GPL-3.0-or-later
#include "cup_shape.hpp"

#include <numbers>
#include <utility>

#include "hdconj/elastic/harmonic_field.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj::detail {

HarmonicField cup_field(LoadModel const& model, Eigen::MatrixXd const& forces, int threads)
{
    DriveStations const& layout = model.drive.stations;
    PointResponse::Loads const loads = model.drive.response.loads(forces, model.drive.phase, threads);
    auto const count = static_cast<Eigen::Index>(layout.turn(0));  // turns stand last
    Eigen::MatrixXd even = loads.even.topRows(count), odd = loads.odd.topRows(count);
    // a moment is the forces that do its work: turn = (V + n U)/r
    for (Eigen::Index k = 0; k < even.cols(); ++k)
        for (std::size_t slice = 0; slice < layout.slices; ++slice)
        {
            auto const turn = static_cast<Eigen::Index>(layout.turn(slice));
            auto const radial = static_cast<Eigen::Index>(layout.radial(slice)), tangential = static_cast<Eigen::Index>(layout.tangential(slice));
            double const n = model.unit.harmonics[static_cast<std::size_t>(k)];
            even(tangential, k) += loads.even(turn, k) / model.radius;
            odd(tangential, k) += loads.odd(turn, k) / model.radius;
            even(radial, k) += n * loads.even(turn, k) / model.radius;
            odd(radial, k) += n * loads.odd(turn, k) / model.radius;
        }
    return harmonic_field(model.unit, even, odd, threads);
}

CupShape cup_shape(LoadModel const& model, HarmonicField const& field, int angles, int threads)
{
    SectionMesh const& mesh = model.solid.mesh();
    CupShape shape;
    std::vector<int> number(mesh.nodes.size(), -1);
    std::vector<SectionPoint> place;
    constexpr double xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    {
        std::vector<int> cell;
        for (std::size_t c = 0; c < 4; ++c)
        {
            auto const node = static_cast<std::size_t>(mesh.elements[e][c]);
            if (number[node] < 0)
            {
                number[node] = static_cast<int>(shape.r.size());
                shape.r.push_back(mesh.nodes[node].x());
                shape.z.push_back(mesh.nodes[node].y() - model.middle);
                place.push_back({e, xi[c], eta[c]});
            }
            cell.push_back(number[node]);
        }
        shape.cells.push_back(std::move(cell));
    }
    for (int i = 0; i < angles; ++i)
        shape.phi.push_back(2 * std::numbers::pi * i / angles);
    std::size_t const points = place.size();
    for (auto* values : {&shape.u_r, &shape.u_t, &shape.u_z, &shape.stress})
        values->assign(points * shape.phi.size(), 0);
    Eigen::MatrixXd const gauss = gauss_stress(mesh, field, shape.phi, threads);
    std::vector<double> around(points, 0);
    constexpr std::size_t nearest[] = {0, 1, 3, 2};  // Gauss point beside each corner
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (std::size_t c = 0; c < 4; ++c)
            around[static_cast<std::size_t>(shape.cells[e][c])] += 1;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (std::size_t c = 0; c < 4; ++c)
        {
            auto const point = static_cast<std::size_t>(shape.cells[e][c]);
            for (std::size_t a = 0; a < shape.phi.size(); ++a)
                shape.stress[a * points + point] += gauss(static_cast<Eigen::Index>(4 * e + nearest[c]), static_cast<Eigen::Index>(a)) / around[point];
        }
    HarmonicWaves const waves(field, shape.phi);
    constexpr std::size_t grain = 32;
    parallel_for(points, threads, grain, [&](std::size_t p) {
        Eigen::Matrix3Xd const u = displacements_at(mesh, field, place[p], waves);
        for (std::size_t a = 0; a < shape.phi.size(); ++a)
        {
            auto const column = static_cast<Eigen::Index>(a);
            shape.u_r[a * points + p] = u(0, column);
            shape.u_z[a * points + p] = u(1, column);
            shape.u_t[a * points + p] = u(2, column);
        }
    });
    return shape;
}

}  // namespace hdconj::detail
