// SPDX-License-Identifier: GPL-3.0-or-later
// A file that goes to the disk while it is being made is the file that is made in memory, byte by byte, and a disk that
// takes no more says so in its own words.
#include "io/hdf5/hdf5_sink.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <fmt/format.h>
#include <boost/crc.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <optional>
#include <random>
#include <thread>

#include "file/atomic_file_posix.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/report.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/solve.hpp"
#include "io/hdf5/checksum.hpp"
#include "support/catch.hpp"
#include "support/read_hdf5.hpp"
#include "support/run_program.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::hdf5_sink_cases {

using io::hdf5::Sink;
using test::content;
using test::TemporaryFolder;

namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

/// A result larger than what is held back of a file.
Solution large_solution()
{
    Solution solution;
    constexpr std::size_t points = 50000;
    for (int i = 0; i < 3; ++i) {
        auto& branch = solution.branches.emplace_back();
        branch.kind = "line";
        for (std::size_t k = 0; k < points; ++k) {
            double const value = static_cast<double>(k) + i;
            branch.u.push_back(value);
            branch.phi.push_back(-value);
            branch.t.push_back(1 / (1 + value));
            branch.point.emplace_back(value, 2 * value);
        }
    }
    solution.neutral_curve = solution.branches[1].point;
    return solution;
}

/// Everything that comes out of a pipe while @p write writes into it.
template <class Write>
std::string through_pipe(std::filesystem::path const& pipe, Write write)
{
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    std::string all;
    std::thread reader([&] { all = content(pipe); });
    write(pipe);
    reader.join();
    return all;
}

}  // namespace

TEST_CASE("a sink in a file is the sink in memory, wherever is written and read")
{
    TemporaryFolder const folder;
    std::mt19937_64 draw(20261123);
    auto const up_to = [&](std::size_t most) { return static_cast<std::size_t>(draw() % (most + 1)); };
    for (int round = 0; round < 20; ++round) {
        file::posix::Descriptor file(folder / "a", O_RDWR | O_CREAT | O_TRUNC);
        REQUIRE(file.is_open());
        Sink direct(file.number(), true), in_memory;
        for (int i = 0; i < 40; ++i) {
            std::string const bytes(up_to(megabyte), static_cast<char>('a' + i % 26));
            std::size_t const at = up_to(4 * megabyte);
            direct.write(at, bytes);
            in_memory.write(at, bytes);
            std::size_t const from = up_to(5 * megabyte), size = up_to(megabyte);
            std::string one(size, 'x'), other(size, 'y');
            direct.read(from, size, one.data());
            in_memory.read(from, size, other.data());
            REQUIRE(one == other);
        }
        std::size_t const end = up_to(6 * megabyte);
        direct.end_at(end);
        in_memory.end_at(end);
        CHECK(direct.finish() == 0);
        CHECK(in_memory.bytes().size() == end + io::hdf5::Checksum::line_length);
        CHECK((content(folder / "a") == in_memory.bytes()));  // not spelt out: megabytes
    }
}

TEST_CASE(
    "a large result is the same through a pipe, where all of it is in memory first, and other programs' calls read it")
{
    TemporaryFolder const folder;
    ::setenv("SOURCE_DATE_EPOCH", "0", 1);
    auto const solution = large_solution();
    write_hdf5(solution, folder / "a.h5");
    auto const piped = through_pipe(folder / "pipe", [&](auto const& pipe) { write_hdf5(solution, pipe); });
    ::unsetenv("SOURCE_DATE_EPOCH");
    auto const written = content(folder / "a.h5");
    CHECK(written.size() > 4 * megabyte);
    CHECK((written == piped));
    auto const file = test::open_file(folder / "a.h5");
    CHECK(test::read(file, "envelope/branch_002/phi").values == solution.branches[2].phi);
    CHECK(test::read(file, "envelope/branch_000/u").values == solution.branches[0].u);
}

