// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One phrase for each choice.
#include "nscd/tools/sceneWork.hpp"

#include "nscd/contacts/contactLaw.hpp"
#include "nscd/kernels/sweepKernels.hpp"

namespace nscd
{

std::string describeWork(const Materials& materials, const GrainShape& shape, const ContactSettings& settings)
{
    std::string work = chooseKernels(settings.vectorPath.c_str()).name;
    work += !actsOnSpins(materials) ? ", normal impulses only" : shape.emptyAxis < 0 ? ", friction" : shape.dimensions == 2 ? ", discs in a plane" : ", spheres in a plane";
    for (const ContactLawRow* law : lawsInUse(materials)) work += ", " + std::string(law->words);
    work += materials.anyRestitution() ? ", restitution" : ", no restitution pass";
    if (settings.sleep) work += ", grains at rest may sleep";
    return work;
}

} // namespace nscd
