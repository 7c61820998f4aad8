// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.hpp"

#include <cctype>
#include <optional>
#include <utility>

#include "hdconj/file/atomic_file.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/scene/number_pairs.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "verb.hpp"

namespace hdconj::cli {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_target(OutputTarget const& target, std::string const& reason, std::string const& remedy)
{
    throw InputError(Fault{target.option, 0, target.file.string(), reason, "write " + remedy});
}

/// The file that a name stands for, through links, whether it exists or not.
fs::path real(fs::path const& name)
{
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(name), error);
}

bool same_file(fs::path const& a, fs::path const& b)
{
    std::error_code error;
    return fs::equivalent(a, b, error) || real(a) == real(b);
}

/// @p file lies in @p folder itself: one with folders in it is no result, which is said elsewhere.
bool holds(fs::path const& folder, fs::path const& file)
{
    return same_file(real(file).parent_path(), folder);
}

void refuse_to_replace(OutputTarget const& target, InputFile const& input)
{
    constexpr char const* loss = ", the result would replace it";
    if (same_file(target.file, input.file))
        refuse_target(target, input.what + loss, "another name");
    for (auto const& member : target.members)
        if (same_file(member, input.file))
            refuse_target(target, "writes " + member.string() + " too: " + input.what + loss, "another name");
    if (target.is_folder && holds(target.file, input.file))
        refuse_target(target, "holds " + input.file.string() + ": " + input.what + loss, "the name of a new folder");
}

void refuse_to_share(OutputTarget const& target, OutputTarget const& other)
{
    if (same_file(other.file, target.file))
        refuse_target(target, "is given to " + other.option + " too", "another name");
    for (auto const& member : other.members)
        if (same_file(member, target.file))
            refuse_target(target, "is written by " + other.option + " too", "another name");
}

/// Throws where the target is standard output, a file that is read, or a file that another target writes too.
void check_name(OutputTarget const& target, std::vector<OutputTarget> const& targets,
                std::vector<InputFile> const& read)
{
    if (target.file == "-")
        refuse_target(target, "results are files and do not go to standard output",
                      "a file name; --json prints the figures to standard output");
    for (auto const& input : read)
        refuse_to_replace(target, input);
    for (auto const& other : targets)
        if (&other != &target)
            refuse_to_share(target, other);
}

/// Files that the keys of one family name.
void append_files(scene::FamilyChoice const& choice, std::vector<scene::FamilyDescription> const& families,
                  fs::path const& folder, std::vector<InputFile>& files)
{
    for (auto const& family : families) {
        if (family.name != choice.family)
            continue;
        for (auto const& parameter : family.parameters) {
            if (parameter.quantity == scene::Quantity::file && choice.has(parameter.key))
                files.push_back({scene::number_file(choice, parameter.key, folder),
                                 "this file is read by " + choice.path + "." + std::string(parameter.key)});
        }
    }
}

}  // namespace

std::string file_name(std::string const& drive)
{
    constexpr std::size_t longest = 100;  // bytes, well below what file systems take
    constexpr unsigned char beyond_ascii = 0x80, continues = 0x80, mask = 0xC0;
    std::string name;
    for (char const c : drive.substr(0, longest)) {
        auto const byte = static_cast<unsigned char>(c);
        bool const kept = byte >= beyond_ascii || std::isalnum(byte) != 0 || c == '.' || c == '_' || c == '-';
        name += kept ? c : '-';
    }
    if (drive.size() > longest) {
        std::size_t cut = longest;
        while (cut > 0 && (static_cast<unsigned char>(drive[cut]) & mask) == continues)
            --cut;
        name.resize(cut);
    }
    name.erase(0, name.find_first_not_of(".-"));  // no hidden file, nothing that looks like an option
    return name.empty() ? "drive" : name;
}

std::vector<InputFile> inputs_of(CommonOptions const& common, Scene const& scene)
{
    std::vector<InputFile> files;
    if (!common.scene.empty() && common.scene != "-")
        files.push_back({common.scene, "this is the scene file"});
    append_files(scene.given_profile(), profile::profile_families(), scene.folder, files);
    if (scene.wants_neutral_curve())
        append_files(*scene.circular_spline.profile, profile::profile_families(), scene.folder, files);
    append_files(scene.wave_generator.shape, wavegen::wave_generator_families(), scene.folder, files);
    return files;
}

std::vector<InputFile> input_of(std::string const& option, std::string const& file)
{
    return file.empty() ? std::vector<InputFile>{} : std::vector<InputFile>{{file, "this file is read by " + option}};
}

void check_outputs(std::vector<OutputTarget> const& targets, std::vector<InputFile> const& read, Faults faults)
{
    std::optional<FileError> unwritable;
    for (auto const& target : targets) {
        try {
            check_name(target, targets, read);
            target.check();
        } catch (InputError const& error) {
            append(faults, error.faults());
        } catch (FileError const& error) {
            if (!unwritable)
                unwritable.emplace(error);
        }
    }
    throw_if_any(std::move(faults));
    if (unwritable)
        throw FileError(*unwritable);
}

std::function<void(fs::path const&)> check_ending(std::string option, std::string ending, std::string reader)
{
    return [=](fs::path const& file) {
        if (CLI::detail::to_lower(file.extension().string()) != ending)
            throw InputError(Fault{option, 0, file.string(), reader + " knows the file by its ending " + ending,
                                   "write NAME" + ending});
        file::check_target(file);
    };
}

fs::path output_name(CommonOptions const& common, std::string const& given, Scene const& scene,
                     std::string const& ending)
{
    bool const has_file = !common.scene.empty() && common.scene != "-";
    std::string const name = has_file ? fs::path(common.scene).stem().string() : scene.drive.name;
    return given.empty() ? file_name(name) + ending : given;
}

}  // namespace hdconj::cli
