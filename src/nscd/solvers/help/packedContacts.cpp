// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lanes taken out of a list's blocks, and put back.
#include "nscd/solvers/help/packedContacts.hpp"

#include "nscd/contacts/contactLaw.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace nscd
{

namespace
{

constexpr std::uint32_t noSlot = std::numeric_limits<std::uint32_t>::max();

bool isLoaded(const ContactBlock& block, int lane) { return block.r[0][lane] != 0.0 || block.r[1][lane] != 0.0 || block.r[2][lane] != 0.0; }

/// Whether a contact closes within the step, or would if its bodies came together faster by `margin`.
bool isClosing(const std::vector<Body>& bodies, const ContactBlock& block, int lane, double margin = 0.0)
{
    const double *const a = bodies[block.a[lane]].v, *const b = bodies[block.b[lane]].v;
    const double speed = block.n[0][lane]*(a[0] - b[0]) + block.n[1][lane]*(a[1] - b[1]) + block.n[2][lane]*(a[2] - b[2]);
    return speed + block.bias[lane] < margin;
}

void copyLane(const ContactBlock& from, int lane, ContactBlock& to, int place)
{
    for (int k = 0; k < 3; ++k)
    {
        to.n[k][place] = from.n[k][lane];
        to.r[k][place] = from.r[k][lane];
    }
    to.bias[place] = from.bias[lane];
    to.invWn[place] = from.invWn[lane];
    to.invWt[place] = from.invWt[lane];
    to.friction[place] = from.friction[lane];
    to.a[place] = from.a[lane];
    to.b[place] = from.b[lane];
}

void putOutOfReach(ContactBlock& block, int lane)
{
    for (int k = 0; k < 3; ++k) block.r[k][lane] = 0.0;
    block.bias[lane] = unreachable;
}

} // namespace

bool PackedContacts::isWorthwhile(const ContactProblem& whole, const SolverStrategy::Packing& strategy) const
{
    return strategy.isOn && whole.isFlowing() && !whole.general && lastSweeps_[whole.isShock] >= (whole.isShock ? strategy.longShock : strategy.longSolve)
        && whole.halo.any(whole.awake.size() >= strategy.largeProblem);
}

/// Behind the contacts of their kind: first those within this rank, then those with others.
void PackedContacts::append(const std::vector<std::uint32_t>& slots, ContactProblem& packed)
{
    const int staticBody = static_cast<int>(packed.bodies.size()) - 1;
    const auto isInner = [&](std::uint32_t slot) { return slot/blockLanes < homeInterface_; };
    std::vector<std::uint32_t> inner, interface;
    std::partition_copy(slots.begin(), slots.end(), std::back_inserter(inner), std::back_inserter(interface), isInner);
    const std::size_t before = blocks_.size();
    insert(inner, packed.interfaceBlock, staticBody);
    packed.interfaceBlock += blocks_.size() - before;
    insert(interface, blocks_.size(), staticBody);
    awake_.resize(blocks_.size());
    std::iota(awake_.begin(), awake_.end(), 0u);
}

void PackedContacts::insert(const std::vector<std::uint32_t>& slots, std::size_t before, int staticBody)
{
    std::vector<ContactBlock>& home = *home_;
    std::vector<Candidate> contacts;
    contacts.reserve(slots.size());
    for (std::uint32_t slot : slots)
    {
        const ContactBlock& block = home[slot/blockLanes];
        contacts.push_back({block.a[slot % blockLanes], block.b[slot % blockLanes], -1, {0, 0, 0}});
    }
    std::vector<std::uint32_t> order(slots.size());
    std::iota(order.begin(), order.end(), 0u);
    const Batches batches = batchContacts(contacts, order, staticBody);

    blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(before), batches.blocks, emptyBlock(staticBody));
    if (homeLaw_) ofLaw_.insert(ofLaw_.begin() + static_cast<std::ptrdiff_t>(before), batches.blocks, LawBlock());
    slotOf_.insert(slotOf_.begin() + static_cast<std::ptrdiff_t>(before*blockLanes), batches.blocks*blockLanes, noSlot);
    for (std::size_t k = 0; k < slots.size(); ++k)
    {
        const std::size_t place = before*blockLanes + batches.slotOf[k];
        ContactBlock& from = home[slots[k]/blockLanes];
        copyLane(from, slots[k] % blockLanes, blocks_[place/blockLanes], place % blockLanes);
        if (homeLaw_) copyLane((*homeLaw_)[slots[k]/blockLanes], slots[k] % blockLanes, ofLaw_[place/blockLanes], place % blockLanes);
        putOutOfReach(from, slots[k] % blockLanes);
        slotOf_[place] = slots[k];
    }
}

