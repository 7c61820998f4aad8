// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One drive in four number types: contacts all over the flank, what each step loses there, and what it has to lose.
///
/// The numbers of the scene are rounded to float first, and so is every position u: all types start from the same
/// drive, so what differs is arithmetic.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drive/drive.hpp"
#include "formulas.hpp"
#include "hdconj/envelope/contact.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace rounding {

using hdconj::Scene;
using oracle::Fifty;

/// All numbers of the scene as floats, its motion exact.
inline Scene as_float(Scene scene)
{
    auto const round = [](double& value) { value = static_cast<double>(static_cast<float>(value)); };
    round(scene.drive.module);
    round(scene.flexspline.wall);
    round(scene.flexspline.neutral_offset);
    if (scene.flexspline.inner_radius)
        round(*scene.flexspline.inner_radius);
    for (auto* choice : {&scene.flexspline.profile, &scene.wave_generator.shape}) {
        for (auto& [key, parameter] : choice->given)
            if (auto* number = std::get_if<double>(&parameter.value))
                round(*number);
    }
    scene.solver.kinematics = hdconj::Kinematics::exact;
    return scene;
}

/// The right flank and the motion in one type.
template <class T>
struct Drive
{
    explicit Drive(Scene const& scene) : tooth(scene), motion(scene) {}

    /// @param piece  of the right flank, from the root up
    /// @param t      where on it the condition n.v = 0 is asked, 0 ... 1
    [[nodiscard]] Inputs<T> inputs(std::size_t piece, double t, double u, int sign) const
    {
        auto const& p = tooth.flank[piece];
        Point<T> const up{T(0), tooth.pitch_line};
        Inputs<T> in;
        in.u = T(u);
        in.phi = motion.phi(in.u);
        in.r_m = motion.r_m;
        in.r_0 = motion.r_0;
        in.w0 = motion.w0;
        in.ratio = motion.turn_ratio;
        in.waves = motion.waves;
        in.arc = p.arc;
        in.a = (p.arc ? p.centre : p.lower) + up;
        in.b = p.upper + up;
        in.radius = T(p.side) * p.radius;
        in.sign = sign;
        in.x = p.at(T(t)) + up;
        in.n = p.normal(T(t));
        return in;
    }

    oracle::Tooth<T> tooth;
    oracle::Motion<T> motion;
};

/// A contact: the profile point at @p t of a piece touches about when the position is u.
struct Place
{
    std::size_t piece = 0;
    double t = 0;
    double u = 0;
    int sign = 1;
};

/// The contact at position @p u on the side of the normal at @p t.
inline Place place_at(Drive<double> const& drive, std::size_t piece, double t, double u)
{
    double const rounded = static_cast<double>(static_cast<float>(u));
    Inputs<double> const in = drive.inputs(piece, t, rounded, 1);
    Steps<double> const s = steps(in);
    return {piece, t, rounded, !in.arc || dot(s.normal, in.n) > 0 ? 1 : -1};
}

/// Contacts of @p per_piece points of each piece of the right flank, and as many of the tip land at any time.
inline std::vector<Place> places(Drive<double> const& drive, int per_piece, int scan = 720)
{
    std::vector<Place> found;
    double const half = drive.motion.half_lobe();
    for (std::size_t piece = 0; piece + 1 < drive.tooth.flank.size(); ++piece) {
        for (int i = 0; i < per_piece; ++i) {
            double const t = (i + 0.5) / per_piece;
            auto const f = [&](double u) { return steps(drive.inputs(piece, t, u, 1)).condition; };
            double before = -half * (1 - 0.3 / scan), value = f(before);
            for (int k = 1; k <= scan; ++k) {
                double const now = half * (2.0 * k / scan - 1 + 0.3 / scan), next = f(now);
                if ((value < 0) != (next < 0)) {
                    double low = before, high = now;
                    for (int step = 0; step < 60; ++step)
                        ((f(0.5 * (low + high)) < 0) == (value < 0) ? low : high) = 0.5 * (low + high);
                    found.push_back(place_at(drive, piece, t, low));
                }
                before = now;
                value = next;
            }
        }
    }
    // the tip land is touched in short moments: by position, where it is inside
    std::size_t const tip = drive.tooth.flank.size() - 1;
    for (int k = 0; k < per_piece; ++k) {
        Place const place = place_at(drive, tip, 0.5, half * (2 * k + 1) / per_piece - half);
        Inputs<double> const in = drive.inputs(tip, 0.5, place.u, 1);
        double const along = steps(in).place;
        if (along >= 0 && along <= length(in.b - in.a))
            found.push_back(place);
    }
    return found;
}

