// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of a family (tooth profile, wave generator): what a family declares
// about its keys, and the values a scene gives them.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace hdconj::scene {

/// What kind of value a key takes; decides type check and printed unit.
enum class Quantity
{
    length,              ///< [mm], any finite number
    positive_length,     ///< [mm], > 0
    nonnegative_length,  ///< [mm], >= 0
    angle_deg,           ///< degrees in the scene
    number,              ///< without unit
    count,               ///< whole number
    word,                ///< one of ParameterSpec::words
    length_or_word,      ///< [mm], or one of ParameterSpec::words
    file,                ///< path, relative to the scene file
    rows,                ///< list of lists of numbers, each in one of the forms ParameterSpec::words
    text                 ///< any text
};

/// One key that a family understands.
struct ParameterSpec
{
    std::string_view key;
    Quantity quantity;
    std::string_view meaning;  ///< one phrase, for --help and error messages
    bool required = true;
    double at_least = -std::numeric_limits<double>::infinity();
    double at_most = std::numeric_limits<double>::infinity();
    /// Allowed words for word, length_or_word. For rows, the forms of a row, such as "[radius, sweep_deg]". A column
    /// whose name ends in _deg takes degrees, `radius` any number but 0, `length` a length of 0 or more, others a
    /// length. at_least and at_most then count rows.
    std::vector<std::string_view> words{};
};

/// @p spec with its words, or the forms of its rows.
[[nodiscard]] inline ParameterSpec with_words(ParameterSpec spec, std::vector<std::string_view> words)
{
    spec.words = std::move(words);
    return spec;
}

/// A family as the scene reader sees it: its name and the keys it understands.
struct FamilyDescription
{
    std::string_view name;
    std::string_view meaning;
    std::vector<ParameterSpec> parameters;
};

/// A list of lists of numbers, such as points.
using NumberRows = std::vector<std::vector<double>>;

/// Number, text or list as given in the scene.
using ParameterValue = std::variant<double, std::string, NumberRows>;

/// What the files of numbers hold that a scene names, by their names there; null: such a file could not be read.
using NamedTexts = std::map<std::string, std::shared_ptr<std::string const>, std::less<>>;

/// One given parameter with its place in the scene.
struct Parameter
{
    ParameterValue value;
    int line = 0;
    /// Of the name of a file, what the file held when the scene was read; null: the file is read where it is needed.
    std::shared_ptr<std::string const> content{};
};

/// A family's name and the parameters given to it (only those given).
struct FamilyChoice
{
    std::string family;
    int line = 0;      ///< of the `family` key
    std::string path;  ///< table path, "flexspline.profile"; not empty: messages begin with it
    std::map<std::string, Parameter, std::less<>> given;  ///< by key, in its unit: degrees for keys in _deg

    [[nodiscard]] bool has(std::string_view key) const { return given.find(key) != given.end(); }
    /// The number under @p key, or nothing when absent or a word.
    [[nodiscard]] std::optional<double> number(std::string_view key) const;
    /// The number under @p key, or @p otherwise when absent.
    [[nodiscard]] double number_or(std::string_view key, double otherwise) const;
    /// The word under @p key, or nothing when absent or a number.
    [[nodiscard]] std::optional<std::string> word(std::string_view key) const;
    /// The list under @p key; empty when absent or no list.
    [[nodiscard]] NumberRows const& rows(std::string_view key) const;
    /// Line of @p key, or the line of `family` when the key is absent.
    [[nodiscard]] int line_of(std::string_view key) const;
    /// The value of @p key as text for messages; empty when absent.
    [[nodiscard]] std::string text_of(std::string_view key) const;
};

}  // namespace hdconj::scene
