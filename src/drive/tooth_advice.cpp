// SPDX-License-Identifier: GPL-3.0-or-later
#include "tooth_advice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/text.hpp"
#include "drive.hpp"
#include "given_tooth.hpp"
#include "hdconj/profile/registry.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::drive {
namespace {

/// A key of the tooth that is a number, and its value.
struct ToothKey
{
    scene::ParameterSpec spec;
    double given;
};

/// The value as it is advised.
double written(double value)
{
    constexpr int digits = 3;
    return std::strtod(short_number(value, digits).c_str(), nullptr);
}

/// Half of the flat tip [mm]; 0 of a pointed or round one.
double half_land(profile::Profile const& tooth)
{
    double half = 0;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i)
        if (auto const* const line = std::get_if<profile::LinePiece>(&tooth.pieces[i].shape);
            line != nullptr && profile::is_tip(tooth, static_cast<int>(i)))
            half = (line->b - line->a).norm() / 2;
    return half;
}

class ToothSearch
{
  public:
    ToothSearch(Scene const& scene, bool outside, std::string_view refused_key)
        : scene_(scene),
          outside_(outside),
          wants_land_(refused_key == "addendum"),
          tooth_(outside ? *scene_.circular_spline.profile : scene_.flexspline.profile),
          amplitude_(scene.wave_generator.shape.number_or("radial_deformation", scene::usual_deformation(scene.drive)))
    {
        for (scene::FamilyDescription const& family : profile::profile_families())
            if (family.name == tooth_.family)
                enter_keys(family, refused_key);
    }

    /// Whether the tooth has keys that can be changed.
    [[nodiscard]] bool has_keys() const { return !keys_.empty(); }

    /// Values that work: @p hint, arguments of --set, where they do.
    [[nodiscard]] scene::Advice operator()(std::vector<std::string> const& hint)
    {
        scene::FamilyChoice const given = tooth_;
        for (std::string const& each : hint) {
            std::size_t const equals = each.find('=');
            enter(each.substr(tooth_.path.size() + 1, equals - tooth_.path.size() - 1),
                  std::strtod(each.c_str() + equals + 1, nullptr));
        }
        if (!hint.empty() && works())
            return changed_from(given);
        scene::FamilyChoice const hinted = std::exchange(tooth_, given);
        if (change_one(1))
            return changed_from(given);
        tooth_ = hinted;
        if (!hint.empty() && change_one(2))
            return changed_from(given);
        tooth_ = given;
        return change_two() ? changed_from(given) : scene::Advice{};
    }

    /// A value of one key with which the key @p path is no longer refused, whatever else is.
    [[nodiscard]] scene::Advice first_step(std::string const& path)
    {
        scene::FamilyChoice const given = tooth_;
        only_ = path;
        return change_one(1) ? changed_from(given) : scene::Advice{};
    }

  private:
    static constexpr int most_steps = 49;  // of a fiftieth: down to almost nothing, or up to the double

    void enter_keys(scene::FamilyDescription const& family, std::string_view refused)
    {
        // a tooth that is too wide is refused as a whole; a higher convex arc leaves the tip its height
        std::vector<std::string_view> first{refused};
        if (refused.empty())
            first = {"thickness", "convex_offset", "dedendum"};
        else if (wants_land_)
            first = {"convex_offset", "addendum"};
        for (scene::ParameterSpec const& spec : family.parameters) {
            std::optional<double> given = tooth_.number(spec.key);
            if (!given && spec.key == "thickness")
                given = std::numbers::pi * scene_.drive.module / 2;
            if (given)
                keys_.push_back({spec, *given});
        }
        std::ranges::stable_sort(keys_, {},
                                 [&](ToothKey const& key) { return std::ranges::find(first, key.spec.key); });
    }

    void enter(std::string_view key, double value)
    {
        auto const [at, is_new] = tooth_.given.try_emplace(std::string(key));
        at->second.value = value;
    }

    /// @p key moved by @p steps; nothing where it takes no such value.
    [[nodiscard]] std::optional<double> moved(ToothKey const& key, int steps) const
    {
        using enum scene::Quantity;
        constexpr double share = 0.02, degree = 1;
        scene::Quantity const quantity = key.spec.quantity;
        double const unit = quantity == angle_deg ? degree / share : quantity == number ? 1 : scene_.drive.module;
        double const value = written(key.given + steps * share * std::max(unit, std::abs(key.given)));
        bool const taken = value >= key.spec.at_least && value <= key.spec.at_most &&
                           (quantity != positive_length || value > 0) && (quantity != nonnegative_length || value >= 0);
        return taken ? std::optional(value) : std::nullopt;
    }

