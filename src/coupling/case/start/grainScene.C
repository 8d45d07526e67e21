// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Setting the scene for the grains.
#include "coupling/case/input/materialsReader.H"
#include "coupling/case/start/grainScene.H"
#include "coupling/case/start/initialChecks.H"
#include "coupling/case/walls/meshWalls.H"

#include "Time.H"

#include <set>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

void checkPairsThatMeet
(
    const GrainProperties& properties, const nscd::Grains& grains, const nscd::Walls& walls, const nscd::Exchange& exchange
)
{
    std::vector<double> isUsed(properties.materials.table.size(), 0.0);
    for (int material : grains.material) isUsed[material] = 1.0;
    exchange.max(isUsed.data(), static_cast<int>(isUsed.size()));
    std::set<int> ofGrains, ofWalls;
    for (std::size_t material = 0; material < isUsed.size(); ++material)
    {
        if (isUsed[material] > 0.0) ofGrains.insert(static_cast<int>(material));
    }
    for (const nscd::WallPatch& patch : walls.patches) ofWalls.insert(patch.material);
    checkPairs
    (
        properties.materials,
        std::vector<int>(ofGrains.begin(), ofGrains.end()), std::vector<int>(ofWalls.begin(), ofWalls.end())
    );
}

} // namespace


vector readGravity(const Time& time)
{
    const uniformDimensionedVectorField g
    (
        IOobject("g", time.constant(), time, IOobject::MUST_READ, IOobject::NO_WRITE, false)
    );
    if (g.dimensions() != dimAcceleration)
    {
        fail
        ({
            placeInDictionaryFile(g.objectPath(), "dimensions"), "has wrong dimensions",
            messageText(g.dimensions()), "[0 1 -2 0 0 0 0]"
        });
    }
    return g.value();
}


GrainScene makeGrainScene(const GrainProperties& properties, const polyMesh& mesh, const vector& gravity)
{
    checkTimeControls(mesh.time());
    GrainScene scene;
    scene.space = grainSpace(properties, mesh);
    checkGravity(gravity, scene.space, mesh.time());
    scene.roles = assignPatchRoles(properties, mesh);
    scene.walls = makeMeshWalls(properties, scene.roles, mesh);
    scene.box = periodicBox(mesh);
    checkMeanFlow(properties, scene.box);
    return scene;
}


nscd::Grains makeFirstGrains
(
    const GrainProperties& properties, const GrainScene& scene, const polyMesh& mesh, nscd::Exchange& exchange
)
{
    nscd::Grains grains;
    grains.shape = scene.space.shape;
    HomeRanks homes(mesh);
    const auto keep = [&](nscd::Grains& batch)
    {
        for (nscd::Vec3& x : batch.position) x = scene.box.wrap(x);
        homes.keepOwn(batch);
        appendGrains(grains, batch);
    };
    placeGrains(properties, scene.space, mesh.time().globalPath()/mesh.time().constant(), keep);
    homes.checkNoneOutside();
    checkPairsThatMeet(properties, grains, scene.walls, exchange);
    checkPeriods(scene.box, grains, mesh);
    checkOverlaps(grains, scene.box, scene.walls, properties.maxInitialOverlap, properties.overlapPlace, exchange);
    return grains;
}


nscd::Grains makeFirstGrains(const GrainProperties& properties, const GrainScene& scene, const polyMesh& mesh)
{
    nscd::Exchange alone;
    return makeFirstGrains(properties, scene, mesh, alone);
}

} // namespace nscdCoupling
} // namespace Foam
