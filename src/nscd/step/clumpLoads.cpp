// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Loads of clumps, by the motion that they would make.
#include "nscd/step/clumpLoads.hpp"

namespace nscd
{

bool isSmall(const Grains& grains, int clump, const ClumpLoad& load, double speed, double deltaT)
{
    const ClumpShape& shape = grains.clumps.shapeOf(clump);
    const double force = speed*shape.mass/deltaT;
    if (!(load.force.squaredNorm() <= force*force)) return false;
    if (load.torque == Vec3::Zero()) return true;
    const Vec3 torque = grains.clumps.orientation[clump].conjugate()*load.torque, turn = deltaT*(shape.inertia.inverse()*torque);
    const double limit = speed/grains.shape.inertiaFactor();
    for (const Ball& member : shape.members)
    {
        if (!(turn.cross(member.center).norm() + member.radius*turn.norm() <= limit)) return false;
    }
    return true;
}

} // namespace nscd
