// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Calling the readers in the order of what they need.
#include "input/scene/sceneReader.hpp"

#include "input/scene/contactReader.hpp"
#include "input/scene/drivenReader.hpp"
#include "input/scene/materialReader.hpp"
#include "input/scene/sourceReader.hpp"
#include "input/scene/wallReader.hpp"

#include <algorithm>

namespace input
{

bool Scene::hasClumps() const
{
    return std::any_of(sources.begin(), sources.end(), [](const GrainSource& source) { return !source.clump.members.empty(); });
}

void readScene(const CheckedEntries& top, const Surroundings& around, Scene& scene)
{
    scene.materials = readMaterials(top, around.hasFluid);
    scene.wallMaterial = readWallMaterial(top, scene.materials);
    readWalls(top, around, scene);
    readSources(top, around, scene);
    scene.driven = readDriven(top, around.shape.emptyAxis);
    readContactSettings(top, around, scene);
}

} // namespace input
