// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading constant/grainProperties, one function per sub-dictionary.
#include "coupling/case/input/dictionaryCheck.H"
#include "coupling/case/input/grainProperties.H"
#include "coupling/case/input/grainSourceReader.H"
#include "coupling/case/input/materialsReader.H"
#include "coupling/mapping/voidFractionMethods.H"

#include "closures/dragLaws.hpp"
#include "nscd/contacts/contactLaw.hpp"
#include "nscd/kernels/sweepKernels.hpp"
#include "nscd/solvers/contactSolver.hpp"

#include "Time.H"
#include "dimensionSets.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

PatchRule readPatchRule(const CheckedDict& patches, const keyType& name, const GrainProperties& properties)
{
    const CheckedDict given(patches.sub(name));
    PatchRule rule;
    rule.patch = name;
    rule.place = patches.place(name);
    rule.isExit = given.choice("type", {"wall", "exit"}) == "exit";
    if (!rule.isExit)
    {
        const bool mayInherit = properties.wallMaterial >= 0 && !given.found("material");
        rule.material = mayInherit ? properties.wallMaterial : readMaterial(given, "material", properties.materials);
        rule.surfaceMotion = readSurfaceMotion(given);
        rule.torquePoint = given.vec("torquePoint", dimLength, Zero);
    }
    given.finish();
    return rule;
}


void readPatches(const CheckedDict& top, GrainProperties& properties)
{
    properties.patchesPlace = top.place("patches");
    if (top.found("wallMaterial"))
    {
        properties.wallMaterial = readMaterial(top, "wallMaterial", properties.materials);
    }
    else if (properties.materials.table.size() == 1)
    {
        properties.wallMaterial = 0;
    }

    const dictionary list = top.subOrEmpty("patches");
    const CheckedDict patches(list);
    for (const entry& given : list)
    {
        properties.patchRules.push_back(readPatchRule(patches, given.keyword(), properties));
    }
}


void readPlanes(const CheckedDict& top, GrainProperties& properties)
{
    const dictionary list = top.subOrEmpty("planes");
    const CheckedDict planes(list);
    for (const entry& entryOfPlane : list)
    {
        const CheckedDict given(planes.sub(entryOfPlane.keyword()));
        PlaneWall plane;
        plane.name = entryOfPlane.keyword();
        plane.point = given.vec("point", dimLength);
        plane.normal = given.vec("normal", dimless);
        if (mag(plane.normal) <= 0) given.reject("normal", "has no length", "a vector towards the grains, as (0 0 1)");
        const bool mayInherit = properties.wallMaterial >= 0 && !given.found("material");
        plane.material = mayInherit ? properties.wallMaterial : readMaterial(given, "material", properties.materials);
        given.finish();
        properties.planes.push_back(plane);
    }
}


Words solverWords()
{
    Words words;
    for (const nscd::ContactSolverRow& row : nscd::contactSolvers()) words.push_back(row.name);
    return words;
}


nscd::ContactSettings readContactSettings(const CheckedDict& top, const nscd::Materials& materials, bool solvesFluid)
{
    const dictionary dict = top.subOrEmpty("solver");
    const CheckedDict given(dict);
    nscd::ContactSettings s;
    s.solver = given.choice("type", solverWords(), s.solver);
    if (Pstream::parRun() && !nscd::findContactSolver(s.solver).worksOnRanks) given.reject("type", "works on one rank only", "NLGS or NNCG");
    for (const nscd::ContactLawRow* law : nscd::lawsInUse(materials))
    {
        if (law->isSwept && s.solver != "NLGS") given.reject("type", "knows no " + string(law->words), "NLGS");
    }
    s.tolerance = given.number("tolerance", above(0), dimless, s.tolerance);
    s.displacementTolerance = given.number("displacementTolerance", above(0), dimless, s.displacementTolerance);
    s.maxSweeps = given.integer("maxSweeps", 1, s.maxSweeps);
    s.deadBand = given.number("deadBand", atLeast(0), dimless, s.deadBand);
    s.overlapTolerance = given.number("overlapTolerance", above(0), dimless, s.overlapTolerance);
    s.skin = given.number("skin", atLeast(0), dimless, s.skin);
    s.accelerate = given.flag("accelerate", s.accelerate);
    s.sleep = given.flag("sleep", !solvesFluid);
    if (s.sleep && solvesFluid) given.reject("sleep", "is for runs without a fluid, which moves all grains", "off");
    s.vectorPath = given.choice("vectorPath", {"auto", "portable", "AVX2", "AVX512"}, s.vectorPath);
    try
    {
        nscd::chooseKernels(s.vectorPath.c_str());
    }
    catch (const std::invalid_argument& error)
    {
        given.reject("vectorPath", "is not for this processor: " + string(error.what()), "auto");
    }
    given.finish();
    return s;
}


