// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Keeping a shock's impulses.
#include "nscd/step/shockImpulses.hpp"

#include <algorithm>

namespace nscd
{

void ShockImpulses::clear()
{
    impulses_.clear();
    ofLaws_.clear();
    ofPart_.clear();
}

void ShockImpulses::keep(Shock shock)
{
    impulses_ = std::move(shock.impulses);
    ofLaws_ = std::move(shock.ofLaws);
}

void ShockImpulses::swapWith(ContactList& whole)
{
    swapImpulses(whole, impulses_, ofLaws_);
    for (AwakePart::Impulse& entry : ofPart_)
    {
        const Vec3 r = impulse(whole, entry.slot);
        const LawImpulses ofLaws = whole.laws.impulses(entry.slot);
        setImpulse(whole, entry.slot, entry.r);
        whole.laws.setImpulses(entry.slot, entry.ofLaws);
        entry.r = r;
        entry.ofLaws = ofLaws;
    }
}

void swapImpulses(ContactList& list, std::vector<double>& impulses, std::vector<LawImpulses>& ofLaws)
{
    constexpr std::ptrdiff_t values = 3*blockLanes;
    auto from = impulses.begin();
    for (std::size_t k = 0; from != impulses.end(); ++k, from += values) std::swap_ranges(from, from + values, &list.blocks[k].r[0][0]);
    for (std::size_t slot = 0; slot < ofLaws.size(); ++slot)
    {
        const LawImpulses before = list.laws.impulses(slot);
        list.laws.setImpulses(slot, ofLaws[slot]);
        ofLaws[slot] = before;
    }
}

} // namespace nscd
