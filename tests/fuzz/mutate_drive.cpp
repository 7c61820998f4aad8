// SPDX-License-Identifier: GPL-3.0-or-later
// Random changes of a drive that know what a key is. Keys and families come from the schema and the registries, so a
// family that is registered is fuzzed.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <sstream>

#include "drive_text.hpp"
#include "hdconj/check.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "scratch_folder.hpp"

namespace hdconj::fuzz {
namespace {

constexpr char const* points_file = "points.csv";

/// Shortest TOML float that reads back as the same number.
std::string number_text(double value)
{
    if (std::isnan(value))
        return "nan";
    if (std::isinf(value))
        return value > 0 ? "inf" : "-inf";
    std::array<char, 32> room{};
    std::string text(room.data(), std::to_chars(room.data(), room.data() + room.size(), value).ptr);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string in_quotes(std::string_view word)
{
    return "\"" + std::string(word) + "\"";
}

bool is_number(scene::Quantity quantity)
{
    using enum scene::Quantity;
    return quantity != word && quantity != file && quantity != text && quantity != count && quantity != rows;
}

/// A list of lists of numbers from TOML of any layout; what is no number is passed over.
scene::NumberRows rows_of(std::string_view text)
{
    scene::NumberRows rows;
    int depth = 0;
    for (std::size_t i = 0; i < text.size();) {
        char const c = text[i];
        double value = 0;
        auto const [next, error] = std::from_chars(text.data() + i, text.data() + text.size(), value);
        if (depth == 2 && error == std::errc{}) {
            rows.back().push_back(value);
            i = static_cast<std::size_t>(next - text.data());
            continue;
        }
        depth += c == '[' ? 1 : c == ']' ? -1 : 0;
        if (c == '[' && depth == 2)
            rows.emplace_back();
        i = c == '#' ? std::min(text.find('\n', i), text.size()) : i + 1;
    }
    return rows;
}

std::string text_of_rows(scene::NumberRows const& rows)
{
    std::string text = "[";
    for (std::vector<double> const& row : rows) {
        text += text.size() > 1 ? ", [" : "[";
        for (std::size_t k = 0; k < row.size(); ++k)
            text += (k > 0 ? ", " : "") + number_text(row[k]);
        text += "]";
    }
    return text + "]";
}

class Mutation
{
  public:
    Mutation(DriveText drive, std::uint32_t seed) : drive_(std::move(drive)), engine_(seed) { look(); }

    DriveText operator()()
    {
        int const changes = 1 + below(4);
        for (int i = 0; i < changes; ++i) {
            change();
            look();
        }
        return drive_;
    }

  private:
    // Own mapping: the standard's distributions differ between libraries.
    int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
    double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) * 0x1p-32; }
    bool chance(int one_in) { return below(one_in) == 0; }
    template <class List>
    auto const& one_of(List const& list)
    {
        return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
    }

    /// What the drive says now: each number by its key, and the families.
    void look()
    {
        scene::SceneReading const reading = examine_scene(base_text(drive_), "", scratch_folder(), drive_.overrides);
        numbers_.clear();
        lists_.clear();
        for (auto const& [path, given] : reading.scene.given) {
            if (given.written.starts_with('['))
                lists_.emplace_back(path, rows_of(given.written));
            double value = 0;
            char const* const end = given.written.data() + given.written.size();
            if (std::from_chars(given.written.data(), end, value).ptr == end && !given.written.empty())
                numbers_.emplace_back(path, value);
        }
        profile_ = described(profile::profile_families(), reading.scene.given_profile().family);
        tooth_table_ = reading.scene.is_reverse() ? "circular_spline.profile" : "flexspline.profile";
        wave_ = described(wavegen::wave_generator_families(), reading.scene.wave_generator.shape.family);
        module_ = number("drive.module").value_or(1);
    }

    static scene::FamilyDescription const* described(std::vector<scene::FamilyDescription> const& families,
                                                     std::string const& name)
    {
        auto const found =
            std::find_if(families.begin(), families.end(), [&](auto const& f) { return f.name == name; });
        return found == families.end() ? nullptr : &*found;
    }

