// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The closed-form solution of one contact, in plain scalar code.
#include "nscd/solvers/problem/localContact.hpp"

#include "nscd/contacts/general/generalSweep.hpp"
#include "nscd/kernels/applyImpulse.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Relative velocity at the contact, world frame [m/s].
void relativeVelocity(const Body& a, const Body& b, const double n[3], double u[3])
{
    const double s[3] = {a.s[0] + b.s[0], a.s[1] + b.s[1], a.s[2] + b.s[2]};
    u[0] = a.v[0] - b.v[0] - (s[1]*n[2] - s[2]*n[1]);
    u[1] = a.v[1] - b.v[1] - (s[2]*n[0] - s[0]*n[2]);
    u[2] = a.v[2] - b.v[2] - (s[0]*n[1] - s[1]*n[0]);
}

double dot(const double a[3], const double b[3]) { return a[0]*b[0] + a[1]*b[1] + a[2]*b[2]; }

} // namespace

LocalChange localChange(const ContactProblem& problem, std::size_t slot)
{
    if (isGeneral(problem.general, slot))
    {
        const GeneralChange change = generalChange(problem.bodies.data(), problem.blocks.data(), *problem.general, slot);
        return {{change.impulse[0], change.impulse[1], change.impulse[2]}, change.defect};
    }
    const ContactBlock& block = problem.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    return localChange(problem, slot, 1.0/block.invWn[lane], 1.0/block.invWt[lane]);
}

LocalChange localChange(const ContactProblem& problem, std::size_t slot, double wn, double wt)
{
    const ContactBlock& block = problem.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    const double n[3] = {block.n[0][lane], block.n[1][lane], block.n[2][lane]};
    const double r[3] = {block.r[0][lane], block.r[1][lane], block.r[2][lane]};
    double u[3];
    relativeVelocity(problem.bodies[block.a[lane]], problem.bodies[block.b[lane]], n, u);
    const double rn = dot(r, n), un = dot(u, n);
    const double pn = std::max(0.0, rn - (un + block.bias[lane])/wn);

    // Scenes without friction have no spin: their friction coefficient is zero and q is dropped.
    double q[3];
    for (int k = 0; k < 3; ++k) q[k] = r[k] - rn*n[k] - (u[k] - un*n[k])/wt;
    const double limit = block.friction[lane]*pn;
    const double q2 = dot(q, q);
    const double scale = q2 > limit*limit ? limit/std::sqrt(q2) : 1.0;

    LocalChange change;
    double tangential2 = 0.0;
    for (int k = 0; k < 3; ++k)
    {
        const double t = scale*q[k] - (r[k] - rn*n[k]);
        change.impulse[k] = (pn - rn)*n[k] + t;
        tangential2 += t*t;
    }
    const double normal = (pn - rn)*wn;
    change.defect = std::sqrt(normal*normal + tangential2*wt*wt);
    return change;
}

std::vector<std::uint32_t> defectiveSlots(const ContactProblem& problem, BlockRange range, double limit)
{
    const SweepFunction evaluate = problem.isFrictional ? problem.kernels.evaluate : problem.kernels.evaluateFrictionless;
    const double small2 = 0.25*limit*limit;
    std::vector<std::uint32_t> found;
    for (std::size_t k = 0; k < range.count; ++k)
    {
        const std::uint32_t index = range[k];
        ContactBlock& block = problem.blocks[index];
        if (!isGeneral(problem.general, index*blockLanes) && evaluate(problem.bodies.data(), &block, {nullptr, 1}).maxSquare <= small2) continue;
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            const std::uint32_t slot = index*blockLanes + lane;
            if (isUsed(block, lane) && localChange(problem, slot).defect > limit) found.push_back(slot);
        }
    }
    return found;
}

void apply(ContactProblem& problem, std::size_t slot, const LocalChange& change)
{
    if (isGeneral(problem.general, slot))
    {
        applyGeneralChange(problem.bodies.data(), problem.blocks.data(), *problem.general, slot, Vec3(change.impulse));
        return;
    }
    ContactBlock& block = problem.blocks[slot/blockLanes];
    const int lane = slot % blockLanes;
    const double n[3] = {block.n[0][lane], block.n[1][lane], block.n[2][lane]};
    for (int k = 0; k < 3; ++k) block.r[k][lane] += change.impulse[k];
    applyImpulse(problem.bodies[block.a[lane]], problem.bodies[block.b[lane]], n, change.impulse);
}

} // namespace nscd
