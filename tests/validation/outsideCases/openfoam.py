# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A case of OpenFOAM's MPPICFoam; `openfoamCases` beside this folder reads those that are installed."""

import math

from foamCase import BoxCase
from outsideCase import BUILD, G


def mppicColumn(verdict):
    """OpenFOAM's MPPICFoam/column: grains of 0.3 mm in parcels of 750 settle in a closed column of air, 18.4 x 18.4 x 300 mm in 40 cells.

    The parcels there lie at random, one upon another; here as many are put where they do not overlap. Their packing is their own:
    MPPICFoam's model packs to 0.6, rigid parcels a seventh of the column wide to less. Judged are masses in both units, and that all
    comes to rest; the height of the bed is shown."""
    d, inParcel, parcels, side, rhoP = 3e-4, 750, 2873, 9.2e-3, 2526
    case = BoxCase(BUILD/"mppicColumn", (-side, -side, 0), (side, side, 0.3), (1, 1, 40),
                   {"zMin": "wall", "zMax": "wall", **{face: "symmetry" for face in ("xMin", "xMax", "yMin", "yMax")}})
    case.fluid(1.2, 1.2e-5)
    case.grains("materials { m { density %g; } } contacts { default { friction 0.1; } } wallMaterial m;\n"
                "forces { drag { law ErgunWenYu; } }\ngrains { type filling; region { type box; box %s %s; }\n"
                "number %d; diameter %g; coarseGraining %.15g; }"
                % (rhoP, "(%g %g 0)" % (-side, -side), "(%g %g 0.3)" % (side, side), parcels*inParcel + inParcel//2, d, inParcel**(1/3)))
    case.control(2e-4, 1)
    report = case.run().report()
    verdict.near("mppicColumn: parcels", report["grains"][0], parcels, 0)
    verdict.near("mppicColumn: real grains", report["realGrains"][0], parcels*inParcel, 1e-9)
    volume = parcels*inParcel*math.pi*d**3/6
    verdict.near("mppicColumn: volume [m3]", report["grainVolume"][0], volume, 1e-9)
    fraction = volume/(4*side**2*2*report["massCenterZ"][-1])
    verdict.near("mppicColumn: solid fraction of the bed at the end", fraction, 0.6, 0.15)
    verdict.below("mppicColumn: kinetic energy at the end, over weight times diameter", report["kineticEnergy"][-1]/(rhoP*volume*G*d), 1e-2)
    case.remove()


CASES = (mppicColumn,)
