// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One law after the other.
#include "nscd/contacts/listLaws.hpp"

namespace nscd
{

ListLaws::ListLaws(const Materials& materials)
{
    std::size_t place = 0;
    for (const ContactLawRow& row : contactLaws())
    {
        const std::size_t own = place;
        place += row.impulseName != nullptr;
        if (!row.isUsed(materials)) continue;
        laws_.push_back(row.make());
        if (row.impulseName) keeping_.push_back({laws_.back().get(), own});
        areOfSpins_ = areOfSpins_ || row.isOfSpins;
        areOfStart_ = areOfStart_ || row.isOfStart;
    }
}

void ListLaws::resize(std::size_t slots)
{
    for (const auto& law : laws_) law->resize(slots);
}

void ListLaws::set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB)
{
    for (const auto& law : laws_) law->set(slot, pair, radiusA, radiusB);
}

void ListLaws::copy(const ListLaws& from, std::size_t source, std::size_t target)
{
    for (std::size_t k = 0; k < laws_.size(); ++k) laws_[k]->copy(*from.laws_[k], source, target);
}

void ListLaws::beginStep(const ContactList& list)
{
    for (const auto& law : laws_) law->beginStep(list);
}

void ListLaws::giveKnown(ContactList& list, double deltaT, double deadBand)
{
    for (const auto& law : laws_) law->giveKnown(list, deltaT, deadBand);
}

void ListLaws::startWarm(ContactList& list, double scale)
{
    for (const auto& law : laws_) law->startWarm(list, scale);
}

void ListLaws::endSolve()
{
    for (const auto& law : laws_) law->endSolve();
}

void ListLaws::beginShock(ContactList& list)
{
    for (const auto& law : laws_) law->beginShock(list);
}

void ListLaws::chooseKernels(SweepKernels& kernels) const
{
    for (const auto& law : laws_) law->chooseKernels(kernels);
}

std::vector<LawBlock>* ListLaws::sweptBlocks() const
{
    for (const auto& law : laws_)
    {
        if (std::vector<LawBlock>* const blocks = law->sweptBlocks()) return blocks;
    }
    return nullptr;
}

void ListLaws::addForces(const ContactList& list, const Scene& scene, double deltaT, ContactSums& sums) const
{
    for (const auto& law : laws_) law->addForces(list, scene, deltaT, sums);
}

Vec3 ListLaws::known(std::size_t slot) const
{
    Vec3 sum = Vec3::Zero();
    for (const auto& law : laws_) sum += law->known(slot);
    return sum;
}

Vec3 ListLaws::moment(const ContactList& list, std::size_t slot) const
{
    Vec3 sum = Vec3::Zero();
    for (const auto& law : laws_) sum += law->moment(list, slot);
    return sum;
}

LawImpulses ListLaws::impulses(std::size_t slot) const
{
    LawImpulses kept = noLawImpulses();
    for (const Keeping& keeping : keeping_) kept[keeping.place] = keeping.law->impulse(slot);
    return kept;
}

void ListLaws::setImpulses(std::size_t slot, const LawImpulses& impulses)
{
    for (const Keeping& keeping : keeping_) keeping.law->setImpulse(slot, impulses[keeping.place]);
}

} // namespace nscd
