# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""What the cases of other solvers share: where they are built, laws and figures that several are judged by."""

import math
from pathlib import Path

BUILD = Path(__file__).resolve().parents[3]/"build/validation/outsideCases"
G = 9.81


def dallaValle(Re):
    """Drag coefficient times Reynolds number over 24: Di Felice's law for a sphere alone."""
    return (0.63*math.sqrt(Re) + 4.8)**2/24


def terminalSpeed(law, d, rhoP, rhoF, mu):
    """Where weight less buoyancy is the drag 3 pi mu d law(Re) u."""
    low, high = 0.0, (rhoP - rhoF)*G*d**2/(18*mu)
    for _ in range(60):
        u = 0.5*(low + high)
        low, high = (u, high) if 18*mu/d**2*law(rhoF*u*d/mu)*u < (rhoP - rhoF)*G else (low, u)
    return u


def fallSpeed(case):
    """Of the last step of the center of mass [m/s]."""
    report = case.run().report()
    y, t = report["massCenterY"], report["time"]
    return (y[-2] - y[-1])/(t[-1] - t[-2])
