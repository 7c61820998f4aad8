// SPDX-License-Identifier: GPL-3.0-or-later
// HDF5's way of saying where bytes go: a file driver, for files that are created and never opened again.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <new>

#include "hdconj/result_files.hpp"
#include "hdf5_sink.hpp"

#if __has_include(<H5FDdevelop.h>)
#include <H5FDdevelop.h>  // from 1.14 on what a driver is made of
#endif

namespace hdconj::io::hdf5 {

/// What HDF5 hands to every function below: its own part first.
struct Sink::Writing
{
    H5FD_t part_of_hdf5 = {};
    Sink* sink = nullptr;
    haddr_t allocated = 0;
};

Sink::~Sink()
{
    if (file_ != nullptr)
        file_->sink = nullptr;
}

namespace {

constexpr herr_t done = 0, failed = -1;

Sink::Writing& driven(H5FD_t* file)
{
    return *reinterpret_cast<Sink::Writing*>(file);
}

Sink::Writing const& driven(H5FD_t const* file)
{
    return *reinterpret_cast<Sink::Writing const*>(file);
}

H5FD_t* open_sink(char const*, unsigned, hid_t access, haddr_t)
{
    auto const* const given = static_cast<Sink* const*>(H5Pget_driver_info(access));
    auto* const made = given != nullptr ? new (std::nothrow) Sink::Writing : nullptr;
    if (made == nullptr)
        return nullptr;
    made->sink = *given;
    made->sink->written_by(made);
    return &made->part_of_hdf5;
}

herr_t close_sink(H5FD_t* file)
{
    if (Sink* const sink = driven(file).sink; sink != nullptr)
        sink->written_by(nullptr);
    delete &driven(file);
    return done;
}

int compare(H5FD_t const* a, H5FD_t const* b)
{
    std::less<> const before;
    Sink const* const first = driven(a).sink;
    Sink const* const second = driven(b).sink;
    return before(first, second) ? -1 : before(second, first) ? 1 : 0;
}

herr_t query(H5FD_t const*, unsigned long* features)
{
    if (features != nullptr) {
        *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA;
    }
    return done;
}

haddr_t allocated(H5FD_t const* file, H5FD_mem_t)
{
    return driven(file).allocated;
}

herr_t allocate(H5FD_t* file, H5FD_mem_t, haddr_t end)
{
    driven(file).allocated = end;
    return done;
}

haddr_t end_of(H5FD_t const* file, H5FD_mem_t)
{
    Sink const* const sink = driven(file).sink;
    return sink != nullptr ? sink->end() : driven(file).allocated;
}

herr_t read_from(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, size_t size, void* bytes)
{
    Sink const* const sink = driven(file).sink;
    if (sink == nullptr)
        return failed;
    sink->read(at, size, static_cast<char*>(bytes));
    return done;
}

herr_t write_to(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, size_t size, void const* bytes)
{
    Sink* const sink = driven(file).sink;
    try {
        if (sink != nullptr)
            sink->write(at, {static_cast<char const*>(bytes), size});
    } catch (std::bad_alloc const&) {
        return failed;  // an exception must not pass through C
    }
    return done;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t)
{
    if (Sink* const sink = driven(file).sink; sink != nullptr)
        sink->end_at(driven(file).allocated);
    return done;
}

hid_t register_driver()
{
    H5FD_class_t driver = {};
#ifdef H5FD_CLASS_VERSION
    constexpr int outside_the_librarys_own = 300;
    driver.version = H5FD_CLASS_VERSION;
    driver.value = static_cast<H5FD_class_value_t>(outside_the_librarys_own);
#endif
    driver.name = "hdconj";
    driver.maxaddr = static_cast<haddr_t>(std::numeric_limits<std::ptrdiff_t>::max());
    driver.fc_degree = H5F_CLOSE_WEAK;
    driver.fapl_size = sizeof(Sink*);
    driver.open = open_sink;
    driver.close = close_sink;
    driver.cmp = compare;
    driver.query = query;
    driver.get_eoa = allocated;
    driver.set_eoa = allocate;
    driver.get_eof = end_of;
    driver.read = read_from;
    driver.write = write_to;
    driver.truncate = truncate;
    constexpr std::array<H5FD_mem_t, H5FD_MEM_NTYPES> kinds = H5FD_FLMAP_DICHOTOMY;
    std::copy(kinds.begin(), kinds.end(), driver.fl_map);
    return checked(H5FDregister(&driver), "register a driver");
}

}  // namespace

File create_in(Sink& sink)
{
    static hid_t const driver = register_driver();
    Properties const access(H5Pcreate(H5P_FILE_ACCESS), "create properties");
    Properties const creation(H5Pcreate(H5P_FILE_CREATE), "create properties");
    // Most groups have four entries: as many go into one node, and a fifth of the library's own size is enough.
    constexpr unsigned half_of_nodes = 4, half_of_entries = 2;
    checked(H5Pset_sym_k(creation, half_of_nodes, half_of_entries), "choose the size of groups");
    Sink* const place = &sink;
    checked(H5Pset_driver(access, driver, static_cast<void const*>(&place)), "choose the driver");
    return {H5Fcreate("hdconj", H5F_ACC_TRUNC, creation, access), "create file"};
}

}  // namespace hdconj::io::hdf5

namespace hdconj {

void leave_memory_at_exit()
{
    H5dont_atexit();
}

}  // namespace hdconj
