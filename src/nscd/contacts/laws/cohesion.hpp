// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cohesion: a constant attraction of contacts that are closed, or in range, beside the sweep kernels.
#pragma once

#include "nscd/base/vec3.hpp"

#include <vector>

namespace nscd
{

struct ContactList;
struct Scene;

/// The law with cohesion: r_n + c dt >= 0, u_n + b >= 0, product 0, |r_t| <= mu (r_n + c dt) (Taboada, Estrada & Radjai 2006, Phys.
/// Rev. Lett. 97, 098302; Radjai & Dubois 2011, Discrete-element modeling of granular materials). The impulse that
/// blocks hold is r + c dt n: for it the law is the one without cohesion, and the attraction -c dt n is one more known impulse, which the
/// free velocities get. Kernels, residual and warm start know nothing of it; what is reported has it subtracted again.
///
/// The attraction acts where the gap is within the dead band or the range, and on bonds: contacts whose blocks held an impulse at the end
/// of the last step, that is, which did not come off in it. A bond that turns opens by (u dt)^2/(2 (R_A + R_B)) a step, since motion is
/// straight; it is drawn back to the edge of the dead band with b = (g - e)/dt, and may not break by that.
struct CohesiveSlot
{
    double force = 0.0;   ///< c [N]
    double range = 0.0;   ///< [m]
    double attraction[3] = {0.0, 0.0, 0.0};   ///< -c dt n, on A, in this step where it acts, else zero [N s]
    bool isBond = false;

    bool isActing() const { return attraction[0] != 0.0 || attraction[1] != 0.0 || attraction[2] != 0.0; }
};

/// One slot for each lane of the blocks; empty in scenes without cohesion, which then pay nothing.
using CohesiveSlots = std::vector<CohesiveSlot>;

/// Marks the bonds: to be called between two steps.
void markBonds(ContactList& list);

/// Pulls of a step of length deltaT, from gaps at its start: bodies' velocities get them, bonds beyond the dead band [m] their bias.
void applyCohesion(ContactList& list, double deltaT, double deadBand);

/// Adds the attraction to `force`, of each body, and to `wall`, see addWallForce() [N].
void addCohesionForces
(
    const ContactList& list, const Scene& scene, double deltaT, std::vector<Vec3>& force, std::vector<Vec3>& wall
);

} // namespace nscd
