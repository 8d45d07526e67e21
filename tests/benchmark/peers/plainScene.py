# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""A dry scene that all programs run: grains, planes, triangles, friction by material; written for ours, LIGGGHTS and LAMMPS, and for those that Python
drives."""

import json
import math
from dataclasses import asdict, dataclass, field

POISSON = 0.25
PER_CONTACT = 20        # steps in the time of an impact
AXES = "xyz"


@dataclass
class Grain:
    x: tuple
    radius: float
    material: int = 0
    v: tuple = (0.0, 0.0, 0.0)
    omega: tuple = (0.0, 0.0, 0.0)


@dataclass
class Plane:
    """Across an axis; `side` 1: grains are above it, -1: below."""
    axis: int
    place: float
    side: int = 1


@dataclass
class PlainScene:
    """SI units. `speed` is that of its impacts, which soft grains' time steps follow from; `low`, `high`: where grains can get to."""
    grains: list
    planes: list
    low: tuple
    high: tuple
    density: float = 2500.0
    friction: tuple = (0.5,)        # of each material, against walls, its own kind and all that come after it
    restitution: float = 0.5
    gravity: tuple = (0.0, 0.0, -9.81)
    speed: float = 1.0
    triangles: list = field(default_factory=list)
    isPlanar: bool = False          # all centers at y = 0
    isDiscs: bool = False           # ours alone
    periods: tuple = (0.0, 0.0, 0.0)

    def smallest(self):
        return min(grain.radius for grain in self.grains)


def effectiveModulus(modulus):
    """Of two bodies of the same material (Hertz)."""
    return modulus/(2*(1 - POISSON**2))


def contactTime(scene, modulus):
    """Of Hertz' impact of two of the smallest grains at the scene's speed [s]: 2.868 (m*^2/(R* E*^2 v))^(1/5) (Johnson 1985, eq. 11.24)."""
    radius = scene.smallest()
    mass = scene.density*4/3*math.pi*radius**3/2
    return 2.868*(mass**2/(radius/2*effectiveModulus(modulus)**2*scene.speed))**0.2


def softStep(scene, modulus):
    return contactTime(scene, modulus)/PER_CONTACT


def restingDepth(grain, scene, modulus):
    """Overlap with a plane of the same material that carries the weight [m]."""
    weight = scene.density*4/3*math.pi*grain.radius**3*-scene.gravity[2]
    return (0.75*weight/(effectiveModulus(modulus)*math.sqrt(grain.radius)))**(2/3)


def numbers(values):
    return " ".join("%.17g" % value for value in values)


def writeOurs(scene, path):
    lines = ["dimensions %d" % (2 if scene.isDiscs else 3), "emptyAxis %d" % (1 if scene.isPlanar else -1), "period " + numbers(scene.periods),
             "gravity " + numbers(scene.gravity), "restitution %.17g" % scene.restitution, "friction " + numbers(scene.friction)]
    for plane in scene.planes:
        lines.append("plane " + numbers([plane.place*(axis == plane.axis) for axis in range(3)] + [plane.side*(axis == plane.axis) for axis in range(3)]))
    lines += ["triangle " + numbers(x for corner in triangle for x in corner) for triangle in scene.triangles]
    lines += ["grain " + numbers((*g.x, g.radius, scene.density, g.material, *g.v, *g.omega)) for g in scene.grains]
    path.write_text("\n".join(lines) + "\n")


def writeData(scene, path):
    """A data file of LIGGGHTS and LAMMPS; walls are of one type more."""
    lines = ["grains", "", "%d atoms" % len(scene.grains), "%d atom types" % (len(scene.friction) + 1)]
    lines += ["%.17g %.17g %slo %shi" % (scene.low[k], scene.high[k], axis, axis) for k, axis in enumerate(AXES)]
    lines += ["", "Atoms", ""]
    lines += ["%d %d %.17g %.17g %s" % (i + 1, g.material + 1, 2*g.radius, scene.density, numbers(g.x)) for i, g in enumerate(scene.grains)]
    lines += ["", "Velocities", ""]
    lines += ["%d %s" % (i + 1, numbers((*g.v, *g.omega))) for i, g in enumerate(scene.grains)]
    path.write_text("\n".join(lines) + "\n")


def writeSurface(scene, path):
    """The triangles as STL."""
    lines = ["solid surface"]
    for triangle in scene.triangles:
        lines += ["facet normal 0 0 0", "outer loop"] + ["vertex " + numbers(corner) for corner in triangle] + ["endloop", "endfacet"]
    path.write_text("\n".join(lines + ["endsolid surface"]) + "\n")


def boundaries(scene):
    return " ".join("p" if scene.periods[k] > 0 else "f" for k in range(3))


def gravityOf(scene):
    size = math.sqrt(sum(x*x for x in scene.gravity))
    return "fix gravity all gravity %.17g vector %s" % (size, numbers(x/size for x in scene.gravity))