    std::optional<double> number(std::string const& path) const
    {
        auto const found =
            std::find_if(numbers_.begin(), numbers_.end(), [&](auto const& n) { return n.first == path; });
        return found == numbers_.end() ? std::nullopt : std::optional(found->second);
    }

    void set(std::string const& path, std::string const& value)
    {
        std::string const start = path + "=";
        auto const same = [&](std::string const& line) { return line.starts_with(start) || line == "!" + path; };
        std::erase_if(drive_.overrides, same);
        drive_.overrides.push_back(start + value);
    }
    void set(std::string const& path, double value) { set(path, number_text(value)); }
    void set_count(std::string const& path, double value) { set(path, std::to_string(static_cast<long long>(value))); }

    void change()
    {
        if (!lists_.empty() && chance(3))
            return change_list();
        switch (below(16)) {
            case 0:
            case 1:
            case 2:
            case 3:
                nudge();
                break;
            case 4:
            case 5:
                near_another();
                break;
            case 6:
                wild();
                break;
            case 7:
                remove_key();
                break;
            case 8:
            case 9:
                add_key();
                break;
            case 10:
                change_tooth();
                break;
            case 11:
                change_wave();
                break;
            case 12:
                change_counts();
                break;
            case 13:
                scale_all();
                break;
            case 14:
                change_points();
                break;
            default:
                simplify();
                break;
        }
    }

    /// A length of about the tooth's size, an angle of about a flank's, or a bound of the key itself.
    std::string value_for(scene::ParameterSpec const& spec)
    {
        using enum scene::Quantity;
        bool const as_word = spec.quantity == word || (spec.quantity == length_or_word && chance(2));
        if (as_word && !spec.words.empty())
            return in_quotes(one_of(spec.words));
        switch (spec.quantity) {
            case file:
                return in_quotes(file_for_scene());
            case rows:
                return text_of_rows(new_rows(spec));
            case text:
            case word:
                return in_quotes("any");
            case count:
                return std::to_string(static_cast<long long>(std::clamp(between(1, 12), spec.at_least, spec.at_most)));
            case angle_deg:
                return number_text(std::clamp(between(0, 60), spec.at_least, spec.at_most));
            default:
                break;
        }
        if (chance(6) && std::isfinite(spec.at_least))
            return number_text(spec.at_least);
        if (chance(6) && std::isfinite(spec.at_most))
            return number_text(spec.at_most);
        double const value = module_ * std::exp(between(-4, 1.5)) * (spec.quantity == length && chance(3) ? -1 : 1);
        return number_text(std::clamp(value, spec.at_least, spec.at_most));
    }

    void nudge()
    {
        if (numbers_.empty())
            return;
        auto const& [path, value] = one_of(numbers_);
        if (is_count(path))
            return set_count(path,
                             std::clamp(value + std::round(std::exp(between(0, 5))) * (chance(2) ? -1 : 1), -9.0, 1e9));
        double const share = chance(2) ? between(-0.3, 0.3) : std::pow(10.0, between(-17, 0)) * (chance(2) ? -1 : 1);
        set(path, value == 0 ? module_ * share : value * (1 + share));
    }

    /// Two lengths that ought to differ are made equal, or nearly.
    void near_another()
    {
        if (numbers_.empty())
            return;
        auto const& [path, value] = one_of(numbers_);
        double const other = one_of(numbers_).second;
        if (is_count(path))
            return;
        double const share = chance(3) ? 0 : std::pow(10.0, between(-17, -2)) * (chance(2) ? -1 : 1);
        double const factor = chance(4) ? 0.5 : chance(4) ? -1 : 1;
        set(path, factor * other * (1 + share));
    }

