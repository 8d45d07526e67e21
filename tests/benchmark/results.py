# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Where benchmarks put what they measured: results/<machine>, a table as CSV, a few lines of Markdown and a picture of each. What scatters is
measured in rounds, everything in turn in each; figures are medians over the rounds, and the CSV has every round, its number first."""

import csv
import os
import statistics
import sys
import textwrap
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot

from origin import ROOT, machine, origin

BUILD = ROOT/"build/benchmark"      # cases, states and logs
RESULTS = Path(os.environ.get("BENCHMARK_RESULTS", ROOT/"tests/benchmark/results"))/machine()
sys.path.insert(0, str(ROOT/"tests/validation/resources"))

ROUNDS = int(os.environ.get("BENCHMARK_ROUNDS", "3"))
LONGEST = 120       # characters of a line of Markdown
SPDX = ("SPDX-License-Identifier: GPL-3.0-or-later", "SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors")


def text(value):
    return "%.4g" % value if isinstance(value, float) else str(value)


def median(values):
    """Of numbers; of words, which do not change from round to round, the word."""
    return statistics.median(values) if all(isinstance(value, (int, float)) for value in values) else values[0]


class Table:
    """Rows of one benchmark, each printed when it is measured. Of columns named in `larger` more is worse, of those in `smaller` less is;
    others tell rows apart, or inform."""

    def __init__(self, name, columns=(), larger=(), smaller=()):
        self.name, self.columns, self.larger, self.smaller = name, list(columns), larger, smaller
        self.rounds, self.origin = [[]], origin()
        for folder in (BUILD, RESULTS):
            folder.mkdir(parents=True, exist_ok=True)

    def addNamed(self, row):
        """A row that brings the names of its columns, which are the table's."""
        self.columns = self.columns or list(row)
        self.add(*row.values())

    def add(self, *row):
        if self.rounds == [[]]:
            print("  ".join("%-*s" % (max(10, len(column)), column) for column in self.columns))
        self.rounds[-1].append(row)
        print("  ".join("%-*s" % (max(10, len(column)), text(value)) for column, value in zip(self.columns, row)), flush=True)

    def inRounds(self, measure, rounds=ROUNDS):
        """measure(table) adds the same rows each time; what is there is saved after each round."""
        for number in range(rounds):
            if number:
                self.rounds.append([])
            measure(self)
            self.save()
        return self

    @property
    def rows(self):
        """Medians over the rounds."""
        return [tuple(map(median, zip(*samples))) for samples in zip(*self.rounds)]

    def column(self, name, **where):
        """Values of a column in the rows whose other columns are as given."""
        at = self.columns.index
        return [row[at(name)] for row in self.rows if all(row[at(key)] == value for key, value in where.items())]

    def spread(self, name):
        """Lowest and highest of a column over the rounds, of each row."""
        at = self.columns.index(name)
        return [(min(row[at] for row in samples), max(row[at] for row in samples)) for samples in zip(*self.rounds)]

    def save(self):
        with open(RESULTS/(self.name + ".csv"), "w", newline="") as file:
            worse = ("# larger is worse: " + "; ".join(self.larger), "# smaller is worse: " + "; ".join(self.smaller))
            file.writelines(line + "\n" for line in (*("# " + line for line in SPDX), "# origin: " + self.origin, *worse))
            rows = [(number + 1, *row) for number, rows in enumerate(self.rounds) for row in rows]
            csv.writer(file, lineterminator="\n").writerows([("repeat", *self.columns)] + rows)
        (RESULTS/(self.name + ".md")).write_text("\n".join(self.markdown()) + "\n")

    def markdown(self):
        """What was measured, where from, and the medians: as many columns, from the first on, as a line takes."""
        shown = [self.columns] + [tuple(map(text, row)) for row in self.rows]
        count = max(n for n in range(1, len(self.columns) + 1) if n == 1 or max(len(markdownRow(row[:n])) for row in shown) <= LONGEST)
        what = " ".join((sys.modules["__main__"].__doc__ or "").split("\n\n")[0].split())
        note = "Medians of %d rounds; every round%s is in %s.csv." % (len(self.rounds), ", with all columns," if count < len(self.columns) else "", self.name)
        lines = ["<!--", *SPDX, "What the benchmark %s measured; written by it." % self.name, "-->", "# " + self.name, ""]
        for paragraph in (what, self.origin + ".", note):
            lines += textwrap.wrap(paragraph, LONGEST, break_long_words=False, break_on_hyphens=False) + [""]
        return lines + [markdownRow(self.columns[:count]), "|" + "---|"*count] + [markdownRow(row[:count]) for row in shown[1:]]


def markdownRow(cells):
    return "| " + " | ".join(cells) + " |"


def savePicture(figure, name):
    """After the table of that name, whose Markdown then shows it."""
    figure.tight_layout()
    figure.savefig(RESULTS/(name + ".png"), dpi=90)
    pyplot.close(figure)
    lines = RESULTS/(name + ".md")
    lines.write_text(lines.read_text() + "\n![%s](%s.png)\n" % (name, name))
    print("written: %s, %s.csv, .md and .png" % (os.path.relpath(RESULTS, ROOT), name))


def bars(table, labels, value, unit):
    """The picture of a table without one of its own: a bar for each row, with the spread of its rounds."""
    figure, axes = pyplot.subplots(figsize=(6, 1 + 0.4*len(table.rows)))
    texts = [" ".join(map(text, row)) for row in zip(*(table.column(label) for label in labels))]
    values = table.column(value)
    spread = [[max(0, middle - low) for middle, (low, _) in zip(values, table.spread(value))],
              [max(0, high - middle) for middle, (_, high) in zip(values, table.spread(value))]]
    axes.barh(range(len(texts)), values, xerr=spread)
    axes.set_yticks(range(len(texts)), texts)
    axes.invert_yaxis()
    axes.set_xlabel(unit)
    savePicture(figure, table.name)
