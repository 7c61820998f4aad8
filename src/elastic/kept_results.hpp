// SPDX-License-Identifier: GPL-3.0-or-later
// Results that several drives share: kept, and found again by the exact values that they depend on.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bearing.hpp"
#include "influence.hpp"

namespace hdconj::elastic {

/// What a computation depends on, as bytes: equal where every value is, to the last bit.
class Dependencies
{
  public:
    template <class Value>
    requires std::is_arithmetic_v<Value> || std::is_enum_v<Value>
    void add(Value value) { bytes_.append(reinterpret_cast<char const*>(&value), sizeof value); }
    template <class Value>
    void add(std::vector<Value> const& values)
    {
        add(values.size());
        for (Value const& value : values)
            add(value);
    }
    void add(Vec2 const& point);
    void add(QuadraticElement const& element);
    void add(Elasticity const& material);
    void add(SectionMesh const& mesh);
    void add(FourierSolid const& solid);
    void add(Station const& station);
    void add(Support const& support);
    void add(CupSection const& section);
    void add(Bearing const& bearing);
    void add(CamSeries const& cam);
    template <class Value>
    void add(std::optional<Value> const& value)
    {
        add(value.has_value());
        if (value)
            add(*value);
    }

    [[nodiscard]] std::string const& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

/// How many results of each kind are kept; see keep_elastic_bodies().
[[nodiscard]] std::size_t most_kept();
void count_result(bool is_reused);

/// The result that @p make gives: one that is kept, where one with the same @p dependencies is there. Several threads
/// may ask at once.
/// @param dependencies  fills the Dependencies; not called where nothing is kept
template <class Value, class Fill, class Make>
[[nodiscard]] std::shared_ptr<Value const> kept_or_made(Fill const& dependencies, Make const& make)
{
    static std::mutex mutex;
    static std::deque<std::pair<std::string, std::shared_ptr<Value const>>> kept;  // the last one used is in front
    std::size_t const most = most_kept();
    Dependencies key;
    if (most > 0)
        dependencies(key);
    {
        std::lock_guard const lock(mutex);
        while (kept.size() > most)
            kept.pop_back();
        auto const found =
            std::find_if(kept.begin(), kept.end(), [&](auto const& each) { return each.first == key.bytes(); });
        if (found != kept.end()) {
            std::rotate(kept.begin(), found, found + 1);
            count_result(true);
            return kept.front().second;
        }
    }
    auto made = std::make_shared<Value const>(make());
    count_result(false);
    if (most > 0) {
        std::lock_guard const lock(mutex);
        kept.emplace_front(key.bytes(), made);
        if (kept.size() > most)
            kept.pop_back();
    }
    return made;
}

}  // namespace hdconj::elastic
