// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Command lines that must be refused, as tables.
#pragma once

#include <string>

#include "hdconj_run.hpp"
#include "support/catch.hpp"

namespace hdconj::test {

/// A command line: what must be said, in what place, and the exit status.
struct BadCommand
{
    std::string arguments;
    std::string place;
    std::string reason;
    std::string remedy;
    int status = 2;
};

/// Runs @p verb, with what stands before the arguments of @p row, in @p folder: refused as the row says, nothing
/// printed as data, nothing written.
inline void check_refused(std::string const& verb, BadCommand const& row, TemporaryFolder const& folder)
{
    auto const before = folder.names();
    auto const refused = hdconj_run(verb + " " + row.arguments, folder.path());
    INFO(row.arguments << "\n" << refused.err);
    CHECK(refused.status == row.status);
    CHECK_THAT(refused.err,
               ContainsSubstring(row.place) && ContainsSubstring(row.reason) && ContainsSubstring(row.remedy));
    CHECK(refused.out.empty());
    CHECK(folder.names() == before);
}

}  // namespace hdconj::test
