// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/registry.hpp"

#include <cstddef>

#include "hdconj/scene.hpp"

namespace hdconj::wavegen {
namespace {

using Families = AnyWaveShape::Families;

/// The family that has no shape yet: `solve` finds it from both teeth.
scene::FamilyDescription wanted()
{
    return {wanted_neutral_curve,
            "looked for: both teeth are given",
            {{.key = major_displacement,
              .quantity = scene::Quantity::positive_length,
              .meaning = "displacement of the neutral curve on the major axis, rho(0) - r_m; absent: as deep as the "
                         "teeth fit into each other there",
              .required = false},
             {.key = inner_distance,
              .quantity = scene::Quantity::nonnegative_length,
              .meaning = "from the neutral curve inward to the cam's surface: half the wall and the bearing; absent: "
                         "to the inner surface of the flexspline",
              .required = false}}};
}

/// Why a wanted shape cannot be built.
Fault not_yet_found(scene::FamilyChoice const& choice)
{
    return {choice.path + ".family", choice.line, choice.family,
            "the neutral curve is not known yet: only solve and check take such a scene",
            "run hdconj solve with --completed DRIVE.toml on this scene, and use DRIVE.toml here"};
}

template <std::size_t... I>
std::vector<scene::FamilyDescription> descriptions(std::index_sequence<I...>)
{
    return {std::variant_alternative_t<I, Families>::describe()..., wanted()};
}

template <std::size_t I = 0>
AnyWaveShape build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    if constexpr (I == std::variant_size_v<Families>) {
        if (choice.family == wanted_neutral_curve) {
            faults.push_back(not_yet_found(choice));
            return {};
        }
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
