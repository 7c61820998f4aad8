// SPDX-License-Identifier: GPL-3.0-or-later
// The number type of references; private to src/accuracy.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace hdconj::accuracy {

/// 50 decimal digits.
using Fifty = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

}  // namespace hdconj::accuracy