/// Condition of each step: relative change of the output when every number that the formulas start from changes by one
/// unit, in the worst combination of signs.
inline Losses conditions(Inputs<Fifty> const& in, Steps<Fifty> const& right, Fifty const& height,
                         oracle::Motion<Fifty> const& motion)
{
    Fifty const small("1e-22");
    Losses sum{};
    auto const disturbed = [&](auto const& change) {
        Inputs<Fifty> moved = in;
        change(moved);
        Losses const one = errors(steps(moved), right, in, height);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += one[i] / 1e-22;
    };
    Fifty const factor = 1 + small;
    disturbed([&](Inputs<Fifty>& i) {
        i.u *= factor;
        i.phi = motion.phi(i.u);
    });
    for (Fifty Inputs<Fifty>::*number : {&Inputs<Fifty>::phi, &Inputs<Fifty>::r_m, &Inputs<Fifty>::r_0,
                                         &Inputs<Fifty>::w0, &Inputs<Fifty>::ratio, &Inputs<Fifty>::radius})
        disturbed([&](Inputs<Fifty>& i) { i.*number *= factor; });
    for (Point<Fifty> Inputs<Fifty>::*point :
         {&Inputs<Fifty>::a, &Inputs<Fifty>::b, &Inputs<Fifty>::x, &Inputs<Fifty>::n}) {
        disturbed([&](Inputs<Fifty>& i) { (i.*point).x *= factor; });
        disturbed([&](Inputs<Fifty>& i) { (i.*point).y *= factor; });
    }
    return sum;
}

/// The program's own double path at the same contact.
class Program
{
  public:
    explicit Program(Scene const& scene)
    {
        hdconj::Faults faults;
        tooth_ = hdconj::drive::given_tooth(scene, faults);
        hdconj::wavegen::AnyWaveShape const shape = hdconj::drive::wave_shape(scene, tooth_, faults);
        if (!faults.empty())
            throw hdconj::InputError(faults);
        double const ratio = static_cast<double>(scene.drive.flexspline_teeth) / scene.drive.circular_spline_teeth;
        motion_.emplace(hdconj::wavegen::NeutralCurve<hdconj::wavegen::AnyWaveShape>(
                            shape, hdconj::drive::ring_geometry(scene, tooth_).r_m),
                        ratio);
        for (auto piece = tooth_.pieces.rbegin(); piece != tooth_.pieces.rend(); ++piece) {
            if (!piece->corner)
                flank_.push_back(piece->shape);
        }
    }

    /// Steps that the program has numbers for; the others stay 0 and are not compared.
    [[nodiscard]] Steps<double> operator()(Inputs<double> const& in, std::size_t piece) const
    {
        hdconj::motion::MotionRates const rates = motion_->rates(in.u);
        Steps<double> out;
        out.phi = motion_->angles(in.u).phi;
        out.turn = rates.twist.omega;
        out.q_x = rates.twist.q.x();
        hdconj::envelope::Contact contact;
        if (auto const* arc = std::get_if<hdconj::profile::ArcPiece>(&flank_[piece])) {
            contact = hdconj::envelope::arc_contact(*arc, rates, in.sign, 0);
            out.velocity = of(rates.twist(arc->centre));
            out.speed = contact.advance / contact.slowness;
        } else {
            auto const& line = std::get<hdconj::profile::LinePiece>(flank_[piece]);
            contact = hdconj::envelope::line_contact(line, rates, 0);
            // the program's lines run down the right flank
            out.velocity = of(rates.twist(line.b));
            out.place = line.length() * (1 - contact.t);
            out.speed = contact.advance / contact.slowness;
        }
        out.normal = of(contact.n);
        out.contact = of(contact.x);
        out.point = of(motion_->pose(in.u)(contact.x));
        return out;
    }

  private:
    static Point<double> of(hdconj::Vec2 const& v) { return {v.x(), v.y()}; }

