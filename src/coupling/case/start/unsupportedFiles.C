// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking for them.
#include "coupling/case/input/inputError.H"
#include "coupling/case/start/unsupportedFiles.H"

#include "IOdictionary.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// A dictionary in a file that need not be there; empty where it is not.
IOdictionary readIfPresent(const Time& time, const fileName& folder, const word& name)
{
    return IOdictionary(IOobject(name, folder, time, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false));
}

/// Options and zones are dictionaries. One that is switched off is refused too: OpenFOAM makes it all the same.
void refuseAny(const IOdictionary& dict, const string& problem, const string& allowed)
{
    for (const entry& part : dict)
    {
        if (part.isDict()) fail({placeOf(dict, part.keyword()), problem, "", allowed});
    }
}

void refuseRotatingZones(const Time& time, bool solvesFluid)
{
    const word name = "MRFProperties";
    refuseAny(readIfPresent(time, time.system(), name), "asks for a rotating frame in a file that nobody reads", "it in constant/MRFProperties");
    if (solvesFluid) return;
    const string problem = "asks for a rotating frame of the fluid's equations, where `fluid none;` solves none";
    refuseAny(readIfPresent(time, time.constant(), name), problem, "no such file, or a fluid");
}

void refuseStatesOfGas(const Time& time)
{
    const string problem = "asks for a fluid whose density follows from pressure and temperature, where it is constant";
    refuseAny(readIfPresent(time, time.constant(), "thermophysicalProperties"), problem, "no such file, and nu and rho in constant/transportProperties");
}

} // namespace


void refuseUnsupportedFiles(const Time& time, bool solvesFluid)
{
    if (solvesFluid) refuseStatesOfGas(time);
    for (const word& folder : {time.constant(), time.system()})
    {
        if (solvesFluid) continue;
        const string problem = "asks for a source in the fluid's equations, where `fluid none;` solves none";
        refuseAny(readIfPresent(time, folder, "fvOptions"), problem, "no such file, or a fluid");
    }
    refuseRotatingZones(time, solvesFluid);
}

} // namespace nscdCoupling
} // namespace Foam
