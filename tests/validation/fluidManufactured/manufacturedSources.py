#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
"""Writes manufacturedSources.H: the momentum sources that make given fields solve the averaged equations.

    python3 manufacturedSources.py > manufacturedSources.H        (needs sympy)

Unknowns: superficial velocity U = alpha u and pressure p, with d(alpha)/dt + div U = 0 identically.
    S   rho [dU/dt + div(U U/alpha)] = -alpha grad p + alpha div tau - beta u + source
    D   rho [dU/dt + div(U U/alpha)] = -alpha grad p + div(alpha tau) - beta u + source
    tau = mu (grad u + grad u^T - 2/3 div u I)
The solver is of form S; form D serves to show that the test tells them apart."""
import sympy as sp

x, y, t, rho, mu, beta = sp.symbols("x y t rho mu beta")
sin, cos, Q = sp.sin, sp.cos, sp.Rational


def taylorGreen():
    """Decaying vortices over a fixed wavy fluid fraction."""
    decay = sp.exp(-2*t)
    return (Q(3, 5) + Q(1, 5)*cos(x)*cos(y),
            (sin(x)*cos(y)*decay, -cos(x)*sin(y)*decay),
            (cos(2*x) + cos(2*y))/4*decay**2)


def travelingWave():
    """A wave of the fluid fraction that moves at speed 1/2; the grains' flux is ((1 - alpha)/2, 0)."""
    alpha = Q(7, 10) + Q(3, 20)*cos(x - t/2)
    return (alpha,
            (alpha/2 + Q(1, 4) + sin(x)*cos(y)/2, -cos(x)*sin(y)/2),
            (cos(2*x) + cos(2*y))/4*sin(2*t) + sin(x)*sin(y))


def sharpBed():
    """Steady flow through edges of a bed, alpha between 0.4 and 1."""
    return (Q(7, 10) + Q(3, 10)*sp.tanh(4*sin(x)), (Q(1, 2) + sin(y)/2, Q(1, 4) + 0*x), sin(x)*cos(y))


X, Y = sp.pi*x, sp.pi*y
VORTEX = (sin(X)**2*cos(Y)*sin(Y), -cos(X)*sin(X)*sin(Y)**2)


def steadyVortex():
    """Case 0 of Lethe's manufactured VANS cases, on [-1, 1]^2."""
    alpha = Q(1, 2) + 0*x
    return alpha, tuple(alpha*u for u in VORTEX), Q(1, 2) + sin(X)*sin(Y)/2


def vortexInHills():
    """Case 1 of the same."""
    alpha = Q(1, 2) + sin(X)*sin(Y)/4
    return alpha, tuple(-2*alpha*u for u in VORTEX), sin(X)*sin(Y)


def uniformFlux():
    """Case 2 of the same."""
    flux = sp.exp(-2)
    return sp.exp(-sin(X)*sin(Y) - 1), (flux + 0*x, flux + 0*x), Q(1, 2) + sin(X)*sin(Y)/2


def source(alpha, U, p, form):
    axis, u = (x, y), [U[0]/alpha, U[1]/alpha]
    divU = sum(sp.diff(u[i], axis[i]) for i in range(2))
    tau = [[mu*(sp.diff(u[i], axis[j]) + sp.diff(u[j], axis[i]) - (Q(2, 3)*divU if i == j else 0))
            for j in range(2)] for i in range(2)]
    result = []
    for i in range(2):
        inertia = rho*(sp.diff(U[i], t) + sum(sp.diff(U[i]*u[j], axis[j]) for j in range(2)))
        if form == "S":
            stress = alpha*sum(sp.diff(tau[i][j], axis[j]) for j in range(2))
        else:
            stress = sum(sp.diff(alpha*tau[i][j], axis[j]) for j in range(2))
        result.append(inertia + alpha*sp.diff(p, axis[i]) - stress + beta*u[i])
    return result


HEAD = """// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Manufactured solutions of the averaged equations; written by manufacturedSources.py, which has the equations.

#ifndef manufacturedSources_H
#define manufacturedSources_H

#include <cmath>

struct ManufacturedFluid { double rho, mu, beta; };

/// Fluid fraction, superficial velocity, pressure, and the source per volume for stress forms S and D.
struct ManufacturedPoint { double fluidFraction, U[2], p, sourceS[2], sourceD[2]; };
"""


def function(name, fields):
    alpha, U, p = fields
    assert sp.simplify(sp.diff(alpha, t) + sp.diff(U[0], x) + sp.diff(U[1], y)) == 0
    values = [alpha, *U, p, *source(alpha, U, p, "S"), *source(alpha, U, p, "D")]
    common, values = sp.cse(values, symbols=sp.numbered_symbols("c"))
    lines = ["", "inline ManufacturedPoint %s" % name, "(",
             "    const ManufacturedFluid& fluid, const double x, const double y, const double t", ")", "{",
             "    using std::cos; using std::exp; using std::pow; using std::sin; using std::tanh;",
             "    const double rho = fluid.rho, mu = fluid.mu, beta = fluid.beta;",
             "    (void)t;"]
    lines += ["    const double %s = %s;" % (s, sp.ccode(e)) for s, e in common]
    v = [sp.ccode(e) for e in values]
    lines += ["    return", "    {", "        %s," % v[0], "        {%s, %s}," % (v[1], v[2]), "        %s," % v[3],
              "        {%s, %s}," % (v[4], v[5]), "        {%s, %s}" % (v[6], v[7]), "    };", "}"]
    return "\n".join(lines)


if __name__ == "__main__":
    print(HEAD, end="")
    for f in (taylorGreen, travelingWave, sharpBed, steadyVortex, vortexInHills, uniformFlux):
        print(function(f.__name__, f()))
    print("\n#endif")
