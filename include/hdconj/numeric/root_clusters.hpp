// SPDX-License-Identifier: GPL-3.0-or-later
// Puts together what was proved about the roots of a function on neighbouring stretches of its axis.
#pragma once

#include <algorithm>
#include <utility>

namespace hdconj::numeric {

/// Between x = lo and hi: one simple root, or a place where the function stays within its noise.
struct RootCluster
{
    double lo = 0;
    double hi = 0;
    int left = 0;              ///< sign at lo and before; 0: lo begins the axis and the sign there is not certain
    int right = 0;             ///< sign at hi and after; 0: hi ends the axis
    bool near_double = false;  ///< not decided: no root, or several; the signs say whether an odd number
    double size = 0;           ///< near_double: largest |f| where roots may be
};

/// Joins stretches, given in increasing order without gaps, into clusters.
///
/// A sign is certain where the function exceeds its noise. Cuts may fall on roots. A monotone stretch with an uncertain
/// end is joined with its neighbour. Two that are monotone in the same direction hold one simple root between them.
/// What stays undecided is reported from the last certain sign before it to the first after it.
/// @tparam Sink  called with each RootCluster, in order
template <class Sink>
class RootClusters
{
  public:
    explicit RootClusters(Sink sink) : sink_(std::move(sink)) {}

    /// The function has the certain sign @p sign on all of the stretch that begins at @p lo.
    void one_sign(double lo, int sign)
    {
        close(lo, sign);
        sign_ = sign;
    }

    /// Exactly one root between certain signs.
    void crossing(double lo, double hi, int left, int right)
    {
        close(lo, left);
        sink_(RootCluster{lo, hi, left, right, false, 0});
        sign_ = right;
    }

    /// Monotone, rising (+1) or falling (-1); @p left and @p right are the signs at the ends, 0 where not certain.
    /// @param reach  this far from an uncertain end the function has left its noise
    void monotone(double lo, double hi, int left, int right, int direction, double reach)
    {
        if (left != 0 && right != 0)
            return left == right ? one_sign(lo, left) : crossing(lo, hi, left, right);
        if (left != 0)
            close(lo, left);
        if (!open_)
            begin(lo, left != 0 ? std::max(lo, hi - reach) : lo, left != 0 ? left : sign_, direction);
        else if (direction != direction_)
            simple_ = false;
        hi_ = hi;
        if (right != 0) {
            close(simple_ ? hi : std::min(hi, lo + reach), right);
            sign_ = right;
        }
    }

    /// Within the noise, or too short to be cut further; |f| <= @p size.
    void undecided(double lo, double hi, double size)
    {
        if (!open_)
            begin(lo, lo, sign_, 0);
        simple_ = false;
        size_ = std::max(size_, size);
        hi_ = hi;
    }

    /// End of the axis.
    void finish() { close(hi_, 0); }

  private:
    void begin(double bracket, double from, int left, int direction)
    {
        open_ = true;
        simple_ = true;
        size_ = 0;
        bracket_ = bracket;
        from_ = from;
        left_ = left;
        direction_ = direction;
    }

    void close(double hi, int right)
    {
        if (!open_)
            return;
        open_ = false;
        if (!simple_)
            sink_(RootCluster{from_, hi, left_, right, true, size_});
        else if (left_ != right || left_ == 0)
            sink_(RootCluster{bracket_, hi, left_, right, false, 0});
    }

    Sink sink_;
    bool open_ = false;
    bool simple_ = true;
    int sign_ = 0;  ///< last certain sign
    int left_ = 0;
    int direction_ = 0;
    double bracket_ = 0;  ///< from where the open cluster is monotone
    double from_ = 0;     ///< from where its sign is not certain
    double hi_ = 0;
    double size_ = 0;
};

}  // namespace hdconj::numeric
