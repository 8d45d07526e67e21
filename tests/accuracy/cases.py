# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""The cases of the page of accuracy: what each is, what it is judged by, errors of other codes where known, and what the page lacks of it.

Errors of other codes are what their own repositories hold: Lethe (chaos-polymtl/lethe, applications_tests), MFiX (tests/dem), Gerris'
example column; none was run here."""

from dataclasses import dataclass


@dataclass
class Case:
    name: str
    what: str
    judge: str
    peers: str = ""
    missing: str = ""       # in words; nothing: the page has the whole case


DRY, FLUID, COUPLED = "Grains alone", "The fluid, at a given fluid fraction", "Grains in a fluid"

CASES = {
    DRY: [
        Case("A01", "fall and stop", "closed form"),
        Case("A02", "bouncing", "Newton's law", "MFiX: passes within 5 %"),
        Case("A03", "shock of two", "Newton's law"),
        Case("A04", "shock of three", "Moreau's law"),
        Case("A05", "slide to roll", "closed form", missing="the disc with radius 0.05 m (nscdTests judges it)"),
        Case("A06", "incline", "closed form"),
        Case("A07", "pyramid of discs", "equilibrium", missing="the friction at which it falls (nscdTests judges it)"),
        Case("A08", "stack of spheres", "its weight"),
        Case("A09", "box of discs at rest", "its weight"),
        Case("A10", "oblique impact", "Coulomb's law; experiment", "MFiX: 0.9 % of the experiment at 60 degrees",
             "angles below 33 degrees against the experiment, where rigid grains cannot follow it"),
        Case("A11", "cooling gas", "Haff's law"),
        Case("A12", "elastic discs in a box", "energy"),
        Case("A13", "collapsing column", "Contact Dynamics grains", "Gerris' grains overlap by 0.4 % in the mean, 2.8 % at most"),
        Case("A14", "run-out of columns", "exponents of others"),
        Case("A15", "silo", "LIGGGHTS"),
        Case("A16", "drum", "LIGGGHTS"),
        Case("A17", "impact on a bed", "LIGGGHTS"),
        Case("A18", "outlet", "Beverloo's exponent",
             missing="spheres (`build/core/validation/dryOutlet 3d`); an arch may stop the outlet of 5 d, which spoils the exponent"),
        Case("A19", "sheared layer", "balance of forces"),
    ],
    FLUID: [
        Case("B01", "still water over jumps", "hydrostatics"),
        Case("B02", "contraction", "Bernoulli"),
        Case("B03", "channel with drag", "Brinkman"),
        Case("B05", "Lethe's cases", "manufactured solution", "Lethe: the bar"),
        Case("B06", "piston of grains", "no net flux"),
        Case("B07", "no grains", "pimpleFoam"),
        Case("B08", "uniform fraction", "the same at alpha 1"),
        Case("M1", "vortices over bumps", "manufactured solution"),
        Case("M2", "traveling wave", "manufactured solution"),
        Case("M3", "sharp bed edges", "manufactured solution"),
    ],
    COUPLED: [
        Case("C01", "grain in gas, CFDEM's", "equation of motion"),
        Case("C02", "grain in a gas stream", "equation of motion", "MFiX: passes within 5 %"),
        Case("C03", "glass in water", "equation of motion", "Lethe: 3 % in v(t) at 5 ms, 0.08 % at the end"),
        Case("C04", "Boycott's grain", "equation of motion"),
        Case("C05", "sand in water", "equation of motion"),
        Case("C06", "viscous", "equation of motion"),
        Case("C07", "suspension, no weight", "exact solution"),
        Case("C08", "hindered settling", "exact solution"),
        Case("C09", "hindered settling, laws", "balance of forces", missing="a run; the figures are those of the drag laws"),
        Case("C10", "settling fronts", "Kynch's theory", missing="all; landingSuspension judges speeds against that theory in other suspensions"),
        Case("C11", "Boycott's box", "clear-fluid rate", missing="all"),
        Case("C12", "lattice bed", "drag laws", missing="cells below half a diameter (`latticeBed/run narrow` and `sweep` have them)"),
        Case("C13", "seepage in a cylinder", "Ergun's law", missing="all; tutorials/coupled/packedBed judges it"),
        Case("C14", "packed bed, Lethe's", "drag laws", "Lethe's drops under two laws differ by 2.6", "all"),
        Case("C15", "seepage force", "Ergun's law", missing="the speed at which the bed lifts off"),
        Case("C16", "submerged weight", "weight", missing="a large grain that floats in a fluidized bed"),
        Case("C17", "ramp of the inflow", "published curve", missing="all"),
        Case("C18", "fluidized bed, Mueller's", "experiment", "sediFoam: rms 0.027, 0.057 in alpha, 0.036 m/s",
             "the third height and the other speed; other laws and coefficients: src/coupling/measured.md"),
        Case("C19", "fluidized bed, Goldschmidt's", "DPMFoam", missing="all; tutorials/coupled/fluidizedBed and benchmark/run dpmfoam have it"),
        Case("C20", "cylinder bed, Lethe's", "weight", missing="all"),
        Case("C21", "bed of van Wachem", "weight", missing="all"),
        Case("C22", "liquid bed, alumina", "drag laws", missing="all; the drag laws' figures are judged in closuresTests"),
        Case("C23", "liquid bed, small", "drag laws", missing="all"),
        Case("C24", "bed of NETL", "weight", missing="all"),
        Case("C25", "ball in a cell", "exact volume"),
        Case("C26", "volume is kept", "conservation"),
        Case("C27", "moving grain", "silhouette"),
        Case("C28", "falling cloud, CFDEM's", "volume", missing="all"),
        Case("C29", "Rayleigh-Taylor", "growth rate", missing="all"),
        Case("C30", "granular Rayleigh-Taylor", "fingers", missing="all"),
        Case("C31", "falling cloud", "Hadamard-Rybczynski", missing="all"),
        Case("C32", "falling drop of MigFlow", "stability", missing="all"),
        Case("C33", "depot of MigFlow", "submerged weight", missing="the floor's force within 1e-4 in good cells, where the water still swirls; the speed of one disc that falls alone, whose drag in a plane is another"),
        Case("C34", "collapse in a liquid", "experiment", missing="all"),
        Case("C35", "impulse wave", "experiment", missing="all: it needs a free surface"),
        Case("C36", "spout", "experiment", missing="all"),
    ],
}