TEST_CASE("a large result on a disk that takes half of it: the system's reason, the old file, nothing beside it")
{
    constexpr int told = 0, not_told = 1, not_as_it_was = 2;
    TemporaryFolder const folder;
    auto const target = folder / "a.h5";
    file::write_text_atomically(target, "old");
    auto const solution = large_solution();
    for (std::size_t const limit : {megabyte / 2, 3 * megabyte, 5 * megabyte}) {
        INFO(limit);
        CHECK(test::in_child([&] {
                  std::signal(SIGXFSZ, SIG_IGN);
                  rlimit const most = {limit, limit};
                  ::setrlimit(RLIMIT_FSIZE, &most);
                  try {
                      write_hdf5(solution, target);
                  } catch (FileError const& error) {
                      bool const clean = content(target) == "old" && folder.names().size() == 1;
                      return !clean                                                             ? not_as_it_was
                             : std::string(error.what()).find("ulimit -f") != std::string::npos ? told
                                                                                                : not_told;
                  }
                  return not_told;
              }) == told);
    }
}

TEST_CASE("after its first error a sink writes nothing more and keeps that error")
{
    file::posix::Descriptor const nowhere("/dev/null", O_RDONLY);
    Sink sink(nowhere.number(), true);
    sink.write(0, "held back");
    CHECK(sink.error() == 0);
    sink.write(8 * megabyte, "not writable");
    CHECK(sink.error() == EBADF);
    std::string read(4, 'x');
    sink.read(0, read.size(), read.data());
    CHECK(read == "held");
    sink.read(8 * megabyte, read.size(), read.data());
    CHECK(read == std::string(4, '\0'));
    CHECK(sink.finish() == EBADF);
}

TEST_CASE("an HDF5 file that outlives its sink writes nowhere")
{
    io::hdf5::Silence const silence;
    std::optional<Sink> sink(std::in_place);
    io::hdf5::File const file = io::hdf5::create_in(*sink);
    (void)io::hdf5::checked(H5Gclose(H5Gcreate2(file, "before", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)), "close group");
    sink.emplace();  // another one, where the first one was
    hid_t const group = H5Gcreate2(file, "after", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    if (group >= 0)
        H5Gclose(group);
    H5Fflush(file, H5F_SCOPE_GLOBAL);
    CHECK(sink->end() == 0);
    CHECK(sink->bytes() == "hdconj crc32 00000000\n");
}

TEST_CASE("the checksum is CRC-32, in pieces of any size", "[hdf5]")
{
    using io::hdf5::Checksum;
    Checksum known;
    known.add("123456789");  // the check value of the catalogue of CRCs
    CHECK(known.line() == "hdconj crc32 cbf43926\n");
    std::minstd_rand draw(2);
    std::string bytes(5000, ' ');
    for (char& byte : bytes)
        byte = static_cast<char>(draw() % 256);
    boost::crc_32_type other;
    other.process_bytes(bytes.data(), bytes.size());
    Checksum pieces;
    for (std::size_t at = 0; at < bytes.size();) {
        std::string const piece = bytes.substr(at, draw() % 30);
        pieces.add(piece);
        at += piece.size();
    }
    CHECK(pieces.line() == fmt::format("hdconj crc32 {:08x}\n", other.checksum()));
}

TEST_CASE("a result file with a changed byte is refused before the library opens it", "[hdf5]")
{
    TemporaryFolder const folder;
    std::filesystem::path const file = folder / "a.h5";
    write_hdf5(solve(builtin_scene()), file);
    std::string const whole = content(file);
    std::string const line = whole.substr(whole.size() - io::hdf5::Checksum::line_length);
    CHECK(line.starts_with(io::hdf5::Checksum::mark));
    auto const is_read = [&](std::string const& bytes) {
        std::ofstream(file, std::ios::binary) << bytes;
        try {
            return read_drive(file).solution.scene.drive.flexspline_teeth == 200;
        } catch (InputError const&) {
            return false;
        }
    };
    CHECK(is_read(whole));
    CHECK(is_read(whole.substr(0, whole.size() - line.size())));  // of an earlier version
    CHECK_FALSE(is_read(whole.substr(0, whole.size() / 2)));
    std::minstd_rand draw(1);
    constexpr int damages = 1000;
    int harmless = 0;
    for (int i = 0; i < damages; ++i) {
        std::size_t const at =
            i < damages / 2 ? draw() % 4096 : draw() % whole.size();  // half in the superblock's part
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 + draw() % 255));
        bool const in_mark = at >= whole.size() - line.size() && at < whole.size() - 9;
        harmless += in_mark ? 1 : 0;
        if (is_read(bytes) != in_mark)
            FAIL("byte " << at);
    }
    CHECK(harmless < 5);
}

}  // namespace hdconj::test::hdf5_sink_cases