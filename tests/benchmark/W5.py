# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""W5: one grain settling from rest, one-way: largest error of v(t) and run time against dt/tau."""

import math

from pinnedRun import pinned
from results import BUILD, Table, pyplot, savePicture
from foamCase import BoxCase

G = 9.81
LAW = "SchillerNaumann"
# d, density of the grain, of the fluid, viscosity, terminal speed (validation cases C05 and C03)
GRAINS = {"C05 sand in water": (2e-4, 2650.0, 1000.0, 1e-3, .024796), "C03 glass in water": (2e-3, 2500.0, 997.0, 1.00199e-3, .267910)}
RATIOS = (.01, .03, .1, .3, 1.0, 3.0, 10.0, 30.0, 100.0)


def exactSpeeds(grain, times):
    """Runge-Kutta of fourth order in steps of tau/200 at most; after 50 tau the terminal speed is exact to round-off."""
    d, rhoP, rhoF, mu, terminal = grain
    tau = terminal/relativeWeight(grain)

    def acceleration(v):
        Re = rhoF*v*d/mu
        return relativeWeight(grain) - 18*mu/(rhoP*d*d)*(1 + 0.15*Re**0.687)*v

    v, t, result = 0.0, 0.0, []
    for end in times:
        span = min(end, 50*tau) - t
        steps = math.ceil(max(span, 0)/(tau/200))
        for _ in range(steps):
            h = span/steps
            k1 = acceleration(v); k2 = acceleration(v + h/2*k1); k3 = acceleration(v + h/2*k2); k4 = acceleration(v + h*k3)
            v += h/6*(k1 + 2*k2 + 2*k3 + k4)
        t = max(t, min(end, 50*tau))
        result.append(v)
    return result


def relativeWeight(grain):
    return (1 - grain[2]/grain[1])*G


def simulate(name, grain, weight, deltaT, steps):
    """Times, speeds, and processor seconds of the run; the fluid is at rest and periodic, for steps of many diameters."""
    d, rhoP, rhoF, mu, _ = grain
    case = BoxCase(BUILD/"cases/W5", (0, 0, 0), (20*d,)*3, (4, 4, 4))
    case.fluid(rhoF, mu, (0, 0, -G))
    case.table([(10*d, 10*d, 10*d, d)])
    case.grains("materials { m { density %.17g; } } contacts { default { friction 0; } } feedback off;\n"
                "forces { drag { law %s; weight %s; } } grains { type table; file grains.dat; }" % (rhoP, LAW, weight))
    case.control(deltaT, steps*deltaT)
    case.call("blockMesh")
    cost = pinned("nscdDEMFoam", case.folder)
    report = case.report()
    mass = rhoP*math.pi/6*d**3
    case.remove()
    return report["time"], [math.sqrt(2*e/mass) for e in report["kineticEnergy"]], cost.cpu


def measure(table):
    for name, grain in GRAINS.items():
        tau = grain[4]/relativeWeight(grain)
        for weight in ("exponential", "backwardEuler"):
            startUp = simulate(name, grain, weight, tau, 1)[2]
            for ratio in RATIOS:
                steps = max(8, round(8/ratio))
                times, speeds, cpu = simulate(name, grain, weight, ratio*tau, steps)
                errors = [abs(v - e)/grain[4] for v, e in zip(speeds, exactSpeeds(grain, times))]
                table.add(name, weight, ratio, steps, max(errors), errors[0], errors[-1], max(cpu - startUp, 0.0))


def main():
    table = Table("W5", ["grain", "weight", "dtOverTau", "steps", "maxError", "firstStepError", "lastError", "seconds"], larger=("maxError", "seconds"))
    draw(table.inRounds(measure))


def draw(table):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4))
    for name in GRAINS:
        for weight, line in (("exponential", "o-"), ("backwardEuler", "s--")):
            errors = [100*e for e in table.column("maxError", grain=name, weight=weight)]
            left.loglog(RATIOS, errors, line, label="%s, %s" % (name, weight))
            right.loglog(table.column("seconds", grain=name, weight=weight), errors, line)
    left.set_xlabel("dt/tau, tau = terminal speed over initial acceleration")
    right.set_xlabel("processor time less start-up [s]")
    left.set_ylabel("largest error of v(t) [% of the terminal speed]")
    left.legend(fontsize=7)
    savePicture(figure, "W5")


main()
