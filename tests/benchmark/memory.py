# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Bytes per grain in the parts of a run and in the contact list's containers, by number of ranks: memory.py [largest number of ranks, 2]"""

import csv
import sys

from coreRun import PROGRAMS, bed
from rankedRun import said
from results import ROOT, Table, pyplot, savePicture

BED = (10, 50)
TILES, STEPS = (2, 2), 22
MPIRUN = ("mpirun", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1", "-np")


def measure(table, largest):
    for ranks in (n for n in (1, 2, 4, 8) if n <= largest):
        printed = said(ROOT/"build", *MPIRUN, ranks, PROGRAMS/"rankedMemory", "bed", bed(*BED), *TILES, STEPS)
        for row in csv.reader(printed.splitlines()):
            if len(row) == 4 and row[0] == str(ranks):
                table.add(ranks, row[1], float(row[2]), float(row[3]))


def main():
    largest = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    table = Table("memory", ["ranks", "what", "mean", "worst"], larger=("mean", "worst"))
    table.inRounds(lambda table: measure(table, largest), 1)    # bytes do not scatter
    figure, axes = pyplot.subplots(figsize=(7, 5))
    names = table.column("what", ranks=1)
    for ranks in sorted(set(table.column("ranks"))):
        axes.plot(table.column("worst", ranks=ranks), names, "o", label="%d ranks" % ranks)
    axes.set_xlabel("bytes per grain, worst rank")
    axes.legend()
    savePicture(figure, "memory")


main()
