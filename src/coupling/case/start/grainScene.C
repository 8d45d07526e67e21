// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Setting the scene for the grains.
#include "coupling/case/start/grainScene.H"

#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/foamPositions.H"
#include "coupling/case/start/initialChecks.H"
#include "coupling/case/walls/meshWalls.H"

#include "input/dictionary/quantity.hpp"
#include "input/start/placement.hpp"

#include "Random.H"
#include "dynamicFvMesh.H"
#include "Time.H"

#include <limits>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

constexpr std::size_t grainsInBatch = 10000;

nscd::RandomNumbers foamRandom(std::uint64_t seed)
{
    return [random = Random(label(seed))]() mutable { return random.sample01<scalar>(); };
}

/// The walls of the mesh come first. Where there will be no grains, walls may do what they like.
void addMovingWalls(GrainScene& scene, const GrainProperties& properties, const polyMesh& mesh)
{
    const pointField rest = pointsAtRest(mesh);
    scene.walls = makeMeshWalls(properties, scene.roles, mesh, rest);
    const labelList walls = properties.hasAnySource() ? scene.roles.ofRole(PatchRole::wall) : labelList();
    scene.movingPatches = std::make_shared<MovingPatches>(mesh, walls, rest);
    for (label k = 0; k < walls.size(); ++k) scene.walls.setMotion(int(k), motionOf(scene.movingPatches, std::size_t(k)));
    nscd::moveWalls(scene.walls, mesh.time().value());
}

} // namespace


vector readGravity(const Time& time)
{
    const IOobject file("g", time.constant(), time, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    checkText(file);
    const uniformDimensionedVectorField g(file);
    if (g.dimensions() != dimAcceleration)
    {
        fail
        ({
            placeInDictionaryFile(g.objectPath(), "dimensions"), "has wrong dimensions",
            messageText(g.dimensions()), "[0 1 -2 0 0 0 0]"
        });
    }
    if (!(cmptMax(cmptMag(g.value())) <= input::largestNumber))
    {
        const string allowed = messageText("numbers up to ", input::largestNumber);
        fail({placeInDictionaryFile(g.objectPath(), "value"), "is too large", messageText(g.value()), allowed});
    }
    return g.value();
}


GrainScene makeGrainScene(const GrainProperties& properties, const polyMesh& mesh, const vector& gravity)
{
    checkTimeControls(mesh.time());
    GrainScene scene;
    scene.space = grainSpace(properties, mesh);
    checkShape(properties, mesh);
    checkGravity(gravity, scene.space, mesh.time());
    scene.roles = assignPatchRoles(properties, mesh);
    if (isA<dynamicFvMesh>(mesh)) addMovingWalls(scene, properties, mesh);
    else scene.walls = makeMeshWalls(properties, scene.roles, mesh);
    scene.box = periodicBox(mesh);
    checkMeanFlow(properties, scene.box);
    return scene;
}


nscd::Grains makeFirstGrains
(
    const GrainProperties& properties, const GrainScene& scene, const polyMesh& mesh, nscd::Exchange& exchange,
    input::PlacedFactors* factors
)
{
    nscd::Grains grains;
    grains.shape = scene.space.shape;
    HomeRanks homes(mesh);
    const auto keep = [&](nscd::Grains& batch)
    {
        homes.keepOwn(batch);
        // Clumps come in one batch with all that there is, and their shapes stand on all ranks.
        if (batch.clumps.shapes.empty()) grains.append(batch);
        else grains = batch;
    };
    input::Surroundings around = surroundingsIn(mesh);
    around.shape = scene.space.shape;
    const auto tell = [](const std::string& line) { Info<< line.c_str() << nl; };
    input::PlacementTools tools = {foamRandom, readFoamPositions, grainsInBatch, &scene.walls, tell, factors};
    if (properties.hasClumps()) tools.grainsInBatch = std::numeric_limits<std::size_t>::max();
    toldByFoam([&] { input::placeGrains(properties, around, tools, keep); });
    homes.checkNoneOutside();
    checkGrains(grains, scene, properties, mesh, exchange);
    checkOverlaps(grains, scene, properties, exchange);
    return grains;
}


nscd::Grains makeFirstGrains(const GrainProperties& properties, const GrainScene& scene, const polyMesh& mesh)
{
    nscd::Exchange alone;
    return makeFirstGrains(properties, scene, mesh, alone);
}

} // namespace nscdCoupling
} // namespace Foam
