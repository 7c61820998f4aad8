// SPDX-License-Identifier: GPL-3.0-or-later
// "Did you mean": the nearest of a list of words.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace hdconj {

/// Least number of insertions, deletions, replacements and swaps of neighbours that turn @p a into @p b, no letter
/// edited twice (Damerau-Levenshtein, optimal string alignment). Costs a.size() * b.size().
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of @p words that @p given most likely means; nothing when none is near. A word is near when it is equal but
/// for case and - or _, when one is the beginning of the other, or when few typing errors separate them. Of equally
/// near words the first is taken.
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view given,
                                                      std::vector<std::string_view> const& words);

}  // namespace hdconj
