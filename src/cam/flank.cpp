// SPDX-License-Identifier: GPL-3.0-or-later
#include "flank.hpp"

namespace hdconj::cam {
namespace {

struct Derivatives
{
    Vec2 point, first, second;
};

Derivatives derivatives(profile::LinePiece const& line, double t)
{
    return {line.a + t * (line.b - line.a), line.b - line.a, Vec2::Zero()};
}

Derivatives derivatives(profile::ArcPiece const& arc, double t)
{
    double const sweep = arc.to - arc.from;
    Vec2 const n = direction(arc.from + sweep * t);
    return {arc.centre + arc.radius * n, arc.radius * sweep * left_of(n), -arc.radius * sweep * sweep * n};
}

Derivatives derivatives(profile::CurvePiece const& curve, double t)
{
    return {curve.point(t), curve.first(t), curve.second(t)};
}

double length_of(profile::PieceShape const& shape)
{
    // panels of Simpson's rule: only the step of a search, and no result, depends on it
    constexpr int panels = 4;
    double sum = 0;
    for (int i = 0; i <= 2 * panels; ++i) {
        double const t = i / (2.0 * panels);
        double const speed = std::visit([t](auto const& s) { return derivatives(s, t).first.norm(); }, shape);
        sum += speed * (i == 0 || i == 2 * panels ? 1 : (i % 2 == 1 ? 4 : 2));
    }
    return sum / (6 * panels);
}

}  // namespace

Flank::Flank(profile::Profile const& tooth)
{
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i) {
        profile::ProfilePiece const& piece = tooth.pieces[i];
        bool const right = profile::start_of(piece.shape).point.x() + profile::end_of(piece.shape).point.x() > 0;
        if (piece.corner || !right || profile::is_tip(tooth, static_cast<int>(i)))
            continue;
        begins_.push_back(length_);
        pieces_.push_back(piece.shape);
        length_ += length_of(piece.shape);
    }
}

PointOnFlank Flank::at(FlankPlace const& place) const
{
    Derivatives const d =
        std::visit([&](auto const& shape) { return derivatives(shape, place.t); }, pieces_[place.piece]);
    double const speed = d.first.norm();
    return {d.point, d.first / speed, cross(d.first, d.second) / (speed * speed * speed), speed};
}

bool Flank::advance(FlankPlace& place, double way) const
{
    while (way != 0) {
        double const speed = at(place).speed;
        double const t = place.t + way / speed;
        if (t >= 0 && t <= 1) {
            place.t = t;
            return true;
        }
        bool const forward = t > 1;
        double const end = forward ? 1 : 0;
        way -= (end - place.t) * speed;
        place.t = end;
        if (forward ? place.piece + 1 == pieces_.size() : place.piece == 0)
            return false;
        place = forward ? FlankPlace{place.piece + 1, 0} : FlankPlace{place.piece - 1, 1};
        // what rounding leaves at a joint must not go back and forth
        if (forward ? way <= 0 : way >= 0)
            return true;
    }
    return true;
}

std::vector<FlankPlace> Flank::places(double step) const
{
    std::vector<FlankPlace> result;
    double next = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        double const end = i + 1 < pieces_.size() ? begins_[i + 1] : length_;
        for (; next < end; next += step)
            result.push_back({i, (next - begins_[i]) / (end - begins_[i])});
    }
    if (!pieces_.empty())
        result.push_back({pieces_.size() - 1, 1});
    return result;
}

double Flank::from_tip(FlankPlace const& place) const
{
    double const end = place.piece + 1 < pieces_.size() ? begins_[place.piece + 1] : length_;
    return begins_[place.piece] + place.t * (end - begins_[place.piece]);
}

}  // namespace hdconj::cam
