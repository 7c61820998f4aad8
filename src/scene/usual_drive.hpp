// SPDX-License-Identifier: GPL-3.0-or-later
// What radial deformation and numbers of teeth usually are, and the settings that bring a drive there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::scene {

/// Ratios of radial deformation and its usual value that are usual themselves. Source: design_limits().
inline constexpr double least_usual_ratio = 0.8;
inline constexpr double largest_usual_ratio = 1.2;

/// The radial deformation m (z_c - z_f)/2 for any number of waves: it closes both pitch circles, of radii m z_f/2 and
/// m z_c/2, at the major axis, and lets the tooth rest in the circular spline there (its locus on many teeth,
/// (m D/(2 n)) (eta - kappa sin eta) along the pitch line, D = z_c - z_f, eta = n phi, stands still at eta = 0 for
/// kappa = 2 w0/(m D) = 1). With one tooth a wave it is m n/2: m/2, m and 3 m/2 for 1, 2 and 3 waves. [mm]
[[nodiscard]] double usual_deformation(Drive const& drive);

/// kappa = w0 over the usual one.
[[nodiscard]] double deformation_ratio(Drive const& drive, double w0);

/// Whether such a ratio is usual; one on a limit is, whatever rounding made of it.
[[nodiscard]] inline bool is_usual(double ratio)
{
    return ratio >= least_usual_ratio * (1 - figure_roundoff) && ratio <= largest_usual_ratio * (1 + figure_roundoff);
}

/// Advice in words, and the same as arguments of --set.
struct Advice
{
    std::string words;             ///< "wave_generator.radial_deformation = 0.25"
    std::vector<std::string> set;  ///< empty: nothing is known to help

    /// Adds that @p key becomes @p value.
    void add(std::string const& key, std::string const& value);
};

/// The tip circle that suits the radial deformation @p w0: that of the default, further out where the tips would not
/// leave it in time or would reach the flexspline's rim; nothing where addendum or dedendum is not a key. [mm]
[[nodiscard]] std::optional<double> usual_tip_radius(Scene const& scene, double w0);
/// The same of a tooth with these heights.
[[nodiscard]] double usual_tip_radius(Drive const& drive, double addendum, double dedendum, double w0);
/// The largest addendum of the flexspline's tooth with which the tips of a given circular spline leave it in time, at
/// the radial deformation @p w0; nothing where none does or the addendum of the given tooth is not a key. [mm]
[[nodiscard]] std::optional<double> usual_addendum(Scene const& scene, double w0);

/// Torque that drives of this size carry, in N m and words: 28 at a pitch diameter of 50 mm, with its cube.
[[nodiscard]] std::string usual_torque(Drive const& drive);

/// "a larger circular_spline.profile.dedendum", or of a family without that key what its tooth has to be.
[[nodiscard]] std::string with_height(FamilyChoice const& tooth, std::string const& change, std::string const& key);

/// What makes @p scene a usual drive: two waves for two teeth more, else one more tooth for each wave, and the radial
/// deformation and tip circle that go with them. @param kept  a radial deformation that stays where it is usual
[[nodiscard]] Advice usual_pair(Scene const& scene, std::optional<double> kept);

/// The radial deformation @p w0 [mm] and the tip circle, or where that is given the addendum, that goes with it; empty
/// where the deformation is no key.
[[nodiscard]] Advice with_deformation(Scene const& scene, double w0);

/// The addendum @p addendum [mm] and a given tip circle that moves as the usual one does at the radial deformation @p
/// w0 [mm]. Domain: the addendum of the flexspline's tooth is a key.
[[nodiscard]] Advice with_addendum(Scene const& scene, double w0, double addendum);

/// Adds a pressure angle with which straight or involute flanks touch long enough, where theirs is smaller than 17 +
/// 400/z_f degrees. A flank touches where the locus runs along it; the tooth turns by some 4/z_f meanwhile. The limit
/// is fitted to drives of 60 to 240 teeth with the usual radial deformation, which touch over one pitch from 24 and 19
/// degrees on; a test solves drives on either side.
void add_pressure_angle(Scene const& scene, Advice& advice);

/// "the radial deformation 2.5 mm is 10 times the usual m (z_c - z_f)/2 = 0.25 mm"; nothing where it is usual.
[[nodiscard]] std::optional<std::string> unusual_deformation(Drive const& drive, double w0);

}  // namespace hdconj::scene
