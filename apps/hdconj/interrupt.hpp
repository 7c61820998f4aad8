// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C in a long run that has something to keep.
#pragma once

namespace hdconj::cli {

/// From now on the first SIGINT only asks the run to stop, and says so; the second ends the program. A process that
/// ignores SIGINT goes on to ignore it. While files are written the first one ends it (atomic_file.hpp).
void stop_at_interrupt();

/// Whether the run was asked to stop.
[[nodiscard]] bool is_stopped();

/// Ends the program as a SIGINT does.
[[noreturn]] void end_by_interrupt();

}  // namespace hdconj::cli
