// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cohesion: a constant attraction of contacts that are closed, or in range, beside the sweep kernels.
#pragma once

#include "nscd/contacts/contactLaw.hpp"

namespace nscd
{

struct CohesiveSlot
{
    double force = 0.0;   ///< c [N]
    double range = 0.0;   ///< [m]
    Vec3 attraction = Vec3::Zero();   ///< -c dt n, on A, in this step where it acts, else zero [N s]
    bool isBond = false;
};

/// The law with cohesion: r_n + c dt >= 0, u_n + b >= 0, product 0, |r_t| <= mu (r_n + c dt) (Taboada, Estrada & Radjai 2006, Phys.
/// Rev. Lett. 97, 098302; Radjai & Dubois 2011, Discrete-element modeling of granular materials). The impulse that
/// blocks hold is r + c dt n: for it the law is the one without cohesion, and the attraction -c dt n is one more known impulse, which the
/// free velocities get. Kernels, residual and warm start know nothing of it; what is reported has it subtracted again.
///
/// The attraction acts where the gap is within the dead band or the range, and on bonds: contacts whose blocks held an impulse at the end
/// of the last step, that is, which did not come off in it. A bond that turns opens by (u dt)^2/(2 (R_A + R_B)) a step, since motion is
/// straight; it is drawn back to the edge of the dead band with b = (g - e)/dt, and may not break by that.
class Cohesion : public LawOfSlots<CohesiveSlot>
{
public:
    void set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB) override;
    /// Marks the bonds.
    void beginStep(const ContactList& list) override;
    /// Attractions, from the gaps at the start of the step; bonds beyond the dead band [m] get their bias.
    void giveKnown(ContactList& list, double deltaT, double deadBand) override;
    Vec3 known(std::size_t slot) const override { return slots_[slot].attraction; }
};

} // namespace nscd
