// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement of an elastic ring under forces on its surface, harmonic by harmonic and between points.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace hdconj::load {

/// A circle around the axis with the direction of the forces and displacements on it.
struct RingStation
{
    /// Radial and axial quantities go with cos(n phi), tangential ones and turns with sin(n phi).
    enum class Parity
    {
        cosine,
        sine
    };
    Parity parity = Parity::cosine;
    double spread = 0;  ///< a point force acts evenly over this angle, a displacement is the mean over it [rad]
};

/// Response of all stations to all stations at one circumferential harmonic: amplitude [mm] per amplitude of a load
/// density [N/rad]. Symmetric (Betti). For turns in place of displacements [rad], with moments [N mm] in place of
/// forces.
struct HarmonicResponse
{
    int n = 0;
    Eigen::MatrixXd response;  ///< (stations, stations)
};

/// Adds to the stations of @p harmonics turns of the surface, beta = (u_t - du_r/dphi)/r, clockwise positive: amplitude
/// (V + n U)/r.
///
/// @param radial, tangential  stations of one place
/// @param radius              of the surface there [mm]
/// The new stations stand behind the others, in order; the load that goes with a turn is the moment of the same
/// direction (work-conjugate), so the matrices stay symmetric.
void add_turns(std::vector<HarmonicResponse>& harmonics, std::vector<std::size_t> const& radial,
               std::vector<std::size_t> const& tangential, double radius);

/// Displacements between points on an even angular grid, summed over the harmonics.
///
/// A force at the angle phi_b and at those that follow by 2 pi/sectors gives at station a and angle phi
///
///   sum_n c_n s_n(a) s_n(b) response_n[a][b] T(n (phi - phi_b)),  c_0 = sectors/(2 pi), c_n = sectors/pi,
///
/// T = cos where both parities agree, sin where a is sine and b is cosine, -sin the other way round; s_n = sin(n
/// spread/2)/(n spread/2). Harmonics must be multiples of `sectors`. Accuracy: roundings of the sum.
class PointResponse
{
  public:
    /// @param grid  angles of one sector
    PointResponse(std::vector<RingStation> stations, std::vector<HarmonicResponse> harmonics, int sectors, int grid,
                  int threads);

    [[nodiscard]] int grid() const { return grid_; }
    [[nodiscard]] int sectors() const { return sectors_; }
    [[nodiscard]] std::vector<HarmonicResponse> const& harmonics() const { return harmonics_; }
    [[nodiscard]] double step() const;  ///< of the grid [rad]

    /// At station @p a to a unit force at station @p b, @p steps of the grid before it.
    [[nodiscard]] double operator()(std::size_t a, std::size_t b, int steps) const { return at(a, b, place(steps)); }

    /// The same in two steps, where several stations are the same number of steps apart.
    [[nodiscard]] std::size_t place(int steps) const
    {
        int const at = steps % grid_;
        return static_cast<std::size_t>(at < 0 ? at + grid_ : at);
    }
    [[nodiscard]] double at(std::size_t a, std::size_t b, std::size_t place) const
    {
        return table_[(a * stations_.size() + b) * static_cast<std::size_t>(grid_) + place];
    }

    /// Amplitudes of the loads that point forces are, stations x harmonics [N/rad]: `even` goes with cos at cosine
    /// stations and sin at sine stations, `odd` with sin and -cos.
    struct Loads
    {
        Eigen::MatrixXd even, odd;
    };
    [[nodiscard]] Loads loads(Eigen::MatrixXd const& force, double phase, int threads = 1) const;

    /// Series of displacements under point forces: a[2 h] cos(n_h phi) + a[2 h + 1] sin(n_h phi) at each station.
    /// @param force  (stations, grid) [N]
    /// @param phase  angle of the grid's first point [rad]
    /// @param wanted stations to give
    [[nodiscard]] std::vector<std::vector<double>> series(Eigen::MatrixXd const& force, double phase,
                                                          std::vector<std::size_t> const& wanted,
                                                          int threads = 1) const;

  private:
    [[nodiscard]] double share(int n, std::size_t station) const;
    [[nodiscard]] double weight(int n) const;

    std::vector<RingStation> stations_;
    std::vector<HarmonicResponse> harmonics_;
    int sectors_;
    int grid_;
    std::vector<double> table_;
};

}  // namespace hdconj::load
