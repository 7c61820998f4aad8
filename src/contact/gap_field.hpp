// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps of all flanks of the circular spline against all teeth, for any turn of the circular spline.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "flank_deviation.hpp"
#include "flank_grid.hpp"
#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/distance/tooth_distance.hpp"

namespace hdconj::contact {

/// Teeth `first` ... of a drive: tooth i has the undeformed angle phi_i = 2 pi i / z_f + phase, and its pose is given
/// in the frame of tooth space i, whose centre line is at (z_f/z_c) phi_i from the major axis. Going on over the ends
/// of a turn, tooth i + z_f is tooth i.
struct ToothPoses
{
    int first = 0;
    std::size_t slices = 0;
    std::vector<Pose> pose;  ///< (teeth, slices)

    [[nodiscard]] Pose const& at(int tooth, std::size_t slice) const
    {
        return pose[static_cast<std::size_t>(tooth - first) * slices + slice];
    }
};

/// Gap of any flank point, in the plane of its slice.
///
/// The nearest tooth of a space is one of the three that are nearest in angle; its distance is exact (ToothDistance).
/// Turning the circular spline counter-clockwise by `turn` turns all teeth clockwise, the wave with them.
class GapField
{
  public:
    struct Index
    {
        std::size_t space;
        int flank;
        std::size_t slice;
        std::size_t point;
    };

    /// @param phase      undeformed angle of tooth 0 [rad]
    /// @param deviation  of the flanks from those of @p tooth and @p grid; null: none
    /// @param lobes      times that all gaps return around the ring, a divisor of both numbers of teeth
    GapField(profile::Profile const& tooth, FlankGrid const& grid, ToothPoses const& places, int flexspline_teeth,
             int circular_spline_teeth, double phase, FlankDeviation const* deviation = nullptr, int lobes = 1);
    GapField(GapField const&) = delete;
    GapField& operator=(GapField const&) = delete;

    /// The teeth that may be nearest to a space in one slice at one turn.
    class NearTeeth
    {
        friend GapField;
        static constexpr int candidates = 3;
        /// x = R q - shift takes a point of a space into the frame of a tooth.
        struct Placement
        {
            double cosine, sine;
            Vec2 shift;
            [[nodiscard]] Vec2 rotate_back(Vec2 const& v) const
            {
                return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
            }
            [[nodiscard]] Vec2 operator()(Vec2 const& q) const
            {
                return Vec2{cosine * q.x() + sine * q.y(), -sine * q.x() + cosine * q.y()} - shift;
            }
        };
        using Candidates = std::array<Placement, candidates>;
        std::size_t space = 0, slice = 0;
        double turn = 0;
        Candidates teeth{};
    };
    [[nodiscard]] NearTeeth near_teeth(std::size_t space, std::size_t slice, double turn) const
    {
        NearTeeth near;
        near.space = space;
        near.slice = slice;
        near.turn = turn;
        near.teeth = candidates_of(space, slice, turn);
        return near;
    }

    [[nodiscard]] FlankGrid const& grid() const { return *grid_; }
    [[nodiscard]] std::size_t spaces() const { return space_angle_.size(); }
    [[nodiscard]] int lobes() const { return lobes_; }
    /// Spaces of one lobe, which stand for all: so many, about the major axis.
    [[nodiscard]] std::size_t spaces_of_lobe() const { return spaces() / static_cast<std::size_t>(lobes_); }
    [[nodiscard]] std::size_t first_of_lobe() const { return (spaces() - spaces_of_lobe()) / 2; }
    /// Angle of the centre line of @p space from the major axis, -pi ... pi.
    [[nodiscard]] double space_angle(std::size_t space) const { return space_angle_[space]; }

    /// Its number: the space beside tooth 0 of ToothPoses is 0, the others follow clockwise.
    [[nodiscard]] int space_number(std::size_t space) const { return space_number_[space]; }

    [[nodiscard]] double gap(Index const& i, double turn) const;

    /// Gap of the flank between its points, at @p s as FlankGrid::between() counts.
    [[nodiscard]] double gap_between(std::size_t space, int flank, std::size_t slice, double s, double turn) const
    {
        return nearest(candidates_of(space, slice, turn), grid_->between(flank, slice, s)) - deduction(flank, slice);
    }

    /// Gaps of @p count neighbouring points @p q of the flank, in the frame of the space.
    void gaps(std::size_t space, int flank, std::size_t slice, Vec2 const* q, std::size_t count, double turn,
              double* out) const
    {
        gaps(near_teeth(space, slice, turn), flank, q, count, out);
    }
    /// @param gradient  gets Touch::gradient() of each; null: not asked
    void gaps(NearTeeth const& near, int flank, Vec2 const* q, std::size_t count, double* out,
              Vec2* gradient = nullptr) const
    {
        nearest(near, q, count, deduction(flank, near.slice), out, gradient);
    }

    /// The smallest gap between a point and its two neighbours on the flank, @p gap at the point: looked for at all
    /// points of the outline between them, and followed from there (minimum_of_steps()), to @p enough.
    [[nodiscard]] double lowest_about(Index const& i, double gap, double turn, double enough) const;

    /// Gaps of all points of one flank and slice at @p turn, into @p out, which holds as many.
    void along(std::size_t space, int flank, std::size_t slice, double turn, double* out) const;

    /// The tooth that is nearest to a flank point, and its nearest point in its own frame. Where flanks deviate, the
    /// distance contains the deviations of both, and the normal is that of the tooth that is made.
    struct Touch
    {
        int tooth = 0;  ///< number as in ToothPoses
        distance::NearestPoint nearest;
        Vec2 normal = Vec2::Zero();  ///< outward from the tooth, in the frame of the space
        double turn = 0;             ///< of the tooth against the space, clockwise [rad]
        Vec2 rise = Vec2::Zero();    ///< gradient of the deviation of the circular spline, in the frame of the space

