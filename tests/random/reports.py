# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Tables that runs write: report.csv, walls.csv."""

import csv
import math

OVERLAP = 1e-2      # [mean diameters] what a user would see; overlapTolerance is 5e-4


def readTable(path):
    """Rows by column; what is no number is NaN."""
    with open(path, newline="", errors="replace") as file:
        return [{name: number(value) for name, value in row.items()} for row in csv.DictReader(line for line in file if line[0] != "#")]


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return math.nan


def notFinite(rows):
    """The first number that is not finite, in words; also where there is no row. None if all are."""
    if not rows:
        return "no row"
    for row in rows:
        for name, value in row.items():
            if not math.isfinite(value):
                return f"{name} at {row['time']} s"
    return None


def wrongContacts(rows):
    """Steps that did not converge, where they are many, and overlaps."""
    found = {}
    missed = sum(row["converged"] == 0 for row in rows)
    if missed > 0.1*len(rows):
        found["unconverged"] = f"{missed} of {len(rows)} steps"
    deepest = max(rows, key=lambda row: row["overlapMax"])
    if deepest["overlapMax"] > OVERLAP:
        found["overlap" if deepest["converged"] else "overlap, unconverged"] = f"{deepest['overlapMax']:.2g} d"
    return found
