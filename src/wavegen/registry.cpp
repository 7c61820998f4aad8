// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/registry.hpp"

#include <cstddef>
#include <utility>

namespace hdconj {

namespace {

template<std::size_t... I>
std::vector<FamilyDescription> descriptions(std::index_sequence<I...>)
{
    return {std::variant_alternative_t<I, AnyWaveShape>::describe()...};
}

template<std::size_t I = 0>
AnyWaveShape build(FamilyChoice const& choice, int waves, Faults& faults)
{
    if constexpr (I == std::variant_size_v<AnyWaveShape>)
    {
        faults.push_back({choice.path + ".family", choice.line, choice.family, "no such wave generator family", "write \"cosine\""});
        return {};
    }
    else
    {
        using Shape = std::variant_alternative_t<I, AnyWaveShape>;
        if (choice.family == Shape::describe().name)
            return Shape::build(choice, waves, faults);
        return build<I + 1>(choice, waves, faults);
    }
}

}  // namespace

std::vector<FamilyDescription> const& wave_generator_families()
{
    static std::vector<FamilyDescription> const all = descriptions(std::make_index_sequence<std::variant_size_v<AnyWaveShape>>{});
    return all;
}

AnyWaveShape build_wave_shape(FamilyChoice const& choice, int waves, Faults& faults)
{
    return build(choice, waves, faults);
}

}  // namespace hdconj