        /// Of the gap, from point to point of the circular spline. Where it is across the nominal flank, the normal is
        /// across the flank that is made.
        [[nodiscard]] Vec2 gradient() const { return normal + rise; }
    };
    [[nodiscard]] Touch touch(Index const& i, double turn) const;

    /// The same of any point of the frame of @p space, in the plane of @p slice.
    [[nodiscard]] Touch touch(std::size_t space, std::size_t slice, Vec2 const& q, double turn) const
    {
        return touch(near_teeth(space, slice, turn), q);
    }
    [[nodiscard]] Touch touch(NearTeeth const& near, Vec2 const& q) const;

    /// A point of the frame of @p space where the displacement of the space puts it.
    [[nodiscard]] Vec2 placed(std::size_t space, Vec2 const& q) const
    {
        return deviation_ ? Vec2(q + displacement_at(deviation_->spaces, space_number_[space]).shift) : q;
    }

    /// All gaps at @p turn. Same bits for any number of threads. At turn 0 of a field that is_mirrored() the left
    /// flanks' gaps are those of the right flanks of the spaces on the other side: the same but for some roundings of
    /// the coordinates.
    [[nodiscard]] GapMap map(double turn, int threads) const;

    /// FlankGrid::radius; 0 where it is empty.
    [[nodiscard]] double radius(int flank, std::size_t slice) const;

    /// Largest distance of a flank point from the axis: no gap changes faster than this with the turn [mm/rad].
    [[nodiscard]] double reach() const { return reach_; }

    /// Largest distance between neighbouring points of a flank: none between them has a gap that is less by more than
    /// half of it [mm].
    [[nodiscard]] double spacing() const { return spacing_; }

  private:
    using Placement = NearTeeth::Placement;
    using Candidates = NearTeeth::Candidates;
    static constexpr int candidates = NearTeeth::candidates;
    [[nodiscard]] Candidates candidates_of(std::size_t space, std::size_t slice, double turn) const;
    /// Whether, at turn 0, the right flanks and their teeth are the mirror image of the left ones about the major axis:
    /// the points in all bits, the teeth but for roundings.
    [[nodiscard]] bool is_mirrored() const;
    [[nodiscard]] double nearest(Candidates const& teeth, Vec2 const& q) const;
    /// The same of @p count points, less @p less, into @p out.
    void nearest(NearTeeth const& near, Vec2 const* q, std::size_t count, double less, double* out,
                 Vec2* gradient) const;
    /// What is less than the distance of a point of the flank, for its gap.
    [[nodiscard]] double deduction(int flank, std::size_t slice) const { return radius(flank, slice) - opening(slice); }
    /// By how much all gaps of a slice are larger.
    [[nodiscard]] double opening(std::size_t slice) const
    {
        return deviation_ && !deviation_->slice.empty() ? deviation_->slice[slice] : 0;
    }
    /// How far a gap may be below the distance of the nominal tooth.
    [[nodiscard]] double excess() const { return deviation_ ? deviation_->excess : 0; }
    [[nodiscard]] bool has_heights() const { return deviation_ && deviation_->height; }
    /// How far a point of the circular spline stands back.
    [[nodiscard]] double standing_back(Vec2 const& q) const
    {
        return deviation_ && deviation_->radius ? deviation_->radius(q.norm()) : 0;
    }
    [[nodiscard]] Vec2 rise(Vec2 const& q) const;
    [[nodiscard]] Vec2 deviating_normal(Vec2 const& x, Vec2 const& normal) const;
    [[nodiscard]] int candidate(std::size_t space, int c) const;
    /// Turn of a tooth against a space, where the flexspline is turned by @p turn.
    [[nodiscard]] double turn_between(std::size_t space, int tooth, double turn) const;

    distance::ToothDistance distance_;
    FlankGrid const* grid_;
    ToothPoses const* places_;
    FlankDeviation const* deviation_;
    std::vector<double> space_angle_;
    std::vector<int> space_number_;
    std::vector<int> nearest_tooth_;
    double pitch_;
    int lobes_;
    bool has_mirror_image_;  ///< the tooth has, and stands on the major axis or there is a space
    double reach_ = 0;
    double spacing_ = 0;
};

/// Range of teeth that a GapField needs: first and last number.
[[nodiscard]] std::array<int, 2> teeth_needed(int flexspline_teeth, int circular_spline_teeth, double phase);

/// A gap and the point of the map it is at or beside.
struct SmallestGap
{
    double gap = 0;  ///< [mm]
    GapField::Index where{};
};

/// How far a smallest gap may be from the true one beside the rounding of coordinates: minimum_beside() ends so near
/// [mm].
[[nodiscard]] double smallest_gap_accuracy(GapField const& field);

/// The smallest gap of @p map, which holds the gaps of @p field at @p turn, with the minima between its points.
///
/// A gap falls no faster than the flank goes on, which drops most points; about the others that are smaller than their
/// neighbours the exact gap is followed to its minimum (GapField::lowest_about()). A dip between two points that
/// neither falls towards is not seen: its depth is less than what the gap changes over half their distance. It lies in
/// the lobe about the major axis.
/// @param flank  GapMap::left or GapMap::right; below 0: both
[[nodiscard]] SmallestGap smallest_gap(GapField const& field, GapMap const& map, double turn, int flank, int threads);

/// The same on one flank in one slice, whose points have the gaps @p gap; minima between points where they may lie
/// below @p below. Of @p line the point does not count.
[[nodiscard]] SmallestGap smallest_on_line(GapField const& field, GapField::Index const& line, double const* gap,
                                           double turn, double below);

}  // namespace hdconj::contact
