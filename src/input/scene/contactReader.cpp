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

std::string readSolver(const CheckedEntries& given, const std::string& usual, const nscd::Materials& materials, bool hasClumps, int nRanks)
{
    Words words, onRanks;
    for (const nscd::ContactSolverRow& row : nscd::contactSolvers())
    {
        words.push_back(row.name);
        if (row.worksOnRanks) onRanks.push_back(row.name);
    }
    const std::string solver = given.choice("type", words, usual);
    if (nRanks > 1 && !nscd::findContactSolver(solver).worksOnRanks) given.reject("type", "works on one rank only", "", onRanks);
    if (hasClumps && solver != "NLGS") given.reject("type", "knows no clumps", "NLGS");
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

void checkLawsOfClumps(const MaterialTable& materials)
{
    for (const nscd::ContactLawRow* law : nscd::lawsInUse(materials.table))
    {
        if (law->isOfClumps) continue;
        throw InputError({materials.contactsPlace, std::string("has ") + law->words + ", which contacts of clumps do not know", "", "none beside clumps"});
    }
}

/// Laws that stand beside no others, or not in every space.
void checkLubrication(const MaterialTable& materials, bool areDiscs)
{
    if (!materials.table.anyRoughness()) return;
    const auto refuse = [&](const char* what, const char* allowed) { throw InputError({materials.contactsPlace, what, "", allowed}); };
    if (areDiscs) refuse("has a roughness, and the films of lubrication are those between spheres", "none between discs");
    if (materials.table.anyRolling()) refuse("has a roughness beside rolling or spinning friction, which are not solved together", "one of the two");
}

bool readSleep(const CheckedEntries& given, const Surroundings& around, Scene& scene)
{
    const bool isOn = given.flag("sleep", around.sleepsByDefault);
    const bool areLubricated = scene.materials.table.anyRoughness();
    if (isOn && areLubricated) scene.notes.push_back("grains at rest stay awake: films of fluid between them do not sleep");
    return isOn && !areLubricated;
}

} // namespace

void readContactSettings(const CheckedEntries& top, const Surroundings& around, Scene& scene)
{
    const Dictionary dict = top.subOrEmpty("solver");
    const CheckedEntries given(dict);
    nscd::ContactSettings& s = scene.contact;
    s.solver = readSolver(given, s.solver, scene.materials.table, scene.hasClumps(), around.nRanks);
    if (scene.hasClumps()) checkLawsOfClumps(scene.materials);
    checkLubrication(scene.materials, around.shape.dimensions == 2);
    s.tolerance = given.number("tolerance", above(0), s.tolerance);
    s.displacementTolerance = given.number("displacementTolerance", above(0), s.displacementTolerance);
    s.forceTolerance = given.number("forceTolerance", above(0), s.forceTolerance);
    s.maxSweeps = static_cast<int>(given.integer("maxSweeps", 1, s.maxSweeps));
    s.deadBand = given.number("deadBand", atLeast(0), s.deadBand);
    s.overlapTolerance = given.number("overlapTolerance", above(0), s.overlapTolerance);
    s.skin = given.number("skin", atLeast(0), s.skin);
    s.accelerate = given.flag("accelerate", s.accelerate);
    s.sleep = readSleep(given, around, scene);
    s.vectorPath = readVectorPath(given, s.vectorPath);
    given.finish();
}

} // namespace input
