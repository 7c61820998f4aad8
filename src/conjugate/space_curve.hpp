// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a tooth space as a curve of exact points, whatever motion it came from.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "outline.hpp"

namespace hdconj::conjugate {

/// A point of the boundary.
struct CurvePoint
{
    Vec2 p = Vec2::Zero();  ///< [mm]
    Vec2 n = Vec2::Zero();  ///< unit normal into the circular spline's material
};

/// The boundary of one tooth space, left mid-land to right mid-land: pieces of contact arcs and lands on the tip
/// circle.
///
/// Owns what its points are computed from, so that slices can be kept and sampled together. Points are exact contacts.
class ToothSpaceBoundary
{
  public:
    /// @param offset   side clearance of the arcs [mm]
    /// @param pieces   left mid-land to right mid-land, cut where x = 0
    /// @param pitch    of the circular spline [rad]
    ToothSpaceBoundary(std::shared_ptr<profile::Profile const> tooth, motion::AnyMotion motion, double offset,
                       std::vector<envelope::ContactArc> arcs, std::vector<BoundaryPiece> pieces, double tip_radius,
                       double pitch)
        : tooth_(std::move(tooth)),
          motion_(std::make_shared<motion::AnyMotion>(std::move(motion))),
          envelope_(*tooth_, *motion_, offset),
          arcs_(std::move(arcs)),
          pieces_(std::move(pieces)),
          tip_radius_(tip_radius),
          pitch_(pitch)
    {
    }

    [[nodiscard]] profile::Profile const& tooth() const { return *tooth_; }
    [[nodiscard]] motion::AnyMotion const& motion() const { return *motion_; }
    [[nodiscard]] std::vector<BoundaryPiece> const& pieces() const { return pieces_; }
    [[nodiscard]] envelope::ContactArc const& arc(BoundaryPiece const& piece) const
    {
        return arcs_[static_cast<std::size_t>(piece.arc)];
    }
    [[nodiscard]] double tip_radius() const { return tip_radius_; }
    [[nodiscard]] double pitch() const { return pitch_; }
    [[nodiscard]] double offset() const { return envelope_.offset(); }
    /// Whether the left half is the mirror image of the right one.
    [[nodiscard]] bool symmetric() const { return tooth_->mirror_symmetric && motion_->symmetric(); }

    /// Kind and segment of what made a piece, as in an outline.
    [[nodiscard]] OutlineStretch made_by(BoundaryPiece const& piece) const
    {
        return piece.arc < 0 ? OutlineStretch{} : conjugate::made_by(*tooth_, arc(piece));
    }

    /// Point of @p piece at its parameter @p u, between its begin and its end.
    [[nodiscard]] CurvePoint at(BoundaryPiece const& piece, double u) const;

    /// Profile parameter of the contact at @p u, 0 ... 1 along its segment.
    [[nodiscard]] double profile_parameter(BoundaryPiece const& piece, double u) const;

    /// Exact points along @p piece to a chord error, in its own direction.
    [[nodiscard]] envelope::SampledArc sampled(BoundaryPiece const& piece, double chord) const;

    /// The same boundary moved by @p distance along its normal into the material (negative: out of it), tip circle too,
    /// its pieces cut or extended to where they meet then: corners stay sharp, as a constant-taper cut or a CAD draft
    /// leaves them. Paths of the tooth's corners and of its tip that turn more sharply than by this radius are
    /// left out: their neighbours meet instead. So is a stretch beside the tip circle that vanishes between its
    /// neighbours: it has become a point before it is left out, and the corner in its place is no nearer to where it
    /// was than @p distance. Exact: the contacts of an offset are those of the base.
    /// @param tip  radius of the tip circle afterwards, where that is not moved by @p distance [mm]
    /// @throws NumericalError where a flank would fold, or a piece would vanish elsewhere
    [[nodiscard]] ToothSpaceBoundary moved_along_normal(double distance, Tolerance const& tolerance,
                                                        std::optional<double> tip = std::nullopt) const;

    /// The part of this boundary outside a wider tip circle.
    [[nodiscard]] ToothSpaceBoundary cut_at(double tip) const;

