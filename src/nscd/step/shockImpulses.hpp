// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The impulses that contacts gave in a step with rebounds, beside those of the motion, which the list keeps for the next step.
// Tested by tests/unit/nscd/scenes/contactImpulsesTest.cpp
#pragma once

#include "nscd/step/awakePart.hpp"
#include "nscd/step/shockWork.hpp"

namespace nscd
{

/// A step's motion and its shock are two solves from the same free velocities, so the shock's impulses are the whole ones: sum of them on a
/// grain = m dv - dt f. The list starts the next step from those of the motion. Empty where nothing rebounded: then the list's are the whole ones.
class ShockImpulses
{
public:
    void clear();
    /// Memory of the last step's, for the next to be gathered in.
    Shock release() { return std::move(shock_); }
    /// Of slots of the list of all contacts, which stay where they are until a list is built. Velocities are not kept.
    void keep(Shock shock);
    /// Of the slots that a part of the list has, by their numbers in the whole.
    void keep(std::vector<AwakePart::Impulse> ofPart) { ofPart_ = std::move(ofPart); }
    /// Changes them for those of the list of all contacts; twice is nothing.
    void swapWith(ContactList& whole);

private:
    Shock shock_;
    std::vector<AwakePart::Impulse> ofPart_;
};

/// Changes the impulses of a shock for those of the list.
void swapImpulses(ContactList& list, Shock& shock);

} // namespace nscd
