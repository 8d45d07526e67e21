# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""All drag laws over alpha, and how far each is from what is measured of packed beds and of suspensions.

tests/benchmark/run dragLaws. What is measured stands at the head of dragLaws/dragLaws.cpp."""

import csv
import math
import subprocess

from results import ROOT, Table, pyplot, savePicture

PROGRAM = ROOT/"build/core/benchmark/dragLaws"
SHOWN = ("0.01", "10", "100", "1000")  # Re_s
LONE = ("Stokes", "SchillerNaumann", "DallaValle", "StokesHindered")


def rows(what):
    output = subprocess.run([str(PROGRAM), what], check=True, stdout=subprocess.PIPE, text=True).stdout
    return list(csv.DictReader(output.splitlines()))


def spread(ratios):
    """Root of the mean square of ln(ratio), as a percentage, and the mean."""
    logs = [math.log(ratio) for ratio in ratios]
    rms = math.sqrt(sum(x*x for x in logs)/len(logs))
    return 100*(math.exp(rms) - 1), 100*(math.exp(sum(logs)/len(logs)) - 1)


def judge(table, errors):
    for law in dict.fromkeys(row["law"] for row in errors):
        figures = []
        for bed in ("packed", "settling"):
            figures += spread([float(row["ratio"]) for row in errors if (row["law"], row["bed"]) == (law, bed)])
        table.add(law, *(round(figure, 1) for figure in figures))


def draw(curves):
    figure, axes = pyplot.subplots(2, 2, figsize=(11, 8), sharex=True)
    colors = pyplot.get_cmap("tab20")
    for ax, Re in zip(axes.flat, SHOWN):
        laws = [law for law in dict.fromkeys(row["law"] for row in curves) if law not in LONE]
        for i, law in enumerate(laws):
            points = [row for row in curves if (row["law"], row["Re"]) == (law, Re)]
            ax.semilogy([float(p["alpha"]) for p in points], [float(p["factor"]) for p in points], color=colors(i), linewidth=1.2, label=law)
        ax.set_ylim(0.5, None)
        ax.set_title("Re_s %s" % Re, fontsize=9)
    for ax in axes[-1]:
        ax.set_xlabel("alpha")
    for row in axes:
        row[0].set_ylabel("gamma/(3 pi mu d)")
    axes[0][0].legend(fontsize=7)
    savePicture(figure, "dragLaws")


def main():
    table = Table("dragLaws", ("law", "packedRms", "packedMean", "settlingRms", "settlingMean"), larger=("packedRms", "settlingRms"))
    table.inRounds(lambda table: judge(table, rows("errors")), 1)   # formulas
    draw(rows("curves"))


if __name__ == "__main__":
    main()
