# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases of Lethe (examples/unresolved-cfd-dem), with its meshes, steps and constants."""

from foamCase import BoxCase
from outsideCase import BUILD, dallaValle, fallSpeed, terminalSpeed


def singleParticleSedimentation(verdict):
    """Lethe's single-particle-sedimentation: one bead of alginate falls in water through cells of its own diameter, Rong's drag, 5 ms steps.

    Rong's law for a sphere alone is Di Felice's. The bead acts on the fluid, and samples its own wake."""
    d, rhoP, rhoF, nu = 2.663e-3, 1029, 996.7775, 8.379e-7
    walls = {side: "type slip;" for side in ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")}
    case = BoxCase(BUILD/"singleParticleSedimentation", (-10*d, 0, -10*d), (10*d, 40*d, 10*d), (20, 40, 20), {side: "wall" for side in walls})
    case.fluid(rhoF, rhoF*nu, (0, -G, 0), sides=walls)
    case.table([(0, 36*d, 0, d)])
    case.grains("materials { m { density %g; } } contacts { default { friction 0.3; } } wallMaterial m;\n"
                "forces { drag { law Rong; } }\ngrains { type table; file grains.dat; }" % rhoP)
    case.control(5e-3, 1.5)
    verdict.near("singleParticleSedimentation: speed [m/s]", fallSpeed(case), terminalSpeed(dallaValle, d, rhoP, rhoF, rhoF*nu), 0.03)
    case.remove()


CASES = (singleParticleSedimentation,)
