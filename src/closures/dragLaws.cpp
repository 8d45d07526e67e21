// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The drag laws, one function each, and under them the table that names them.
#include "closures/dragLaws.hpp"

#include <cmath>
#include <stdexcept>

namespace closures
{

namespace
{

constexpr double pi = 3.14159265358979323846;

/// Below this fluid fraction Gidaspow's law is Ergun's.
constexpr double gidaspowSwitch = 0.8;

/// Above this Reynolds number Schiller and Naumann take Newton's constant drag.
constexpr double newtonRe = 1000;

/// Re of the slip velocity, for a grain alone.
double slipRe(const DragState& s)
{
    return s.density*s.slip*s.size.diameter/s.viscosity;
}

/// Re_s = rho U_s d/mu of the superficial slip U_s = alpha |u - v|.
double superficialRe(const DragState& s)
{
    return s.fluidFraction*slipRe(s);
}

// The product Cd Re has a limit at Re = 0 where Cd has none: every law is written with it.

double stokesCdRe()
{
    return 24;
}

/// Cd = 24/Re (1 + 0.15 Re^0.687), 0.44 from Re 1000 on (Schiller & Naumann 1933).
double schillerNaumannCdRe(double Re)
{
    return Re < newtonRe ? 24*(1 + 0.15*std::pow(Re, 0.687)) : 0.44*Re;
}

/// Cd = (0.63 + 4.8/sqrt(Re))^2 (DallaValle 1948).
double dallaValleCdRe(double Re)
{
    const double root = 0.63*std::sqrt(Re) + 4.8;
    return root*root;
}

/// beta = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2) (Di Felice 1994).
double diFeliceExponent(double Re)
{
    // The exponential is below 1e-39 there; log10(0) would trip a run that traps floating-point errors.
    if (Re < 1e-12) return 3.7;
    const double x = 1.5 - std::log10(Re);
    return 3.7 - 0.65*std::exp(-0.5*x*x);
}

/// F = A/2 rho Cd(Re) |u - v|^2 divided by |u - v|, with Cd = cdRe/Re.
double loneGrain(const DragState& s, double cdRe)
{
    return 0.5*s.size.frontalArea*s.viscosity*cdRe/s.size.diameter;
}

/// F = A/2 rho Cd(Re_s) U_s^2 alpha^(-beta) divided by |u - v|.
double hindered(const DragState& s, double cdRe, double beta)
{
    return loneGrain(s, cdRe)*std::pow(s.fluidFraction, 1 - beta);
}

double stokes(const DragState& s)
{
    return loneGrain(s, stokesCdRe());
}

double schillerNaumann(const DragState& s)
{
    return loneGrain(s, schillerNaumannCdRe(slipRe(s)));
}

double dallaValle(const DragState& s)
{
    return loneGrain(s, dallaValleCdRe(slipRe(s)));
}

double stokesHindered(const DragState& s)
{
    return hindered(s, stokesCdRe(), 3.8);
}

double diFelice(const DragState& s)
{
    const double Re = superficialRe(s);
    return hindered(s, dallaValleCdRe(Re), diFeliceExponent(Re));
}

double diFeliceConstant(const DragState& s)
{
    return hindered(s, dallaValleCdRe(superficialRe(s)), 3.8);
}

double schillerNaumannDiFelice(const DragState& s)
{
    const double Re = superficialRe(s);
    return hindered(s, schillerNaumannCdRe(Re), diFeliceExponent(Re));
}

/// n gamma = 3/4 Cd(Re_s) alpha phi rho |u - v|/d alpha^(-2.65), which is beta = 3.65 (Wen & Yu 1966 as in Gidaspow 1994).
double wenYu(const DragState& s)
{
    return hindered(s, schillerNaumannCdRe(superficialRe(s)), 3.65);
}

/// n gamma = 150 phi^2 mu/(alpha d^2) + 1.75 phi rho |u - v|/d with n = phi/V (Ergun 1952).
double ergun(const DragState& s)
{
    const double d = s.size.diameter;
    const double phi = 1 - s.fluidFraction;
    return s.size.volume*(150*phi*s.viscosity/(s.fluidFraction*d*d) + 1.75*s.density*s.slip/d);
}

/// Ergun below alpha = 0.8, Wen-Yu from there on (Gidaspow 1994); the published law jumps there.
double gidaspow(const DragState& s)
{
    return s.fluidFraction < gidaspowSwitch ? ergun(s) : wenYu(s);
}

// Schiller-Naumann jumps by 0.4 % at Re 1000 (Cd 0.4383 to 0.44). Gidaspow's law jumps at alpha = 0.8: Ergun is 15 %
// above Wen-Yu at Re_s -> 0 and 3.75 times Wen-Yu at Re_s 1000.
// stokesLimit: 23.04/24 of DallaValle's Cd; Ergun's viscous part vanishes with the solid fraction.
const std::vector<DragLawRow> table =
{
    // name                    alias        function                 Stokes  slip    alpha  source
    {"Stokes",                  "",          stokes,                  1,     0,      0,     "Stokes 1851"},
    {"SchillerNaumann",         "",          schillerNaumann,         1,     4.0e-3, 0,     "Schiller & Naumann 1933"},
    {"DallaValle",              "",          dallaValle,              0.96,  0,      0,     "DallaValle 1948"},
    {"StokesHindered",          "",          stokesHindered,          1,     0,      0,     "Stokes 1851 times alpha^-2.8"},
    {"DiFelice",                "",          diFelice,                0.96,  0,      0,     "Di Felice 1994"},
    {"DiFeliceConstant",        "MigFlow",   diFeliceConstant,        0.96,  0,      0,     "Di Felice 1994, exponent 3.8"},
    {"SchillerNaumannDiFelice", "",          schillerNaumannDiFelice, 1,     4.0e-3, 0,     "Di Felice 1994"},
    {"WenYu",                   "",          wenYu,                   1,     4.0e-3, 0,     "Wen & Yu 1966"},
    {"Ergun",                   "",          ergun,                   0,     0,      0,     "Ergun 1952"},
    {"Gidaspow",                "ErgunWenYu", gidaspow,               1,     4.0e-3, 2.75,  "Gidaspow 1994"}
};

} // namespace

GrainSize sphereSize(double diameter)
{
    return {diameter, pi*diameter*diameter/4, pi*diameter*diameter*diameter/6};
}

GrainSize discSize(double diameter, double thickness)
{
    return {diameter, diameter*thickness, pi*diameter*diameter*thickness/4};
}

double sphereSpinDrag(double diameter, double viscosity)
{
    return pi*viscosity*diameter*diameter*diameter;
}

double discSpinDrag(double diameter, double thickness, double viscosity)
{
    return pi*viscosity*diameter*diameter*thickness;
}

const std::vector<DragLawRow>& dragLaws()
{
    return table;
}

std::vector<std::string> dragLawNames()
{
    std::vector<std::string> names;
    for (const DragLawRow& row : table) names.emplace_back(row.name);
    return names;
}

const DragLawRow& findDragLaw(const std::string& name)
{
    std::string known;
    for (const DragLawRow& row : table)
    {
        if (name == row.name || (*row.alias && name == row.alias)) return row;
        known += std::string(known.empty() ? "" : ", ") + row.name;
    }
    throw std::invalid_argument("drag law '" + name + "' is not known; known are: " + known);
}

} // namespace closures
