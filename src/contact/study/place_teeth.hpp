// SPDX-License-Identifier: GPL-3.0-or-later
// All teeth of a drive at one angle of the wave generator.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "contact/gap_field.hpp"
#include "contact_context.hpp"

namespace hdconj::contact {

/// Undeformed angle of tooth 0 for an angle of the wave generator, reduced to one tooth.
[[nodiscard]] double phase_of(Scene const& scene, double wave_generator);

/// Teeth at the angles that several surfaces are looked at: their places do not depend on the surface.
class ToothPoseCache
{
  public:
    /// The same as tooth_places(); kept for the next who asks, up to as many angles as cost little memory.
    [[nodiscard]] std::shared_ptr<ToothPoses const> operator()(ContactContext const& context, double phase)
    {
        return (*this)(context, phase, context.maker.z());
    }
    /// In the planes @p z, evenly spaced over the width.
    [[nodiscard]] std::shared_ptr<ToothPoses const> operator()(ContactContext const& context, double phase,
                                                               std::vector<double> const& z);

  private:
    std::map<std::pair<double, std::size_t>, std::shared_ptr<ToothPoses const>> known_;
};

/// Poses of teeth with the undeformed angles @p phi in the planes @p z, (phi,z): each in the frame of a tooth space
/// whose centre line is at (z_f/z_c) phi; as tooth_places().
[[nodiscard]] std::vector<Pose> poses_at(ContactContext const& context, std::vector<double> const& phi,
                                         std::vector<double> const& z);

/// All teeth of the drive in the planes @p z; where the wall has moved along the axis, the parts of them that
/// are in the plane.
[[nodiscard]] ToothPoses tooth_places(ContactContext const& context, double phase, std::vector<double> const& z);

}  // namespace hdconj::contact
