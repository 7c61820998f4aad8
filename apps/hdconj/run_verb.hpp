// SPDX-License-Identifier: GPL-3.0-or-later
// The run that all verbs share: targets are checked, the result is computed and written, figures are printed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/file/atomic_file.hpp"
#include "hdconj/file/written_file.hpp"
#include "hdconj/note.hpp"
#include "hdconj/plan.hpp"
#include "outputs.hpp"
#include "verb.hpp"

namespace hdconj::cli {

/// On a terminal, names the stage that runs, over and over in one line; where nobody looks it says nothing.
class ProgressLine
{
  public:
    explicit ProgressLine(bool wanted);
    ~ProgressLine() { clear(); }
    ProgressLine(ProgressLine const&) = delete;
    ProgressLine& operator=(ProgressLine const&) = delete;

    void say(std::string const& what) const;
    /// The same with a bar; @p share 0 ... 1.
    void say(std::string const& what, double share) const;
    /// A line that stays on the screen.
    void keep(std::string const& line) const;
    void clear() const;

    /// Says each stage that begins. The observer must not outlive this object.
    [[nodiscard]] StageObserver stages() const;
    /// Says what runs, and how much of all is done. The function must not outlive this object.
    [[nodiscard]] std::function<void(std::string const&, double)> shares() const;

  private:
    bool shown_;
};

using Written = std::vector<WrittenFile>;

/// A target, and how it is made of the result of a verb.
template <class Result>
struct Output
{
    OutputTarget target;
    std::function<Written(Result&)> write;
};

/// What a verb does; functions that are null do nothing.
template <class Result>
struct Work
{
    Faults faults;                  ///< of the scene and of options, which are told with those of the outputs
    std::vector<InputFile> inputs;  ///< that no output may replace
    std::vector<Output<Result>> outputs;
    std::function<Result(ProgressLine const&)> compute;
    std::function<std::string(Result const&, Written const&)> text;  ///< the printed summary
    std::function<std::string(Result const&, Written const&)> json;  ///< the same figures for --json
    /// What is said to be written on standard error, a line each; null: the files, where the printed summary does not
    /// name them.
    std::function<std::vector<std::string>(Result const&, Written const&)> wrote;
    std::function<int(Result const&)> status;       ///< the exit status; null: done
    std::function<Notes(Result const&)> judgement;  ///< of the design, for --strict; null: none
};

/// Runs @p write and keeps its time.
[[nodiscard]] WrittenFile timed(std::string const& kind, std::filesystem::path const& file,
                                std::function<void()> const& write);

/// Names of the files.
[[nodiscard]] std::vector<std::string> names_of(Written const& written);

/// What a verb with several results ends with: done, or failed where some are @p missing, which is said on standard
/// error.
[[nodiscard]] int status_of_missing(std::vector<std::string> const& missing);

/// Adds the file @p name to @p work; none where the name is empty.
/// @param option  that names it
/// @param write   write(result, file)
/// @param check   what can be known about it before the long work; throws
template <class Result, class Write>
void add_file(Work<Result>& work, std::string const& kind, std::string const& option, std::filesystem::path const& name,
              Write write, std::function<void(std::filesystem::path const&)> check = file::check_target)
{
    if (name.empty())
        return;
    work.outputs.push_back(
        {{kind, option, name, [check = std::move(check), name] { check(name); }}, [kind, name, write](Result& result) {
             return Written{timed(kind, name, [&] { write(std::as_const(result), name); })};
         }});
}

/// @p status, or failed where it is done, --strict is given and @p notes hold a warning, which is said on standard
/// error.
[[nodiscard]] int strict_status(CommonOptions const& common, Notes const& notes, int status);

/// Prints the text, and what was written unless @p common is quiet.
void print_result(CommonOptions const& common, std::string const& text, std::vector<std::string> const& wrote);

/// Runs a verb: checks all targets, computes, writes, prints.
/// @return the exit status
template <class Result>
int run_verb(CommonOptions const& common, Work<Result> const& work)
{
    std::vector<OutputTarget> targets;
    for (auto const& output : work.outputs)
        targets.push_back(output.target);
    check_outputs(targets, work.inputs, work.faults);
    Written written;
    ProgressLine const progress(!common.quiet);
    Result result = work.compute(progress);
    for (auto const& output : work.outputs) {
        progress.say(output.target.kind);
        append(written, output.write(result));
    }
    progress.clear();
    auto const& summary = common.json ? work.json : work.text;
    bool const printed = summary && (common.json || !common.quiet);
    std::vector<std::string> const files = common.json ? names_of(written) : std::vector<std::string>{};
    print_result(common, printed ? summary(result, written) : "", work.wrote ? work.wrote(result, written) : files);
    int const status = work.status ? work.status(result) : exit_done;
    return work.judgement ? strict_status(common, work.judgement(result), status) : status;
}

}  // namespace hdconj::cli
