// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Resistance to rolling and to spinning: laws of Coulomb's kind for the moment that a contact bears, solved by the kernels of moments.
#pragma once

#include "nscd/contacts/contactLaw.hpp"

namespace nscd
{

/// With the reduced radius R' = R_A R_B/(R_A + R_B) (at a wall: R_A; Ai et al. 2011, Powder Technol. 206, 269) and the relative
/// angular velocity omega = omega_A - omega_B, a contact bears a moment impulse M on A, -M on B [N m s], written as q = M/R' [N s],
/// with its power partner w = R' omega [m/s]. Along the normal (spinning) and in the tangent plane (rolling):
///     |q_t| <= mu_r r_n, and if w_t is not 0, q_t = -mu_r r_n w_t/|w_t|;
///     |q_n| <= mu_s r_n, and if w_n is not 0, q_n = -mu_s r_n sign(w_n)
/// (set-valued as Coulomb's law; in contact dynamics Estrada, Taboada & Radjai 2008, Phys. Rev. E 78, 021301). In the spin variables
/// s = R omega: w = a s_A - b s_B with a = R'/R_A, b = R'/R_B, q changes s_A by a q/(kappa m_A) and s_B by -b q/(kappa m_B), and for
/// spheres and discs w changes by W_r q, W_r = a^2/(kappa m_A) + b^2/(kappa m_B).
class RollingFriction : public ContactLaw
{
public:
    void resize(std::size_t slots) override { blocks_.resize((slots + blockLanes - 1)/blockLanes, LawBlock()); }
    void copy(const ContactLaw& from, std::size_t source, std::size_t target) override;
    void set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB) override;

    /// Last step's moments times `scale`, turned into the present tangent planes and cut to what the impulses allow.
    void startWarm(ContactList& list, double scale) override;

    std::vector<LawBlock>* sweptBlocks() override { return &blocks_; }

    void addForces(const ContactList& list, const Scene& scene, double deltaT, ContactSums& sums) const override;
    /// R' q.
    Vec3 moment(const ContactList& list, std::size_t slot) const override;

    Vec3 impulse(std::size_t slot) const override;
    void setImpulse(std::size_t slot, const Vec3& q) override;

private:
    std::vector<LawBlock> blocks_;   ///< `across` holds mu_r, `along` mu_s
};

} // namespace nscd
