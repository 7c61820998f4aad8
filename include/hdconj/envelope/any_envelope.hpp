// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope under a motion of any model: compiled once, in the library.
#pragma once

#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/envelope/sample.hpp"
#include "hdconj/motion/any_motion.hpp"

namespace hdconj::envelope {

using AnyEnvelope = Envelope<motion::AnyMotion>;

extern template class ArcSampler<motion::AnyMotion>;
extern template BranchSet find_branches(AnyEnvelope const& envelope, int threads, bool long_job);
extern template SampledArc sample_arc(AnyEnvelope const& envelope, ContactArc const& arc, double from, double to,
                                      double chord, int threads, ChordTest test);

}  // namespace hdconj::envelope
