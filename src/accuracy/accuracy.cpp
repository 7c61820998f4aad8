// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/accuracy.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>

#include "hdconj/base/parallel.hpp"
#include "study_case.hpp"

namespace hdconj {
namespace {

std::string processor()
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            return line.substr(std::min(line.find(':') + 2, line.size()));
    return "unknown";
}

/// Gives @p to what @p from has along the axis.
void give_axis(Scene const& from, Scene& to)
{
    to.coning = from.coning;
    to.slices = from.slices;
    to.tilt = from.tilt;
}

/// One run of all studies that are wanted.
class Measuring
{
  public:
    Measuring(Scene const& scene, AccuracyOptions const& options, StudyProgress const& progress)
        : options_(options), progress_(progress), scene_share_(options.sample > 0 ? 1.0 / 8 : 1.0)
    {
        report_.quick = options.quick;
        report_.scene = accuracy::plain(scene, notes_);
        report_.threads = thread_count(scene.solver.threads);
        report_.machine = processor();
        chosen_ = accuracy::wanted(report_.scene, options, notes_);
        flat_ = report_.scene;
        give_axis({}, flat_);
    }

    AccuracyReport operator()()
    {
        auto const start = std::chrono::steady_clock::now();
        measure_scene(reference());
        if (report_.records.empty())
            throw InputError(accuracy::nothing_measured(chosen_, notes_));
        // what this drive has not, designs about it have not either
        std::erase_if(chosen_, [&](accuracy::Study const& study) {
            return std::none_of(report_.records.begin(), report_.records.end(),
                                [&](StudyRecord const& record) { return record.study == study.kind.name; });
        });
        measure_sample();
        report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        for (accuracy::StudyNote const& note : notes_)
            report_.notes.push_back(note.study.empty() ? note.words : note.study + ": " + note.words);
        return std::move(report_);
    }

  private:
    void say(std::string const& what, double share) const
    {
        if (progress_)
            progress_(what, share);
    }

    /// The scene's own drive; what needs no reference still runs where there is none.
    accuracy::Case reference()
    {
        accuracy::Case whole{flat_, {}, {}};
        if (std::none_of(chosen_.begin(), chosen_.end(), accuracy::has_outline))
            return whole;
        say("reference in 50 digits", 0);
        constexpr int points = 240, positions = 1200;
        try {
            whole = accuracy::case_of(flat_, chosen_, points, positions);
            report_.reference_error = whole.error();
            report_.reference_interference = whole.entry();
        } catch (NumericalError const& error) {
            if (std::all_of(chosen_.begin(), chosen_.end(), accuracy::has_outline))
                throw;
            for (accuracy::Study const& study : chosen_)
                if (accuracy::has_outline(study))
                    notes_.push_back({std::string(study.kind.name), std::string("left out, ") + error.what()});
            std::erase_if(chosen_, accuracy::has_outline);
        }
        return whole;
    }

    void measure_scene(accuracy::Case const& whole)
    {
        std::size_t done = 0;
        for (accuracy::Study const& study : chosen_) {
            say(std::string(study.kind.name),
                scene_share_ * static_cast<double>(done++) / static_cast<double>(chosen_.size()));
            accuracy::run_study(study, whole,
                                {report_, notes_, flat_, report_.scene.drive.name,
                                 options_.quick ? 1 : options_.repeats, options_.quick, false, report_.threads},
                                report_.scene);
        }
    }

    /// Designs about the scene, a few at a time: their references take more memory than what is measured.
    void measure_sample()
    {
        constexpr int most_drawn = 4;  // times as many as wanted
        std::vector<Unfinished> unfinished(chosen_.size());
        for (int drawn = 0;
             !chosen_.empty() && report_.sample < options_.sample && drawn < most_drawn * options_.sample;) {
            int const batch = std::min(options_.sample - report_.sample, report_.threads);
            std::vector<std::unique_ptr<accuracy::Case>> const designs =
                accuracy::designs_of(flat_, chosen_, options_.seed, drawn, batch, report_.threads);
            drawn += batch;
            report_.sample_refused += batch - static_cast<int>(designs.size());
            for (auto const& one : designs)
                measure_design(*one, unfinished);
        }
        for (std::size_t k = 0; k < chosen_.size(); ++k)
            if (unfinished[k].designs > 0)
                notes_.push_back({std::string(chosen_[k].kind.name),
                                  fmt::format("not finished on {} of {} designs of the sample; the first is {}",
                                              unfinished[k].designs, report_.sample, unfinished[k].first)});
    }

    /// Designs that a study was not finished on.
    struct Unfinished
    {
        int designs = 0;
        std::string first;  ///< which, and why
    };

    void measure_design(accuracy::Case const& one, std::vector<Unfinished>& unfinished)
    {
        report_.reference_error = std::max(report_.reference_error, one.error());
        report_.reference_interference = std::max(report_.reference_interference, one.entry());
        std::string const name =
            "design-" + std::string(report_.sample < 10 ? "0" : "") + std::to_string(report_.sample);
        say(name, scene_share_ + (1 - scene_share_) * report_.sample / options_.sample);
        ++report_.sample;
        Scene coned = one.scene;
        give_axis(report_.scene, coned);
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            try {
                accuracy::run_study(chosen_[k], one, {report_, notes_, one.scene, name, 1, options_.quick, true, 1},
                                    coned);
            } catch (NumericalError const& error) {
                // such as another motion model with which the teeth have no land: what was measured before stays
                if (unfinished[k].designs++ == 0)
                    unfinished[k].first = name + ": " + error.what();
            }
        }
    }

    AccuracyOptions const& options_;
    StudyProgress const& progress_;
    double scene_share_;  ///< of the time
    AccuracyReport report_;
    std::vector<accuracy::StudyNote> notes_;
    std::vector<accuracy::Study> chosen_;
    Scene flat_;  ///< the scene's drive without what it has along the axis
};

}  // namespace

AccuracyReport measure_accuracy(Scene const& scene, AccuracyOptions const& options, StudyProgress const& progress)
{
    throw_if_any(check_accuracy(scene, options));
    return Measuring(scene, options, progress)();
}

}  // namespace hdconj
