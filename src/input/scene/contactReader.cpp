// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading the contact settings.
#include "input/scene/contactReader.hpp"

#include "nscd/contacts/contactLaw.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/contactSolver.hpp"

namespace input
{

namespace
{

std::string readSolver(const CheckedEntries& given, const std::string& usual, const nscd::Materials& materials, int nRanks)
{
    Words words, onRanks;
    for (const nscd::ContactSolverRow& row : nscd::contactSolvers())
    {
        words.push_back(row.name);
        if (row.worksOnRanks) onRanks.push_back(row.name);
    }
    const std::string solver = given.choice("type", words, usual);
    if (nRanks > 1 && !nscd::findContactSolver(solver).worksOnRanks) given.reject("type", "works on one rank only", "", onRanks);
    for (const nscd::ContactLawRow* law : nscd::lawsInUse(materials))
    {
        if (law->isSwept && solver != "NLGS") given.reject("type", std::string("knows no ") + law->words, "NLGS");
    }
    return solver;
}

std::string readVectorPath(const CheckedEntries& given, const std::string& usual)
{
    const std::string path = given.choice("vectorPath", {"auto", "portable", "AVX2", "AVX512"}, usual);
    try
    {
        nscd::chooseKernels(path.c_str());
    }
    catch (const std::invalid_argument& error)
    {
        given.reject("vectorPath", std::string("is not for this processor: ") + error.what(), "auto");
    }
    return path;
}

} // namespace

nscd::ContactSettings readContactSettings(const CheckedEntries& top, const nscd::Materials& materials, const Surroundings& around)
{
    const Dictionary dict = top.subOrEmpty("solver");
    const CheckedEntries given(dict);
    nscd::ContactSettings s;
    s.solver = readSolver(given, s.solver, materials, around.nRanks);
    s.tolerance = given.number("tolerance", above(0), s.tolerance);
    s.displacementTolerance = given.number("displacementTolerance", above(0), s.displacementTolerance);
    s.maxSweeps = static_cast<int>(given.integer("maxSweeps", 1, s.maxSweeps));
    s.deadBand = given.number("deadBand", atLeast(0), s.deadBand);
    s.overlapTolerance = given.number("overlapTolerance", above(0), s.overlapTolerance);
    s.skin = given.number("skin", atLeast(0), s.skin);
    s.accelerate = given.flag("accelerate", s.accelerate);
    s.sleep = given.flag("sleep", around.sleepsByDefault);
    if (s.sleep && around.hasFluid) given.reject("sleep", "is for runs without a fluid, which moves all grains", "off");
    s.vectorPath = readVectorPath(given, s.vectorPath);
    given.finish();
    return s;
}

} // namespace input
