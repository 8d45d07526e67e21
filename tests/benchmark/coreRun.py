# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Benchmark programs of the core, pinned to one core, and the settled beds that they work on."""

import csv
import subprocess

from pinnedRun import CORE
from results import ROOT, ROUNDS, Table

PROGRAMS = ROOT/"build/core/benchmark"
BEDS = ROOT/"build/beds"
SETTLING = 2000     # steps


def bed(perSide, layers, seed=1):
    """The file of a settled bed of perSide x perSide x layers grains with periodic sides, another one for each seed; settled first if it is not
    there, some minutes."""
    path = BEDS/("bed%dx%d%s.dat" % (perSide, layers, "" if seed == 1 else ".%d" % seed))
    if not path.exists():
        BEDS.mkdir(parents=True, exist_ok=True)
        print("settling %s" % path.relative_to(ROOT), flush=True)
        subprocess.run([PROGRAMS/"coldSolve", "settle", path, str(perSide), str(layers), str(SETTLING), str(seed)], check=True)
    return path


def rows(program, *arguments):
    """What a program prints as CSV, a dictionary a row: numbers where they are."""
    command = ["taskset", "-c", str(CORE), PROGRAMS/program, *map(str, arguments)]
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    return [{name: numberOr(value) for name, value in row.items()} for row in csv.DictReader(output.splitlines())]


def numberOr(value):
    try:
        return float(value)
    except ValueError:
        return value


def tableOf(name, measure, rounds=ROUNDS, larger=(), smaller=()):
    """All columns of the rows that are measured; measure() gives pairs of leading columns and rows, as Table.inRounds has them measured."""
    def addAll(table):
        for lead, found in measure():
            for row in found:
                table.addNamed({**lead, **row})
    return Table(name, (), larger, smaller).inRounds(addAll, rounds)
