# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A table of runs that take an hour each: one row of each, saved once it is measured. BENCHMARK_RUNS names those that are made (their `knob`, several
with semicolons between); the other rows stay as the machine's table has them, each with the commit that it is of."""

import csv
import os
import sys

from origin import commit
from results import RESULTS, Table


def number(word):
    try:
        return float(word)
    except ValueError:
        return word


class KeptTable(Table):
    """Columns: `code`, `knob`, then the benchmark's own, then `measuredAt`."""

    def __init__(self, name, columns, larger):
        super().__init__(name, ["code", "knob", *columns, "measuredAt"], larger)
        self.rounds = [self.kept()]

    def kept(self):
        path = RESULTS/(self.name + ".csv")
        if not path.exists():
            return []
        rows = csv.DictReader(line for line in path.read_text().splitlines() if not line.startswith("#"))
        return [tuple(number(row[column]) for column in self.columns) for row in rows]

    def replace(self, code, knob, *values):
        """Where the knob's row is, or at the end; saved."""
        before = self.kept()    # anew: another process may have added rows
        row = (code, knob, *values, commit())
        self.rounds = [[row if kept[1] == knob else kept for kept in before]] if any(kept[1] == knob for kept in before) else [[*before, row]]
        self.save()
        print("  ".join("%s %s" % pair for pair in zip(self.columns, map(str, row))), flush=True)

    def ofRuns(self, runs, measure):
        """`runs`: by knob, what measure(table, knob, run) takes."""
        asked = [knob.strip() for knob in os.environ.get("BENCHMARK_RUNS", ";".join(runs)).split(";")]
        unknown = [knob for knob in asked if knob not in runs]
        if unknown:
            sys.exit("BENCHMARK_RUNS: %s has %s, not '%s'" % (self.name, "; ".join(runs), unknown[0]))
        for knob in asked:
            measure(self, knob, runs[knob])
        return self
