// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The force of a contact on its wall, and its torque.
#include "nscd/contacts/wallForce.hpp"

namespace nscd
{

void addWallForce(const ContactList& list, const Scene& scene, std::size_t slot, const Vec3& onGrain, std::vector<Vec3>& wall)
{
    const std::size_t patch = scene.walls.regions[list.wall[slot]].patch;
    const int a = list.blocks[slot/blockLanes].a[slot % blockLanes];
    const Vec3 point = scene.box.wrap(list.position[a]) - (list.radius[a] + list.gap[slot])*normal(list, slot);
    wall[patch] -= onGrain;
    wall[scene.walls.patches.size() + patch] -= (point - scene.walls.patches[patch].torquePoint).cross(onGrain);
}

} // namespace nscd
