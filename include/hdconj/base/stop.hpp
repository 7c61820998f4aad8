// SPDX-License-Identifier: GPL-3.0-or-later
// A long computation that somebody else wants to end.
#pragma once

#include <atomic>
#include <exception>

namespace hdconj {

/// What a computation ends with that was asked to stop. It says nothing of the drive, hence it is no NumericalError,
/// which searches take as an answer.
class Stopped : public std::exception
{
  public:
    [[nodiscard]] char const* what() const noexcept override { return "the computation was stopped"; }
};

/// While it lives, the computations of this thread, and of the loops that it starts, end with Stopped soon after
/// @p asked becomes true: at the next iteration of a parallel loop, or at the next end_if_stopped().
class StopScope
{
  public:
    /// @param asked  set by any thread or by a signal; must outlive the object. Null: nobody can ask
    explicit StopScope(std::atomic<bool> const* asked) noexcept;
    ~StopScope();
    StopScope(StopScope const&) = delete;
    StopScope& operator=(StopScope const&) = delete;

    /// That of this thread, which a loop hands to its threads; null: none.
    [[nodiscard]] static std::atomic<bool> const* of_this_thread() noexcept;

  private:
    std::atomic<bool> const* before_;
};

/// @throws Stopped where this thread was asked to stop
void end_if_stopped();

}  // namespace hdconj
