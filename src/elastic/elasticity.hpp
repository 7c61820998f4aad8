// SPDX-License-Identifier: GPL-3.0-or-later
// Linear elastic material.
#pragma once

#include <Eigen/Core>

namespace hdconj::elastic {

/// Isotropic material. Domain: youngs_modulus > 0, 0 <= poissons_ratio < 0.5.
struct Elasticity
{
    double youngs_modulus = 206e3;  ///< E [MPa]
    double poissons_ratio = 0.3;    ///< nu
};

/// Stress from strain in the order rr, zz, tt, rz, rt, zt, shear strains as gamma = 2 epsilon.
using StressMatrix = Eigen::Matrix<double, 6, 6>;

/// sigma = lambda tr(epsilon) + 2 mu epsilon with lambda = E nu/((1 + nu)(1 - 2 nu)), mu = E/(2 (1 + nu)).
[[nodiscard]] inline StressMatrix stress_matrix(Elasticity const& material)
{
    double const nu = material.poissons_ratio;
    double const shear = material.youngs_modulus / (2 * (1 + nu));
    double const lame = 2 * shear * nu / (1 - 2 * nu);
    StressMatrix d = StressMatrix::Zero();
    d.topLeftCorner<3, 3>().setConstant(lame);
    for (Eigen::Index i = 0; i < 3; ++i) {
        d(i, i) += 2 * shear;
        d(i + 3, i + 3) = shear;
    }
    return d;
}

/// Teeth as a layer, @p share of which is steel: prisms along z that stand on the ring, side by side and free of each
/// other. They carry stress along z and r (plane stress), bend with the ring's surface, and neither hoop stress nor
/// shear in that surface goes from one to the next.
///
///   s_rr = share E/(1 - nu^2) (e_rr + nu e_zz), s_zz likewise, t_rz = share G g_rz, t_rt = share G g_rt, s_tt = t_zt =
///   0.
[[nodiscard]] inline StressMatrix tooth_stress_matrix(Elasticity const& material, double share)
{
    double const nu = material.poissons_ratio;
    double const plane = share * material.youngs_modulus / (1 - nu * nu);
    double const shear = share * material.youngs_modulus / (2 * (1 + nu));
    constexpr Eigen::Index rr = 0, zz = 1, rz = 3, rt = 4;
    StressMatrix d = StressMatrix::Zero();
    d(rr, rr) = d(zz, zz) = plane;
    d(rr, zz) = d(zz, rr) = nu * plane;
    d(rz, rz) = d(rt, rt) = shear;
    return d;
}

}  // namespace hdconj::elastic
