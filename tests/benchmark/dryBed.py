# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What a step costs while a lattice of spheres lands, and while a jet keeps a bed in motion. dryBed.py [option=value ...], options as
build/core/benchmark/dryBed has them, for both."""

import sys

from coreRun import rows, tableOf
from results import pyplot, savePicture

SCENES = {"landing": (), "jet": ("nx=26", "ny=5", "nz=40", "spacing=1.04", "jet=1", "steps=450", "every=25")}


def withSum(row):
    return {**row, "msPerStep": sum(value for name, value in row.items() if name.endswith("Ms"))}


def main():
    table = tableOf("dryBed", lambda: (({"scene": name}, map(withSum, rows("dryBed", *options, *sys.argv[1:]))) for name, options in SCENES.items()),
                    larger=("sweeps", "msPerStep"))
    parts = [name for name in table.columns if name.endswith("Ms")]
    figure, rowsOfAxes = pyplot.subplots(2, len(SCENES), figsize=(10, 6), sharex="col")
    for (cost, sweeps), name in zip(zip(*rowsOfAxes), SCENES):
        steps, grains = table.column("step", scene=name), table.column("grains", scene=name)[0]
        cost.stackplot(steps, [[1e3*ms/grains for ms in table.column(part, scene=name)] for part in parts], labels=parts)
        cost.set_title("%s, %d grains" % (name, grains))
        cost.set_ylabel("us a step and grain")
        sweeps.plot(steps, table.column("sweeps", scene=name))
        sweeps.set(xlabel="step", ylabel="sweeps a step")
    rowsOfAxes[0][0].legend()
    savePicture(figure, "dryBed")


main()
