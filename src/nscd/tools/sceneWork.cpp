// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One phrase for each choice.
#include "nscd/tools/sceneWork.hpp"

#include "nscd/kernels/sweepKernels.hpp"

namespace nscd
{

std::string describeWork(const Materials& materials, const GrainShape& shape, const ContactSettings& settings)
{
    const bool isFrictional = materials.anyFriction() || materials.anyRolling();
    const bool isPlanar = shape.dimensions == 2 && shape.emptyAxis >= 0;
    std::string work = chooseKernels(settings.vectorPath.c_str()).name;
    work += !isFrictional ? ", normal impulses only" : isPlanar ? ", discs in a plane" : ", friction";
    if (materials.anyRolling()) work += ", rolling or spinning friction";
    else work += ", isolated pairs beside the sweeps";
    if (materials.anyCohesion()) work += ", cohesion";
    work += materials.anyRestitution() ? ", restitution" : ", no restitution pass";
    if (settings.sleep) work += ", grains at rest may sleep";
    return work;
}

} // namespace nscd
