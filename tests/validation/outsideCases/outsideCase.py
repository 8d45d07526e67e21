# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What the cases of other solvers share: where they are built, a cylinder's mesh, laws and figures that several are judged by."""

import math
from pathlib import Path

from foamCase import MeshedCase, vec

BUILD = Path(__file__).resolve().parents[3]/"build/validation/outsideCases"
G = 9.81


def inlet(speed):
    """U at an inlet where no grain lies, (0 0 speed)."""
    return "type fixedValue; value uniform %s;" % vec((0, 0, speed))


OUTLET = "type pressureInletOutletVelocity; value uniform (0 0 0);"
SLIP = "type slip;"
FIXED_FLUX = "type fixedFluxPressure; value uniform 0;"


class CylinderCase(MeshedCase):
    """A cylinder about z: `core` x `core` cells in the middle, four times `core` x `ring` around them, `layers` along z.

    Its patches are bottom, top (of type `ends`) and walls; the walls are 4 `core` flat faces around, whose corners lie on the radius."""

    def __init__(self, folder, radius, lower, upper, core, ring, layers, ends="patch"):
        super().__init__(folder, {"bottom": ends, "top": ends, "walls": "wall"})
        self.radius, self.lower, self.upper, self.layers, self.core, self.ring = radius, lower, upper, layers, core, ring
        self.sides = 4*core
        self.writeMesh()

    def area(self):
        """Of the meshed cross-section."""
        return self.sides/2*self.radius**2*math.sin(2*math.pi/self.sides)

    def innerRadius(self):
        """Of the largest circle in the cross-section."""
        return self.radius*math.cos(math.pi/self.sides)

    def layerOfCells(self):
        """In the order of blockMesh: block by block, layers from the bottom up."""
        return [layer for width in (self.core*self.core,) + 4*(self.core*self.ring,) for layer in range(self.layers) for _ in range(width)]

    def writeMesh(self):
        corners = [(x*r, y*r, z) for z in (self.lower, self.upper) for r in (0.47*self.radius, self.radius*math.sqrt(0.5))
                   for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        arcs = "".join("arc %d %d %s\n" % (first + start, first + (start + 1) % 4, vec((size*x, size*y, z)))
                       for first, size, z in ((0, 0.55*self.radius, self.lower), (4, self.radius, self.lower),
                                              (8, 0.55*self.radius, self.upper), (12, self.radius, self.upper))
                       for start, (x, y) in enumerate(((0, -1), (1, 0), (0, 1), (-1, 0))))
        rings = [(4 + k, 4 + (k + 1) % 4, (k + 1) % 4, k) for k in range(4)]
        blocks = [((0, 1, 2, 3), self.core)] + [(corner, self.ring) for corner in rings]
        hexes = "".join("hex (%s) (%d %d %d) simpleGrading (1 1 1)\n" % (face(corner + raised(corner)), self.core, width, self.layers)
                        for corner, width in blocks)
        patches = {"bottom": [corner for corner, _ in blocks], "top": [raised(corner) for corner, _ in blocks],
                   "walls": [(a, b, b + 8, a + 8) for a, b, _, _ in rings]}
        neighbor = {"bottom": "neighbourPatch top; ", "top": "neighbourPatch bottom; "} if self.types["top"] == "cyclic" else {}
        boundary = "".join("%s { type %s; %sfaces (%s); }\n" % (name, self.types[name], neighbor.get(name, ""), " ".join("(%s)" % face(each) for each in faces))
                           for name, faces in patches.items())
        self.write("system/blockMeshDict", "vertices\n(\n%s\n);\nedges\n(\n%s);\nblocks\n(\n%s);\nboundary\n(\n%s);"
                   % ("\n".join(map(vec, corners)), arcs, hexes, boundary))


def face(corners):
    return " ".join(map(str, corners))


def raised(corners):
    return tuple(corner + 8 for corner in corners)


def meanPressureAt(patch):
    """For controlDict: writes the mean of p_rgh over a patch in every step, and the volumes of cells with each written time."""
    return ("functions { inletPressure { type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name %s; "
            "operation areaAverage; fields (p_rgh); writeFields no; log no; }\n"
            "volumes { type writeCellVolumes; libs (fieldFunctionObjects); writeControl writeTime; } }" % patch)


def valuesOf(case, functionObject):
    """[(time, value)] that a surfaceFieldValue wrote."""
    file = max(Path(case.folder).glob("postProcessing/%s/*/surfaceFieldValue.dat" % functionObject), key=lambda path: float(path.parent.name))
    return [tuple(map(float, line.split())) for line in open(file) if not line.startswith("#")]


def meanBetween(rows, start, end):
    """Of the values of rows (time, value) with start < time <= end, as far as round-off goes."""
    values = [value for time, value in rows if start + 1e-9 < time <= end + 1e-9]
    return sum(values)/len(values)


def shown(what, value, reference):
    """A figure beside what the original has for it, where that is not one of its reference: not judged."""
    print("     %-58s %.8g, there %.8g" % (what, value, reference))


def dallaValle(Re):
    """Drag coefficient times Reynolds number over 24: Di Felice's law for a sphere alone."""
    return (0.63*math.sqrt(Re) + 4.8)**2/24


def transition(Re):
    """How far the exponents of Di Felice and Rong are from their limits."""
    return math.exp(-(1.5 - math.log10(Re))**2/2)


def diFelice(alpha, Re):
    """Exponent of the fluid fraction, Di Felice 1994."""
    return 3.7 - 0.65*transition(Re)


def rong(alpha, Re):
    """Likewise, Rong et al. 2013."""
    return 2.65*(alpha + 1) - (5.3 - 3.5*alpha)*alpha**2*transition(Re)


def hinderedGradient(exponent, alpha, U, d, rho, mu):
    """Pressure gradient of spheres at rest where each has the drag A/2 rho Cd U^2 alpha^-exponent, U superficial, and the pressure force: (1 - alpha)/V times
    that over alpha."""
    Re = rho*U*d/mu
    return (1 - alpha)/alpha*18*mu*U/d**2*dallaValle(Re)*alpha**-exponent(alpha, Re)


def ergunGradient(alpha, U, d, rho, mu):
    """Ergun 1952."""
    return (150*(1 - alpha)*mu/d + 1.75*rho*U)*(1 - alpha)*U/(alpha**3*d)


def lawOverLayers(case, gradient, time=None):
    """Pressure drop by a law, gradient(alpha), with the mean alpha of each layer of cells."""
    solid, whole = [0.0]*case.layers, [0.0]*case.layers
    for layer, alpha, volume in zip(case.layerOfCells(), case.fieldValues("alpha.fluid", time), case.fieldValues("V", time)):
        solid[layer] += (1 - alpha)*volume
        whole[layer] += volume
    return sum(gradient(1 - part/volume) for part, volume in zip(solid, whole))*(case.upper - case.lower)/case.layers


def zeroOf(rising, most):
    """Where a function that rises from below zero at 0 is zero, or most."""
    low, high = 0.0, most
    for _ in range(60):
        middle = 0.5*(low + high)
        low, high = (middle, high) if rising(middle) < 0 else (low, middle)
    return 0.5*(low + high)


def lawOverSharedLayers(case, gradient, U, time=None):
    """Pressure drop by a law, gradient(alpha, superficial velocity), where the flow through each layer of cells is shared out so that all its cells have one gradient:
    what flows that change their place from layer to layer without resistance would have, and so the least that there may be; layers with a cell without grains
    count nothing. U: mean superficial velocity."""
    layers = [[] for _ in range(case.layers)]
    for layer, alpha, volume in zip(case.layerOfCells(), case.fieldValues("alpha.fluid", time), case.fieldValues("V", time)):
        layers[layer].append((alpha, volume))

    def flow(cells, wanted):
        return sum(volume*zeroOf(lambda u: gradient(alpha, u) - wanted, 100*U) for alpha, volume in cells)/sum(volume for _, volume in cells)

    def gradientOf(cells):
        return zeroOf(lambda wanted: flow(cells, wanted) - U, 10*max(gradient(alpha, U) for alpha, _ in cells))

    filled = [cells for cells in layers if max(alpha for alpha, _ in cells) < 1 - 1e-9]
    return sum(map(gradientOf, filled))*(case.upper - case.lower)/case.layers


def terminalSpeed(law, d, rhoP, rhoF, mu):
    """Where weight less buoyancy is the drag 3 pi mu d law(Re) u."""
    weight = (rhoP - rhoF)*G
    return zeroOf(lambda u: 18*mu/d**2*law(rhoF*u*d/mu)*u - weight, weight*d**2/(18*mu))


def fallSpeed(case):
    """Of the last step of the center of mass [m/s]."""
    report = case.run().report()
    y, t = report["massCenterY"], report["time"]
    return (y[-2] - y[-1])/(t[-1] - t[-2])
