# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The seven parts of a coupled step, out of the timing table of a log, and as a picture."""

import re

from results import pyplot, savePicture

PARTS = ["sampleFluid", "linearizeDrag", "solveFluid", "fluidForces", "advanceGrains", "depositGrains", "reportStep"]


def timesOf(log, column):
    """Of each part: its `seconds`, or its `ms` per step."""
    place = {"seconds": 1, "ms": 2}[column]
    return [float(re.search(r"^\s*%s\s+(\S+)\s+\S+ %%\s+(\S+)\s*$" % part, log, flags=re.M).group(place)) for part in PARTS]


def drawParts(table, name, label):
    """A bar for each row, of its columns PARTS [ms per step]."""
    figure, axes = pyplot.subplots(figsize=(6, 3.5))
    left = [0.0]*len(table.rows)
    for part in PARTS:
        widths = table.column(part)
        axes.barh(table.column(label), widths, left=left, label=part)
        left = [a + b for a, b in zip(left, widths)]
    axes.set_xlabel("ms per step (clock)")
    axes.legend(fontsize=7)
    savePicture(figure, name)
