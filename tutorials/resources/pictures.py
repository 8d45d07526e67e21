# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What the tutorials' evaluate.py share: results.csv for the comparer, and pictures of one style."""

import csv

import matplotlib.pyplot as plt
from matplotlib.collections import EllipseCollection

BLUE, ORANGE, GRAY = "#1f6fb4", "#e07b00", "#707070"


def writeResults(rows, path="results.csv"):
    """`rows`: pairs of quantity and value."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("quantity", "value"))
        for quantity, value in rows:
            writer.writerow((quantity, "%.8g" % value))


def newPicture(width, height, columns=1, rows=1, **options):
    """Figure and axes, in inches; the picture has 100 dots per inch."""
    plt.rcParams.update({"font.size": 10, "axes.grid": True, "grid.alpha": 0.3, "legend.frameon": False})
    return plt.subplots(rows, columns, figsize=(width, height), constrained_layout=True, **options)


def drawGrains(axes, centers, diameters, values=None, **style):
    """Grains as seen along the third axis, at their size, colored by `values` where given. Returns what a color bar needs."""
    style = {"facecolors": BLUE, **style} if values is None else {"cmap": "viridis", "array": values, **style}
    grains = EllipseCollection(diameters, diameters, [0]*len(diameters), units="x", transOffset=axes.transData,
                               offsets=[(c[0], c[1]) for c in centers], **style)
    axes.add_collection(grains)
    axes.set_aspect("equal")
    axes.grid(False)
    return grains


def savePicture(figure, path="drawing.png"):
    """Beside picture.png, which README shows and git tracks: `cp drawing.png picture.png` renews that one."""
    figure.savefig(path, dpi=100, metadata={"Software": None})
    plt.close(figure)
