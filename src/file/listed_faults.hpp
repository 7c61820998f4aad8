// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of a long file: the first are listed, the others, which are of the same sort, counted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "hdconj/error.hpp"

namespace hdconj::file {

/// Faults that are listed of one file.
inline constexpr std::size_t most_listed_faults = 20;

/// Counts the faults that are not listed.
class FurtherFaults
{
  public:
    /// Leaves the first of @p faults, and counts the others.
    void take_from(Faults& faults)
    {
        std::size_t const listed = std::min(faults.size(), most_listed_faults);
        count_ += faults.size() - listed;
        faults.resize(listed);
    }
    /// Says in @p faults how many of @p file are not listed.
    void add_to(Faults& faults, std::string const& file) const
    {
        if (count_ > 0)
            faults.push_back(
                {"further lines", 0, "",
                 std::to_string(count_) + (count_ == 1 ? " more fault is not listed" : " more faults are not listed"),
                 "mend those that are", file});
    }

  private:
    std::size_t count_ = 0;
};

/// The faults of one file.
class ListedFaults
{
  public:
    explicit ListedFaults(std::string file) : file_(std::move(file)) {}

    /// Lists @p fault, or counts it.
    void add(Fault fault)
    {
        faults_.push_back(std::move(fault));
        further_.take_from(faults_);
    }
    /// @throws InputError where there are any
    void refuse()
    {
        if (faults_.empty())
            return;
        further_.add_to(faults_, file_);
        throw InputError(std::move(faults_));
    }

  private:
    std::string file_;
    Faults faults_;
    FurtherFaults further_;
};

}  // namespace hdconj::file
