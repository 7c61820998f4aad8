// SPDX-License-Identifier: GPL-3.0-or-later
// The number type of references; private to src/accuracy.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

namespace hdconj::accuracy {

/// 50 decimal digits.
using Fifty =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

}  // namespace hdconj::accuracy