    hdconj::profile::Profile tooth_;
    std::optional<hdconj::motion::ExactMotion<hdconj::wavegen::AnyWaveShape>> motion_;
    std::vector<hdconj::profile::PieceShape> flank_;  ///< the right one from the root up
};

/// What one contact loses: relative errors over the roundoff of the type, and the condition of each step.
struct Contact
{
    Place place;
    std::string piece;
    Losses condition{}, in_float{}, in_double{}, in_long_double{}, in_program{};
};

/// A drive in all types.
class FourTypes
{
  public:
    explicit FourTypes(Scene const& scene)
        : scene_(as_float(scene)),
          float_(scene_),
          double_(scene_),
          long_(scene_),
          fifty_(scene_),
          program_(scene_),
          height_(fifty_.tooth.addendum + fifty_.tooth.dedendum)
    {
    }

    [[nodiscard]] Scene const& scene() const { return scene_; }
    [[nodiscard]] Drive<double> const& in_double() const { return double_; }
    [[nodiscard]] Drive<Fifty> const& in_fifty() const { return fifty_; }
    [[nodiscard]] Fifty const& height() const { return height_; }

    [[nodiscard]] Contact operator()(Place const& p) const
    {
        Inputs<Fifty> const in = fifty_.inputs(p.piece, p.t, p.u, p.sign);
        Steps<Fifty> const right = steps(in);
        Contact c;
        c.place = p;
        c.piece = fifty_.tooth.flank[p.piece].name;
        c.condition = conditions(in, right, height_, fifty_.motion);
        c.in_float = loss<float>(float_, p, right, in);
        c.in_double = loss<double>(double_, p, right, in);
        c.in_long_double = loss<long double>(long_, p, right, in);
        c.in_program = in_roundoffs<double>(program_steps(p), right, in);
        // the program does not ask for these
        for (Judged absent : {judged_element, judged_position})
            c.in_program[absent] = 0;
        return c;
    }

    /// Steps in one type.
    template <class T>
    [[nodiscard]] Steps<T> in(Place const& p) const
    {
        if constexpr (std::is_same_v<T, float>)
            return steps(float_.inputs(p.piece, p.t, p.u, p.sign));
        else if constexpr (std::is_same_v<T, double>)
            return steps(double_.inputs(p.piece, p.t, p.u, p.sign));
        else if constexpr (std::is_same_v<T, long double>)
            return steps(long_.inputs(p.piece, p.t, p.u, p.sign));
        else
            return steps(fifty_.inputs(p.piece, p.t, p.u, p.sign));
    }

    /// n.v at the profile point of @p p and position @p u.
    template <class T>
    [[nodiscard]] T condition(Place const& p, T const& u) const
    {
        Inputs<T> in = drive<T>().inputs(p.piece, p.t, 0, p.sign);
        in.u = u;
        return steps(in).condition;
    }

    template <class T>
    [[nodiscard]] Drive<T> const& drive() const
    {
        if constexpr (std::is_same_v<T, float>)
            return float_;
        else if constexpr (std::is_same_v<T, double>)
            return double_;
        else if constexpr (std::is_same_v<T, long double>)
            return long_;
        else
            return fifty_;
    }

  private:
    [[nodiscard]] Steps<double> program_steps(Place const& p) const
    {
        return program_(double_.inputs(p.piece, p.t, p.u, p.sign), p.piece);
    }

    template <class T>
    [[nodiscard]] Losses in_roundoffs(Steps<T> const& got, Steps<Fifty> const& right, Inputs<Fifty> const& in) const
    {
        Losses losses = errors(got, right, in, height_);
        for (double& loss : losses)
            loss /= static_cast<double>(std::numeric_limits<T>::epsilon());
        return losses;
    }

    template <class T>
    [[nodiscard]] Losses loss(Drive<T> const& drive, Place const& p, Steps<Fifty> const& right,
                              Inputs<Fifty> const& in) const
    {
        return in_roundoffs(steps(drive.inputs(p.piece, p.t, p.u, p.sign)), right, in);
    }

    Scene scene_;
    Drive<float> float_;
    Drive<double> double_;
    Drive<long double> long_;
    Drive<Fifty> fifty_;
    Program program_;
    Fifty height_;
};

}  // namespace rounding
