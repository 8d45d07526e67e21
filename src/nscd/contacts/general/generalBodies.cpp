// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Members and velocities of general bodies.
#include "nscd/contacts/general/generalBodies.hpp"

#include <algorithm>

namespace nscd
{

int GeneralBodies::representative(int body) const
{
    int at = member(body);
    if (at < 0) return body;
    while (at > 0 && members[at - 1].owner == members[at].owner) --at;
    return members[at].body;
}

std::pair<std::size_t, std::size_t> GeneralBodies::besides(std::size_t number) const
{
    std::size_t first = number, end = number + 1;
    while (first > 0 && members[first - 1].owner == members[number].owner) --first;
    while (end < ownMembers && members[end].owner == members[number].owner) ++end;
    return {first, end};
}

GeneralHalo::Motions GeneralBodies::velocities() const
{
    GeneralHalo::Motions values;
    values.reserve(GeneralHalo::width*bodies.size());
    for (const GeneralBody& body : bodies)
    {
        values.insert(values.end(), body.v.data(), body.v.data() + 3);
        values.insert(values.end(), body.omega.data(), body.omega.data() + 3);
    }
    return values;
}

void GeneralBodies::setVelocities(const GeneralHalo::Motions& velocities)
{
    const double* from = velocities.data();
    for (GeneralBody& body : bodies)
    {
        body.v = Vec3(from);
        body.omega = Vec3(from + 3);
        from += GeneralHalo::width;
    }
}

void GeneralBodies::giveBodies()
{
    if (!halo.isParallel()) return;
    halo.giveBodies(bodies);
    given_ = velocities();
}

void GeneralBodies::giveVelocities()
{
    if (!halo.isParallel()) return;
    given_ = velocities();
    halo.give(given_);
    setVelocities(given_);
}

void GeneralBodies::takeVelocities()
{
    if (!halo.isParallel()) return;
    GeneralHalo::Motions now = velocities();
    halo.take(now, given_);
    setVelocities(now);
}

} // namespace nscd
