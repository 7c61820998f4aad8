// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/registry.hpp"

#include <cstddef>

namespace hdconj::wavegen {
namespace {

using Families = AnyWaveShape::Families;

template <std::size_t... I>
std::vector<scene::FamilyDescription> descriptions(std::index_sequence<I...>)
{
    return {std::variant_alternative_t<I, Families>::describe()...};
}

template <std::size_t I = 0>
AnyWaveShape build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    if constexpr (I == std::variant_size_v<Families>) {
        faults.push_back(
            {choice.path + ".family", choice.line, choice.family, "no such wave generator family", "write \"cosine\""});
        return {};
    } else {
        using Shape = std::variant_alternative_t<I, Families>;
        if (choice.family == Shape::describe().name)
            return AnyWaveShape(Shape::build(choice, place, faults));
        return build<I + 1>(choice, place, faults);
    }
}

}  // namespace

std::vector<scene::FamilyDescription> const& wave_generator_families()
{
    static std::vector<scene::FamilyDescription> const all =
        descriptions(std::make_index_sequence<std::variant_size_v<Families>>{});
    return all;
}

AnyWaveShape build_wave_shape(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    return build(choice, place, faults);
}

}  // namespace hdconj::wavegen
