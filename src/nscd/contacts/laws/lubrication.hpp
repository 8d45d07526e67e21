// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Lubrication: the film of a viscous fluid that is pressed out from between two surfaces, or sucked in.
// Tested by tests/unit/nscd/contacts/laws/lubricationTest.cpp
#pragma once

#include "nscd/contacts/contactLaw.hpp"

namespace nscd
{

/// Between two spheres a gap g apart, g much less than their radii, that part with the speed u_n, a fluid of viscosity mu acts with
///     f_n = -6 pi mu R'^2 u_n/(g + g_r),  g < range,  R' = R_A R_B/(R_A + R_B), at a wall R_A
/// (Jeffrey & Onishi 1984, J. Fluid Mech. 139, 261, the leading term); where surfaces touch the roughness g_r keeps them apart (Davis, Serayssol & Hinch
/// 1986, J. Fluid Mech. 163, 479; Smart & Leighton 1989, Phys. Fluids A 1, 52). In a step from the thickness h = g + g_r to h + dt u_n it gives exactly
///     q = -k ln((h + dt u_n)/h),  k = 6 pi mu R'^2 [N s],
/// whatever the step's length, with both thicknesses bounded by range + g_r. The law of a contact is then r_n >= 0, u_n + b >= 0, product 0, beside q,
/// which is solved with it in the sweeps (filmSweep.hpp): implicit, so that no film limits the time step, and dissipative: q u_n <= 0.
///
/// An approach at u loses (k/m) ln((range + g_r)/g_r) on its way through the film, m the pair's reduced mass, hits with what is left, and loses the
/// same on its way back: its coefficient of restitution is e - (1 + e) ln((range + g_r)/g_r)/St, St = m u/k, and none below St = ln(...)(1 + 1/e).
/// What slides along feels no film: its resistance goes as ln(R'/g), and is left out, as is what films do to spins.
class Lubrication : public ContactLaw
{
public:
    void resize(std::size_t slots) override;
    void set(std::size_t slot, const ContactPair& pair, double radiusA, double radiusB) override;
    void copy(const ContactLaw& from, std::size_t source, std::size_t target) override;

    /// Films of the step, from the gaps at its start, without impulses; their blocks are awake, and their contacts close to nothing without a dead band.
    void giveKnown(ContactList& list, double deltaT, double deadBand) override;

    std::vector<LawBlock>* sweptBlocks() override { return &blocks_; }
    void chooseKernels(SweepKernels& kernels) const override;
    void endSolve() override;
    /// The impulses of films belong to the motion before a shock, which is over in no time.
    void beginShock(ContactList& list) override;

    /// The film's impulse in the last motion solved.
    Vec3 known(std::size_t slot) const override { return films_[slot].given; }

private:
    struct Film
    {
        double strength = 0.0;    ///< k [N s]
        double roughness = 0.0;   ///< [m]
        double range = 0.0;       ///< [m]
        Vec3 given = Vec3::Zero();
    };

    /// Sets the coefficients of a slot for a step. Returns whether its film can matter in it.
    bool prepare(ContactList& list, std::size_t slot, double deltaT);

    std::vector<Film> films_;
    std::vector<LawBlock> blocks_;
};

} // namespace nscd
