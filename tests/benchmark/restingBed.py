# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What a step of a bed at rest costs, part by part: all grains awake, and free to sleep. restingBed.py [tiles along x and y, 1]
[option=value ...], options as build/core/benchmark/restingBed has them."""

import sys

from coreRun import bed, rows, tableOf
from results import pyplot, savePicture

BED = (29, 30)


def main():
    tiles = sys.argv[1] if len(sys.argv) > 1 else "1"
    table = tableOf("restingBed", lambda: [({}, rows("restingBed", bed(*BED), "tilesX=" + tiles, "tilesY=" + tiles, *sys.argv[2:]))], larger=("sweeps", "msPerStep"))
    figure, axes = pyplot.subplots(figsize=(7, 4))
    names = ["%s, %d" % (what, k % 3 + 1) for k, what in enumerate(table.column("what"))]
    below = [0.0]*len(names)
    for part in [name for name in table.columns if name.endswith("Ms")]:
        height = table.column(part)
        axes.bar(names, height, bottom=below, label=part)
        below = [a + b for a, b in zip(below, height)]
    axes.set_ylabel("ms a step, %d grains" % table.column("grains")[0])
    axes.tick_params(axis="x", rotation=30)
    axes.legend()
    savePicture(figure, "restingBed")


main()
