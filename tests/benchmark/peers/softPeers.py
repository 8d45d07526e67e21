# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Inputs of LIGGGHTS and LAMMPS for a settled bed of spheres, and what their runs left: soft spheres, Hertz' law with friction and damping."""

import math
import os

RADIUS, DENSITY, FRICTION, POISSON, RESTITUTION, GRAVITY = 1.25e-3, 2526.0, 0.3, 0.25, 0.3, 9.81
RAYLEIGH_SHARE = 0.2    # of the Rayleigh time: the largest step that their manuals and users take for granted
FAR = 2.0               # m: where the floor ends for grains that run out
HIGH = 0.2              # m


def rayleighTime(modulus):
    """Time that a surface wave takes around half a grain [s], E in Pa."""
    shear = modulus/(2*(1 + POISSON))
    return math.pi*RADIUS*math.sqrt(DENSITY/shear)/(0.1631*POISSON + 0.8766)


def timeStep(modulus):
    return RAYLEIGH_SHARE*rayleighTime(modulus)


def hertzStiffness(modulus):
    """kn of LAMMPS' gran/hertz/history [Pa], F = kn sqrt(R') delta^(3/2) with R' = R/2 of equal spheres."""
    return 2*modulus/(3*(1 - POISSON**2))


def rebound(modulus, damping, speed):
    """Restitution of two equal grains in LAMMPS' gran/hertz/history, gamma_n = damping [1/(m s)]."""
    mass = DENSITY*4/3*math.pi*RADIUS**3/2
    root, kn = math.sqrt(RADIUS/2), hertzStiffness(modulus)
    h = timeStep(modulus)/50
    depth, v = 0.0, speed
    while depth >= 0.0:
        force = root*math.sqrt(depth)*(kn*depth + mass*damping*v)
        v -= h*max(force, 0.0)/mass
        depth += h*v
    return -v/speed


def lammpsDamping(modulus, restitution=RESTITUTION, speed=0.3):
    """gamma_n that gives this restitution at an impact of `speed` [m/s]: the law has none that holds at every speed."""
    low, high = 0.0, 1e3/timeStep(modulus)/RADIUS
    for _ in range(40):
        middle = 0.5*(low + high)
        low, high = (middle, high) if rebound(modulus, middle, speed) > restitution else (low, middle)
    return 0.5*(low + high)


def writeData(grains, periods, path, isBed):
    """A data file of both programs from rows x y z, velocity, spin."""
    width, depth = periods
    left, right = (0.0, width) if isBed else (-RADIUS, FAR)
    with open(path, "w") as file:
        file.write("grains\n\n%d atoms\n1 atom types\n%.17g %.17g xlo xhi\n0 %.17g ylo yhi\n0 %.17g zlo zhi\n\nAtoms\n\n" % (
            len(grains), left, right, depth, HIGH))
        for i, row in enumerate(grains):
            file.write("%d 1 %.17g %.17g %.17g %.17g %.17g\n" % (i + 1, 2*RADIUS, DENSITY, *row[:3]))
        file.write("\nVelocities\n\n")
        for i, row in enumerate(grains):
            file.write("%d %.17g %.17g %.17g %.17g %.17g %.17g\n" % (i + 1, *row[3:9]))


def walls(scene, width):
    """Planes across an axis: name, axis, lower and upper place (None: none there)."""
    sides = [("floor", "z", 0.0, None)]
    if scene != "bed":
        sides.append(("sides", "x", -RADIUS, width + RADIUS if scene == "box" else None))
    return sides


def liggghts(start, scene, width, modulus, skin, commands, restitution=RESTITUTION):
    """`start` reads a data file or a restart; skin in diameters."""
    # It refuses more than 1e9 Pa unless told that this is meant.
    hard = ["hard_particles yes"] if modulus > 1e9 else []
    lines = hard + ["atom_style granular", "atom_modify map array", "boundary %s p f" % ("p" if scene == "bed" else "f"), "newton off",
             "communicate single vel yes", "units si", start, "neighbor %.9g bin" % (skin*2*RADIUS), "neigh_modify delay 0",
             "fix m1 all property/global youngsModulus peratomtype %.9g" % modulus,
             "fix m2 all property/global poissonsRatio peratomtype %.9g" % POISSON,
             "fix m3 all property/global coefficientRestitution peratomtypepair 1 %.9g" % restitution,
             "fix m4 all property/global coefficientFriction peratomtypepair 1 %.9g" % FRICTION,
             "pair_style gran model hertz tangential history", "pair_coeff * *", "timestep %.9g" % timeStep(modulus),
             "fix gravity all gravity %.9g vector 0 0 -1" % GRAVITY]
    for name, axis, low, high in walls(scene, width):
        for end, place in (("low", low), ("high", high)):
            if place is not None:
                lines.append("fix %s%s all wall/gran model hertz tangential history primitive type 1 %splane %.17g" % (name, end, axis, place))
    return "\n".join(lines + ["fix move all nve/sphere", "thermo_style custom step atoms ke cpu", "thermo 100000"] + commands) + "\n"


def lammps(start, scene, width, modulus, skin, commands, restitution=RESTITUTION):
    kn = hertzStiffness(modulus)
    # kt/kn of Mindlin; damping half as large along the contact, the program's default.
    law = "%.9g %.9g %.9g NULL %.9g 1" % (kn, kn*3*(1 - POISSON)/(2 - POISSON), lammpsDamping(modulus, restitution), FRICTION)
    lines = ["atom_style sphere", "atom_modify map array", "boundary %s p f" % ("p" if scene == "bed" else "f"), "newton off",
             "comm_modify vel yes", "units si", start, "neighbor %.9g bin" % (skin*2*RADIUS), "neigh_modify delay 0 every 1 check yes",
             "pair_style gran/hertz/history " + law, "pair_coeff * *", "timestep %.9g" % timeStep(modulus),
             "fix gravity all gravity %.9g vector 0 0 -1" % GRAVITY]
    for name, axis, low, high in walls(scene, width):
        ends = " ".join("NULL" if place is None else "%.17g" % place for place in (low, high))
        lines.append("fix %s all wall/gran hertz/history %s %splane %s" % (name, law, axis, ends))
    return "\n".join(lines + ["fix move all nve/sphere", "thermo_style custom step atoms ke cpu", "thermo 100000"] + commands) + "\n"


PEERS = {"LIGGGHTS": ("liggghts", liggghts), "LAMMPS": ("lmp", lammps)}


def readDump(path):
    """Rows of the columns of a dump's last snapshot, in the order of identities."""
    with open(path) as file:
        lines = file.read().split("\n")
    at = max(k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS"))
    names = lines[at].split()[2:]
    rows = sorted(([float(word) for word in line.split()] for line in lines[at + 1:] if line), key=lambda row: row[names.index("id")])
    place = [names.index(name) for name in ("x", "y", "z", "vx", "vy", "vz", "omegax", "omegay", "omegaz")]
    return [[row[k] for k in place] for row in rows]


def dumpCommands(path):
    return ["dump last all custom 1 %s id x y z vx vy vz omegax omegay omegaz" % os.fspath(path), "run 0", "undump last"]
