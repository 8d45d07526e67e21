# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Tables that runs write: report.csv, walls.csv."""

import csv
import math


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
