// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_group.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <vector>

#include "figures/contact_figures.hpp"

namespace hdconj::report {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

constexpr std::size_t most_doubles = 4096;   // of an array that keeps its precision
constexpr std::size_t most_values = 200000;  // of one that is not thinned

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(unsigned char const* bytes, std::size_t count)
{
    std::string text;
    text.reserve((count + 2) / 3 * 4);
    for (std::size_t i = 0; i < count; i += 3) {
        unsigned const one = bytes[i], two = i + 1 < count ? bytes[i + 1] : 0U,
                       three = i + 2 < count ? bytes[i + 2] : 0U;
        unsigned const all = one << 16 | two << 8 | three;
        text += letters[all >> 18];
        text += letters[all >> 12 & 63];
        text += i + 1 < count ? letters[all >> 6 & 63] : '=';
        text += i + 2 < count ? letters[all & 63] : '=';
    }
    return text;
}

/// The bytes that base64() made @p text of.
std::string bytes_of(std::string_view text)
{
    std::string bytes;
    unsigned all = 0;
    int bits = 0;
    for (char const letter : text) {
        if (letter == '=')
            break;
        all = all << 6 | static_cast<unsigned>(letters.find(letter));
        bits += 6;
        if (bits >= 8)
            bytes += static_cast<char>(all >> (bits -= 8) & 255);
    }
    return bytes;
}

template <class Number>
std::vector<double> numbers_in(std::string const& bytes)
{
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
    return {numbers.begin(), numbers.end()};
}

/// The dimension along which a map of @p dims may be thinned; none: their number.
std::size_t thinned_dimension(io::layout::Dims const& dims)
{
    auto const found = std::find_if(dims.begin(), dims.end(), [](std::string_view dim) {
        return dim == figures::flank_position.now || dim == "phi";
    });
    return static_cast<std::size_t>(found - dims.begin());
}

/// Every n-th slab of @p values along the dimension @p along, so that at most most_values are left; n into @p every.
std::vector<double> every_nth(io::layout::Shape& shape, double const* values, std::size_t along, std::size_t& every)
{
    auto const product = [&](std::size_t from, std::size_t to) {
        return std::accumulate(shape.begin() + static_cast<std::ptrdiff_t>(from),
                               shape.begin() + static_cast<std::ptrdiff_t>(to), std::size_t{1}, std::multiplies<>());
    };
    std::size_t const outer = product(0, along), inner = product(along + 1, shape.size()), length = shape[along];
    every = (product(0, shape.size()) + most_values - 1) / most_values;
    std::vector<double> kept;
    for (std::size_t o = 0; o < outer; ++o)
        for (std::size_t i = 0; i < length; i += every) {
            double const* const slab = values + (o * length + i) * inner;
            kept.insert(kept.end(), slab, slab + inner);
        }
    shape[along] = (length + every - 1) / every;
    return kept;
}

Json json_of(io::layout::AttributeValue const& value)
{
    return std::visit(
        [](auto const& given) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(given)>, double>)
                return number(given);
            else
                return given;
        },
        value);
}

}  // namespace

Json array_json(std::string_view type, io::layout::Shape const& shape, void const* values, std::size_t bytes)
{
    return {{"type", type}, {"shape", shape}, {"data", base64(static_cast<unsigned char const*>(values), bytes)}};
}

Json array_json(io::layout::Shape const& shape, double const* values)
{
    std::size_t const count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
    if (count <= most_doubles)
        return array_json("f8", shape, values, count * sizeof(double));
    std::vector<float> single(count);
    std::transform(values, values + count, single.begin(), [](double value) { return static_cast<float>(value); });
    return array_json("f4", shape, single.data(), count * sizeof(float));
}

std::vector<double> array_values(Json const& array)
{
    std::string const type = array.at("type").get<std::string>(),
                      bytes = bytes_of(array.at("data").get_ref<std::string const&>());
    return type == "f8" ? numbers_in<double>(bytes) : type == "f4" ? numbers_in<float>(bytes) : numbers_in<int>(bytes);
}

std::vector<double> column_of(Json const& group, char const* name, double unit)
{
    if (!group.contains("datasets") || !group.at("datasets").contains(name))
        return {};
    std::vector<double> values = array_values(group.at("datasets").at(name));
    for (double& value : values)
        value /= unit;
    return values;
}

Json group_at(Json const& root, std::initializer_list<std::string> path)
{
    Json const* group = &root;
    for (std::string const& name : path) {
        if (!group->contains("groups") || !group->at("groups").contains(name))
            return Json::object();
        group = &group->at("groups").at(name);
    }
    return *group;
}

std::vector<Json> groups_of(Json const& group, std::string_view beginning)
{
    std::vector<Json> found;
    if (!group.contains("groups"))
        return found;
    for (auto const& [name, each] : group.at("groups").items())
        if (name.starts_with(beginning))
            found.push_back(each);
    return found;
}

double attribute_of(Json const& group, char const* name)
{
    Json const attributes = group.value("attributes", Json::object());
    return attributes.contains(name) && attributes.at(name).is_number() ? attributes.at(name).get<double>() : 0;
}

void JsonGroup::group(std::string const& name, std::function<void(io::layout::GroupSink&)> const& fill)
{
    if (left_.contains(name))
        return;
    JsonGroup inner(left_);
    fill(inner);
    json_["groups"][name] = inner.json_;
}

void JsonGroup::dataset(std::string const& name, io::layout::Shape const& shape, io::layout::Values const& values,
                        io::layout::About const& about)
{
    if (left_.contains(name))
        return;
    Json& made = json_["datasets"][name];
    if (auto const* const texts = std::get_if<std::string const*>(&values)) {
        made = {{"texts", std::vector<std::string>(*texts, *texts + shape.front())}};
    } else if (auto const* const integers = std::get_if<int const*>(&values)) {
        std::size_t const count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
        made = array_json("i4", shape, *integers, count * sizeof(int));
    } else {
        double const* const doubles = std::get<double const*>(values);
        std::size_t const count = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
        std::size_t const along = thinned_dimension(about.dims);
        // the coordinates of a dimension stay whole: a reader takes every n-th, as the map says
        if (count > most_values && shape.size() > 1 && along < shape.size()) {
            io::layout::Shape size = shape;
            std::size_t every = 1;
            std::vector<double> const kept = every_nth(size, doubles, along, every);
            made = array_json(size, kept.data());
            made["every"] = {about.dims[along], every};
        } else {
            made = array_json(shape, doubles);
        }
    }
    made["units"] = about.units;
    made["meaning"] = about.meaning;
}

void JsonGroup::attribute(std::string const& name, io::layout::AttributeValue const& value)
{
    json_["attributes"][name] = json_of(value);
}

void JsonGroup::figure(io::layout::FigurePlace const& figure)
{
    json_["figures"].push_back(
        {figure.name, figure.value, figure.error, figure.units, figure.meaning, figure.is_attribute});
}

}  // namespace hdconj::report
