// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The table that names the drag laws; they are in closures/drag, one function each.
#include "closures/dragLaws.hpp"

#include "closures/drag/hinderedDrag.hpp"
#include "closures/drag/loneGrainDrag.hpp"
#include "closures/drag/nonsphericalDrag.hpp"
#include "closures/drag/packedBedDrag.hpp"
#include "closures/drag/simulatedDrag.hpp"

#include <algorithm>
#include <stdexcept>

namespace closures
{

namespace
{

using namespace drag;

/// What Huilin and Gidaspow's switch leaves of Wen and Yu's law at alpha 1.
constexpr double smooth = 0.993937687637;

// Ranges: Re_s up to, alpha from, to. Lone grains: at alpha 0.95 neighbors add about 15 % to what these laws know nothing of.
// Packings of equal spheres end at alpha 0.36 or so; a law without a bound of its own has none here.
constexpr DragRange stokesLone = {0.1, 0.95, 1}, lone = {2e5, 0.95, 1}, stokesAny = {0.1, 0, 1}, any = {2e5, 0, 1};
constexpr DragRange liquidBeds = {1e4, 0, 1}, dilute = {2e5, 0.8, 1}, packed = {1500, 0, 0.8}, cellModel = {1000, 0, 0.9};
constexpr DragRange rongsBeds = {3000, 0.37, 1}, kochHillBeds = {200, 0.36, 1}, beetstraBeds = {1000, 0.36, 1}, tennetiBeds = {300, 0.5, 1};

// Schiller-Naumann jumps by 0.4 % at Re 1000 (Cd 0.4383 to 0.44). Gidaspow's law jumps at alpha = 0.8: Ergun is 15 % above Wen-Yu at
// Re_s -> 0 and 3.75 times Wen-Yu at Re_s 1000. Koch and Hill's rises by 1 % at phi 0.4, Hill, Koch and Ladd's by 28 % at phi 0.01.
// stokesLimit: 23.04/24 of DallaValle's Cd; Ergun's viscous part vanishes with the solid fraction, also in
// GidaspowSmooth, where 1/2 - atan(52.5)/pi of it is left.
const std::vector<DragLawRow> table =
{
    // name                    alias         function                 Stokes  slip    alpha    range         source
    {"Stokes",                  "",           stokes,                  1,      0,      0,       stokesLone,   "Stokes 1851"},
    {"SchillerNaumann",         "",           schillerNaumann,         1,      4.0e-3, 0,       lone,         "Schiller & Naumann 1933"},
    {"DallaValle",              "",           dallaValle,              0.96,   0,      0,       lone,         "DallaValle 1948"},
    {"StokesHindered",          "",           stokesHindered,          1,      0,      0,       stokesAny,    "Stokes 1851 times alpha^-2.8"},
    {"DiFelice",                "",           diFelice,                0.96,   0,      0,       liquidBeds,   "Di Felice 1994"},
    {"DiFeliceConstant",        "MigFlow",    diFeliceConstant,        0.96,   0,      0,       liquidBeds,   "Di Felice 1994, exponent 3.8"},
    {"SchillerNaumannDiFelice", "",           schillerNaumannDiFelice, 1,      4.0e-3, 0,       liquidBeds,   "Di Felice 1994"},
    {"WenYu",                   "",           wenYu,                   1,      4.0e-3, 0,       dilute,       "Wen & Yu 1966"},
    {"Ergun",                   "",           ergun,                   0,      0,      0,       packed,       "Ergun 1952"},
    {"Gidaspow",                "ErgunWenYu", gidaspow,                1,      4.0e-3, 2.75,    any,          "Gidaspow 1994"},
    {"GidaspowSmooth",          "",           gidaspowSmooth,          smooth, 3.8e-3, 0,       any,          "Huilin & Gidaspow 2003"},
    {"SyamlalOBrien",           "",           syamlalOBrien,           0.96,   0,      1.0e-3,  any,          "Syamlal & O'Brien 1987"},
    {"PlessisMasliyah",         "",           plessisMasliyah,         0,      0,      0,       cellModel,    "Du Plessis & Masliyah 1988"},
    {"KochHill",                "",           kochHill,                1,      0,      1.05e-2, kochHillBeds, "Koch & Hill 2001"},
    {"HillKochLadd",            "",           hillKochLadd,            1,      0,      0.282,   kochHillBeds, "Benyahia et al. 2006"},
    {"Beetstra",                "",           beetstra,                1,      0,      0,       beetstraBeds, "Beetstra et al. 2007"},
    {"Rong",                    "",           rong,                    0.96,   0,      0,       rongsBeds,    "Rong et al. 2013"},
    {"Tenneti",                 "",           tenneti,                 1,      0,      0,       tennetiBeds,  "Tenneti et al. 2011"},
    {"HaiderLevenspiel",        "",           haiderLevenspiel,        1,      0,      0,       liquidBeds,   "Haider & Levenspiel 1989"},
    {"HoelzerSommerfeld",       "",           holzerSommerfeld,        1,      0,      0,       liquidBeds,   "Hoelzer & Sommerfeld 2008"}
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

BeyondRange beyondRange(const DragRange& range, const DragState& state)
{
    const double alpha = state.fluidFraction;
    return {superficialRe(state)/range.highestRe, std::max({0.0, range.lowestFraction - alpha, alpha - range.highestFraction})};
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
