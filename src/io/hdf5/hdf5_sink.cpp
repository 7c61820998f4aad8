// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_sink.hpp"

#include <algorithm>

#include "checksum.hpp"
#include "file/atomic_file_posix.hpp"

namespace hdconj::io::hdf5 {
namespace {

/// How much of the beginning of a file is held back [bytes].
constexpr std::size_t beginning = std::size_t{1} << 21;
/// From what size on the disk is told of a write [bytes].
constexpr std::size_t worth_a_call = std::size_t{1} << 17;

}  // namespace

Sink::Sink(int descriptor, bool goes_back) : descriptor_(descriptor), goes_back_(goes_back)
{
    if (goes_back) {
        most_held_ = beginning;
        held_.reserve(beginning);  // memory once it is written to
    }
}

void Sink::write(std::size_t at, std::string_view bytes)
{
    end_ = std::max(end_, at + bytes.size());
    if (at < most_held_) {
        std::size_t const first = std::min(bytes.size(), most_held_ - at);
        held_.resize(std::max(held_.size(), at + first));
        std::copy_n(bytes.begin(), first, held_.begin() + static_cast<std::ptrdiff_t>(at));
        bytes.remove_prefix(first);
        at += first;
    }
    if (error_ == 0) {
        error_ = file::posix::write_at(descriptor_, at, bytes);
        if (bytes.size() > worth_a_call)
            file::posix::begin_to_store(descriptor_, at, bytes.size());
    }
}

void Sink::read(std::size_t at, std::size_t size, char* bytes) const
{
    std::fill_n(bytes, size, '\0');
    if (at < held_.size()) {
        std::size_t const first = std::min(size, held_.size() - at);
        std::copy_n(held_.begin() + static_cast<std::ptrdiff_t>(at), first, bytes);
    }
    if (at + size > most_held_) {
        std::size_t const skipped = most_held_ > at ? most_held_ - at : 0;
        file::posix::read_at(descriptor_, at + skipped, size - skipped, bytes + skipped);
    }
}

std::string Sink::checksum_line() const
{
    Checksum checksum;
    std::string_view const held = std::string_view(held_).substr(0, end_);
    checksum.add(held);
    std::string bytes;
    for (std::size_t at = held.size(); at < end_; at += bytes.size()) {
        bytes.resize(std::min(beginning, end_ - at));
        read(at, bytes.size(), bytes.data());
        checksum.add(bytes);
    }
    return checksum.line();
}

int Sink::finish()
{
    held_.resize(std::min(end_, most_held_));
    if (error_ == 0)
        error_ = goes_back_ ? file::posix::write_at(descriptor_, 0, held_) : file::posix::write_on(descriptor_, held_);
    if (error_ == 0 && goes_back_)
        error_ = file::posix::end_at(descriptor_, end_);
    if (error_ == 0)
        error_ = goes_back_ ? file::posix::write_at(descriptor_, end_, checksum_line())
                            : file::posix::write_on(descriptor_, checksum_line());
    return error_;
}

std::string Sink::bytes() const
{
    std::string whole = held_;
    whole.resize(end_);
    return whole + checksum_line();
}

}  // namespace hdconj::io::hdf5
