// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Contact lists of test scenes, to be looked into.
#pragma once

#include "nscd/contacts/contactGeometry.hpp"
#include "nscd/contacts/contactList.hpp"
#include "nscd/search/wallSearch.hpp"
#include "unit/nscd/scenes/scenes.hpp"

#include <random>

namespace scenes
{

inline nscd::Scene partsOf(const Scene& scene) { return {scene.grains, scene.materials, scene.walls, scene.box}; }

inline double meanDiameter(const Scene& scene)
{
    double sum = 0.0;
    for (double r : scene.grains.radius) sum += 2*r;
    return sum/static_cast<double>(scene.grains.size());
}

/// The list of a scene in which each grain may travel `reach`, with its geometry.
inline nscd::ContactList listContacts(const Scene& scene, double reach)
{
    nscd::Exchange alone;
    const double diameter = meanDiameter(scene);
    const nscd::WallSearch wallSearch(scene.walls, 2*diameter);
    const std::vector<double> reaches(scene.grains.size(), reach);
    nscd::ContactList list = nscd::buildContactList(partsOf(scene), wallSearch, reaches, {}, diameter, alone);
    nscd::updateGeometry(list, partsOf(scene));
    return list;
}

/// The two bodies of a slot.
inline std::pair<int, int> bodiesOf(const nscd::ContactList& list, std::size_t slot)
{
    const nscd::ContactBlock& block = list.blocks[slot/nscd::blockLanes];
    return {block.a[slot % nscd::blockLanes], block.b[slot % nscd::blockLanes]};
}

inline std::vector<std::size_t> usedSlots(const nscd::ContactList& list)
{
    std::vector<std::size_t> used;
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        if (list.isUsed(slot)) used.push_back(slot);
    }
    return used;
}

inline int bodyOf(const nscd::ContactList& list, int grain)
{
    return static_cast<int>(std::find(list.grainOf.begin(), list.grainOf.end(), grain) - list.grainOf.begin());
}

inline void setVelocity(nscd::ContactList& list, int grain, const Vec3& v)
{
    for (int k = 0; k < 3; ++k) list.bodies[bodyOf(list, grain)].v[k] = v[k];
}

/// Grains of several sizes at random in a cube that is periodic along x and y, above a floor; some overlap.
inline Scene cloud(int grains)
{
    Scene scene(3, 0.3, 0.0);
    scene.box.length = Vec3(1, 1, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < grains; ++i) scene.addGrain(Vec3(unit(random), unit(random), unit(random)), 0.03*(1 + unit(random)));
    return scene;
}

} // namespace scenes
