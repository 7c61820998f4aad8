// SPDX-License-Identifier: GPL-3.0-or-later
// Any result of a verb, as Python sees it: its layout, its figures as JSON and text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hdconj/design.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/wire_files.hpp"
#include "io/layout/results.hpp"

namespace hdconj::python {

class Result
{
  public:
    Result() = default;
    Result(Result const&) = delete;
    Result& operator=(Result const&) = delete;
    virtual ~Result() = default;

    virtual void write(io::layout::Writer const& root) const = 0;
    [[nodiscard]] virtual std::string json() const = 0;
    [[nodiscard]] virtual std::string text() const = 0;
    /// Cases that have no result, each with its cause.
    [[nodiscard]] virtual std::vector<std::string> missing() const = 0;

    double seconds = 0;  ///< wall time of the computation [s]
};

/// A load study and the measured curve that it is compared with.
struct LoadedDrive
{
    LoadStudy study;
    std::optional<Measurement> measured;

    [[nodiscard]] Measurement const* measurement() const { return measured ? &*measured : nullptr; }
};

/// What the wire does and, where they are written, the files that say so.
struct WireCut
{
    WireSetUps programs;
    std::vector<WireFile> files;
    std::string folder;
};

}  // namespace hdconj::python
