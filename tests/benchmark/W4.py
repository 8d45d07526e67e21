# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W4: 20 000 spheres of 2 mm with their centers in a plane flow out of 16 slots, 6 to 12 d wide, in the floor of a silo (A18; friction and
restitution 0.3): error of the flow against the extrapolation of our two finest runs and against LIGGGHTS's stiffest one, and run time; flows are
means over the rounds, each of which settles from another lattice."""

import json
import math
import random
import statistics
import sys
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent/"peers"))
from plainRuns import installed, ours, theirs
from plainScene import Grain, PlainScene, Plane, softStep
from results import BUILD, ROUNDS, Table, pyplot, savePicture

D, SPREAD, WIDTH, LAYERS, SETTLING = 2e-3, 0.1, 576, 40, 0.2       # d: WIDTH of the silo
SLOTS = 4*(6, 8, 10, 12)       # d
FROM, EVERY, BLOCKS = 0.1, 0.025, 6         # s; the flow is that of all blocks, its scatter that between them
TIMES = [FROM + EVERY*k for k in range(BLOCKS + 1)]
RUNS = ((2e-3, 1e-2), (1e-3, 1e-1), (5e-4, 1e-1), (2.5e-4, 1e-1), (1e-3, 1e-2), (5e-4, 1e-2), (2.5e-4, 1e-2))     # time step, tolerance; the two last
# are extrapolated
MODULI = (1e6, 1e7)
FIRST_SEED = 4     # of the lattices; each round has the next
COLUMNS = ["code", "knob", "deltaT", "seconds", "errorPercent", "errorToLiggghtsPercent", "flow", "standardError", "exponent", "steps",
           "overlapMax", "flowOfRound"]


def centers():
    return [WIDTH*D*((k + 0.5)/len(SLOTS) - 0.5) for k in range(len(SLOTS))]


def silo(grains, isOpen):
    """The floor as triangles between slots, or a plane."""
    half, deep = 0.5*WIDTH*D, 0.9*D
    scene = PlainScene(grains, [Plane(0, -half), Plane(0, half, -1)], (-half - D, -D, -0.4), (half + D, D, 1.3*LAYERS*D), friction=(0.3,),
                       restitution=0.3 if isOpen else 0.0, speed=0.5, isPlanar=True)
    if not isOpen:
        return replace(scene, planes=scene.planes + [Plane(2, 0.0)])
    edges = [-half - 0.5*D] + [x + side*width*D/2 for x, width in zip(centers(), SLOTS) for side in (-1, 1)] + [half + 0.5*D]
    triangles = []
    for a, b in zip(edges[::2], edges[1::2]):
        triangles += [((a, -deep, 0.0), (b, -deep, 0.0), (b, deep, 0.0)), ((a, -deep, 0.0), (b, deep, 0.0), (a, deep, 0.0))]
    return replace(scene, triangles=triangles)


def settled(seed):
    """Grains that fell from a lattice; done once, and kept."""
    kept = BUILD/("dry/W4.settled.%d.json" % seed)
    if not kept.exists():
        chance = random.Random(seed)
        perRow = int(WIDTH/(1.05*(1 + SPREAD)))
        step = WIDTH*D/perRow
        lattice = [Grain((-0.5*WIDTH*D + step*(i + 0.5) + 0.02*D*chance.uniform(-1, 1), 0.0, 1.05*(1 + SPREAD)*D*(k + 0.6)), D/2*(1 + SPREAD*chance.uniform(-1, 1)))
                   for k in range(LAYERS) for i in range(perRow)]
        rows = ours("W4", silo(lattice, False), [SETTLING], deltaT=1e-3)[1][0]
        kept.write_text(json.dumps([(row[:3], grain.radius) for row, grain in zip(rows, lattice)]))
    return [Grain((x[0], 0.0, x[2]), radius) for x, radius in json.loads(kept.read_text())]


def flows(scene, times, found):
    """Of each slot: kg/s in each block; a grain belongs to the slot under which it is."""
    places = centers()
    passed = [[0.0]*len(SLOTS) for _ in times]
    for masses, rows in zip(passed, found):
        for grain, row in zip(scene.grains, rows):
            if row[2] < 0:
                slot = min(range(len(SLOTS)), key=lambda k: abs(places[k] - row[0]))
                masses[slot] += scene.density*4/3*math.pi*grain.radius**3
    return [[(after - before)/(t1 - t0) for before, after, t0, t1 in zip(*([row[k] for row in passed[:-1]], [row[k] for row in passed[1:]]), times, times[1:])]
            for k in range(len(SLOTS))]


def exponent(each):
    """Of the flow in D - 1.5 d: Beverloo's is 1.5 in a plane."""
    points = [(math.log(width - 1.5), math.log(max(statistics.mean(blocks), 1e-12))) for width, blocks in zip(SLOTS, each)]
    x, y = (statistics.mean(values) for values in zip(*points))
    return sum((a - x)*(b - y) for a, b in points)/sum((a - x)**2 for a, _ in points)


