# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Visits of contacts a second in an active sweep, for each vector path: a settled bed of 25 230 spheres, and 36 tiles of it, which leave the
caches, beside what the core's memory allows. sweepSpeed.py [tiles along x and y, 6]"""

import sys

from coreRun import bed, rows, tableOf
from results import pyplot, savePicture

BED = (29, 30)


def main():
    tiles = int(sys.argv[1]) if len(sys.argv) > 1 else 6
    sizes = ((1, 50), (tiles, 1)) if tiles > 1 else ((1, 50),)
    table = tableOf("sweepSpeed", lambda: (({"tiles": n*n}, rows("sweepSpeed", bed(*BED), n, n, sweeps)) for n, sweeps in sizes), larger=("nsPerVisit",), smaller=("visitsMperS",))
    figure, axes = pyplot.subplots(figsize=(6, 4))
    for k, (n, _) in enumerate(sizes):
        paths = table.column("path", tiles=n*n)
        places = [i + 0.4*k for i in range(len(paths))]
        axes.bar(places, table.column("visitsMperS", tiles=n*n), 0.38, label="%.3g loaded contacts" % table.column("loaded", tiles=n*n)[0])
        allowed = table.column("allowedMperS", tiles=n*n)[0]
        if n > 1:
            axes.axhline(allowed, color="gray", linestyle=":", label="what memory allows")
        axes.set_xticks(range(len(paths)), paths)
    axes.set_ylabel("visits a second [1e6]")
    axes.legend()
    savePicture(figure, "sweepSpeed")


main()
