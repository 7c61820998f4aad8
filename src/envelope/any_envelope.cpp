// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/envelope/any_envelope.hpp"

namespace hdconj::envelope {

template class ArcSampler<motion::AnyMotion>;
template BranchSet find_branches(AnyEnvelope const& envelope, int threads, bool long_job);
template SampledArc sample_arc(AnyEnvelope const& envelope, ContactArc const& arc, double from, double to, double chord,
                               int threads, ChordTest test);

}  // namespace hdconj::envelope
