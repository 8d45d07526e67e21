// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The energy account of a shock: what restitution and friction together may add.
#pragma once

#include "nscd/contacts/contactList.hpp"
#include "nscd/solvers/help/andersonAcceleration.hpp"

namespace nscd
{

struct ShockWork
{
    double work;         ///< of all impulses [J]; positive: energy has come into being
    double residualWork; ///< what the solve's residual, and round-off, may have of it [J]
};

/// Velocities and impulses of a solve.
struct Shock
{
    std::vector<Body> bodies;
    std::vector<std::uint32_t> blocks;         ///< of the list, those that may carry impulses
    AndersonAcceleration::Impulses impulses;   ///< of these blocks
    std::vector<LawImpulses> ofLaws;   ///< empty where no law keeps any
    std::vector<GeneralBody> general;
};

/// Work of the impulses in the list, from the velocities without them to the present ones, over all ranks.
/// Equation: sum r.(u^- + u)/2, u relative to walls that move. Laws within the sweeps, which only take, are left out. Newton's law with one
///           e and no friction gives -(1 - e)/(1 + e) r.W r/2 <= 0. With several e, or with friction (Kane's paradox), the law
///           itself may make it positive.
/// `residual`: Euclidean norm of the solve's natural map over its contacts [m/s]
ShockWork shockWork(const ContactList& list, const std::vector<Body>& freeBodies, double residual);

/// Contacts of the shock in the list that rebound, of a grain that is neither held nor asleep: mean over all ranks [-].
double impactsOfAGrain(const ContactList& list);

/// Where the rebound in the list has work > 0: goes back from it to `inelastic`, the solution without restitution (whose work is
/// at most 0), as far as it takes for the work to be 0. All impulses and velocities go alike, so laws of momentum and the cone of
/// friction stay; in effect every coefficient of restitution of the step is multiplied by the share returned.
double limitRebound(ContactList& list, const std::vector<Body>& freeBodies, const Shock& inelastic);

/// The rebound of a shock that was not solved: the impulses of the motion, (1 + e) times.
/// Equation: r = (1 + e) r_i, v = v_i + e (v_i - v^-), i the solution without restitution, e the mean of the contacts that rebound, weighted by r_i,n.
///           u_n = -e u_n^- on contacts that r_i loads, |r_t| <= mu r_n on all; what sticks rebounds along the surface too. Since r_i.u_i <= 0,
///           the work is at most -(1 - e^2) r_i.W r_i/2.
void reboundOfMotion(ContactList& list, const std::vector<Body>& freeBodies, const Shock& inelastic);

} // namespace nscd
