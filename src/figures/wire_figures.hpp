// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a wire program, which has no HDF5: names are keys of JSON.
#pragma once

#include <string>
#include <vector>

#include "figure_of.hpp"
#include "hdconj/wedm.hpp"
#include "hdconj/wire_files.hpp"

namespace hdconj::figures {

/// A program and what was measured of it.
struct MeasuredProgram
{
    WireProgram const& program;
    WireFigures figures;

    explicit MeasuredProgram(WireProgram const& of) : program(of), figures(measured(of)) {}
};

/// A pass and what was measured of it.
struct MeasuredPass
{
    WirePass pass;
    PassFigures figures;
};

[[nodiscard]] Rows<MeasuredProgram> wire_figures();
/// Of the checks; only of a program that was checked.
[[nodiscard]] Rows<MeasuredProgram> wire_check_figures();
/// Of the contour in one face.
[[nodiscard]] Rows<FaceRadii> face_figures();
[[nodiscard]] Rows<MeasuredPass> pass_figures();
[[nodiscard]] Rows<Residual> residual_figures();
[[nodiscard]] Rows<WireFile> wire_file_figures();

/// The warnings of @p program, and of @p files whose cut may exceed the tolerance.
[[nodiscard]] std::vector<std::string> wire_warnings(WireProgram const& program, std::vector<WireFile> const& files);

}  // namespace hdconj::figures
