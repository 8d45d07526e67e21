// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ways of walls.
#include "nscd/step/groupMotion.hpp"

namespace nscd
{

GroupMotion::GroupMotion(const ContactList& list, const WallsOfStep& walls, int number)
:
    group(number),
    isMoving(walls.search.patchOf(number) >= 0),
    now(isMoving ? walls.scene.walls.patches[walls.search.patchOf(number)].pose : WallPose::Identity()),
    next(isMoving ? walls.moving.next(walls.search.patchOf(number)) : WallPose::Identity()),
    way(isMoving ? largestDisplacement(now, next, walls.search.outlined(number)) : 0.0),
    wayFromBuild(0.0)
{
    // While grains sleep nothing moves.
    if (!isMoving || list.wallReach.empty()) return;
    wayFromBuild = largestDisplacement(list.wallReach[walls.search.patchOf(number)].poseAtBuild, next, walls.search.outlined(number));
}

std::vector<GroupMotion> motionsOf(const ContactList& list, const WallsOfStep& walls)
{
    std::vector<GroupMotion> motions;
    for (int group = 0; group < walls.search.groups(); ++group)
    {
        if (!walls.search.outlined(group).isEmpty()) motions.emplace_back(list, walls, group);
    }
    return motions;
}

} // namespace nscd
