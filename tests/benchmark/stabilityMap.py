# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Where beds stay at rest: depth against cap of sweeps, for tolerances and time steps.

tests/benchmark/run stabilityMap [long]. Long: more depths, caps and steps. Beds are settled in build/beds when they are missing."""

import csv
import subprocess
import sys

from results import ROOT, Table, pyplot, savePicture

PROGRAM = ROOT/"build/core/benchmark/stabilityMap"
BEDS = ROOT/"build/beds"
TOLERANCES = ("1e-1", "1e-2", "1e-3")
STEPS_OF_TIME = ("2.5e-4", "1e-3")
SHORT = {"layers": (10, 25, 50, 100), "caps": (3, 10, 30, 1000), "steps": 300}
LONG = {"layers": (10, 15, 25, 35, 50, 70, 100), "caps": (3, 5, 10, 20, 30, 50, 100, 200, 1000), "steps": 1000}
COLUMNS = ("layers", "cap", "tolerance", "deltaT", "energy", "baseError", "baseMean", "sunk", "capped", "sweeps")
# At rest: kinetic energy per grain below this, in m g d; base force within this share of the weight in every step; sunk by less, in d.
ENERGY, BASE, SUNK = 1e-6, 0.05, 0.02


def isAtRest(row):
    return row["energy"] < ENERGY and row["baseError"] < BASE and abs(row["sunk"]) < SUNK


def measure(table, size):
    for layers in size["layers"]:
        command = [PROGRAM, layers, size["steps"], ",".join(map(str, size["caps"])), ",".join(TOLERANCES), ",".join(STEPS_OF_TIME)]
        output = subprocess.run(list(map(str, command)), cwd=BEDS, check=True, stdout=subprocess.PIPE, text=True).stdout
        for row in csv.DictReader(output.splitlines()):
            row = {name: float(row[name]) for name in COLUMNS}
            table.add(*(row[name] for name in COLUMNS), int(isAtRest(row)))


def draw(table, size):
    rows = [dict(zip(table.columns, row)) for row in table.rows]
    figure, axes = pyplot.subplots(len(STEPS_OF_TIME), len(TOLERANCES), figsize=(11, 6), sharex=True, sharey=True)
    for i, deltaT in enumerate(map(float, STEPS_OF_TIME)):
        for j, tolerance in enumerate(map(float, TOLERANCES)):
            ax = axes[i][j]
            for row in rows:
                if (row["deltaT"], row["tolerance"]) == (deltaT, tolerance):
                    ax.loglog(row["cap"], row["layers"], "o", color="tab:green" if isAtRest(row) else "tab:red", markersize=5)
            ax.set_title("dt %g s, tolerance %g" % (deltaT, tolerance), fontsize=9)
    for ax in axes[-1]:
        ax.set_xlabel("cap of sweeps")
    for row in axes:
        row[0].set_ylabel("layers")
    figure.suptitle("green: stays at rest", fontsize=9)
    savePicture(figure, "stabilityMap")


def main():
    size = LONG if "long" in sys.argv[1:] else SHORT
    BEDS.mkdir(parents=True, exist_ok=True)
    table = Table("stabilityMap", [*COLUMNS, "atRest"], larger=("energy", "baseError"), smaller=("atRest",))
    draw(table.inRounds(lambda table: measure(table, size), 1), size)   # no times


if __name__ == "__main__":
    main()
