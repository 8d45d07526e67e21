# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What finding contacts costs a grain and build, in parts: settled beds, a loose lattice, grains of two sizes."""

from coreRun import bed
from leftOut import measured
from results import pyplot, savePicture

PARTS = ["sortNs", "searchNs", "batchesNs"]


def main():
    file = bed(29, 30)
    table = measured("detection", [["detection", "bed", file], ["detection", "bed", file, 6, 6], ["detection", "lattice"], ["detection", "ratio20"],
                                   ["detection", "ratio100"]], (*PARTS, "buildNs", "wholeNs"))
    figure, axes = pyplot.subplots(figsize=(7, 3.5))
    left = [0.0]*len(table.rows)
    columns = {part: table.column(part) for part in PARTS}
    columns["rest of the list"] = [whole - sum(parts) for whole, *parts in zip(table.column("buildNs"), *columns.values())]
    columns.update({part: table.column(part) for part in ("geometryNs", "impulsesNs")})
    for part, widths in columns.items():
        axes.barh(range(len(left)), widths, left=left, label=part.replace("Ns", ""))
        left = [a + b for a, b in zip(left, widths)]
    axes.set_yticks(range(len(left)), ["%s, %d" % (row[0], row[1]) for row in table.rows])
    axes.set_xlabel("ns per grain and build (processor)")
    axes.legend(fontsize=7)
    savePicture(figure, "detection")


main()
