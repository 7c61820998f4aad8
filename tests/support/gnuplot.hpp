// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// With gnuplot and without.
#pragma once

#include <cstdlib>
#include <string>

#include "not_tried.hpp"
#include "report/plots/gnuplot.hpp"

namespace hdconj::test {

inline constexpr double six_digits = 1e-5;  ///< relative, of what scripts print

/// Says so where there is none.
inline bool no_gnuplot()
{
    if (!report::gnuplot::is_installed()) {
        not_tried("gnuplot");
        return true;
    }
    return false;
}

/// PATH with nothing on it, while it lives.
class EmptyPath
{
  public:
    EmptyPath() : before_(std::getenv("PATH")) { ::setenv("PATH", "", 1); }
    ~EmptyPath() { ::setenv("PATH", before_.c_str(), 1); }
    EmptyPath(EmptyPath const&) = delete;
    EmptyPath& operator=(EmptyPath const&) = delete;

  private:
    std::string before_;
};

}  // namespace hdconj::test
