// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_path.hpp"

#include <fcntl.h>
#include <semaphore.h>
#include <stdio.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include <unistd.h>

#include "hdconj/file/atomic_file.hpp"

namespace hdconj::file {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view mark = ".hdconj-", ending = ".tmp";

/// "-HOST.tmp": a process number means something on its own machine only, and folders may be shared.
std::string const& host_and_ending()
{
    static std::string const text = [] {
        std::array<char, HOST_NAME_MAX + 1> name{};
        ::gethostname(name.data(), name.size() - 1);
        return "-" + std::string(name.data()) + std::string(ending);
    }();
    return text;
}

/// Whether @p process runs: one that has ended and that nobody has waited for does not.
bool runs(pid_t process)
{
    std::ifstream in("/proc/" + std::to_string(process) + "/stat");
    std::string const said((std::istreambuf_iterator<char>(in)), {});  // "PID (NAME) STATE ..."
    std::size_t const at = said.rfind(") ");
    bool const ended = at != std::string::npos && said.substr(at + 2, 1).find_first_of("ZX") != std::string::npos;
    return !ended && (::kill(process, 0) == 0 || errno != ESRCH);
}

/// Whether a process of this machine made the temporary @p name and does not run any more.
bool is_left_over(std::string_view name)
{
    std::size_t const at = name.rfind(mark);
    if (!name.starts_with('.') || at == std::string_view::npos)
        return false;
    char const* const end = name.data() + name.size();
    pid_t process = 0;
    auto const [rest, error] = std::from_chars(name.data() + at + mark.size(), end, process);
    return error == std::errc() && process > 0 && std::string_view(rest, end) == host_and_ending() && !runs(process);
}

void discard(fs::path const& name)
{
    std::error_code ignored;  // what cannot be removed is left to a later run
    fs::remove_all(name, ignored);
}

/// The same while other threads still write into @p name: nothing finds it any more under its new name.
void discard_in_use(fs::path const& name)
{
    fs::path const aside = name.parent_path() / (".ended" + name.filename().string());
    std::error_code error;
    fs::rename(name, aside, error);
    discard(error ? name : aside);
}

/// Removes what killed processes have left in @p folder.
void remove_left_overs(fs::path const& folder)
{
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (is_left_over(at->path().filename().string()))
            discard(at->path());
}

/// The temporaries of this process. Lives for ever: a signal may come while the process ends.
struct Registry
{
    std::mutex mutex;
    std::set<fs::path> names;
    bool wanted = false, watched = false;  ///< signals remove the temporaries; a thread waits for them
    sem_t arrived{};                       ///< posted by the handler, which may do little else
    volatile std::sig_atomic_t signal = 0;
};

Registry& registry()
{
    static auto& only = *new Registry;
    return only;
}

extern "C" void note_signal(int signal)
{
    int const before = errno;
    registry().signal = signal;
    ::sem_post(&registry().arrived);
    errno = before;
}

/// Waits for a signal, removes the temporaries and lets the signal end the process.
[[noreturn]] void watch()
{
    Registry& all = registry();
    while (::sem_wait(&all.arrived) != 0) {
    }
    std::lock_guard const nothing_new(all.mutex);  // held to the end
    for (auto const& name : all.names)
        discard_in_use(name);
    std::signal(all.signal, SIG_DFL);
    for (;;)
        ::kill(::getpid(), all.signal);
}

/// Begins to wait for signals. One that the process ignores (nohup) stays ignored.
void start_watching(Registry& all)
{
    all.watched = true;
    ::sem_init(&all.arrived, 0, 0);
    std::thread(watch).detach();
    for (int const signal : {SIGHUP, SIGINT, SIGTERM})
        if (std::signal(signal, note_signal) == SIG_IGN)
            std::signal(signal, SIG_IGN);
}

}  // namespace

fs::path temporary_name(fs::path const& target)
{
    std::string name = target.filename().string();
    std::string const rest = std::string(mark) + std::to_string(::getpid()) + host_and_ending();
    std::size_t cut = NAME_MAX - rest.size() - 1;
    if (name.size() > cut) {
        constexpr unsigned char continues = 0x80, bits = 0xC0;  // do not cut a UTF-8 character in half
        while (cut > 0 && (static_cast<unsigned char>(name[cut]) & bits) == continues)
            --cut;
        name.resize(cut);
    }
    return (target.has_parent_path() ? target.parent_path() : fs::path(".")) / ("." + name + rest);
}

TemporaryPath::TemporaryPath(fs::path const& target) : name_(temporary_name(target))
{
    remove_left_overs(name_.parent_path());
    discard(name_);
    std::lock_guard const lock(registry().mutex);
    registry().names.insert(name_);
    if (registry().wanted && !registry().watched)
        start_watching(registry());
}

TemporaryPath::~TemporaryPath()
{
    discard(name_);
    std::lock_guard const lock(registry().mutex);
    registry().names.erase(name_);
}

int TemporaryPath::rename_to(fs::path const& target, unsigned int flags) const
{
    std::lock_guard const lock(registry().mutex);
    int const failed = flags == 0 ? ::rename(name_.c_str(), target.c_str())
                                  : ::renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, target.c_str(), flags);
    return failed == 0 ? 0 : errno;
}

void remove_temporaries_when_interrupted()
{
    std::lock_guard const lock(registry().mutex);
    registry().wanted = true;
}

}  // namespace hdconj::file