  private:
    /// Which part of a moved piece runs backwards.
    enum class Vanished
    {
        nothing,
        begin,
        end,
        whole
    };
    [[nodiscard]] Vanished vanished_part(ToothSpaceBoundary const& base, BoundaryPiece& piece) const;
    /// What is left of a piece of the boundary when this moves.
    struct Remainder
    {
        BoundaryPiece before;   ///< where it was
        BoundaryPiece forward;  ///< what does not run backwards
        Vanished vanished = Vanished::nothing;
        bool cut = false;         ///< whether its end that faces the next piece was cut, or what lay there left out
        BoundaryPiece rest = {};  ///< of what runs forward, cut to its neighbour
    };
    /// Cuts what is left of pieces that vanished in part to where they meet their neighbours. One that meets none is
    /// left out.
    void cut_to_neighbours(std::vector<Remainder>& left, double distance, Tolerance const& tolerance) const;
    /// Whether what is left of a piece meets @p neighbour; cuts it there.
    [[nodiscard]] bool reaches(BoundaryPiece& rest, bool begin, BoundaryPiece const& neighbour, double distance,
                               Tolerance const& tolerance) const;
    /// @return whether they do
    [[nodiscard]] bool meet(BoundaryPiece& before, BoundaryPiece& after, double distance,
                            Tolerance const& tolerance) const;
    /// A piece that is not left between its neighbours.
    struct NoPlace
    {
        std::size_t piece = 0;
        Vec2 place = Vec2::Zero();  ///< the joint that fails, before the move [mm]
        std::string why;
    };
    /// Writes what is @p left into @p moved, each piece cut or extended to where it meets the next. @return the first
    /// piece that does not meet the next
    [[nodiscard]] std::optional<std::size_t> first_gap(std::vector<Remainder> const& left, ToothSpaceBoundary& moved,
                                                       double distance, Tolerance const& tolerance) const;
    /// The same, and parts that lie beyond a joint are taken out, those that lie beyond an end put in. @return the
    /// first that has no place
    [[nodiscard]] std::optional<NoPlace> join(std::vector<Remainder>& left, ToothSpaceBoundary& moved, double distance,
                                              Tolerance const& tolerance) const;
    /// Where the arc of @p piece ends beside its begin or its end.
    [[nodiscard]] double end_beside(BoundaryPiece const& piece, bool begin) const;
    /// The arc on which the boundary of @p piece goes on where the piece's own arc ends, as at a knot of a wave
    /// generator's curve: whole, in the piece's direction.
    /// @param begin  whether the piece begins there
    [[nodiscard]] std::optional<BoundaryPiece> beyond(BoundaryPiece const& piece, bool begin,
                                                      Tolerance const& tolerance) const;
    /// Whether @p gone, one of two pieces of which the first runs on into the second, may vanish beyond the other: a
    /// part of the same stretch of the outline, or the path of a corner.
    [[nodiscard]] bool may_go(Remainder const& gone, Remainder const& before, Remainder const& after) const;
    /// Takes out of what is @p left the parts beside the joint of pieces @p i and i + 1 that lie beyond it, where the
    /// curve on one side meets the other only in a part further away. Beside a land nothing is taken out: join() looks
    /// whether that may go. @return whether it does
    [[nodiscard]] bool shorten(std::vector<Remainder>& left, std::size_t i, ToothSpaceBoundary const& moved,
                               double distance, Tolerance const& tolerance) const;
    /// Puts between the pieces @p i and i + 1 of what is @p left what lies beyond one of them, where it meets the other
    /// one. @return whether it does
    [[nodiscard]] bool extend(std::vector<Remainder>& left, std::size_t i, ToothSpaceBoundary const& moved,
                              double distance, Tolerance const& tolerance) const;
    /// Distance of the nearest corner of a land [mm].
    [[nodiscard]] double nearest_corner_of_land(envelope::SampledArc const& from) const;
    [[nodiscard]] TurnedArc<motion::AnyMotion> turned(BoundaryPiece const& piece) const
    {
        return {envelope_, arc(piece), piece.copy * pitch_};
    }

    std::shared_ptr<profile::Profile const> tooth_;
    std::shared_ptr<motion::AnyMotion const> motion_;  // the envelope keeps a pointer to it
    envelope::AnyEnvelope envelope_;
    std::vector<envelope::ContactArc> arcs_;
    std::vector<BoundaryPiece> pieces_;
    double tip_radius_;
    double pitch_;
};

}  // namespace hdconj::conjugate
