// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading constant/grainProperties, one function per sub-dictionary.
#include "coupling/case/input/grainProperties.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/foamSizes.H"
#include "coupling/case/input/heatReader.H"
#include "coupling/case/input/writtenGrains.H"
#include "coupling/mapping/voidFractionMethods.H"

#include "input/dictionary/withoutTraps.hpp"
#include "input/scene/materialReader.hpp"
#include "input/scene/motionReader.hpp"
#include "input/scene/sceneReader.hpp"

#include "Time.H"

#include <memory>

namespace Foam
{
namespace nscdCoupling
{

using input::CheckedEntries;

namespace
{

PatchRule readPatchRule(const CheckedEntries& patches, const input::Entry& entry, const GrainProperties& properties, int emptyAxis)
{
    const CheckedEntries given(patches.sub(entry.keyword));
    PatchRule rule;
    rule.patch = keyType(entry.keyword, entry.isQuoted ? keyType::REGEX : keyType::LITERAL);
    rule.place = patches.place(entry.keyword);
    rule.isExit = given.choice("type", {"wall", "exit"}) == "exit";
    if (!rule.isExit)
    {
        rule.material = input::readMaterialOfWall(given, properties);
        rule.surfaceMotion = input::readSurfaceMotion(given, emptyAxis);
        rule.torquePoint = toFoam(given.vec("torquePoint", input::unit::length, nscd::Vec3::Zero()));
    }
    given.finish();
    return rule;
}


void readPatches(const CheckedEntries& top, GrainProperties& properties, int emptyAxis)
{
    properties.patchesPlace = top.place("patches");
    const input::Dictionary list = top.subOrEmpty("patches");
    const CheckedEntries patches(list);
    for (const input::Entry& given : list.entries) properties.patchRules.push_back(readPatchRule(patches, given, properties, emptyAxis));
}


/// Discs at rest leave less between them than spheres, 0.16 of the area at random for 0.36 of the volume.
constexpr scalar minFluidFractionOfDiscs = 0.1;

VoidFractionSettings readVoidFraction(const CheckedEntries& top, const ::nscd::GrainShape& shape)
{
    const input::Dictionary dict = top.subOrEmpty("voidFraction");
    const CheckedEntries given(dict);
    VoidFractionSettings settings;
    settings.method = given.choice("method", toWords(voidFractionMethodNames()), settings.method);
    settings.diffusion = given.number("diffusion", input::atLeast(0), settings.diffusion);
    if (given.found("filterWidth")) settings.filterWidth = given.number("filterWidth", input::atLeast(0), 0);
    if (settings.diffusion > 0 && settings.filterWidth.value_or(0) > 0)
    {
        fail({given.place("filterWidth"), "says how much to smooth, as `diffusion` does beside it", messageText(*settings.filterWidth), "0 for one of the two"});
    }
    if (shape.dimensions == 2) settings.minFluidFraction = minFluidFractionOfDiscs;
    settings.minFluidFraction = given.number("minFluidFraction", input::within(0, 1), settings.minFluidFraction);
    given.finish();
    return settings;
}


/// Forces by their keyword, and whether they are on where a case does not say. What each is: coupling/step/forces.
const std::vector<std::pair<const char*, bool>> forceSwitches =
{
    {"pressureGradient", true},
    {"viscous", true},
    {"spinDrag", true},
    {"addedMass", false},
    {"basset", false},
    {"saffmanLift", false},
    {"magnusLift", false}
};


/// Model B has what the pressure gradient and the stress do to a grain in its drag, which no other force of the fluid has a like of.
void applyModelB(const CheckedEntries& given, ForceSettings& settings)
{
    for (const char* force : {"pressureGradient", "viscous"})
    {
        if (given.found(force) && settings.isOn(force)) given.reject(force, "belongs to model A; model B has it in the drag", "off, or no such entry");
        settings.switches[force].isOn = false;
    }
    for (const char* force : {"addedMass", "basset", "saffmanLift", "magnusLift"})
    {
        if (settings.isOn(force)) given.reject(force, "is not part of model B, which is defined for drag", "off, or model A");
    }
}


ForceSettings readForces(const CheckedEntries& top, const input::Surroundings& around)
{
    const input::Dictionary dict = top.subOrEmpty("forces");
    const CheckedEntries given(dict);
    ForceSettings settings;
    settings.drag = readDrag(given, around);
    settings.field = readField(given, around);
    settings.switches["field"] = {given.found("field"), given.place("field")};
    settings.switches["drag"] = {settings.drag.isOn(), given.place("drag")};
    for (const auto& [name, byDefault] : forceSwitches) settings.switches[name] = {given.flag(name, byDefault), given.place(name)};
    settings.switches["modelB"] = {given.choice("model", {"A", "B"}, "A") == "B", given.place("model")};
    if (settings.isOn("modelB")) applyModelB(given, settings);
    given.finish();
    return settings;
}


GrainTimeSettings readTimeSettings(const CheckedEntries& top)
{
    const input::Dictionary dict = top.subOrEmpty("timeStep");
    const CheckedEntries given(dict);
    GrainTimeSettings settings;
    settings.maxGrainDisplacement = given.number("maxGrainDisplacement", input::atLeast(0), settings.maxGrainDisplacement);
    settings.maxGrainImpacts = given.number("maxGrainImpacts", input::atLeast(0), settings.maxGrainImpacts);
    settings.subCycles = label(given.integer("subCycles", 1, settings.subCycles));
    given.finish();
    return settings;
}


scalar readMaxLoadImbalance(const CheckedEntries& top, scalar byDefault)
{
    const input::Dictionary dict = top.subOrEmpty("parallel");
    const CheckedEntries given(dict);
    const scalar largest = given.number("maxLoadImbalance", input::above(1), byDefault);
    given.finish();
    return largest;
}


void readCoupling(const CheckedEntries& top, const input::Surroundings& around, GrainProperties& properties)
{
    properties.hasFeedback = top.flag("feedback", properties.hasFeedback);
    properties.holdsMeanFlow = top.found("meanFlow");
    properties.meanFlowPlace = top.place("meanFlow");
    properties.meanFlow = toFoam(top.vec("meanFlow", input::unit::velocity, nscd::Vec3::Zero()));
    properties.voidFraction = readVoidFraction(top, around.shape);
    // Nothing is read of the solid fraction then.
    if (!properties.hasFeedback && !properties.voidFraction.filterWidth) properties.voidFraction.filterWidth = 0;
    properties.forces = readForces(top, around);
    if (properties.forces.isOn("modelB") && !properties.hasFeedback)
    {
        fail({properties.forces.switches["modelB"].place, "is a way to share the pressure gradient, and with `feedback off` the fluid feels no grains", "B", "A"});
    }
    properties.time = readTimeSettings(top);
    if (!top.foundAsSpelt("heat")) return;
    properties.heat = std::make_shared<HeatSettings>(readHeat(top, properties, properties.solvesFluid, properties.hasFeedback));
}

/// Steps of another length than the last one wake all: nothing sleeps where they are the rule.
void keepAwake(GrainProperties& properties, const std::string& reason)
{
    if (!properties.contact.sleep) return;
    properties.contact.sleep = false;
    properties.notes.push_back("grains at rest stay awake: " + reason);
}

GrainProperties readAll(const dictionary& dict, input::Surroundings around)
{
    const input::Dictionary entries = fromFoam(dict);
    const CheckedEntries top(entries);
    // Where users may keep values of their own, for use as $:variables.d.
    top.found("variables");
    GrainProperties properties;
    properties.solvesFluid = top.choice("fluid", {"solved", "none"}, "solved") == "solved";
    properties.shape = top.choice("shape", {"sphere", "disc"}, "");
    properties.shapePlace = top.place("shape");
    around.shape = chosenShape(around.shape, properties.shape);
    around.hasFluid = properties.solvesFluid;
    input::readScene(top, around, properties);
    readPatches(top, properties, around.shape.emptyAxis);
    properties.hasWalls = !top.subOrEmpty("walls").entries.empty();
    properties.maxLoadImbalance = readMaxLoadImbalance(top, properties.maxLoadImbalance);
    readCoupling(top, around, properties);
    top.finish();
    if (properties.solvesFluid && properties.time.mayCycle()) keepAwake(properties, "with subCycles the predicted step is longer than theirs");
    return properties;
}

std::string inFolder(const fileName& path, const fileName& folder) { return path.isAbsolute() ? path : folder/path; }

/// Files that it includes may hold numbers that overflow.
std::unique_ptr<IOdictionary> readWithoutTraps(const IOobject& io)
{
    const input::WithoutTraps traps;
    return std::make_unique<IOdictionary>(io);
}

} // namespace


dictionary VoidFractionSettings::forMapping(scalar meanDiameter, scalar cellSize) const
{
    // Cells of just that size are not small on any number of ranks, which sum their volumes in other orders.
    constexpr scalar small = 1.75, thin = 0.5, roundOff = 1e-6;
    dictionary dict("voidFraction");
    dict.add("method", word(method));
    dict.add("minFluidFraction", minFluidFraction);
    dict.add("diffusionLength", diffusion*meanDiameter);
    if (diffusion > 0) return dict;
    dict.add("filterWidth", chosenWidth()*meanDiameter);
    if (!filterWidth && cellSize >= (1 - roundOff)*small*meanDiameter) dict.add("thinCell", thin*meanDiameter);
    return dict;
}


dictionary GrainProperties::meanFlowDict() const
{
    dictionary dict("meanFlow");
    if (holdsMeanFlow) dict.add("target", meanFlow);
    return dict;
}


::nscd::GrainShape chosenShape(::nscd::GrainShape byMesh, const std::string& word)
{
    if (word == "sphere") byMesh.dimensions = 3;
    return byMesh;
}


bool correctsOwnWake(const GrainProperties& properties, const ::nscd::GrainShape& shape)
{
    const ForceSettings& forces = properties.forces;
    return properties.solvesFluid && properties.hasFeedback && forces.isOn("drag") && forces.drag.correctsOwnWake && shape.emptyAxis < 0;
}


input::Surroundings foamSurroundings(const fileName& casePath)
{
    const fileName constant = casePath/"constant";
    input::Surroundings around;
    around.pathOfGrains = [=](const std::string& path) { return inFolder(path, constant); };
    around.pathOfSurface = [=](const std::string& path)
    {
        return inFolder(path, path.find('/') == std::string::npos ? constant/"triSurface" : casePath);
    };
    around.nRanks = Pstream::nProcs();
    around.sleepsByDefault = false;
    around.hasCoarseGrains = true;
    around.sizeModels = foamSizeModels();
    around.grainsOfTime = [casePath](const input::GrainSource& source, const input::MaterialTable& materials)
    {
        return grainsOfTime(casePath, source, materials);
    };
    return around;
}


GrainProperties readGrainProperties(const dictionary& dict, const input::Surroundings& around)
{
    return toldByFoam([&] { return readAll(dict, around); });
}


GrainProperties readGrainProperties(const Time& time, const input::Surroundings& around)
{
    const IOobject io("grainProperties", time.constant(), time, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    checkText(io);
    const std::unique_ptr<IOdictionary> dict = readWithoutTraps(io);
    GrainProperties properties = readGrainProperties(*dict, around);
    if (time.controlDict().getOrDefault<bool>("adjustTimeStep", false)) keepAwake(properties, "adjustTimeStep changes the time step");
    return properties;
}

} // namespace nscdCoupling
} // namespace Foam