ContactProblem PackedContacts::pack(ContactProblem& whole, double nearlyClosing)
{
    const StepTimes::Timer timer(whole.times, GrainPart::packContacts);
    home_ = &whole.blocks;
    homeInterface_ = whole.interfaceBlock;
    homeLaw_ = whole.lawBlocks;
    blocks_.clear();
    ofLaw_.clear();
    slotOf_.clear();
    const int staticBody = static_cast<int>(whole.bodies.size()) - 1;
    const double margin = nearlyClosing*whole.diameter/whole.deltaT;
    std::vector<std::uint32_t> slots;
    for (std::uint32_t k : whole.awake)
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        const ContactBlock& block = whole.blocks[k];
        if (block.a[lane] == staticBody) continue;
        const bool hasFilm = whole.areFilms && (*whole.lawBlocks)[k].of[filmLaw::strength][lane] > 0.0;
        const bool isPacked = hasFilm || block.bias[lane] == 0.0 || isLoaded(block, lane) || isClosing(whole.bodies, block, lane, margin);
        if (isPacked) slots.push_back(k*blockLanes + static_cast<std::uint32_t>(lane));
    }
    ContactProblem packed
    {
        whole.bodies, blocks_, awake_, 0, whole.halo, whole.kernels, whole.isFrictional,
        whole.deltaT, whole.speedScale, whole.diameter, whole.position
    };
    packed.motion = whole.motion;
    packed.isDriven = whole.isDriven;
    packed.isShock = whole.isShock;
    packed.massRatio = whole.massRatio;
    packed.areFilms = whole.areFilms;
    packed.lawBlocks = whole.lawBlocks ? &ofLaw_ : nullptr;
    packed.leftOut = this;
    packed.freeVelocity = whole.freeVelocity;
    packed.times = whole.times;
    append(slots, packed);
    if (whole.isShock) awakeAtHome_ = whole.awake;
    return packed;
}

BlockRange PackedContacts::lookedAt(const ContactProblem& packed) const
{
    return packed.isShock ? BlockRange{awakeAtHome_.data(), awakeAtHome_.size()} : BlockRange{nullptr, home_->size()};
}

bool PackedContacts::wake(ContactProblem& packed)
{
    packed.giveVelocities();
    const int staticBody = static_cast<int>(packed.bodies.size()) - 1;
    std::vector<std::uint32_t> slots;
    const BlockRange looked = lookedAt(packed);
    for (std::size_t m = 0; m < looked.count; ++m)
    {
        const std::uint32_t k = static_cast<std::uint32_t>(looked[m]);
        const ContactBlock& block = (*home_)[k];
        // What is not packed carries nothing: what the law asks for is normal, so the frictionless evaluation tells.
        if (packed.kernels.evaluateFrictionless(packed.bodies.data(), &(*home_)[k], {nullptr, 1}).active == 0.0) continue;
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            if (block.a[lane] == staticBody || !isClosing(packed.bodies, block, lane)) continue;
            slots.push_back(k*blockLanes + static_cast<std::uint32_t>(lane));
        }
    }
    if (!slots.empty()) append(slots, packed);
    return packed.halo.any(!slots.empty());
}

DefectSums PackedContacts::defects(const ContactProblem& packed) const
{
    return packed.kernels.evaluateFrictionless(packed.bodies.data(), home_->data(), lookedAt(packed));
}

void PackedContacts::giveBack(ContactProblem& whole) const
{
    const StepTimes::Timer timer(whole.times, GrainPart::packContacts);
    std::vector<char> isAwake(whole.blocks.size(), 0);
    for (std::uint32_t k : whole.awake) isAwake[k] = 1;
    for (std::size_t place = 0; place < slotOf_.size(); ++place)
    {
        if (slotOf_[place] == noSlot) continue;
        const ContactBlock& from = blocks_[place/blockLanes];
        ContactBlock& to = whole.blocks[slotOf_[place]/blockLanes];
        const std::size_t lane = place % blockLanes, home = slotOf_[place] % blockLanes;
        for (int k = 0; k < 3; ++k) to.r[k][home] = from.r[k][lane];
        for (int k = 0; k < 3 && homeLaw_; ++k) (*homeLaw_)[slotOf_[place]/blockLanes].q[k][home] = ofLaw_[place/blockLanes].q[k][lane];
        to.bias[home] = from.bias[lane];
        isAwake[slotOf_[place]/blockLanes] = 1;
    }
    whole.awake.clear();
    for (std::uint32_t k = 0; k < isAwake.size(); ++k)
    {
        if (isAwake[k]) whole.awake.push_back(k);
    }
}

} // namespace nscd
