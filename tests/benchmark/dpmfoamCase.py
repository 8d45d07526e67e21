# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Cases of OpenFOAM's DPMFoam beside ours, on the same box and from the same grains, made of the parts in the folder DPMFoam."""

import re
import shutil
from pathlib import Path

from foamFiles import setEntry

HERE = Path(__file__).resolve().parent
PARTS = ("constant/turbulenceProperties.air", "constant/transportProperties", "constant/kinematicCloudProperties", "system/fvSolution", "system/fvSchemes")
# For nscdDEMFoam beside it: the same solvers.
SOLUTION = """
solvers
{
    p_rgh { solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0.01; }
    p_rghFinal { $p_rgh; relTol 0; }
    "meanFlowPotential.*" { $p_rgh; relTol 0; }
    "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-5; relTol 0; }
}
PIMPLE { nOuterCorrectors 1; nCorrectors 2; pRefCell 0; pRefValue 0; }
"""
FLUX_PRESSURE = "type fixedFluxPressure; phi phi.air; value uniform 0;"


def copyParts(case, rho, mu):
    """Of a BoxCase: models, solvers and schemes of DPMFoam for a fluid of this density and viscosity."""
    for part in PARTS:
        shutil.copy(HERE/"DPMFoam"/part, Path(case.folder)/part)
    setEntry(Path(case.folder)/"constant/transportProperties", r"rho\.air", "%.17g" % rho)
    setEntry(Path(case.folder)/"constant/transportProperties", "nu", "%.17g" % (mu/rho))


def setGrains(case, d, density, centers, patches=(), collisions=True):
    """Equal grains at these places [m]; `patches` are those they rebound from, cyclic ones left out."""
    path = Path(case.folder)/"constant/kinematicCloudProperties"
    cloud = path.read_text()
    walls = "".join("            %s { $rebound; }\n" % patch for patch in patches)
    changes = [("rho0           2526", "rho0           %.17g" % density), ("value 0.0025", "value %.17g" % d), ("maxInteractionDistance     0.0025", "maxInteractionDistance     %.17g" % d)]
    if not collisions:
        changes.append(("collisionModel pairCollision", "collisionModel none"))
    for before, after in changes:
        if before not in cloud:
            raise SystemExit("%s lacks '%s', which this is to change" % (path, before))
        cloud = cloud.replace(before, after)
    path.write_text(re.sub(r"(        patches\n        \(\n).*?(        \);)", lambda found: found.group(1) + walls + found.group(2), cloud, flags=re.S))
    places = "".join("(%.17g %.17g %.17g)\n" % tuple(center) for center in centers)
    case.write("constant/kinematicCloudPositions", "(\n" + places + ")", "vectorField")


def setFields(case, velocity, velocitySides, pressureSides):
    """U.air and p [m2/s2]; sides are entries by side, and those of cyclic, symmetry and wall sides may be left out."""
    wall = {"cyclic": "type cyclic;", "symmetry": "type symmetry;", "patch": ""}
    case.field("U.air", "volVectorField", "[0 1 -1 0 0 0 0]", velocity, dict(wall, wall="type noSlip;"), velocitySides)
    case.field("p", "volScalarField", "[0 2 -2 0 0 0 0]", "0", dict(wall, wall=FLUX_PRESSURE), pressureSides)
