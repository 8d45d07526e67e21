# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""How often each kind of finding may be, as a share of the trials, and why. What is not listed may not be at all."""

STEPS_AT_CAP = 0.01     # of all steps

KNOWN = {
    "dry": {
        "unconverged": (0.10, "more than a tenth of the steps: friction of 1 and more, whose steps are held; solvers other than NLGS; jams"),
        "energy growth, clumps": (0.01, "that rebound: they turn by the velocities before the rebound, with which inertia turns"),
        "energy growth, unconverged, not named": (0.01, "held friction beside rolling friction (456); open"),
        "overlap": (0.01, "clumps that turn meet others on arcs: method.md; grains at the edges of small plates (112, 321): open"),
        "overlap, unconverged": (0.01, "jams: walls that move into grains"),
        "restart refused, overlap": (0.01, "deeper than 0.1 d after jams; maxInitialOverlap lets it"),
        "too fast": (0.01, "more than a period in a step: stopped in words"),
    },
    "coupled": {
        "unconverged": (0.03, "more than a tenth of the steps: as in dry scenes"),
        "overlap": (0.01, "as in dry scenes"),
        "restart differs": (0.015, "with exits and adjustTimeStep by 1e-5 of the energy (66, 153), else in last bits (154); open"),
        "too fast": (0.01, "more than a period in a step: stopped in words"),
        "momentum": (0.02, "more than 1 % of the weight: sudden inflow into grains, of which eight corrections of the pressure leave that much"),
    },
    "brokenScenes": {},
    "brokenCases": {
        "poor message, OpenFOAM's": (0.03, "its own words on its own dictionaries, without the file's name"),
    },
}
HARMLESS = ("accepted", "long")     # broken, but it still made sense, and the numbers are finite
