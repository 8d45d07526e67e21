// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Arms, Delassus operators and impulses of general contacts.
#include "nscd/contacts/generalSlots.hpp"

#include "nscd/contacts/general/generalMoments.hpp"
#include "nscd/contacts/general/generalSweep.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// Delassus operator of one side.
Eigen::Matrix3d mobility(const ContactList& list, int owner, const Vec3& arm, int body, const Vec3& n)
{
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    if (owner < 0) return list.bodies[body].invMass*one + list.bodies[body].invSpin*(one - n*n.transpose());
    const Eigen::Matrix3d cross = crossMatrix(arm);
    return list.general.bodies[owner].invMass*one - cross*list.general.bodies[owner].invInertia*cross;
}

/// General body, if any, and arm of a contact with a body whose surface it touches at `side` R n from the body's center.
void setSide(const ContactList& list, int body, const Vec3& toContact, int& owner, Vec3& arm)
{
    const int member = list.general.member(body);
    owner = member >= 0 ? list.general.members[member].owner : -1;
    arm = member >= 0 ? Vec3(list.general.members[member].arm + list.radius[body]*toContact) : Vec3(Vec3::Zero());
}

void setOperator(ContactList& list, std::size_t slot)
{
    ContactBlock& block = list.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    GeneralSlot& contact = list.general.slots[slot - list.general.firstBlock*blockLanes];
    const Vec3 n = normal(list, slot);
    setSide(list, block.a[lane], -n, contact.ownerA, contact.armA);
    setSide(list, block.b[lane], n, contact.ownerB, contact.armB);
    if (slot/blockLanes >= list.general.firstInterface && contact.ownerA >= 0) contact.ownerA = list.general.halo.inInterface(contact.ownerA);
    contact.w = mobility(list, contact.ownerA, contact.armA, block.a[lane], n)
              + mobility(list, contact.ownerB, contact.armB, block.b[lane], n);
    contact.inverse = contact.w.inverse();
    const double wn = n.dot(contact.w*n);
    block.invWn[lane] = 1.0/wn;
    block.invWt[lane] = 2.0/(contact.w.trace() - wn);
}

void setMoments(ContactList& list, const std::vector<LawBlock>& laws)
{
    GeneralBodies& general = list.general;
    general.moments.assign(general.slots.size(), GeneralMoment());
    for (std::size_t k = 0; k < general.slots.size(); ++k)
    {
        const std::size_t slot = general.firstBlock*blockLanes + k, number = slot/blockLanes;
        if (!list.isUsed(slot)) continue;
        const ContactBlock& block = list.blocks[number];
        const int lane = slot % blockLanes;
        general.moments[k] = makeMoment(list.bodies.data(), block, lane, laws[number], general, general.slots[k], list.radius[block.a[lane]]);
    }
}

} // namespace

void setGeneralLaws(ContactList& list, double deltaT, double deadBand, double unreachable)
{
    for (std::size_t slot = list.general.firstBlock*blockLanes; slot < list.slots(); ++slot)
    {
        if (!list.isUsed(slot)) continue;
        setOperator(list, slot);
        list.blocks[slot/blockLanes].bias[slot % blockLanes] = list.gap[slot] > deadBand ? std::min(list.gap[slot], unreachable*deltaT)/deltaT : 0.0;
    }
    if (const std::vector<LawBlock>* const laws = list.laws.sweptBlocks()) setMoments(list, *laws);
}

void startGeneralSlots(ContactList& list, double impulseScale)
{
    for (std::size_t k = list.general.firstBlock; k < list.blocks.size(); ++k)
    {
        for (std::size_t slot = k*blockLanes; slot < (k + 1)*blockLanes; ++slot)
        {
            if (!list.isUsed(slot)) continue;
            setImpulse(list, slot, admissible(impulseScale*impulse(list, slot), normal(list, slot), list.blocks[k].friction[slot % blockLanes]));
        }
        // Closing is judged by the free motion, so all blocks come before any impulse.
        if (isGeneralBlockActive(list.bodies.data(), list.blocks.data(), list.general, k)) list.awake.push_back(static_cast<std::uint32_t>(k));
    }
    for (std::size_t k = list.general.firstBlock; k < list.blocks.size(); ++k)
    {
        giveGeneralImpulses(list.bodies.data(), list.blocks.data(), list.general, k);
    }
}

} // namespace nscd
