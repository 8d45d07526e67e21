# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Where benchmarks put what they measured: a table on the screen and as CSV, and a picture."""

import csv
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT/"build/benchmark"
sys.path.insert(0, str(ROOT/"tests/validation/resources"))


def text(value):
    return "%.4g" % value if isinstance(value, float) else str(value)


class Table:
    """Rows of one benchmark, each printed when it is measured."""

    def __init__(self, name, columns):
        self.name, self.columns, self.rows = name, columns, []
        BUILD.mkdir(parents=True, exist_ok=True)
        print("  ".join("%-*s" % (max(10, len(column)), column) for column in columns))

    def add(self, *row):
        self.rows.append(row)
        print("  ".join("%-*s" % (max(10, len(column)), text(value)) for column, value in zip(self.columns, row)), flush=True)

    def column(self, name, **where):
        """Values of a column in the rows whose other columns are as given."""
        at = self.columns.index
        return [row[at(name)] for row in self.rows if all(row[at(key)] == value for key, value in where.items())]

    def save(self):
        with open(BUILD/(self.name + ".csv"), "w", newline="") as file:
            csv.writer(file).writerows([self.columns] + self.rows)


def savePicture(figure, name):
    figure.tight_layout()
    figure.savefig(BUILD/(name + ".png"), dpi=90)
    pyplot.close(figure)
    print("written: build/benchmark/%s.csv, %s.png" % (name, name))
