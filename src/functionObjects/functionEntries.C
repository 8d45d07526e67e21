// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Which keywords OpenFOAM reads itself.
#include "functionObjects/functionEntries.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Of functionObject, timeControl, regionFunctionObject and writeFile, v1912 to v2506.
const char* const keywordsOfOpenFOAM[] =
{
    "type", "libs", "functionObjectLibs", "enabled", "log", "errors", "region", "useNamePrefix",
    "timeStart", "timeEnd", "triggerStart", "triggerEnd", "controlMode",
    "executeControl", "executeInterval", "writeControl", "writeInterval", "outputControl", "outputInterval",
    "writePrecision", "writeToFile", "useUserTime"
};

} // namespace


void readFunction(const dictionary& dict, const std::function<void(const input::CheckedEntries&)>& read)
{
    toldByFoam([&]
    {
        const input::Dictionary translated = fromFoam(dict);
        const input::CheckedEntries entries(translated);
        for (const char* keyword : keywordsOfOpenFOAM) entries.found(keyword);
        read(entries);
        entries.finish();
    });
}


Plane readPlane(const input::Dictionary& dict)
{
    const input::CheckedEntries entries(dict);
    const Plane plane{entries.vec("point", input::unit::length), entries.vec("normal", input::unit::one)};
    if (plane.normal.isZero(0)) entries.reject("normal", "has no direction", "a vector other than (0 0 0)");
    entries.finish();
    return plane;
}


void requireEveryStep(const input::CheckedEntries& entries)
{
    for (const char* keyword : {"executeControl", "executeInterval"})
    {
        if (entries.found(keyword)) entries.reject(keyword, "would leave steps out of the count", "no such entry: every step is counted");
    }
}

} // namespace nscdCoupling
} // namespace Foam
