# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""9240 spheres of 1.2 mm that drop into a box of 44 x 10 mm: the case of the benchmark K2."""

import math

from foamCase import BoxCase

G, D, RHO = 9.81, 1.2e-3, 1000.0
COUNT = (33, 7, 40)
GRAINS = COUNT[0]*COUNT[1]*COUNT[2]
MASS = RHO*math.pi/6*D**3
GRAIN_TEXT = """
materials {{ bead {{ density {density}; }} }}
contacts  {{ default {{ friction 0.1; restitution 0; }} }}
patches   {{ zMax {{ type exit; }} }}
grains    {{ type lattice; box (0 0 0) (0.044 0.01 0.06); count ({x} {y} {z}); diameter {d}; jitter 0.5; }}
"""


def settledBox(folder, extra, sides=None):
    """The case, with its grains still in the lattice from which they drop; `extra` goes into grainProperties, `sides` are those that are not
    walls below an open top."""
    walls = {"xMin": "wall", "xMax": "wall", "yMin": "wall", "yMax": "wall", "zMin": "wall", "zMax": "patch"}
    case = BoxCase(folder, (0, 0, 0), (0.044, 0.01, 0.12), (22, 5, 60), {**walls, **(sides or {})})
    case.gravity((0, 0, -G))
    writeGrains(case, extra)
    return case


def writeGrains(case, extra):
    case.grains(GRAIN_TEXT.format(density=RHO, x=COUNT[0], y=COUNT[1], z=COUNT[2], d=D) + extra)
