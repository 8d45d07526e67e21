// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The table of laws beside Coulomb's, a file each.
#include "nscd/contacts/contactLaw.hpp"

#include "nscd/contacts/contactList.hpp"
#include "nscd/contacts/laws/cohesion.hpp"
#include "nscd/contacts/laws/lubrication.hpp"
#include "nscd/contacts/laws/rollingFriction.hpp"
#include "nscd/contacts/wallForce.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

template<class Law>
std::unique_ptr<ContactLaw> make() { return std::make_unique<Law>(); }

double none(const Materials&) { return 0.0; }

} // namespace

void ContactLaw::addForces(const ContactList& list, const Scene& scene, double deltaT, ContactSums& sums) const
{
    for (std::size_t slot = 0; slot < list.slots(); ++slot)
    {
        const Vec3 onA = known(slot)/deltaT;
        if (onA == Vec3::Zero()) continue;
        const ContactBlock& block = list.blocks[slot/blockLanes];
        sums.force[block.a[slot % blockLanes]] += onA;
        if (list.wall[slot] >= 0) addWallForce(list, scene, slot, onA, sums.wall);
        else sums.force[block.b[slot % blockLanes]] -= onA;
    }
}

const std::vector<ContactLawRow>& contactLaws()
{
    static const std::vector<ContactLawRow> rows =
    {
        {
            "cohesion", nullptr, false, true, false, true,
            [](const Materials& m) { return m.anyCohesion(); }, [](const Materials& m) { return m.cohesionRange(); }, make<Cohesion>
        },
        {
            "rolling or spinning friction", "rolling", true, true, true, false,
            [](const Materials& m) { return m.anyRolling(); }, none, make<RollingFriction>
        },
        {
            "lubrication", nullptr, true, false, false, false,
            [](const Materials& m) { return m.anyRoughness(); }, [](const Materials& m) { return m.lubricationRange(); }, make<Lubrication>
        }
    };
    return rows;
}

std::vector<const ContactLawRow*> lawsInUse(const Materials& materials)
{
    std::vector<const ContactLawRow*> used;
    for (const ContactLawRow& row : contactLaws())
    {
        if (row.isUsed(materials)) used.push_back(&row);
    }
    return used;
}

double rangeOfLaws(const Materials& materials)
{
    double largest = 0.0;
    for (const ContactLawRow& row : contactLaws()) largest = std::max(largest, row.range(materials));
    return largest;
}

bool actsOnSpins(const Materials& materials)
{
    const std::vector<const ContactLawRow*> used = lawsInUse(materials);
    return materials.anyFriction() || std::any_of(used.begin(), used.end(), [](const ContactLawRow* row) { return row->isOfSpins; });
}

} // namespace nscd