def snapshots(steps, prefix):
    """Commands that run on to each count of steps and leave the grains there."""
    lines, done = [], 0
    for k, step in enumerate(steps):
        lines += ["run %d" % (step - done), "write_dump all custom %s.%d id x y z vx vy vz omegax omegay omegaz modify sort id format float %%.12g"
                  % (prefix, k + 1)]
        done = step
    return lines


def dumps(steps, prefix):
    """The same for LIGGGHTS."""
    lines, done = [], 0
    for k, step in enumerate(steps):
        lines += ["run %d" % (step - done), "dump last all custom 1 %s.%d id x y z vx vy vz omegax omegay omegaz" % (prefix, k + 1),
                  "dump_modify last format \"%d" + " %.12g"*9 + "\"", "run 0", "undump last"]
        done = step
    return lines


def common(scene, data, skin):
    return ["boundary " + boundaries(scene), "newton off", "units si", "read_data " + data, "neighbor %.9g bin" % (skin*2*scene.smallest())]


def matrix(values):
    return " ".join("%.9g" % value for row in values for value in row)


def liggghts(scene, modulus, data, surface, steps, prefix, skin=0.2, more=""):
    """Input of LIGGGHTS: Hertz, Mindlin, Coulomb, viscous damping by the restitution; `more` are words at the end of its laws."""
    types = len(scene.friction) + 1
    pairs = [[(*scene.friction, max(scene.friction))[min(a, b)] for b in range(types)] for a in range(types)]
    # It refuses what is beyond these unless told that this is meant.
    lines = ["hard_particles yes"]*(modulus > 1e9) + ["soft_particles yes"]*(modulus < 5e6)
    lines += ["atom_style granular", "atom_modify map array", "communicate single vel yes"] + common(scene, data, skin)
    lines += ["neigh_modify delay 0", "fix m1 all property/global youngsModulus peratomtype " + numbers([modulus]*types),
              "fix m2 all property/global poissonsRatio peratomtype " + numbers([POISSON]*types),
              "fix m3 all property/global coefficientRestitution peratomtypepair %d %s" % (types, matrix([[scene.restitution]*types]*types)),
              "fix m4 all property/global coefficientFriction peratomtypepair %d %s" % (types, matrix(pairs)),
              "pair_style gran model hertz tangential history" + more, "pair_coeff * *", "timestep %.17g" % softStep(scene, modulus), gravityOf(scene)]
    law = "wall/gran model hertz tangential history"
    for k, plane in enumerate(scene.planes):
        lines.append("fix wall%d all %s primitive type %d %splane %.17g%s" % (k, law, types, AXES[plane.axis], plane.place, more))
    if scene.triangles:
        lines += ["fix surface all mesh/surface file %s type %d" % (surface, types), "fix onSurface all %s mesh n_meshes 1 meshes surface%s" % (law, more)]
    return "\n".join(lines + ["fix move all nve/sphere", "thermo 1000000", "thermo_modify lost ignore norm no"] + dumps(steps, prefix)) + "\n"


def lammps(scene, modulus, data, surface, steps, prefix, skin=0.2):
    """Input of LAMMPS: the same laws, in words of its pair style granular. Triangles it cannot have."""
    assert not scene.triangles, surface
    lines = ["atom_style sphere", "atom_modify map array", "comm_modify vel yes"] + common(scene, data, skin)
    lines += ["neigh_modify delay 0 every 1 check yes", "pair_style granular"]
    law = "hertz/material %.9g %.9g %.9g tangential mindlin NULL 1.0 %.9g damping tsuji"
    laws = [law % (modulus, scene.restitution, POISSON, friction) for friction in scene.friction]
    types = len(scene.friction) + 1
    for a in range(types):
        lines += ["pair_coeff %d %d %s" % (a + 1, b + 1, laws[min(a, types - 2)]) for b in range(a, types)]
    lines += ["timestep %.17g" % softStep(scene, modulus), gravityOf(scene)]
    for material, of in enumerate(laws):
        lines.append("group material%d type %d" % (material, material + 1))
        for k, plane in enumerate(scene.planes):
            ends = ("%.17g NULL" if plane.side > 0 else "NULL %.17g") % plane.place
            lines.append("fix wall%d_%d material%d wall/gran granular %s %splane %s" % (k, material, material, of, AXES[plane.axis], ends))
    return "\n".join(lines + ["fix move all nve/sphere", "thermo 1000000", "thermo_modify lost ignore norm no"] + snapshots(steps, prefix)) + "\n"


def undamped(*arguments):
    """LIGGGHTS without the dashpot along contacts, which by default acts on some that slide too: its law looks whether the spring, cut to
    Coulomb's limit in the step before, is beyond the limit of this one. Without it nothing stops a spring that sticks from swinging."""
    return liggghts(*arguments, more=" tangential_damping off")


def described(scene, deltaT, steps, prefix, **law):
    """Input of a program that Python drives: all of it as JSON. Triangles and periods these do not have."""
    assert not scene.triangles and not any(scene.periods)
    return json.dumps({"scene": asdict(scene), "deltaT": deltaT, "steps": steps, "prefix": prefix, **law})
