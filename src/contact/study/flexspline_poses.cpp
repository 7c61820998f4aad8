// SPDX-License-Identifier: GPL-3.0-or-later
// The flexspline's teeth in the frame of the drive.
#include <numbers>

#include "conjugate/plane/plane_motion.hpp"
#include "contact_study_data.hpp"
#include "hdconj/contact.hpp"

namespace hdconj {

std::vector<Pose> flexspline_poses(Scene const& scene, std::vector<double> const& z, double pitches)
{
    contact::require_planes(scene, z);
    Scene asked = scene;
    constexpr double any_width = 1;  // of one plane [mm]
    asked.circular_spline.width = z.size() > 1 ? z.back() - z.front() : any_width;
    contact::ContactStudyData const data(asked, Verb::contact, {}, static_cast<int>(z.size()));
    int const teeth = scene.drive.flexspline_teeth;
    double const pitch = 2 * std::numbers::pi / teeth;
    auto const places = contact::tooth_places(*data.context, pitch * pitches, z);
    int const found = static_cast<int>(places.pose.size() / z.size());
    std::vector<Pose> poses;
    for (int i = 0; i < teeth; ++i) {
        int number = i;  // teeth are counted from -z_f/2 on there
        while (number >= places.first + found)
            number -= teeth;
        // the frame of its tooth space has turned by z_f/z_c phi
        double const turn = conjugate::tooth_ratio(scene) * pitch * (number + pitches);
        Pose const space{std::cos(turn), std::sin(turn), Vec2::Zero()};
        for (std::size_t k = 0; k < z.size(); ++k) {
            Pose const& at = places.at(number, k);
            Vec2 const y = space.rotate(at.rotate(Vec2(0, 1)));
            poses.push_back({y.y(), y.x(), space.rotate(at.origin)});
        }
    }
    return poses;
}

}  // namespace hdconj
