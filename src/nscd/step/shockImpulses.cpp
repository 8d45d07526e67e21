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
    shock_.blocks.clear();
    shock_.impulses.clear();
    shock_.ofLaws.clear();
    ofPart_.clear();
}

void ShockImpulses::keep(Shock shock)
{
    shock_ = std::move(shock);
    shock_.bodies = std::vector<Body>();
    shock_.general = std::vector<GeneralBody>();
}

void ShockImpulses::swapWith(ContactList& whole)
{
    swapImpulses(whole, shock_);
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

void swapImpulses(ContactList& list, Shock& shock)
{
    constexpr std::ptrdiff_t values = 3*blockLanes;
    auto from = shock.impulses.begin();
    for (std::uint32_t k : shock.blocks)
    {
        std::swap_ranges(from, from + values, &list.blocks[k].r[0][0]);
        from += values;
    }
    for (std::size_t slot = 0; slot < shock.ofLaws.size(); ++slot)
    {
        const LawImpulses before = list.laws.impulses(slot);
        list.laws.setImpulses(slot, shock.ofLaws[slot]);
        shock.ofLaws[slot] = before;
    }
}

} // namespace nscd
