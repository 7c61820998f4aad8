// SPDX-License-Identifier: GPL-3.0-or-later
// What any value of the library is as a result.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/accuracy_files.hpp"
#include "hdconj/contact_files.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/inspect_files.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/running_files.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "result.hpp"

namespace hdconj::python {

/// What differs between the results: overloads where the library's own do not fit.
void write_value(io::layout::Writer const& root, auto const& value)
{
    io::layout::write_result(root, value);
}
inline void write_value(io::layout::Writer const& root, LoadedDrive const& value)
{
    io::layout::write_result(root, value.study, value.measurement());
}
inline void write_value(io::layout::Writer const& root, WireCut const& value)
{
    io::layout::write_result(root, value.programs);
}
inline void write_value(io::layout::Writer const&, Design const&) {}

std::string json_of(auto const& value)
{
    return summary_json(value);
}
inline std::string json_of(LoadedDrive const& value)
{
    return summary_json(value.study, {}, value.measurement());
}
inline std::string json_of(StoredAccuracy const& value)
{
    return summary_json(value, AccuracyAdvice{}, {});
}
inline std::string json_of(WireCut const& value)
{
    return summary_json(value.programs, value.files, value.folder);
}

std::string summary_of(auto const& value)
{
    return summary_text(value);
}
inline std::string summary_of(LoadedDrive const& value)
{
    return summary_text(value.study, {}, value.measurement());
}
inline std::string summary_of(StoredAccuracy const& value)
{
    return summary_text(value, AccuracyAdvice{});
}
inline std::string summary_of(WireCut const& value)
{
    return summary_text(value.programs, value.files);
}

std::vector<std::string> missing_of(auto const&)
{
    return {};
}
inline std::vector<std::string> missing_of(ContactStudy const& value)
{
    return value.missing;
}
inline std::vector<std::string> missing_of(LoadedDrive const& value)
{
    return value.study.missing;
}

inline std::vector<std::string> missing_of(RunStudy const& value)
{
    return value.missing;
}

template <class Value>
class ResultOf final : public Result
{
  public:
    explicit ResultOf(Value value) : value_(std::move(value)) {}

    [[nodiscard]] Value const& value() const { return value_; }

    void write(io::layout::Writer const& root) const override { write_value(root, value_); }
    [[nodiscard]] std::string json() const override { return json_of(value_); }
    [[nodiscard]] std::string text() const override { return summary_of(value_); }
    [[nodiscard]] std::vector<std::string> missing() const override { return missing_of(value_); }

  private:
    Value value_;
};

template <class Value>
std::unique_ptr<Result> result_of(Value value)
{
    return std::make_unique<ResultOf<Value>>(std::move(value));
}

}  // namespace hdconj::python
