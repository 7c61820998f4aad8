// SPDX-License-Identifier: GPL-3.0-or-later
// How the process takes its memory from the system.
#pragma once

namespace hdconj::cli {

/// Asks for large pages for the heap, and that what is given back to it stays: at a fine tolerance a fifth of the time
/// would go into handing out pages of 4 kB. Where the system or the C library knows no such thing nothing happens. To
/// be called before the first thread starts.
void prepare_heap();

/// The same for the heap of the thread that calls it; its first 2 MB stay in small pages, which is all that a coarse
/// tolerance takes. A heap for each thread: of one for all, small pieces are waited for, and a thread that waits
/// sleeps.
void prepare_heap_of_thread() noexcept;

}  // namespace hdconj::cli
