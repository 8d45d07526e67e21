# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Beds of equal grains at random places, in diameters, periodic sideways, and water or air that flows up through them."""

import math
import random

from foamCase import BoxCase


def distance2(a, b, side):
    x, y = (a[0] - b[0]) - side*round((a[0] - b[0])/side), (a[1] - b[1]) - side*round((a[1] - b[1])/side)
    return x*x + y*y + (a[2] - b[2])**2


def randomGrains(phi, side, height):
    """Centers [d] by random sequential addition, periodic sideways."""
    chance, centers = random.Random(1), []
    while len(centers) < phi*side**2*height/(math.pi/6):
        new = (side*chance.random(), side*chance.random(), 0.5 + (height - 1)*chance.random())
        if all(distance2(new, old, side) >= 1 for old in centers):
            centers.append(new)
    return centers


def solidFraction(centers, side, low, high, slices=2000):
    """Between two heights."""
    heights = [low + (k + 0.5)*(high - low)/slices for k in range(slices)]
    return sum(math.pi*max(0, 0.25 - (z - c[2])**2) for z in heights for c in centers)/slices/side**2


class HeldBed:
    """Where a bed is: width and height of the bed, and free height below and above it [d]; diameter [m]; width of its cells [d], where they are no cubes."""

    def __init__(self, centers, side, height, free, d, across=None):
        self.centers, self.side, self.height, self.free, self.d, self.across = centers, side, height, free, d, across

    def perSide(self, cell):
        return round(self.side/(self.across or cell))

    def box(self, folder, cell):
        """A mesh of cells that many diameters high, open below and above."""
        layers = round((self.height + 2*self.free)/cell)
        return BoxCase(folder, (0, 0, -self.free*self.d), (self.side*self.d, self.side*self.d, (self.height + self.free)*self.d),
                       (self.perSide(cell),)*2 + (layers,), {"zMin": "patch", "zMax": "patch"})

    def case(self, folder, cell, U, rho, mu, settings):
        """A case of nscdDEMFoam with the grains held, drag by Ergun's law, and more settings; without a time step."""
        case = self.box(folder, cell)
        case.fluid(rho, mu, (0, 0, 0), (0, 0, U), {"zMin": "type fixedValue; value uniform (0 0 %g);" % U, "zMax": "type zeroGradient;"},
                   {"zMin": "type fixedFluxPressure; value uniform 0;"})
        case.table([tuple(self.d*x for x in center) + (self.d,) for center in self.centers])
        case.grains("materials { glass { density 2500; } }\ncontacts { default { friction 0; } }\nmotion fixed;\n"
                    "patches { zMin { type exit; } zMax { type exit; } }\nforces { drag { law Ergun; } }\n%s\n"
                    "grains { type table; file grains.dat; }" % settings)
        return case

    def gradient(self, pressure, cell, low, high):
        """Of the pressure in cells, between two heights [d], linear between layers [Pa/m]."""
        perLayer = self.perSide(cell)**2
        layer = [sum(pressure[k:k + perLayer])/perLayer for k in range(0, len(pressure), perLayer)]

        def at(z):
            k, rest = divmod((z + self.free)/cell - 0.5, 1)
            return layer[int(k)] + rest*(layer[int(k) + 1] - layer[int(k)])

        return (at(low) - at(high))/((high - low)*self.d)

    def ergun(self, U, rho, mu, low, high):
        """Ergun's pressure gradient at the solid fraction between two heights [Pa/m]."""
        phi = solidFraction(self.centers, self.side, low, high)
        return 150*phi**2*mu*U/((1 - phi)**3*self.d**2) + 1.75*phi*rho*U**2/((1 - phi)**3*self.d)
