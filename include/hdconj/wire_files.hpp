// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `wedm` writes and prints: one list of wire moves in the dialects of CAD programs and machines.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/file/written_file.hpp"
#include "hdconj/wedm.hpp"

namespace hdconj {

/// A dialect that wire programs can be written in.
struct WireDialect
{
    std::string_view name;     ///< word for `--dialect`
    std::string_view meaning;  ///< one line for --help
    std::string_view
        verified_by;  ///< reader that is not ours and accepts it; empty: not verified, on hardware or otherwise
    bool only_untilted = false;  ///< can be written only where both faces are the same

    /// Whether another reader than ours has accepted it.
    [[nodiscard]] bool verified() const { return !verified_by.empty(); }
};

/// All dialects, in the order written.
[[nodiscard]] std::vector<WireDialect> wire_dialects();

/// Those that can be written of @p program.
[[nodiscard]] std::vector<std::string> fitting_dialects(WireProgram const& program);

/// A dialect whose grid or lengths of files have no room for a program.
struct UnfitDialect
{
    std::string name;                            ///< of the dialect
    std::string place;                           ///< "pass 1, block 67 (contour, tooth 151)"
    std::string cause;                           ///< why the program does not fit
    std::optional<int> decimals = std::nullopt;  ///< of wedm.decimals with which it does; nothing: none helps
};

/// Those of @p dialects with limits of their own, which no key of the scene changes, that cannot hold all of
/// @p programs; empty: of all that fit the kind of part, those with the grid of wedm.decimals among them. Blocks that a
/// grid loses cannot be joined to their neighbours: moves are already as long as the tolerance lets them be.
[[nodiscard]] std::vector<UnfitDialect> unfit_dialects(WireSetUps const& programs,
                                                       std::vector<std::string> const& dialects = {});

/// Dialects that the scene names in wedm.dialects; none: all that fit.
[[nodiscard]] std::vector<std::string> named_dialects(Scene const& scene);

/// Deals with the dialects that cannot hold @p programs. Where @p dialects names them that is an error; else the
/// programs list them as left out. The error's remedy is the least of some coarser values of wedm.tolerance with which
/// all of @p dialects hold the part; the paths are made anew with each. There may be none.
/// @param programs  of @p scene
/// @param scene     with [wedm]
/// @param dialects  that were asked for by name; empty: all that fit
/// @param solved    the circular spline, where it has been solved; null: it is solved where it is needed
/// @throws NumericalError where a named dialect cannot hold them
void settle_unfit_dialects(WireSetUps& programs, Scene const& scene, std::vector<std::string> const& dialects,
                           Solution const* solved = nullptr);

/// A file of a wire program.
struct WireFile
{
    std::string dialect;           ///< name of the dialect
    std::string_view verified_by;  ///< as of the dialect
    std::string name;              ///< in the folder
    int set_up = 1;                ///< number of the clamping
    int pass = 0;                  ///< 0: all passes
    std::size_t blocks = 0;        ///< straight moves in it
    std::size_t bytes = 0;         ///< size of the file
    double unit = 0;               ///< last digit [mm]; 0: not rounded
    double drift = 0;      ///< largest distance, along the whole path and in both faces, of what is read back from the
                           ///< exact; of all files of its dialect [mm]
    double cut_error = 0;  ///< bound for the distance of the cut from the nominal faces when the file is run, residual
                           ///< material apart: that of the exact path and the drift [mm]

    /// Whether another reader than ours has accepted the dialect.
    [[nodiscard]] bool verified() const { return !verified_by.empty(); }
};

/// Dialects that are not known.
/// @param dialects  names
/// @param place     option or key that names them, for messages
[[nodiscard]] Faults check_dialects(std::vector<std::string> const& dialects, std::string const& place = "--dialect");

/// Dialects of wedm.dialects that are not known, at their place in the scene, which has a table [wedm].
[[nodiscard]] Faults check_named_dialects(Scene const& scene);

/// What can be known before the long work.
/// @param folder    that the files will stand in
/// @param dialects  empty: all that fit
/// @param place     option or key that names them, for messages
/// @throws InputError for a dialect that is not known; FileError where @p folder cannot be made, or holds files that
/// are not ours
void check_wire_files(std::filesystem::path const& folder, std::vector<std::string> const& dialects = {},
                      std::string const& place = "--dialect");

/// Writes the set-ups @p programs of one part into @p folder, with a summary, a setup
/// sheet (text and SVG) and a list of the files, files.txt. Where there are
/// several set-ups, names of files say which they belong to. Either all files appear or none. They are made in a
/// temporary folder beside it, and each is read back from there. The path so read must agree with both faces to one
/// unit of its last digit. Then the folder is renamed. A folder that was written so before is replaced as a whole.
///
/// Checked before, of the path: pairing, finite numbers, a vertical wire at begin and end, no block of length zero in
/// either plane after rounding. Checked of the texts: characters, line lengths, no exponent, no negative zero, equal
/// words for equal faces.
/// @param programs  the set-ups of one part
/// @param folder    that is made, or replaced where it was written so before
/// @param dialects  empty: all that fit. unfit_dialects() are left out; the warnings of the programs do not say so
/// @throws NumericalError with file, line and cause where a check fails; InputError, FileError. Nothing is written
/// then.
std::vector<WireFile> write_wire_files(WireSetUps const& programs, std::filesystem::path const& folder,
                                       std::vector<std::string> const& dialects = {});

/// The printed summary that a machine operator reads: wire and gap, passes, faces, guides, files, residuals, what was
/// checked.
[[nodiscard]] std::string summary_text(WireSetUps const& programs, std::vector<WireFile> const& files = {});

/// One page for whoever clamps and cuts the part: part, faces and which is larger, wire and guides, start, direction,
/// stops, passes, files, and which of them no other reader than ours has accepted.
[[nodiscard]] std::string setup_sheet_text(WireSetUps const& programs, std::vector<WireFile> const& files = {});

/// The same as a picture of a sheet A4 (SVG), with the part from above, the start, and the planes from the side.
[[nodiscard]] std::string setup_sheet_svg(WireSetUps const& programs, std::vector<WireFile> const& files = {});

/// The same figures as one JSON object, keys in docs/reference/json.md. Numbers are finite or null.
[[nodiscard]] std::string summary_json(WireSetUps const& programs, std::vector<WireFile> const& files = {},
                                       std::filesystem::path const& folder = {},
                                       std::vector<WrittenFile> const& pictures = {});

/// Names of the pictures of a wire program: NAME.svg or .png stands for three or four.
struct WirePictures
{
    std::filesystem::path tooth;  ///< NAME-tooth.svg: one tooth space in both faces, with the wire
    std::vector<std::filesystem::path>
        rings;  ///< NAME-ring.svg: the whole contour, start hole, lead-in; NAME-ring1.svg and on of several set-ups
    std::filesystem::path residual;  ///< NAME-residual.svg: what no pass reaches
};

/// Names of the pictures for @p file, NAME.svg or NAME.png.
[[nodiscard]] WirePictures wire_picture_names(std::filesystem::path const& file, std::size_t set_ups = 1);

/// What can be known before the long work. Throws what write_wire_pictures() would.
void check_wire_pictures(std::filesystem::path const& file, std::size_t set_ups = 1);

/// Draws them with gnuplot; the residual map only where there is any.
std::vector<WrittenFile> write_wire_pictures(WireSetUps const& programs, std::filesystem::path const& file);

}  // namespace hdconj
