// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is wrong with a user's input: data, collected, reported all at once.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hdconj {

/// One fault of a scene or of the command line.
struct Fault
{
    std::string path;      ///< key path such as "flexspline.profile.addendum", or a file name
    int line = 0;          ///< line in the scene file, 1-based; 0 where there is none
    std::string value;     ///< the offending value as the user wrote it; empty when absent
    std::string reason;    ///< why this cannot be computed
    std::string remedy;    ///< what to write instead
    std::string origin{};  ///< "--set" for a fault of the command line; empty: the scene
};

/// All faults found so far, in the order found.
using Faults = std::vector<Fault>;

/// Bad input (exit status 2): carries every fault found, not only the first.
class InputError : public std::runtime_error
{
  public:
    explicit InputError(Faults found);
    explicit InputError(Fault found) : InputError(Faults{std::move(found)}) {}

    [[nodiscard]] Faults const& faults() const { return faults_; }

  private:
    Faults faults_;
};

/// The message a user reads: one paragraph per fault,
/// "line 12: flexspline.wall = -0.7: reason (write ...)".
[[nodiscard]] std::string describe(Faults const& faults);

/// Faults of the scene by line, those without a line after them, those of the command line last.
void sort_by_place(Faults& faults);

}  // namespace hdconj
