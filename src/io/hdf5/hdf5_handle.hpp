// SPDX-License-Identifier: GPL-3.0-or-later
// HDF5 identifiers that close themselves, and HDF5 failures as exceptions.
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <utility>

namespace hdconj::io::hdf5 {

/// An HDF5 call failed; what() is the library's own innermost description.
class Failure : public std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// Switches the library's printing to standard error off while it lives.
class Silence
{
  public:
    Silence()
    {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    Silence(Silence const&) = delete;
    Silence& operator=(Silence const&) = delete;

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// @throws Failure with the description from the library's error stack
[[noreturn]] void fail(char const* doing);

/// Passes a result of the C interface on, or throws when it is negative.
template <class Result>
Result checked(Result result, char const* doing)
{
    if (result < 0)
        fail(doing);
    return result;
}

/// Owns one identifier; @p Close is the matching H5?close.
template <herr_t (*Close)(hid_t)>
class Handle
{
  public:
    Handle(hid_t id, char const* doing) : id_(checked(id, doing)) {}
    ~Handle()
    {
        if (id_ >= 0)
            Close(id_);
    }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Handle(Handle const&) = delete;
    Handle& operator=(Handle const&) = delete;
    Handle& operator=(Handle&&) = delete;

    operator hid_t() const { return id_; }  // the C interface takes it everywhere

  private:
    hid_t id_;
};

using File = Handle<H5Fclose>;
using Group = Handle<H5Gclose>;
using Dataset = Handle<H5Dclose>;
using Space = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;
using Attribute = Handle<H5Aclose>;
using Properties = Handle<H5Pclose>;

/// Text of any length in UTF-8.
inline Type text_type()
{
    Type type(H5Tcopy(H5T_C_S1), "copy string type");
    checked(H5Tset_size(type, H5T_VARIABLE), "set string length");
    checked(H5Tset_cset(type, H5T_CSET_UTF8), "set character set");
    return type;
}

}  // namespace hdconj::io::hdf5
