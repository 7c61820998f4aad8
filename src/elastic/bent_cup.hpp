// SPDX-License-Identifier: GPL-3.0-or-later
// The cup bent by its wave generator, and the displacement of the teeth on it.
#pragma once

#include <memory>
#include <vector>

#include "harmonic_field.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/wavegen/material_displacement.hpp"
#include "wave_generator_contact.hpp"

namespace hdconj::elastic {

/// Axial displacement of a point of the wall and its derivatives.
struct AxialMove
{
    double u_z = 0;     ///< [mm], positive towards the open end
    double by_phi = 0;  ///< [mm/rad]
    double by_z = 0;    ///< [1]
};

/// Resolution of the contact with the bearing.
struct BentCupGrid
{
    int angles = 48;   ///< in a lobe, even; harmonics up to half of it times the waves
    int circles = 13;  ///< over the bearing's width
    int layers = 1;    ///< elements across the wall, at least
};

/// Cup, bearing and cam, solved: design 3.6 without load. Heights from the outer face of the cup's bottom.
///
/// The wall at a height and a radius moves by a Fourier series each for w, v and u_z, of first order in the
/// displacements, like the contact; length_kept() adds the second order to place teeth.
class BentCup
{
  public:
    /// @param shape  of the cam, at the undeformed angle
    /// @throws NumericalError for impossible dimensions or a contact that cannot be solved
    template <wavegen::WaveShape Shape>
    BentCup(CupSection const& section, Bearing const& bearing, Shape const& shape, BentCupGrid const& grid, int threads)
        : BentCup(section, bearing, cam_series(shape, grid.angles), grid.circles, threads, grid.layers)
    {
    }
    BentCup(CupSection const& section, Bearing const& bearing, CamSeries const& cam, int circles, int threads,
            int layers = 1);

    [[nodiscard]] CupSection const& section() const { return section_; }
    [[nodiscard]] Bearing const& bearing() const { return bearing_; }
    [[nodiscard]] CamSeries const& cam() const { return cam_; }
    [[nodiscard]] FourierSolid const& solid() const { return solid_; }
    [[nodiscard]] WaveGeneratorContact const& contact() const { return contact_; }
    [[nodiscard]] HarmonicField const& field() const { return field_; }

    /// w and v of the wall at height @p z that had the radius @p radius.
    /// @throws NumericalError where there is no wall, or no teeth on it
    [[nodiscard]] wavegen::MaterialDisplacement displacement(double z, double radius) const;
    /// u_z of the wall there as a series, in the place of w; v is 0.
    [[nodiscard]] wavegen::MaterialDisplacement axial_displacement(double z, double radius) const;
    [[nodiscard]] AxialMove axial(double z, double radius, double phi) const;
    /// Slope du_r/dz of the best line over the tooth ring, inner surface [rad]: the coning angle at @p phi.
    [[nodiscard]] double coning(double phi) const;

  private:
    [[nodiscard]] SectionPoint place(double z, double radius) const;

    CupSection section_;
    Bearing bearing_;
    CamSeries cam_;
    FourierSolid solid_;
    WaveGeneratorContact contact_;
    HarmonicField field_;
};

/// Slope du_r/dz of the best line along the inner surface of the straight wall from @p begin to @p end [mm above the
/// bottom], from 33 even heights, at @p phi.
/// @throws NumericalError outside the straight wall
[[nodiscard]] double wall_slope(SectionMesh const& mesh, HarmonicField const& field, double begin, double end,
                                double phi);

/// Such a cup, unless keep_elastic_bodies() has it.
/// @throws NumericalError as BentCup does
[[nodiscard]] std::shared_ptr<BentCup const> solved_cup(CupSection const& section, Bearing const& bearing,
                                                        CamSeries const& cam, BentCupGrid const& grid, int threads);

/// Differences between two cups of the same bodies; displacements are compared at even angles of a lobe.
/// @param z       heights above the bottom [mm]
/// @param radius  of the layer that carries the teeth [mm]
/// @throws NumericalError as BentCup::displacement does
[[nodiscard]] BentCupError distance_between(BentCup const& cup, BentCup const& other, std::vector<double> const& z,
                                            double radius);

/// What that says of the first: 3/(sqrt 2 - 1) times the distance (a bearing's edges are singular: order one half; of
/// two grids, Roache's safety of 3), of no figure less than of the middle one relative to its size.
/// @param other   with half the circles and angles of the bearing's contact, and two elements across the wall:
/// discretised_otherwise() Accuracy: an estimate, no proof. Of three drives no finer grid of four was further away;
/// displacements are stated 1.9, 24 and 9 times as large as their distance from the finest.
/// @throws NumericalError as BentCup::displacement does
[[nodiscard]] BentCupError bent_cup_error(BentCup const& cup, BentCup const& other, std::vector<double> const& z,
                                          double radius);

/// The grid to compare @p grid with.
[[nodiscard]] BentCupGrid discretised_otherwise(BentCupGrid const& grid);

}  // namespace hdconj::elastic
