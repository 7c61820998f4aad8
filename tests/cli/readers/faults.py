# SPDX-License-Identifier: GPL-3.0-or-later
"""What the readers beside this file find wrong."""

faults = []


def want(condition, text):
    """Notes the text as a fault where the condition does not hold."""
    if not condition:
        faults.append(text)


def verdict(count, found):
    """Prints all faults and what was found; the exit status. Nothing counted is a fault too."""
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{found}, {len(faults)} faults")
    return 1 if faults or count == 0 else 0
