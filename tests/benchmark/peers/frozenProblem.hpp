// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A contact problem and its solution as two files of plain doubles, for programs that know nothing of this library.
#pragma once

#include "benchmark/coldSolve/frozenBed.hpp"

namespace scenes
{

/// NAME.bodies: a body a row, free v, 1/m, free s, 1/(kappa m). NAME.contacts: a contact a row, body A, body B (-1: none), n, bias, friction,
/// impulse on A. All contacts that are listed, in SI units; symbols as in src/nscd/method.md.
class FrozenFiles
{
public:
    /// Before the solve: bodies hold free velocities.
    FrozenFiles(const std::string& name, const nscd::ContactProblem& problem, const nscd::ContactList& list)
    :
        name_(name)
    {
        std::ofstream file(name + ".bodies", std::ios::binary);
        for (int i = 0; i < list.owned(); ++i)
        {
            const nscd::Body& body = problem.bodies[i];
            const double row[] = {body.v[0], body.v[1], body.v[2], body.invMass, body.s[0], body.s[1], body.s[2], body.invSpin};
            file.write(reinterpret_cast<const char*>(row), sizeof(row));
        }
    }

    /// After the solve.
    void writeContacts(const nscd::ContactProblem& problem, const nscd::ContactList& list) const
    {
        std::ofstream file(name_ + ".contacts", std::ios::binary);
        for (std::size_t slot = 0; slot < list.slots(); ++slot)
        {
            if (!list.isUsed(slot)) continue;
            const nscd::ContactBlock& block = problem.blocks[slot/nscd::blockLanes];
            const std::size_t k = slot % nscd::blockLanes;
            const double row[] = {double(block.a[k]), block.b[k] < list.owned() ? double(block.b[k]) : -1.0, block.n[0][k], block.n[1][k], block.n[2][k],
                                  block.bias[k], block.friction[k], block.r[0][k], block.r[1][k], block.r[2][k]};
            file.write(reinterpret_cast<const char*>(row), sizeof(row));
        }
    }

private:
    std::string name_;
};

} // namespace scenes
