# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Beds of equal grains at random places, in diameters, periodic sideways."""

import math
import random


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