    /// Half the tip land of the tooth; nothing where it cannot be built or does not fit its pitch.
    [[nodiscard]] std::optional<double> built_land() const
    {
        Faults faults;
        profile::Profile const tooth = build_tooth(scene_, outside_, faults);
        auto const is_it = [&](Fault const& fault) { return fault.path == only_; };
        if (!only_.empty())
            return std::ranges::none_of(faults, is_it) ? std::optional(0.0) : std::nullopt;
        if (!faults.empty() || tooth.pieces.empty() ||
            widest_place(scene_, tooth, pair_geometry(scene_, tooth, amplitude_), outside_).excess > 0)
            return std::nullopt;
        return half_land(tooth);
    }
    [[nodiscard]] bool works() const { return built_land().has_value(); }

    /// The change of @p key alone that works, nearest to its value or, for a tip land, a little further on.
    bool change(ToothKey const& key, int stride)
    {
        constexpr double usual_half_land = 0.21;  // modules; of design_limits()
        scene::FamilyChoice const before = tooth_;
        std::optional<double> found;
        int side_of_found = 0;
        for (int steps = stride; steps <= most_steps; steps += stride)
            for (int const side : {-1, 1}) {
                if (found && side != side_of_found)
                    continue;
                auto const value = moved(key, side * steps);
                if (value)
                    enter(key.spec.key, *value);
                auto const land = value ? built_land() : std::nullopt;
                if (land && (!wants_land_ || *land >= usual_half_land * scene_.drive.module))
                    return true;
                if (land && !found) {
                    found = value;
                    side_of_found = side;
                }
            }
        tooth_ = before;
        if (found)
            enter(key.spec.key, *found);
        return found.has_value();
    }

    bool change_one(int stride)
    {
        return std::ranges::any_of(keys_, [&](ToothKey const& key) { return change(key, stride); });
    }

    bool change_two()
    {
        constexpr int coarse = 4, stride = 3;
        constexpr std::size_t most_first = 2;
        scene::FamilyChoice const given = tooth_;
        for (std::size_t i = 0; i < std::min(most_first, keys_.size()); ++i)
            for (int steps = coarse; steps <= most_steps; steps += coarse)
                for (int const side : {-1, 1}) {
                    auto const value = moved(keys_[i], side * steps);
                    if (!value)
                        continue;
                    tooth_ = given;
                    enter(keys_[i].spec.key, *value);
                    for (ToothKey const& other : keys_)
                        if (other.spec.key != keys_[i].spec.key && change(other, stride))
                            return true;
                }
        tooth_ = given;
        return false;
    }

    [[nodiscard]] scene::Advice changed_from(scene::FamilyChoice const& given) const
    {
        scene::Advice advice;
        for (auto const& [key, parameter] : tooth_.given)
            if (given.number(key) != tooth_.number(key))
                advice.add(tooth_.path + "." + key, short_number(std::get<double>(parameter.value)));
        return advice;
    }

    Scene scene_;
    bool outside_, wants_land_;
    scene::FamilyChoice& tooth_;  // of scene_
    double amplitude_;
    std::string only_;  ///< path of the only fault that counts; empty: every one does
    std::vector<ToothKey> keys_;
};

}  // namespace

void advise_tooth(Scene const& scene, bool outside, Fault& fault)
{
    std::string const& path = (outside ? *scene.circular_spline.profile : scene.flexspline.profile).path;
    bool const has_key = fault.path.size() > path.size() && fault.path.starts_with(path);
    ToothSearch search(scene, outside, has_key ? std::string_view(fault.path).substr(path.size() + 1) : "");
    if (!search.has_keys())
        return;
    scene::Advice advice = search(fault.set);
    if (!advice.set.empty()) {
        fault.remedy += "; " + advice.words + (advice.set.size() > 1 ? " make" : " makes");
        fault.remedy += " a tooth that fits its pitch";
    } else {
        fault.remedy += "; no change of one or two keys makes a tooth that fits its pitch";
        advice = has_key ? search.first_step(fault.path) : scene::Advice{};
        fault.remedy += advice.set.empty() ? "" : ", and " + advice.words + " is a first step";
    }
    fault.set = advice.set;
}

}  // namespace hdconj::drive
