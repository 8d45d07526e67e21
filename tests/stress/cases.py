# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The stress cases: what is asked for, which tests of the project show it, and what of it none shows yet."""

from dataclasses import dataclass, field


@dataclass
class Case:
    name: str
    parameters: str
    expected: str
    unit: str = ""          # filters of nscdTests
    foam: str = ""          # filters of nscdDEMFoamTests
    validation: list = field(default_factory=list)
    missing: str = ""       # in words; nothing: the case is whole


CASES = [
    Case("S1 drag-stiff grains", "C07, dt/tau up to 1e4", "final velocity at once, momentum kept", validation=["uniformSuspension"],
         missing="C32"),
    Case("S2 explicit-drag trap", "C05: dt/tau .1 to 100", "same terminal velocity", validation=["settlingGrain"]),
    Case("S3 light, neutral grains", "density ratios 2000 to .001", "rises by its law, stable", validation=["landingSuspension", "uniformSuspension"]),
    Case("S4 heavy on light", "1:1 to 1:1e4, on one and on 19", "forces right, or said", "Stress.heavyOnLight*", validation=["dryStress", "dryStacks"]),
    Case("S5 tall stacks", "100, 300, 1000 spheres, cold", "base force 1e-6, few sweeps then",
         "Stack.*:Direct.stackOfThreeHundredFromCold", validation=["dryStacks", "dryStatics"]),
    Case("S6 sizes 1:100", "1:20, 1:100 in a box", "overlap, cost of search", foam="mappingWeights.grainsFive*", validation=["drySizes", "drySizes many"]),
    Case("S7 cells below grains", "d 5 and 10 cells; lattice bed, h = d", "alpha in its range, law's gradient",
         foam="mappingWeights.grainsFiveAndTen*:mappingOctant.grainsWider*", validation=["latticeBed"]),
    Case("S8 dt -> 0, moving", "exact fraction against the silhouette", "pressure has a limit",
         foam="mappingWeights.exactFractionChanges*:fluidPiston.*", validation=["movingBed", "movingBed grain"]),
    Case("S9 packing limit", "landing at .5; lid to .66 and .68", "no clipping, finite, said", "MovingWall.aLid*:Squeezed.*", "mappingRedistribution.*",
         ["landingSuspension", "stressInFluid"]),
    Case("S10 fully packed", "lattice, random grains fill the box; jumps", "Ergun's law; closed: at rest", foam="fluidAtRest.*",
         validation=["latticeBed", "stressInFluid"]),
    Case("S11 dt 10x and 100x", "C33 at 10x; random steps", "stable, none lost", "RandomSteps.*", validation=["grainsOnRanks", "depot steps"],
         missing="C33 at 100x, C18 and A13 at 10x and 100x, by hand: tests/measured.md"),
    Case("S12 zero grains", "from the start, or all leave", "as without grains, files valid", "Stress.noGrains*:SmallScenes.nothing*",
         "Program.runsWithoutGrains:Program.goesOn*Left:mappingWeights.noGrains:mappingRanks.noGrainsAnywhere", ["fluidWithoutGrains"]),
    Case("S13 one grain, one cell", "1x1x1, periodic and closed", "shares to round-off", "SmallScenes.nothingAndOne*",
         "mappingWeights.conserveWithOneOrTwo*", ["uniformSuspension"]),
    Case("S14 as wide as its shaft", "d = width", "no crash, walls balanced", "Stress.grainAsWide*", validation=["stressInFluid"]),
    Case("S15 borders of ranks", "1 to 8 ranks, corners, empty ranks", "one answer", validation=["grainsOnRanks"]),
    Case("S16 gravity turned over", "bed, g to -g", "no tunneling, no energy", validation=["dryStress", "stressInFluid"]),
    Case("S17 inflow stepped", "bed, k .1 to 1e4; to twice what lifts it, back to 0", "drop by its law, bed as before", validation=["packedBed"]),
    Case("S18 fast grain", "50 d a step: wall, grain, bed", "no tunneling, no energy", "Stress.fastGrain*:StopsOnWay.*", validation=["dryFast"]),
    Case("S19 initial overlap", "clouds, columns, 1 to 50 %", "gentle, or refused", "Stress.initialOverlaps*:OverlapCorrection.*",
         "BadStart.overlaps*"),
    Case("S20 coincident centers", "two grains", "a message", "Stress.coincident*:ContactGeometry.coincident*"),
    Case("S21 friction 0 to 1e6", "heaps, belts", "converges, or held and said", "Solver.*:Solvers.*:HeldFriction.*:Pyramid.*",
         validation=["dryShear rough 10", "dryShear rough 1e6"]),
    Case("S22 e = 1, dense", "phi .6, friction 0 and .5", "energy exact, else said", "Shock.*", validation=["dryStress"]),
    Case("S23 wedge", "disc between walls, friction 1", "finite impulses, no drift", "Stress.discWedged*"),
    Case("S24 fluid solver limits", "Co .1 to 10; viscosity x 1e6", "stable, drop and floor force right", validation=["packedBed"]),
    Case("S25 bad cells", "distorted; 70 deg, aspect 100: B01, C12, C33", "at rest to 1e-8, law's gradient",
         foam="fluidAtRest.staysAtRestOnADistorted*:mappingWeights.conserveOnAShaken*", validation=["badCells", "depot"]),
    Case("S26 source switched", "grains held and let go", "continuity 1e-8", foam="fluidResponse.clearedSources*:Program.letsFixed*",
         validation=["stressInFluid"]),
    Case("S27 restart", "in the middle, dry and coupled", "to the bit", "Restart.*:Checkpoint.*", "Program.*NeverStopped:BadRestart.*",
         ["writtenTimes"]),
    Case("S28 open borders", "exits, all leave; in and out", "exact count", "GrainEntry.*", "GrainExits.*:GrainMemory.*:Program.goesOn*Left:Entries.*",
         ["inAndOut"], "1e5 steps: IN_AND_OUT_STEPS=100000 tests/validation/inAndOut/run"),
    Case("S29 cloud, no contact", "1e6 grains, phi 1e-3", "contacts < 10 % of the time", "Skip.*",
         missing="the share of time: tests/benchmark/run S29, which does not judge"),
    Case("S30 long rest", "beds, 1e4 steps; asleep", "no creep, cheap", "Rest.*:*/Sleep.*:SleepOf.*:PartialSleep.*", validation=["dryRest"],
         missing="1e5 steps: tests/benchmark/run S30, which does not judge"),
]
