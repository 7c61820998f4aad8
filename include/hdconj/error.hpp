// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What can go wrong: bad input (exit status 2), a computation that fails, a file that cannot be used (exit status 1).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hdconj {

/// What a fault depends on. A caller decides by it; texts are for people.
enum class FaultKind
{
    other,    ///< other keys, files or the geometry: another scene may take the same value
    unknown,  ///< a key or table of this name does not stand here, in any scene
    value     ///< the key takes no such value, in any scene
};

/// One fault of a scene or of the command line.
struct Fault
{
    std::string path;                   ///< key path such as "flexspline.profile.addendum", or a file name
    int line = 0;                       ///< line in the scene file, 1-based; 0 where there is none
    std::string value;                  ///< the offending value as the user wrote it; empty when absent
    std::string reason;                 ///< why this cannot be computed
    std::string remedy;                 ///< what to write instead
    std::string origin{};               ///< "--set" for a fault of the command line; empty: the scene
    std::vector<std::string> set{};     ///< the remedy as arguments of --set; empty where no number is known
    FaultKind kind = FaultKind::other;  ///< what it depends on
};

/// All faults found so far, in the order found.
using Faults = std::vector<Fault>;

/// Bad input: carries every fault found, not only the first.
class InputError : public std::runtime_error
{
  public:
    /// @param found  at least one fault
    explicit InputError(Faults found);
    /// A single fault.
    explicit InputError(Fault found) : InputError(Faults{std::move(found)}) {}

    /// Every fault, in the order found.
    [[nodiscard]] Faults const& faults() const { return faults_; }

  private:
    Faults faults_;
};

/// Throws InputError with @p faults where there are any.
void throw_if_any(Faults faults);

/// The kind as Python gives it: "other", "unknown", "value".
[[nodiscard]] std::string_view kind_word(FaultKind kind);

/// The message a user reads: one paragraph per fault,
/// "line 12: flexspline.wall = -0.7: reason (write ...)".
[[nodiscard]] std::string describe(Faults const& faults);

/// Orders the faults of the scene by line, those without a line after them, those of the command line last.
void sort_by_place(Faults& faults);

/// Kinds of numerical failure. A caller decides by them; texts are for people.
enum class ErrorCode
{
    not_converged,    ///< an iteration, a series or a sampling does not reach its tolerance
    not_smooth,       ///< a shape has too few derivatives for the method
    no_solution,      ///< the equations have no solution with these numbers
    no_land,          ///< no land is left at the tip circle of the circular spline; a larger tip circle may leave one
    no_outline,       ///< an outline cannot be put together, or folds over itself
    no_flank,         ///< the tip of the tooth alone makes a tooth space
    interference,     ///< teeth, or a tooth and a rim, overlap
    no_contact,       ///< bodies do not reach each other
    overload,         ///< the teeth cannot carry the torque
    unsuitable_body,  ///< dimensions of cup or bearing do not make a body that can be meshed and held
    no_reference,     ///< the accuracy study has nothing to compare with
    no_room,          ///< a dialect of the wire machine cannot hold the program
    failed_check,     ///< a result does not pass the program's own check of it
    stopped           ///< who asked for it wants no more
};

/// The code as JSON writes it: "not-converged", "no-land" ...
[[nodiscard]] std::string_view code_word(ErrorCode code);

/// A computation could not be finished to its tolerance. The message reads "stage: place: cause; remedy".
class NumericalError : public std::runtime_error
{
  public:
    /// @param code    kind of failure
    /// @param stage   part of the computation: "envelope"
    /// @param place   where in the drive: "segment 2 at u = 12.3 deg"
    /// @param cause   what happened
    /// @param remedy  what can be done, "write a larger flexspline.dedendum"; empty where nothing is known to help
    /// @param set     the same as arguments of --set; empty where no number is known
    NumericalError(ErrorCode code, std::string stage, std::string place, std::string cause, std::string remedy = {},
                   std::vector<std::string> set = {});

    [[nodiscard]] ErrorCode code() const { return code_; }                      ///< kind of failure
    [[nodiscard]] std::string const& stage() const { return stage_; }           ///< part of the computation
    [[nodiscard]] std::string const& place() const { return place_; }           ///< where in the drive
    [[nodiscard]] std::string const& cause() const { return cause_; }           ///< what happened
    [[nodiscard]] std::string const& remedy() const { return remedy_; }         ///< what can be done; may be empty
    [[nodiscard]] std::vector<std::string> const& set() const { return set_; }  ///< the same as arguments of --set

    /// Whether the drive that was asked for has no answer, as opposed to a result or a file that the program itself
    /// rejects. Searches over drives count such a drive as impossible and go on.
    [[nodiscard]] bool is_infeasible() const;
    /// Where it was caught: throws it once more unless is_infeasible().
    void rethrow_unless_infeasible() const;

    /// The same failure as an outer stage sees it: the whole former message becomes the cause.
    [[nodiscard]] NumericalError inside(std::string stage, std::string place) const;

  private:
    ErrorCode code_;
    std::string stage_, place_, cause_, remedy_;
    std::vector<std::string> set_;
};

/// A file could not be read or written.
class FileError : public std::runtime_error
{
  public:
    /// @param file    as the user gave it
    /// @param cause   what the system says, or why the file is refused
    /// @param remedy  what can be done, "write a file name in it"; empty where nothing is known to help
    FileError(std::string file, std::string cause, std::string remedy = {});

    [[nodiscard]] std::string const& file() const { return file_; }      ///< as the user gave it
    [[nodiscard]] std::string const& cause() const { return cause_; }    ///< what happened
    [[nodiscard]] std::string const& remedy() const { return remedy_; }  ///< what can be done; may be empty

  private:
    std::string file_, cause_, remedy_;
};

}  // namespace hdconj
