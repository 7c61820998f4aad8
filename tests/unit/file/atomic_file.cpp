// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/file/atomic_file.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdio>

#include "support/catch.hpp"
#include "support/not_tried.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::atomic_file_cases {

namespace fs = std::filesystem;
using test::content;
using test::TemporaryFolder;

namespace {

std::string message_of(fs::path const& target, std::string const& text = "new")
{
    try {
        file::write_text_atomically(target, text);
    } catch (FileError const& error) {
        return error.what();
    }
    return "";
}

constexpr std::size_t more_than_fits = std::size_t{1} << 20;
constexpr int told = 0, not_told = 1, not_allowed = 2;

/// Tries to write more than fits over an old file; told when the message has @p expected and the old file is whole.
int full_disk(fs::path const& file, std::string const& expected)
{
    file::write_text_atomically(file, "old");
    auto const message = message_of(file, std::string(more_than_fits, 'x'));
    bool const clean = std::distance(fs::directory_iterator(file.parent_path()), {}) == 1;
    return message.find(expected) != std::string::npos && content(file) == "old" && clean ? told : not_told;
}

}  // namespace

TEST_CASE("write_text_atomically makes and replaces a file and leaves nothing else")
{
    TemporaryFolder const folder;
    file::write_text_atomically(folder / "a.txt", "one");
    file::write_text_atomically(folder / "a.txt", std::string("t\0wo", 4));
    CHECK(content(folder / "a.txt") == std::string("t\0wo", 4));
    CHECK(folder.names() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("write_atomically leaves the old file when the writer throws")
{
    TemporaryFolder const folder;
    file::write_text_atomically(folder / "a.txt", "old");
    CHECK_THROWS_AS(file::write_atomically(folder / "a.txt", [](fs::path const&) { throw std::logic_error("no"); }),
                    std::logic_error);
    CHECK(content(folder / "a.txt") == "old");
    CHECK(folder.names().size() == 1);
}

TEST_CASE("a target that cannot be written is refused with the reason")
{
    TemporaryFolder const folder;
    fs::create_directory(folder / "sub");
    file::write_text_atomically(folder / "plain", "");
    CHECK_THAT(message_of(folder / "sub"), ContainsSubstring("is a folder"));
    CHECK_THAT(message_of((folder / "sub").string() + "/"), ContainsSubstring("is a folder"));
    CHECK_THAT(message_of(folder / "none/a.txt"), ContainsSubstring("does not exist") && ContainsSubstring("mkdir -p"));
    CHECK_THAT(message_of(folder / "plain/a.txt"), ContainsSubstring("is not a folder"));
    CHECK_THAT(message_of(folder / std::string(300, 'x')), ContainsSubstring("name too long"));
    CHECK_THAT(message_of(""), ContainsSubstring("no file name"));
    fs::create_symlink("loop", folder / "loop");
    CHECK_THAT(message_of(folder / "loop"), ContainsSubstring("symbolic links"));
}

TEST_CASE("the longest possible names can be written")
{
    TemporaryFolder const folder;
    std::string const longest(255, 'x');
    file::write_text_atomically(folder / longest, "text");
    CHECK(content(folder / longest) == "text");
    CHECK(file::temporary_name(folder / longest).filename().string().size() <= 255);
    std::string umlauts;
    for (int i = 0; i < 127; ++i)
        umlauts += "\xc3\xbc";
    CHECK(file::temporary_name(umlauts).string().find("\xc3.hdconj") == std::string::npos);
    file::write_text_atomically(folder / umlauts, "text");
    CHECK(content(folder / umlauts) == "text");
}

TEST_CASE("a temporary name is recognisable and beside its target")
{
    std::string const name = file::temporary_name("some/where.h5").string();
    CHECK(name.starts_with("some/.where.h5.hdconj-" + std::to_string(::getpid()) + "-"));
    CHECK(name.ends_with(".tmp"));
    CHECK(file::temporary_name("where.h5").parent_path() == ".");
}

TEST_CASE("permissions and symbolic links survive")
{
    TemporaryFolder const folder;
    file::write_text_atomically(folder / "real", "old");
    fs::permissions(folder / "real", fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    fs::create_symlink("real", folder / "link");
    file::write_text_atomically(folder / "link", "new");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(content(folder / "real") == "new");
    CHECK(fs::status(folder / "real").permissions() ==
          (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read));
}

TEST_CASE("a write-protected folder or file is refused")
{
    TemporaryFolder const folder;
    CHECK(test::in_child([&] {
              constexpr uid_t nobody = 65534;
              if (::geteuid() == 0 && (::chown(folder.path().c_str(), nobody, nobody) != 0 || ::setuid(nobody) != 0))
                  return not_allowed;
              file::write_text_atomically(folder / "file", "old");
              fs::permissions(folder / "file", fs::perms::owner_read);
              fs::create_directory(folder / "sub");
              fs::permissions(folder / "sub", fs::perms::owner_read | fs::perms::owner_exec);
              bool const file =
                  message_of(folder / "file").find("write-protected: Permission denied") != std::string::npos;
              bool const sub =
                  message_of(folder / "sub/a").find("cannot be written: Permission denied") != std::string::npos;
              return file && sub ? told : not_told;
          }) == told);
}

TEST_CASE("devices and pipes are written directly")
{
    TemporaryFolder const folder;
    CHECK(message_of("/dev/null").empty());
    CHECK_THAT(message_of("/dev/full"), ContainsSubstring("No space left"));
    fs::path const pipe = folder / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    int const reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    file::write_text_atomically(pipe, "through");
    char text[8] = {};
    CHECK(::read(reader, text, sizeof text) == 7);
    CHECK(std::string(text) == "through");
    ::close(reader);
    CHECK(folder.names().size() == 1);
}

TEST_CASE("a limit on file size leaves the old file and says what to do")
{
    TemporaryFolder const folder;
    CHECK(test::in_child([&] {
              std::signal(SIGXFSZ, SIG_IGN);
              rlimit const limit = {more_than_fits / 2, more_than_fits / 2};
              ::setrlimit(RLIMIT_FSIZE, &limit);
              return full_disk(folder / "a.h5", "ulimit -f");
          }) == told);
}

TEST_CASE("a full disk leaves the old file and is told")
{
    TemporaryFolder const folder;
    int const status = test::in_child([&] {
        bool const apart = ::unshare(CLONE_NEWNS) == 0 || ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
        if (!apart || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            ::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=512k") != 0) {
            return not_allowed;
        }
        return full_disk(folder / "a.h5", "No space left on device");
    });
    if (status == not_allowed) {
        not_tried("mounting is not allowed: the small disk");
        return;
    }
    CHECK(status == told);
}

}  // namespace hdconj::test::atomic_file_cases
