// SPDX-License-Identifier: GPL-3.0-or-later
#include "swept_mesh.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "hdconj/error.hpp"

namespace hdconj::elastic {
namespace {

using Eigen::Index;

/// Numbers of the nodes of a swept mesh: plane by plane, those between two planes behind the first.
class Numbering
{
  public:
    Numbering(SectionMesh const& section, double angle, int steps)
        : whole_(static_cast<int>(section.nodes.size())), steps_(steps)
    {
        constexpr double rounding = 1e-12;  // of 2 pi
        closed_ = angle > 2 * std::numbers::pi - rounding;
        corner_.assign(section.nodes.size(), -1);
        for (QuadraticElement const& element : section.elements)
            for (std::size_t a = 0; a < 4; ++a)
                corner_[static_cast<std::size_t>(element[a])] = 0;
        for (int& c : corner_)
            c = c < 0 ? -1 : corners_++;
    }

    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] bool is_corner(int node) const { return corner_[static_cast<std::size_t>(node)] >= 0; }
    [[nodiscard]] int on_plane(int node, int plane) const
    {
        return (closed_ && plane == steps_ ? 0 : plane) * (whole_ + corners_) + node;
    }
    [[nodiscard]] int between(int node, int step) const
    {
        return step * (whole_ + corners_) + whole_ + corner_[static_cast<std::size_t>(node)];
    }

  private:
    int whole_;
    int steps_;
    int corners_ = 0;
    bool closed_ = false;
    std::vector<int> corner_;
};

}  // namespace

SweptMesh swept_mesh(SectionMesh const& section, double angle, int steps)
{
    if (steps < fewest_swept_steps || steps > most_swept_steps)
        throw InputError(Fault{"steps", 0, std::to_string(steps), "so many elements round the axis make no mesh",
                               "give a whole number from " + std::to_string(fewest_swept_steps) + " to " +
                                   std::to_string(most_swept_steps)});
    Numbering const number(section, angle, steps);
    auto const count = static_cast<int>(section.nodes.size());
    SweptMesh mesh;
    for (int plane = 0; plane < (number.closed() ? steps : steps + 1); ++plane) {
        for (int node = 0; node < count; ++node)
            mesh.nodes.push_back({node, angle * plane / steps});
        for (int node = 0; node < count && plane < steps; ++node)
            if (number.is_corner(node))
                mesh.nodes.push_back({node, angle * (plane + 0.5) / steps});
    }
    for (int step = 0; step < steps; ++step)
        for (QuadraticElement const& e : section.elements) {
            std::array<int, 20> hexahedron{};
            for (std::size_t a = 0; a < 4; ++a) {
                hexahedron[a] = number.on_plane(e[a], step + 1);
                hexahedron[a + 4] = number.on_plane(e[a], step);
                hexahedron[a + 8] = number.on_plane(e[a + 4], step + 1);
                hexahedron[a + 12] = number.on_plane(e[a + 4], step);
                hexahedron[a + 16] = number.between(e[a], step);
            }
            mesh.elements.push_back(hexahedron);
        }
    return mesh;
}

std::vector<double> swept_loads(SectionMesh const& section, SweptMesh const& swept, double angle, int steps, int waves,
                                Eigen::MatrixXd const& cosine, Eigen::MatrixXd const& sine)
{
    Numbering const number(section, angle, steps);
    std::vector<double> loads(swept.nodes.size(), 0);
    // Gauss' points and weights on [-1, 1]: exact to the power 9, harmonics of several elements a wave to all digits
    constexpr std::array at{0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array weight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double const half = angle / steps / 2;
    for (Index i = 0; i < cosine.rows(); ++i) {
        if (cosine.row(i).isZero(0) && sine.row(i).isZero(0))
            continue;
        int const node = static_cast<int>(i);
        for (int step = 0; step < steps; ++step)
            for (int g = -2; g <= 2; ++g) {
                auto const p = static_cast<std::size_t>(std::abs(g));
                double const x = g < 0 ? -at[p] : at[p];
                double const phi = half * (2 * step + 1 + x);
                double load = 0;
                for (Index k = 0; k < cosine.cols(); ++k)
                    load += cosine(i, k) * std::cos(static_cast<double>(k) * waves * phi) +
                            sine(i, k) * std::sin(static_cast<double>(k) * waves * phi);
                load *= weight[p] * half;
                auto const first = static_cast<std::size_t>(number.on_plane(node, step)),
                           last = static_cast<std::size_t>(number.on_plane(node, step + 1));
                if (number.is_corner(node)) {
                    loads[first] += load * x * (x - 1) / 2;
                    loads[last] += load * x * (x + 1) / 2;
                    loads[static_cast<std::size_t>(number.between(node, step))] += load * (1 - x * x);
                } else {
                    loads[first] += load * (1 - x) / 2;
                    loads[last] += load * (1 + x) / 2;
                }
            }
    }
    return loads;
}

}  // namespace hdconj::elastic
