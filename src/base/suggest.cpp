// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/base/suggest.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace hdconj {
namespace {

constexpr std::size_t letters_per_error = 3;   ///< one typing error is believed for every so many letters
constexpr std::size_t shortest_beginning = 3;  ///< letters that a word's beginning needs to count as meant
constexpr std::size_t longest_word = 64;       ///< longer texts are no misspelt keys

/// Lower case, '-' as '_': differences that are no typing errors.
std::string folded(std::string_view word)
{
    std::string result;
    for (char const c : word)
        result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '-' || c == ' ' ? '_' : c;
    return result;
}

bool begins(std::string_view word, std::string_view with)
{
    return with.size() >= shortest_beginning && word.substr(0, with.size()) == with;
}

/// 0 for the same word; no value when too far.
std::optional<std::size_t> distance(std::string const& given, std::string const& word)
{
    std::size_t const steps = edit_distance(given, word);
    std::size_t const believed = std::max<std::size_t>(1, std::max(given.size(), word.size()) / letters_per_error);
    if (steps <= believed && steps < std::min(given.size(), word.size()))
        return steps;
    if (begins(word, given) || begins(given, word))
        return believed + 1;
    return std::nullopt;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    std::iota(previous.begin(), previous.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            std::size_t const replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])  // swapped
                current[j] = std::min(current[j], before[j - 2] + 1);
        }
        before.swap(previous);
        previous.swap(current);
    }
    return previous[b.size()];
}

std::optional<std::string_view> nearest(std::string_view given, std::vector<std::string_view> const& words)
{
    if (given.empty() || given.size() > longest_word)
        return std::nullopt;
    std::string const wanted = folded(given);
    std::optional<std::string_view> best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (auto const word : words) {
        auto const steps = distance(wanted, folded(word));
        if (steps && *steps < least) {
            best = word;
            least = *steps;
        }
    }
    return best;
}

}  // namespace hdconj
