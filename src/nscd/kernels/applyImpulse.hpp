// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What an impulse does to the two bodies of a contact.
#pragma once

#include "nscd/base/vec3.hpp"
#include "nscd/kernels/contactBlock.hpp"

namespace nscd
{

/// Changes the velocities of two bodies by an impulse `delta` on A along a contact with normal n, in the world frame [N s].
/// Equation: v_A += p/m_A, s_A -= (n x p)/(kappa_A m_A); v_B -= p/m_B, s_B -= (n x p)/(kappa_B m_B)
void applyImpulse(Body& a, Body& b, const double n[3], const double delta[3]);

/// Velocity of A relative to B where they touch [m/s].
/// Equation: u = v_A - v_B - (s_A + s_B) x n
Vec3 relativeVelocity(const Body& a, const Body& b, const Vec3& n);

} // namespace nscd
