# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases of CFDEMcoupling, with its meshes, steps and constants."""

from foamCase import BoxCase
from outsideCase import BUILD, G, dallaValle, fallSpeed, terminalSpeed


def settlingTestMPI(verdict):
    """CFDEMcoupling's cfdemSolverPiso/settlingTestMPI: one sphere of 0.1 mm falls for 0.15 s through 320 cells, model B, Di Felice's drag: 0.1286 m/s."""
    d, rhoP, rhoF, nu = 1e-4, 3000, 10, 1e-5
    for model in ("A", "B"):
        case = BoxCase(BUILD/("settlingTestMPI" + model), (0.045, 0, 0.045), (0.055, 0.05, 0.055), (4, 20, 4),
                       {"xMin": "wall", "xMax": "wall", "yMin": "patch", "yMax": "patch", "zMin": "wall", "zMax": "wall"})
        case.fluid(rhoF, rhoF*nu, (0, -G, 0))
        case.table([(0.05, 0.025, 0.05, d)])
        case.grains("materials { m { density %g; } } contacts { default { friction 0.5; restitution 0.3; } } wallMaterial m;\n"
                    "forces { model %s; drag { law DiFelice; } }\ngrains { type table; file grains.dat; }\n"
                    "patches { yMin { type exit; } yMax { type exit; } }" % (rhoP, model))
        case.control(1e-3, 0.15)
        speed = fallSpeed(case)
        verdict.near("settlingTestMPI, model %s: speed [m/s]" % model, speed, terminalSpeed(dallaValle, d, rhoP, rhoF, rhoF*nu), 0.005)
        case.remove()


CASES = (settlingTestMPI,)
