// SPDX-License-Identifier: GPL-3.0-or-later
// Threads of one loop, each on a processor of its own.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace hdconj {

/// The processors that the threads of one loop began on.
///
/// A kernel may start or wake a thread on the processor of the one that wakes it, and look for an idle one milliseconds
/// later; until then the loop has one processor, whatever stands idle. So a thread that finds its processor taken moves
/// to one that is not. It is bound to nothing: the processors that it may use are the same afterwards, and a user's own
/// binding is kept to. Only on Linux; elsewhere nothing is done.
class SeparateProcessors
{
  public:
    /// By the thread that begins the loop; its processor is taken.
    SeparateProcessors() noexcept;

    /// By every other thread, once, before its first iteration.
    void settle() noexcept;

  private:
    /// Whether @p processor was free before. Those past the last word are never taken.
    bool take(int processor) noexcept;

    static constexpr std::size_t word_bits = 64;
    std::array<std::atomic<std::uint64_t>, 16> taken_{};
};

}  // namespace hdconj
