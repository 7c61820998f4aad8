// SPDX-License-Identifier: GPL-3.0-or-later
// Random teeth that cannot be built or do not fit their pitch: the advice that is given on them works.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "hdconj/check.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"
#include "support/draws.hpp"
#include "support/followed_advice.hpp"

namespace hdconj::test::tooth_advice_cases {
namespace {

constexpr std::array families{"double-circular-arc", "straight", "involute", "cycloid", "s-tooth"};

/// A drive with numbers as people try them, wilder than those of usual teeth.
class Trial
{
  public:
    Trial(std::string const& family, unsigned seed) : draws_(seed)
    {
        module_ = draws_.between(0.1, 1);
        int const teeth = draws_.whole(30, 260), waves = draws_.chance(0.7) ? 2 : draws_.whole(1, 3);
        text_ = "[drive]\nname = \"trial\"\n" + line("module", module_) + count("flexspline_teeth", teeth) +
                count("circular_spline_teeth", teeth + waves) + "[flexspline]\n" +
                line("wall", 0.013 * module_ * teeth) + "[flexspline.profile]\nfamily = \"" + family + "\"\n";
        modules("addendum", 0.5, 1.6);
        modules("dedendum", 0.6, 1.6);
        if (family == "double-circular-arc")
            arcs();
        if (family == "cycloid") {
            modules("addendum_rolling_radius", 0.3, 2);
            modules("dedendum_rolling_radius", 0.4, 2);
        }
        if (family == "s-tooth")
            text_ += line("deflection", draws_.between(0.6, 0.98));
        if (family == "straight" || family == "involute")
            text_ += line("pressure_angle_deg", draws_.between(8, 38));
        if (family == "straight" || (family != "double-circular-arc" && draws_.chance(0.5)))
            modules("thickness", 0.7, 2.4);
        text_ += "[wave_generator]\nfamily = \"cosine\"\n" + line("radial_deformation", module_ * waves / 2) +
                 count("waves", waves);
    }

    /// What is said of the tooth with @p set.
    [[nodiscard]] Faults faults(std::vector<std::string> const& set = {}) const
    {
        auto reading = examine_scene(text_, "trial", {}, set);
        examine_geometry(reading);
        std::erase_if(reading.faults, [](Fault const& each) { return !each.path.starts_with("flexspline.profile"); });
        return reading.faults;
    }
    [[nodiscard]] std::string const& text() const { return text_; }

  private:
    static std::string line(std::string const& key, double value) { return key + " = " + std::to_string(value) + "\n"; }
    static std::string count(std::string const& key, int value) { return key + " = " + std::to_string(value) + "\n"; }
    void modules(std::string const& key, double low, double high)
    {
        text_ += line(key, module_ * draws_.between(low, high));
    }
    void arcs()
    {
        modules("convex_radius", 0.9, 1.5);
        modules("convex_offset", 0.1, 0.7);
        modules("concave_radius", 1.4, 2.6);
        modules("concave_rise", 0.2, 0.35);
        text_ += "concave_offset = \"tangent\"\n";
    }

    designs::Draws draws_;
    double module_;
    std::string text_;
};

/// The number behind @p words in @p text, as it stands there; empty where they do not.
std::string number_behind(std::string const& words, std::string const& text)
{
    std::size_t const at = text.find(words);
    if (at == std::string::npos)
        return "";
    std::string const rest = text.substr(at + words.size());
    return rest.substr(0, rest.find_first_of(",; )"));
}

}  // namespace

TEST_CASE("advice on a tooth that is followed at most three times ends in one that is built", "[advice]")
{
    constexpr unsigned teeth = 60;
    for (char const* const family : families) {
        unsigned refused = 0;
        for (unsigned seed = 0; seed < teeth; ++seed) {
            Trial const trial(family, seed);
            std::vector<std::string> set;
            std::string way;
            Faults faults = trial.faults();
            refused += faults.empty() ? 0 : 1;
            constexpr int most = 3;
            for (int i = 0; i < most && !faults.empty(); ++i) {
                way += describe(faults) + "\n";
                std::vector<std::string> next;
                for (Fault const& fault : faults)
                    add_advice(next, fault.set);
                add_advice(next, set);
                set = next;
                faults = trial.faults(set);
            }
            INFO(trial.text() << way);
            CHECK(faults.empty());
        }
        INFO(family << ": " << refused);
        CHECK(refused > teeth / 5);
    }
}

TEST_CASE("a largest addendum that is named is not refused for the same reason", "[advice]")
{
    constexpr unsigned teeth = 150;
    unsigned named = 0;
    for (unsigned seed = 0; seed < teeth; ++seed) {
        Trial const trial(families.at(seed % families.size()), seed);
        for (Fault const& fault : trial.faults()) {
            std::string const most = number_behind("an addendum of at most ", fault.remedy);
            if (most.empty())
                continue;
            ++named;
            std::string const set = "flexspline.profile.addendum=" + most;
            for (Fault const& other : trial.faults({set})) {
                INFO(trial.text() << describe({fault}) << "\n" << set << "\n" << describe({other}));
                CHECK(other.path != fault.path);
            }
        }
    }
    CHECK(named > teeth / 10);
}

}  // namespace hdconj::test::tooth_advice_cases
