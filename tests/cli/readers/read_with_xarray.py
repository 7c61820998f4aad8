#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens every group of a result by xarray through h5netcdf, a netCDF-4 reader that is not ours.

  read_with_xarray.py RESULT.h5...

h5netcdf refuses a dataset whose dimensions have no names. Prints what is wrong, and one line that says what was read.
"""

import sys
import warnings

import h5py

from faults import verdict, want

try:
    warnings.simplefilter("ignore")  # those of its own libraries
    import h5netcdf  # noqa: F401
    import xarray
except ImportError:
    sys.exit("no xarray with h5netcdf")

# Dimensions of some datasets, and those of them that have coordinates.
KNOWN = {
    "circular_spline/outline": (("z", "point", "xy"), {"z"}),
    "neutral_curve": (("neutral_point", "xy"), {"xy"}),
    "envelope/branch_000/point": (("u", "xy"), {"u"}),
    "conjugate_zones/phi": (("zone", "end"), set()),
    "timing/seconds": (("stage",), {"stage"}),
    "contact/map/gap": (("angle", "flank", "z", "flank_position"), {"angle", "flank", "z", "flank_position"}),
    "contact/case_000/flank_where": (("z", "xy"), {"z"}),
    "contact/case_000/revolution/backlash": (("wave_generator",), {"wave_generator"}),
    "contact/best/interval": (("optimum", "end"), set()),
    "load/case_000/map/pressure": (("angle", "flank", "z"), {"angle", "flank", "z"}),
    "load/case_000/curve/twist": (("state",), set()),
    "load/case_000/curve/error/twist": (("state",), set()),
    "load/shape/stress": (("phi", "node"), {"phi"}),
}
NOT_A_VARIABLE = b"This is a netCDF dimension but not a netCDF variable."


def check_variable(place, variable, stored):
    want(variable.shape == stored.shape, f"{place}: shape {variable.shape}, not {stored.shape}")
    want(len(variable.attrs.get("long_name", "")) > 2, f"{place} has no long_name")
    want("units" in variable.attrs, f"{place} has no units")
    if place in KNOWN:
        dims, coordinates = KNOWN[place]
        want(variable.dims == dims, f"{place} has the dimensions {variable.dims}, not {dims}")
        want(set(variable.coords) >= coordinates, f"{place} has coordinates for {set(variable.coords)} only")
    if stored.dtype.kind == "f" and stored.size:
        want((variable.values == stored[()]).all(), f"{place}: values differ")


def check_group(name, group):
    stored = {key: item for key, item in group.items() if isinstance(item, h5py.Dataset)}
    read = xarray.open_dataset(name, group=group.name, engine="h5netcdf")
    want(not [dim for dim in read.dims if "phony" in dim], f"{group.name} has dimensions without names")
    for key, item in stored.items():
        if NOT_A_VARIABLE in item.attrs.get("NAME", b""):
            want(key in read.dims and read.dims[key] == item.shape[0], f"{item.name} is no dimension")
        else:
            check_variable(item.name.strip("/"), read[key], item)
    return len(read.variables)


def main(names):
    count = 0
    for name in names:
        with h5py.File(name, "r") as file:
            groups = [file]
            file.visititems(lambda _, item: groups.append(item) if isinstance(item, h5py.Group) else None)
            count += sum(check_group(name, group) for group in groups)
    return verdict(count, f"{count} variables")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
