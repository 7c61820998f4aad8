// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/ellipse_cam.hpp"

#include <boost/math/special_functions/ellint_2.hpp>
#include <cstddef>
#include <numbers>

#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj::wavegen {

EllipseCam::EllipseCam(double w0, double r_m) : w0_(w0), a_(r_m + w0), b_(a_)
{
    // excess of the circumference over the ring's, as a function of b
    auto const excess = [&](double b) {
        double const k = std::sqrt((a_ - b) * (a_ + b)) / a_;
        return 4 * a_ * boost::math::ellint_2(k) - 2 * std::numbers::pi * r_m;
    };
    double const flat = excess(0);
    if (!(flat < 0))
        throw NumericalError(ErrorCode::no_solution, "wave generator", "ellipse",
                             "an ellipse with this major axis is longer than the ring even when flat");
    b_ = numeric::bracketed_root(excess, 0.0, a_, flat, excess(a_)).x;
}

EllipseCam EllipseCam::build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    std::size_t const before = faults.size();
    double const w0 = choice.number_or(radial_deformation, 0);
    if (place.waves != 2)
        faults.push_back(waves_fault(choice, place.waves, "an ellipse has two waves", "write 2, or another family"));
    if (!(place.r_m > 0))
        return {};  // the tooth or the ring has faults of its own
    if (!(w0 < (std::numbers::pi / 2 - 1) * place.r_m))
        faults.push_back(scene::parameter_fault(
            choice, radial_deformation, "an ellipse with this major axis is longer than the ring even when flat",
            "write a smaller number, about one module"));
    return faults.size() > before ? EllipseCam{} : EllipseCam(w0, place.r_m);
}

}  // namespace hdconj::wavegen
