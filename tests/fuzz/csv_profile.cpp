// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <sstream>

#include "drive/drive.hpp"
#include "hdconj/check.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "refusal.hpp"
#include "scratch_folder.hpp"
#include "targets.hpp"

namespace hdconj::fuzz {
namespace {

constexpr char const* file_name = "fuzzed.csv";

scene::ParameterSpec const* file_key(scene::FamilyDescription const& family)
{
    auto const found =
        std::find_if(family.parameters.begin(), family.parameters.end(),
                     [](scene::ParameterSpec const& spec) { return spec.quantity == scene::Quantity::file; });
    return found == family.parameters.end() ? nullptr : &*found;
}

/// The family named @p name among @p families when it reads a file.
scene::FamilyDescription const* reader_named(std::vector<scene::FamilyDescription> const& families,
                                             std::string const& name)
{
    auto const found = std::find_if(families.begin(), families.end(), [&](scene::FamilyDescription const& family) {
        return family.name == name && file_key(family) != nullptr;
    });
    return found == families.end() ? nullptr : &*found;
}

/// Required words and numbers that the first line does not give: something that is allowed.
void fill_in(scene::FamilyChoice& choice, scene::FamilyDescription const& family)
{
    for (scene::ParameterSpec const& spec : family.parameters) {
        if (!spec.required || choice.has(spec.key))
            continue;
        if (spec.quantity == scene::Quantity::file)
            choice.given[std::string(spec.key)] = {std::string(file_name), 0};
        else if (!spec.words.empty())
            choice.given[std::string(spec.key)] = {std::string(spec.words.front()), 0};
        else
            choice.given[std::string(spec.key)] = {std::clamp(1.0, spec.at_least, spec.at_most), 0};
    }
}

/// "key=word" of the first line: only words that the family allows, as the scene's reader would pass on.
void take_words(scene::FamilyChoice& choice, scene::FamilyDescription const& family, std::istringstream& words)
{
    for (std::string word; words >> word;) {
        std::size_t const equals = word.find('=');
        for (scene::ParameterSpec const& spec : family.parameters) {
            bool const named = equals != std::string::npos && spec.key == std::string_view(word).substr(0, equals);
            std::string const value = named ? word.substr(equals + 1) : "";
            if (named && std::find(spec.words.begin(), spec.words.end(), value) != spec.words.end())
                choice.given[std::string(spec.key)] = {value, 0};
        }
    }
}

void validate_tooth(profile::Profile const& tooth)
{
    constexpr double coarse = 0x1p-6;  // of the tooth's height
    for (Vec2 const& p : profile::polygon_of(tooth, (tooth.addendum + tooth.dedendum) * coarse)) {
        if (!p.allFinite())
            throw Find("a point of the tooth is not finite");
    }
}

}  // namespace

void csv_profile(Bytes input)
{
    std::string_view const text = text_of(input);
    std::size_t const end = std::min(text.find('\n'), text.size());
    std::istringstream head{std::string(text.substr(0, end))};
    std::string name;
    head >> name;
    scene::FamilyDescription const* const tooth_family = reader_named(profile::profile_families(), name);
    scene::FamilyDescription const* const wave_family = reader_named(wavegen::wave_generator_families(), name);
    if (tooth_family == nullptr && wave_family == nullptr)
        return;
    scene::FamilyDescription const& family = tooth_family != nullptr ? *tooth_family : *wave_family;
    scene::FamilyChoice choice{name, 0, tooth_family != nullptr ? "flexspline.profile" : "wave_generator", {}};
    take_words(choice, family, head);
    fill_in(choice, family);
    choice.given[std::string(file_key(family)->key)] = {(scratch_folder() / file_name).string(), 0};
    write_scratch(file_name, end < text.size() ? text.substr(end + 1) : "");

    Scene scene = builtin_scene({"!circular_spline.inner_radius"});
    scene.folder = scratch_folder();
    (tooth_family != nullptr ? scene.flexspline.profile : scene.wave_generator.shape) = choice;
    Faults faults;
    accepted([&] {
        profile::Profile const tooth = drive::given_tooth(scene, faults);
        wavegen::AnyWaveShape const shape = drive::wave_shape(scene, tooth, faults);
        if (!faults.empty())
            return;
        validate_tooth(tooth);
        if (!std::isfinite(shape.amplitude()) || !std::isfinite(shape(1).w))
            throw Find("the wave is not finite");
        faults = check_scene(scene);
    });
    validate_faults(faults);
}

}  // namespace hdconj::fuzz
