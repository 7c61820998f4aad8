#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the balance of loaded teeth from result files alone, with h5py and nothing of hdconj:

    check_equilibrium.py FILE.h5...

For each case: no force is negative, each normal has the length 1, each lever is the moment of its normal about the
axis, and the torques of all sectors add up to the torque.
"""
import sys

import h5py
import numpy as np

BALANCE = 1e-9  # relative
LEVER = 1e-12  # relative: the file has all digits


def faults_of(file):
    load = file["load"]
    for name in sorted(name for name in load if name.startswith("case_")):
        contacts = load[name]["contacts"]
        place, normal, lever, force = (contacts[key][()] for key in ("place", "normal", "lever", "force"))
        moment = normal[:, 0] * place[:, 1] - normal[:, 1] * place[:, 0]
        torque = contacts.attrs["torque_Nmm"]
        rest = load.attrs["sectors"] * np.sum(lever * force) / torque - 1
        print(f"{name}: {len(force)} contacts, balance of {torque / 1000:g} N m to {abs(rest):.1e}")
        if not np.all(force > 0):
            yield f"{name}: a force is not positive"
        if not np.allclose(np.hypot(*normal.T), 1, rtol=0, atol=LEVER):
            yield f"{name}: a normal has not the length 1"
        if not np.allclose(moment, lever, rtol=0, atol=LEVER * np.abs(place).max()):
            yield f"{name}: a lever is not the moment of its normal"
        if not abs(rest) <= BALANCE:
            yield f"{name}: torques add up to {1 + rest} of {torque} N mm"


def main(paths):
    faults = []
    for path in paths:
        with h5py.File(path) as file:
            faults += [f"{path}: {fault}" for fault in faults_of(file)]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