    void wild()
    {
        using limits = std::numeric_limits<double>;
        static std::array<double, 22> const values{0.0,
                                                   -0.0,
                                                   limits::denorm_min(),
                                                   1e-310,
                                                   limits::min(),
                                                   1e-300,
                                                   1e-100,
                                                   1e-20,
                                                   1e-12,
                                                   1e-9,
                                                   1e-6,
                                                   1e-3,
                                                   1.0,
                                                   1e3,
                                                   1e6,
                                                   1e9,
                                                   1e100,
                                                   limits::max(),
                                                   -1.0,
                                                   -1e-9,
                                                   limits::quiet_NaN(),
                                                   limits::infinity()};
        if (numbers_.empty())
            return;
        auto const& [path, value] = one_of(numbers_);
        double const chosen = one_of(values);
        if (is_count(path))
            return set_count(path, std::clamp(std::isnan(chosen) ? 0 : chosen, -1e18, 1e18));
        set(path, chance(2) ? chosen : value * std::pow(10.0, static_cast<double>(below(25) - 12)));
    }

    void remove_key()
    {
        if (numbers_.empty())
            return;
        std::string const path = one_of(numbers_).first;
        std::erase_if(drive_.overrides, [&](std::string const& line) { return line.starts_with(path + "="); });
        drive_.overrides.push_back("!" + path);
    }

    void add_key()
    {
        if (profile_ != nullptr && chance(3) && !profile_->parameters.empty()) {
            scene::ParameterSpec const& spec = one_of(profile_->parameters);
            return set(tooth_table_ + "." + std::string(spec.key), value_for(spec));
        }
        if (wave_ != nullptr && chance(3) && !wave_->parameters.empty()) {
            scene::ParameterSpec const& spec = one_of(wave_->parameters);
            return set("wave_generator." + std::string(spec.key), value_for(spec));
        }
        scene::TableSpec const& table = one_of(scene::scene_schema());
        if (table.keys.empty())
            return;
        // an effect is nothing without the keys that it requires
        bool const effect = table.presence == scene::Presence::effect;
        for (scene::KeySpec const& key : table.keys)
            if (effect && key.spec.required && chance(2))
                set(std::string(table.path) + "." + std::string(key.spec.key), value_for(key.spec));
        scene::ParameterSpec const& spec = one_of(table.keys).spec;
        if (spec.key != "family" && spec.key != "tolerance")
            set(std::string(table.path) + "." + std::string(spec.key), value_for(spec));
    }

    /// Another family of @p families under @p table: the keys it requires, and some of the others.
    void change_family(std::vector<scene::FamilyDescription> const& families, std::string const& table)
    {
        scene::FamilyDescription const& family = one_of(families);
        std::erase_if(drive_.overrides, [&](std::string const& line) {
            return line.starts_with(table + ".") && !line.starts_with("wave_generator.waves");
        });
        for (auto const& [path, value] : numbers_) {
            if (path.starts_with(table + ".") && path != "wave_generator.waves")
                drive_.overrides.push_back("!" + path);
        }
        drive_.overrides.push_back(table + ".family=" + in_quotes(family.name));
        for (scene::ParameterSpec const& spec : family.parameters) {
            std::string const path = table + "." + std::string(spec.key);
            if (auto const old = number(path); old && is_number(spec.quantity))
                set(path, *old);
            else if (spec.required || chance(3))
                set(path, value_for(spec));
        }
    }

    /// A scene of data/scenes has values that make a tooth; those of the families alone seldom do.
    void change_tooth()
    {
        if (chance(4))
            return change_family(profile::profile_families(), tooth_table_);
        drive_.scene = one_of(scene_names());
        std::erase_if(drive_.overrides,
                      [&](std::string const& line) { return line.find(".profile") != std::string::npos || chance(2); });
    }

    void change_wave()
    {
        change_family(wavegen::wave_generator_families(), "wave_generator");
        double const teeth = number("drive.flexspline_teeth").value_or(200);
        double const more = number("drive.circular_spline_teeth").value_or(teeth + 2) - teeth;
        for (char const* key : {"radial_deformation", "amplitude"}) {
            if (described(wavegen::wave_generator_families(), "cosine") != nullptr && chance(2) && wave_knows(key))
                set("wave_generator." + std::string(key), module_ * more / 2 * between(0.6, 1.2));
        }
    }