VoidFractionSettings readVoidFraction(const CheckedDict& top)
{
    const dictionary dict = top.subOrEmpty("voidFraction");
    const CheckedDict given(dict);
    VoidFractionSettings settings;
    settings.method = given.choice("method", toWords(voidFractionMethodNames()), settings.method);
    settings.diffusion = given.number("diffusion", atLeast(0), dimless, settings.diffusion);
    settings.minFluidFraction =
        given.number("minFluidFraction", Range{0, 1, false, false}, dimless, settings.minFluidFraction);
    given.finish();
    return settings;
}


Words dragWords()
{
    Words words = {"none"};
    for (const closures::DragLawRow& row : closures::dragLaws())
    {
        words.push_back(row.name);
        if (row.alias[0]) words.push_back(row.alias);
    }
    return words;
}


/// Forces by their keyword, and whether they are on where a case does not say. What each is: coupling/step/forces.
const std::vector<std::pair<const char*, bool>> forceSwitches =
{
    {"pressureGradient", true},
    {"viscous", true},
    {"spinDrag", true},
    {"saffmanLift", false},
    {"magnusLift", false}
};


ForceSettings readForces(const CheckedDict& top)
{
    const dictionary dict = top.subOrEmpty("forces");
    const CheckedDict given(dict);
    ForceSettings settings;
    const dictionary dragDict = given.subOrEmpty("drag");
    const CheckedDict drag(dragDict);
    settings.dragLaw = drag.choice("law", dragWords(), settings.dragLaw);
    settings.dragWeight = drag.choice("weight", {"exponential", "backwardEuler"}, settings.dragWeight);
    drag.finish();
    settings.switches["drag"] = {settings.dragLaw != "none", given.place("drag")};
    for (const auto& [name, byDefault] : forceSwitches) settings.switches[name] = {given.flag(name, byDefault), given.place(name)};
    given.finish();
    return settings;
}


GrainTimeSettings readTimeSettings(const CheckedDict& top)
{
    const dictionary dict = top.subOrEmpty("timeStep");
    const CheckedDict given(dict);
    GrainTimeSettings settings;
    settings.maxGrainDisplacement =
        given.number("maxGrainDisplacement", atLeast(0), dimless, settings.maxGrainDisplacement);
    settings.subCycles = given.integer("subCycles", 1, settings.subCycles);
    given.finish();
    return settings;
}


scalar readMaxLoadImbalance(const CheckedDict& top, scalar byDefault)
{
    const dictionary dict = top.subOrEmpty("parallel");
    const CheckedDict given(dict);
    const scalar largest = given.number("maxLoadImbalance", above(1), dimless, byDefault);
    given.finish();
    return largest;
}


void readCoupling(const CheckedDict& top, GrainProperties& properties)
{
    properties.solvesFluid = top.choice("fluid", {"solved", "none"}, "solved") == "solved";
    properties.hasFeedback = top.flag("feedback", properties.hasFeedback);
    properties.holdsMeanFlow = top.found("meanFlow");
    properties.meanFlowPlace = top.place("meanFlow");
    properties.meanFlow = top.vec("meanFlow", dimVelocity, Zero);
    properties.voidFraction = readVoidFraction(top);
    properties.forces = readForces(top);
    properties.time = readTimeSettings(top);
}

} // namespace


dictionary VoidFractionSettings::forMapping(scalar meanDiameter) const
{
    dictionary dict("voidFraction");
    dict.add("method", word(method));
    dict.add("diffusionLength", diffusion*meanDiameter);
    dict.add("minFluidFraction", minFluidFraction);
    return dict;
}


dictionary GrainProperties::meanFlowDict() const
{
    dictionary dict("meanFlow");
    if (holdsMeanFlow) dict.add("target", meanFlow);
    return dict;
}


GrainProperties readGrainProperties(const dictionary& dict)
{
    const CheckedDict top(dict);
    // Where users may keep values of their own, for use as $:variables.d.
    top.found("variables");
    GrainProperties properties;
    properties.materials = readMaterials(top);
    readPatches(top, properties);
    readPlanes(top, properties);
    properties.walls = readWalls(top, properties);
    readSources(top, properties);
    properties.driven = readDriven(top);
    properties.contact = readContactSettings(top, properties.materials.table, properties.solvesFluid);
    properties.maxLoadImbalance = readMaxLoadImbalance(top, properties.maxLoadImbalance);
    readCoupling(top, properties);
    top.finish();
    return properties;
}


GrainProperties readGrainProperties(const Time& time)
{
    return readGrainProperties
    (
        IOdictionary
        (
            IOobject("grainProperties", time.constant(), time, IOobject::MUST_READ, IOobject::NO_WRITE, false)
        )
    );
}

} // namespace nscdCoupling
} // namespace Foam
