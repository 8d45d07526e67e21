// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking them up.
// Tested by tests/foam/program/functionObjectsTest.C
#include "coupling/case/start/functionTypes.H"
#include "coupling/case/input/inputError.H"

#include "functionObject.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Called functionObjectLibs up to v1612.
void openLibraries(const dictionary& dict, Time& time)
{
    for (const word& keyword : {word("libs"), word("functionObjectLibs")}) if (dict.found(keyword)) time.libs().open(dict, keyword);
}

void checkFunctionType(const dictionary& function)
{
    const word keyword = "type";
    if (!function.getOrDefault("enabled", true)) return;
    const auto* known = functionObject::dictionaryConstructorTablePtr_;
    const word type = function.getOrDefault<word>(keyword, word::null);
    if (type.empty()) fail({placeOf(function), "has no type", "", "a type of function object"});
    if (known->found(type)) return;
    fail({placeOf(function, keyword), "is no function object of the libraries that are loaded (`libs`)", type, "", toWords(known->sortedToc())});
}

} // namespace


void checkFunctionTypes(Time& time)
{
    const dictionary* functions = time.controlDict().findDict("functions");
    if (!functions || !time.functionObjects().status()) return;
    openLibraries(*functions, time);
    for (const entry& function : *functions) if (function.isDict()) openLibraries(function.dict(), time);
    for (const entry& function : *functions) if (function.isDict()) checkFunctionType(function.dict());
}

} // namespace nscdCoupling
} // namespace Foam
