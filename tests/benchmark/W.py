# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W: the processor time that each code takes to come within 10, 3 and 1 % of the reference, for each case, out of all tables W*.csv that lie in the
folder of results; it measures nothing itself. `never`: by none of the runs; the smallest error is theirs then. In bold: the first of a case."""

import csv
import statistics
import sys
import textwrap
from pathlib import Path

from results import LONGEST, RESULTS, SPDX, markdownRow, text

NAME = "W"
BARS = (10, 3, 1)       # percent
# Columns of tables that do not have `case`, `code`, `errorPercent`: case, code, error and its factor to percent.
OWN = {
    "W5": ("grain", lambda row: "nscdDEMFoam, " + row["weight"], "maxError", 100)
}
# Codes that are no runs to be scored: references, variants of the scene.
APART = ("reference", "nscdDEMFoam, mirrored", "nscdDEMFoam, discs")
WHY = Path(__file__).resolve().parent/"W.reasons.md"


def read(path):
    """Origin of a table, and its rows; W12 has no error, and is left out."""
    lines = path.read_text().splitlines()
    origin = next(line for line in lines if line.startswith("# origin: "))[len("# origin: "):]
    return origin, list(csv.DictReader(line for line in lines if not line.startswith("#")))


def scored(name, rows):
    """Case, code, error in percent and seconds of each run, medians over the rounds."""
    case, codeOf, error, factor = OWN.get(name, ("case" if rows and "case" in rows[0] else "scene", lambda row: row["code"], "errorPercent", 1))
    if not rows or error not in rows[0] or "seconds" not in rows[0]:
        return []
    rounds = {}
    for row in rows:
        rounds.setdefault(row.pop("repeat"), []).append(row)
    result = []
    for same in zip(*rounds.values()):
        median = lambda column: statistics.median(float(row[column]) for row in same)
        what = "%s %s" % (name, same[0].get(case) or "")
        if codeOf(same[0]) not in APART:
            result.append((what.strip(), codeOf(same[0]), abs(factor*median(error)), median("seconds")))
    return result


def times(runs):
    """Of (error, seconds): the least seconds within each bar, None where none is. Stored errors of others have no time."""
    return [min((seconds for error, seconds in runs if error <= bar and seconds == seconds), default=None) for bar in BARS]


def isTimed(runs):
    return any(seconds == seconds for _, seconds in runs)


def hasPeer(codes):
    """Of (code, runs): whether one that was timed is another's."""
    return any(not code.startswith("nscdDEMFoam") and isTimed(runs) for code, runs in codes.items())


def isUseful(runs):
    return any(error == error for error, _ in runs)


def table(results):
    """Rows of case, code, time to each bar, smallest error."""
    lines = []
    for case in dict.fromkeys(row[0] for row in results):
        codes = {code: [row[2:] for row in results if row[:2] == (case, code)] for code in dict.fromkeys(row[1] for row in results if row[0] == case)}
        found = {code: times(runs) for code, runs in codes.items() if isUseful(runs)}
        for code, values in found.items():
            cells = []
            for k, value in enumerate(values):
                best = min((other[k] for other in found.values() if other[k] is not None), default=None)
                none = "never" if isTimed(codes[code]) else "not timed"
                cells.append(none if value is None else ("**%s**" if value == best and hasPeer(codes) else "%s") % text(value))
            lines.append((case, code, *cells, text(min(error for error, _ in codes[code] if error == error))))
    return lines


def behind(results):
    """Cases in which the first at 3 % is not ours."""
    cases = []
    for case in dict.fromkeys(row[0] for row in results):
        found = sorted((row[3], row[1]) for row in results if row[0] == case and row[2] <= 3 and row[3] == row[3])
        if found and not found[0][1].startswith("nscdDEMFoam"):
            cases.append(case)
    return cases


def order(path):
    return int(path.stem[1:])


def main():
    results, origins = [], []
    for path in sorted((p for p in RESULTS.glob("W*.csv") if p.stem[1:].isdigit()), key=order):
        origin, rows = read(path)
        found = scored(path.stem, rows)
        results += found
        if found:
            origins.append("- %s: %s" % (path.stem, origin))
    if not results:
        sys.exit("tests/benchmark/run W: there is no table W*.csv in %s yet: run W1, W2, ... first" % RESULTS)
    columns = ["case", "code", *("to %d %% [s]" % bar for bar in BARS), "smallest error [%]"]
    lines = ["<!--", *SPDX, "What the benchmark W made of the others' tables; written by it.", "-->", "# W", ""]
    lines += textwrap.wrap(" ".join(__doc__.split()), LONGEST) + [""]
    lines += [markdownRow(columns), "|" + "---|"*len(columns)] + [markdownRow(row) for row in table(results)] + [""]
    lines += ["Not first at 3 %: " + (", ".join(behind(results)) or "nowhere") + ".", ""]
    if WHY.exists():
        lines += WHY.read_text().split("-->\n", 1)[1].strip().splitlines() + [""]
    lines += ["Measured:", ""]
    for origin in origins:
        lines += textwrap.wrap(origin, LONGEST, subsequent_indent="  ", break_on_hyphens=False)
    (RESULTS/(NAME + ".md")).write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