    bool wave_knows(std::string_view key)
    {
        look();
        return wave_ != nullptr && std::any_of(wave_->parameters.begin(), wave_->parameters.end(),
                                               [&](scene::ParameterSpec const& spec) { return spec.key == key; });
    }

    void change_counts()
    {
        int const waves = 1 + below(scene::bounds::most_waves);
        double const teeth = chance(8) ? scene::bounds::most_teeth - 4 : std::round(std::exp(between(1.7, 7)));
        set_count("wave_generator.waves", waves);
        set_count("drive.flexspline_teeth", teeth);
        set_count("drive.circular_spline_teeth", teeth + waves * (1 + (chance(2) ? below(3) : 0)));
        if (chance(2))
            drive_.overrides.push_back("!circular_spline.inner_radius");
    }

    void scale_all()
    {
        double const factor = chance(2) ? std::exp(between(-8, 8)) : std::exp2(below(20) - 10);
        for (auto const& [path, value] : std::vector(numbers_)) {
            if (!is_count(path) && !path.ends_with("_deg"))
                set(path, value * factor);
        }
    }

    /// A flank from tip to root: smooth, and then spoilt.
    std::string new_points()
    {
        int const count = 2 + below(chance(4) ? 60 : 12);
        double const tip = between(0.05, 0.5), slope = between(0.1, 0.8), bend = between(-1, 1),
                     noise = chance(2) ? 0 : std::pow(10.0, between(-12, -1));
        std::string pairs;
        for (int i = 0; i < count; ++i) {
            double const y = 0.9 - 2.0 * i / std::max(1, count - 1);
            double const x = tip + slope * (0.9 - y) * 0.5 + bend * 0.2 * std::sin(2 * y) + noise * between(-1, 1);
            pairs += (i == 0 ? "" : " ") + number_text(module_ * x) + "," + number_text(module_ * y);
        }
        return pairs;
    }

    std::string file_for_scene()
    {
        if (drive_.files.empty())
            drive_.files[points_file] = new_points();
        return drive_.files.begin()->first;
    }

    void change_points()
    {
        if (drive_.files.empty() || chance(4)) {
            drive_.files[points_file] = new_points();
            return;
        }
        std::string& pairs = drive_.files.begin()->second;
        std::vector<std::string> list;
        for (std::size_t at = 0; at < pairs.size();) {
            std::size_t const end = std::min(pairs.find(' ', at), pairs.size());
            list.push_back(pairs.substr(at, end - at));
            at = end + 1;
        }
        if (list.empty())
            return;
        auto const where = list.begin() + below(static_cast<int>(list.size()));
        switch (below(4)) {
            case 0:
                list.erase(where);
                break;
            case 1:
                list.insert(where, std::string(*where));
                break;
            case 2:
                std::iter_swap(where, list.begin() + below(static_cast<int>(list.size())));
                break;
            default: {
                std::size_t const comma = where->find(',');
                double const x = std::atof(where->c_str()),
                             y = comma == std::string::npos ? 0 : std::atof(where->c_str() + comma + 1);
                double const size = module_ * std::pow(10.0, between(-16, 0));
                *where = number_text(x + size * between(-1, 1)) + "," + number_text(y + size * between(-1, 1));
            }
        }
        pairs.clear();
        for (std::string const& pair : list)
            pairs += (pairs.empty() ? "" : " ") + pair;
    }

