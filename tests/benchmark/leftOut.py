# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Rows and pictures of build/core/benchmark/skips and detection: what scenes cost with and without what they do not need."""

import csv
import subprocess

from pinnedRun import CORE
from results import ROOT, Table, pyplot, savePicture

PROGRAMS = ROOT/"build/core/benchmark"
BEDS = ROOT/"build/beds"


def bed(perSide, layers, steps=2000):
    """A settled bed in a periodic box; one that is missing takes some minutes."""
    path = BEDS/("bed%dx%d.dat" % (perSide, layers))
    if not path.exists():
        BEDS.mkdir(parents=True, exist_ok=True)
        subprocess.run([PROGRAMS/"rankedBed", "settle", path, str(perSide), str(layers), str(steps)], check=True)
    return path


def measured(name, runs):
    """A table of the rows that a program printed: runs are lists of a program's name and its arguments."""
    table = None
    for program, *arguments in runs:
        command = ["taskset", "-c", str(CORE), PROGRAMS/program, *map(str, arguments)]
        output = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        rows = list(csv.reader(output.splitlines()))
        table = table or Table(name, rows[0])
        for row in rows[1:]:
            table.add(*(number(value) for value in row))
    table.save()
    return table


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def bars(table, name, labels, value, unit):
    """A bar for each row."""
    figure, axes = pyplot.subplots(figsize=(6, 1 + 0.4*len(table.rows)))
    texts = [" ".join(str(part) for part in row) for row in zip(*(table.column(label) for label in labels))]
    axes.barh(range(len(texts)), table.column(value))
    axes.set_yticks(range(len(texts)), texts)
    axes.invert_yaxis()
    axes.set_xlabel(unit)
    savePicture(figure, name)
