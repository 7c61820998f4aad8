// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law as a check.
#pragma once

#include "catch.hpp"
#include "support/oracle/touch_law.hpp"

namespace oracle {

inline void check_touched(TouchReport const& report)
{
    INFO(report);
    CHECK(report.touched.deviation <= touch_limit);
    CHECK(report.entered.deviation <= touch_limit);
}

}  // namespace oracle