    /// Rows in one of the forms of the key: points run from the tip down, angles in degrees, the rest about as long as
    /// a tooth.
    scene::NumberRows new_rows(scene::ParameterSpec const& spec)
    {
        scene::NumberRows rows;
        int const count = (std::isfinite(spec.at_least) ? static_cast<int>(spec.at_least) : 1) + below(6);
        for (int i = 0; i < count; ++i) {
            std::string_view const chosen = spec.words.empty() ? "[x, y]" : one_of(spec.words);
            std::istringstream form(std::string(chosen == scene::row_file ? spec.words.front() : chosen));
            std::vector<double> row;
            for (std::string column; std::getline(form, column, ',');) {
                bool const height = column.find('y') != std::string::npos;
                bool const degrees = column.find("_deg") != std::string::npos;
                row.push_back(degrees  ? between(1, 60)
                              : height ? module_ * (0.9 - 2.0 * i / std::max(1, count - 1))
                                       : module_ * (0.1 + 0.8 * (i + between(0, 1)) / count));
            }
            rows.push_back(row);
        }
        return rows;
    }

    void change_list()
    {
        auto [path, rows] = one_of(lists_);
        if (rows.empty())
            return;
        auto const row = rows.begin() + below(static_cast<int>(rows.size()));
        switch (below(6)) {
            case 0:
                rows.erase(row);
                break;
            case 1:
                rows.insert(row, std::vector(*row));
                break;
            case 2:
                std::iter_swap(row, rows.begin() + below(static_cast<int>(rows.size())));
                break;
            default:
                if (!row->empty()) {
                    double& value = (*row)[static_cast<std::size_t>(below(static_cast<int>(row->size())))];
                    value += (std::abs(value) + module_) * std::pow(10.0, between(-16, 0)) * between(-1, 1);
                }
        }
        set(path, text_of_rows(rows));
    }

    void simplify()
    {
        if (!drive_.overrides.empty())
            drive_.overrides.erase(drive_.overrides.begin() + below(static_cast<int>(drive_.overrides.size())));
    }

    static bool is_count(std::string const& path)
    {
        return path.ends_with("teeth") || path.ends_with("waves") || path.ends_with("count") ||
               path.ends_with("threads");
    }

    DriveText drive_;
    std::mt19937 engine_;
    std::vector<std::pair<std::string, double>> numbers_;
    std::vector<std::pair<std::string, scene::NumberRows>> lists_;
    scene::FamilyDescription const* profile_ = nullptr;
    scene::FamilyDescription const* wave_ = nullptr;
    double module_ = 1;
    std::string tooth_table_ = "flexspline.profile";  ///< or the circular spline's, in the reverse problem
};

/// The scene and its geometry are without fault.
bool gets_in(DriveText const& drive)
{
    try {
        return check_scene(scene_of(drive)).empty();
    } catch (std::runtime_error const&) {  // what it throws is for the target to judge
        return false;
    }
}

}  // namespace

std::string mutated_drive(std::string_view text, std::uint32_t seed)
{
    // most random drives are refused at the door: nine in ten are drawn again until one gets in, from a drive that does
    constexpr std::uint32_t careless_one_in = 10, attempts = 8;
    DriveText drive = parse_drive(text);
    bool const careful = seed % careless_one_in != 0;
    std::mt19937 engine(seed);
    while (careful && !drive.overrides.empty() && !gets_in(drive))
        std::erase_if(drive.overrides, [&](std::string const&) { return engine() % 4 == 0; });
    DriveText changed = Mutation(drive, seed)();
    for (std::uint32_t attempt = 1; attempt < attempts && careful && !gets_in(changed); ++attempt)
        changed = Mutation(drive, static_cast<std::uint32_t>(engine()))();
    return to_text(changed);
}

std::string crossed_drives(std::string_view one, std::string_view other, std::uint32_t seed)
{
    DriveText child = parse_drive(one);
    DriveText const second = parse_drive(other);
    std::mt19937 engine(seed);
    auto const coin = [&] { return engine() % 2 == 0; };
    std::erase_if(child.overrides, [&](std::string const&) { return coin(); });
    for (std::string const& line : second.overrides) {
        if (coin())
            child.overrides.push_back(line);
    }
    child.files.insert(second.files.begin(), second.files.end());
    return to_text(child);
}

}  // namespace hdconj::fuzz
