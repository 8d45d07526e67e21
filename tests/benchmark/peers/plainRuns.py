# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Runs of a plain scene by each program, pinned: processor seconds of the steps, and the grains at some times."""

import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from pinnedRun import CORE, pinned
from plainPeers import PEERS, readRows
from plainScene import restingDepth, writeData, writeOurs, writeSurface
from results import BUILD, ROOT
from softRuns import ALONE

PROGRAM = ROOT/"build/core/benchmark/dryWork"


def installed(*peers):
    """Those of the peers that are there; the others are named."""
    there = [peer for peer in peers if PEERS[peer].isThere(PEERS[peer])]
    for peer in peers:
        if peer not in there:
            print("%s (program %s) is not installed: left out" % (peer, PEERS[peer].program))
    return there


def emptied(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def ours(name, scene, times, **options):
    """Its row of figures, and rows x y z, velocity, spin at each time."""
    folder = emptied(BUILD/"dry"/(name + ".ours"))
    writeOurs(scene, folder/"scene")
    command = ["taskset", "-c", str(CORE), PROGRAM, "scene", "grains", ",".join("%.17g" % t for t in times)]
    text = subprocess.run(command + ["%s=%.17g" % option for option in options.items()], cwd=folder, check=True, stdout=subprocess.PIPE, text=True).stdout
    head, values = text.splitlines()
    return dict(zip(head.split(","), map(float, values.split(",")))), [readRows(folder/("grains.%d" % (k + 1))) for k in range(len(times))]


def theirs(peer, name, scene, knob, times):
    """The same of a peer, at the steps nearest to these times; start-up, a run of one step, is subtracted. Of its figures, steps and seconds."""
    folder = emptied(BUILD/"dry"/("%s.%s.%.0e" % (name, peer.replace(" ", ""), knob)))
    writeData(scene, folder/"grains.data")
    writeSurface(scene, folder/"surface.stl")
    of = PEERS[peer]
    steps = [max(1, round(t/of.step(scene, knob))) for t in times]
    costs = []
    for kind, counts in (("start", [1]*(len(steps) if of.writesInPython else 1)), ("whole", steps)):
        (folder/(kind + ".in")).write_text(of.make(scene, knob, "grains.data", "surface.stl", counts, kind))
        costs.append(pinned(of.program, folder, CORE, kind + ".screen", of.words(kind), ALONE).cpu)
    return {"steps": steps[-1], "seconds": costs[1] - costs[0]}, [of.read(folder/("whole.%d" % (k + 1))) for k in range(len(times))]


def atRest(scene, modulus):
    """The scene with each grain pressed as deep into the floor as its weight wants: where soft grains that lie on it are."""
    from dataclasses import replace
    grains = [replace(g, x=(g.x[0], g.x[1], g.x[2] - restingDepth(g, scene, modulus))) for g in scene.grains]
    return replace(scene, grains=grains)
