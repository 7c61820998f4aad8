// SPDX-License-Identifier: GPL-3.0-or-later
// One target as a libFuzzer program. HDCONJ_FUZZ_TARGET names the target; HDCONJ_FUZZ_DRIVES: its inputs are drives.
#include <algorithm>
#include <cstring>

#include "drive_text.hpp"
#include "targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    hdconj::fuzz::HDCONJ_FUZZ_TARGET({data, size});
    return 0;
}

#ifdef HDCONJ_FUZZ_DRIVES

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

std::size_t put(std::string const& text, std::uint8_t* out, std::size_t most)
{
    std::size_t const size = std::min(text.size(), most);
    std::memcpy(out, text.data(), size);
    return size;
}

}  // namespace

/// Mostly changes that know what a drive is; now and then bytes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed)
{
    constexpr unsigned bytes_one_in = 32;
    if (seed % bytes_one_in == 0)
        return LLVMFuzzerMutate(data, size, most);
    return put(hdconj::fuzz::mutated_drive(hdconj::fuzz::text_of({data, size}), seed), data, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(std::uint8_t const* a, std::size_t a_size, std::uint8_t const* b,
                                                 std::size_t b_size, std::uint8_t* out, std::size_t most, unsigned seed)
{
    using hdconj::fuzz::text_of;
    return put(hdconj::fuzz::crossed_drives(text_of({a, a_size}), text_of({b, b_size}), seed), out, most);
}

#endif
