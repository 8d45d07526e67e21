# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Programs that run plain scenes beside ours: how each is started, from what input, and how what it left is read."""

import shutil
import subprocess
from pathlib import Path
from typing import Callable, NamedTuple

from plainScene import POISSON, described, lammps, liggghts, softStep, undamped
from softPeers import readDump

HERE = Path(__file__).resolve().parent
PYTHON = "/usr/bin/python3"     # the one that Debian's Siconos is for


def isProgram(peer):
    return shutil.which(peer.program) is not None


def hasSiconos(peer):
    return isProgram(peer) and subprocess.run([peer.program, "-c", "import siconos.mechanics.collision.native"], stderr=subprocess.DEVNULL).returncode == 0


def readRows(path):
    with open(path) as file:
        return [[float(word) for word in line.split()] for line in file]


def inputAndLog(kind):
    return ["-in", kind + ".in", "-log", kind + ".log"]


class Peer(NamedTuple):
    """The knob is Young's modulus of soft grains, the time step of rigid ones. `kind` is a run: its input is <kind>.in, its snapshots are <kind>.1, ..."""
    program: str
    make: Callable                              # input: scene, knob, file of grains, file of triangles, counts of steps, kind
    words: Callable = inputAndLog               # after the program, of a kind
    read: Callable = readDump                   # rows x y z, velocity, spin of a snapshot
    step: Callable = softStep                   # time step: scene, knob
    isThere: Callable = isProgram
    writesInPython: bool = False                # snapshots take long: those of the run that is subtracted are as many


def yade(scene, modulus, data, surface, steps, prefix):
    return described(scene, softStep(scene, modulus), steps, prefix, modulus=modulus, poisson=POISSON)


def siconos(scene, deltaT, data, surface, steps, prefix):
    return described(scene, deltaT, steps, prefix)


PEERS = {
    "LIGGGHTS": Peer("liggghts", liggghts),
    "LIGGGHTS undamped": Peer("liggghts", undamped),
    "LAMMPS": Peer("lmp", lammps),
    "Yade": Peer("yade", yade, lambda kind: ["-n", "-x", "-j1", HERE/"yadeScene.py", kind + ".in"], readRows, writesInPython=True),
    "Siconos": Peer(PYTHON, siconos, lambda kind: [HERE/"siconosScene.py", kind + ".in"], readRows, lambda scene, deltaT: deltaT, hasSiconos, True),
}