class Run:
    def __init__(self, code, knob, deltaT, scene, times, run):
        self.code, self.knob, self.deltaT, self.figures = code, knob, deltaT, run[0]
        each = flows(scene, times, run[1])
        blocks = [sum(values) for values in zip(*each)]
        self.flow, self.exponent = statistics.mean(blocks), exponent(each)
        self.standardError = statistics.stdev(blocks)/math.sqrt(len(blocks))


def simulate(scene, deltaT, tolerance):
    options = dict(deltaT=deltaT, tolerance=tolerance, displacementTolerance=3e-2*tolerance)
    return Run("nscdDEMFoam", "dt %g s, tolerance %g" % (deltaT, tolerance), deltaT, scene, TIMES, ours("W4", scene, TIMES, **options))


def simulateSoft(peer, scene, modulus):
    deltaT = softStep(scene, modulus)
    times = [round(t/deltaT)*deltaT for t in TIMES]
    return Run(peer, "E %.0e Pa" % modulus, deltaT, scene, times, theirs(peer, "W4", scene, modulus, TIMES))


def measure(peers, seed):
    """Ours, and those of the peers, from one settled bed, in turn."""
    scene = silo(settled(seed), True)
    mine, theirs = [], []
    for k in range(max(len(RUNS), len(MODULI))):
        mine += [simulate(scene, *run) for run in RUNS[k:k + 1]]
        theirs += [simulateSoft(peer, scene, modulus) for modulus in MODULI[k:k + 1] for peer in peers]
    return mine + theirs


def errors(rounds):
    """In percent, of the mean flow of each run over the rounds: against ours, against theirs."""
    flow = [statistics.mean(run.flow for run in runs) for runs in zip(*rounds)]
    fine = 2*flow[len(RUNS) - 1] - flow[len(RUNS) - 2]
    return [(100*abs(value/fine - 1), 100*abs(value/flow[-1] - 1) if len(flow) > len(RUNS) else math.nan) for value in flow]


def meanOf(runs):
    """Of one kind of run in all rounds: the mean flow, and the standard error of that, from the scatter between rounds or, of a single one, between
    blocks of time."""
    flow = [run.flow for run in runs]
    return statistics.mean(flow), statistics.stdev(flow)/math.sqrt(len(flow)) if len(flow) > 1 else runs[0].standardError


def tabulate(table, peers):
    """All rounds first: what the errors are taken against is a mean of them."""
    rounds = []
    for number in range(ROUNDS):
        rounds.append(measure(peers, FIRST_SEED + number))
        print("round %d: flows %s" % (number + 1, " ".join("%.4g" % run.flow for run in rounds[-1])), flush=True)
    ofMeans = errors(rounds)

    def addRound(table):
        for k, run in enumerate(rounds[len(table.rounds) - 1]):
            table.add(run.code, run.knob, run.deltaT, run.figures["seconds"], *ofMeans[k], *meanOf([runs[k] for runs in rounds]), run.exponent, int(run.figures["steps"]),
                      run.figures.get("overlapMax", math.nan), run.flow)
    return table.inRounds(addRound, ROUNDS)


def draw(table):
    figure, axis = pyplot.subplots(figsize=(7, 4.5))
    for code in dict.fromkeys(table.column("code")):
        bars = table.column("standardError", code=code)
        axis.errorbar(table.column("seconds", code=code), table.column("flow", code=code), bars, fmt="o", label=code)
    axis.set_xscale("log")
    axis.set_xlabel("processor time of 0.25 s, less start-up [s]")
    axis.set_ylabel("flow through all slots [kg/s]")
    axis.legend(fontsize=7)
    savePicture(figure, "W4")


if __name__ == "__main__":
    there = installed("LIGGGHTS")
    draw(tabulate(Table("W4", COLUMNS, larger=("seconds",)), there))
