// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One contact of rigid bodies that bears a moment: both laws, by code of the test's own, for random inertia, arms and motion.
#include "nscd/contacts/general/generalMoments.hpp"

#include <gtest/gtest.h>

#include <random>

using nscd::Vec3;
using Eigen::Matrix3d;

namespace
{

constexpr double reduced = 0.4, friction = 0.5;

/// A contact of a body with a wall: W, K and S from an arm and an inertia.
struct Random
{
    std::mt19937 engine{7};
    std::uniform_real_distribution<double> unit{-1.0, 1.0};

    Vec3 vec() { return Vec3(unit(engine), unit(engine), unit(engine)); }
    Matrix3d inertia()
    {
        Matrix3d a;
        for (int k = 0; k < 3; ++k) a.col(k) = vec();
        return a*a.transpose() + 0.3*Matrix3d::Identity();
    }
};

struct Problem
{
    nscd::GeneralMoment moment;
    nscd::MomentContact contact;
    Vec3 u, w;   ///< free

    Problem(Random& random, double across, double along) : contact{{}, moment, across, along}
    {
        const Vec3 n = random.vec().normalized(), arm = -n + 0.2*random.vec();
        const Matrix3d c = nscd::crossMatrix(arm), inverse = random.inertia().inverse();
        const Matrix3d mobility = Matrix3d::Identity() - c*inverse*c;
        contact.coulomb = {mobility, mobility.inverse(), n, 0.0, friction};
        moment = {reduced, -reduced*c*inverse, reduced*reduced*inverse};
        u = random.vec() - 0.8*n;
        w = 0.2*random.vec();
    }

    /// Largest |p - Proj(p - mobility^-1 v)|, in velocities: natural maps of impulse and moment.
    double residual(const nscd::BorneByContact& b) const
    {
        const Vec3& n = contact.coulomb.n;
        const Vec3 uNow = u + contact.coulomb.w*b.r + moment.coupling*b.q, wNow = w + moment.coupling.transpose()*b.r + moment.mobility*b.q;
        const double rn = n.dot(b.r), pn = std::max(0.0, rn - n.dot(uNow));
        Vec3 t = (b.r - rn*n) - (uNow - n.dot(uNow)*n), qt = (b.q - n.dot(b.q)*n) - (wNow - n.dot(wNow)*n);
        if (t.norm() > friction*rn) t *= friction*rn/t.norm();
        if (qt.norm() > contact.across*rn) qt *= contact.across*rn/qt.norm();
        const double qn = std::clamp(n.dot(b.q) - n.dot(wNow), -contact.along*rn, contact.along*rn);
        return std::max((pn*n + t - b.r).norm(), (qt + qn*n - b.q).norm());
    }
};

} // namespace

TEST(GeneralMoments, bothLawsHoldAtOnce)
{
    Random random;
    int held = 0, turning = 0, sliding = 0, open = 0;
    for (const double size : {0.02, 0.3, 3.0})
    for (const bool spins : {false, true})
    for (int k = 0; k < 200; ++k)
    {
        const Problem problem(random, size, spins ? 0.5*size : 0.0);
        nscd::BorneByContact borne{Vec3::Zero(), Vec3::Zero()};
        for (int sweep = 0; sweep < 200; ++sweep) borne = nscd::solveWithMoment(problem.contact, problem.u, problem.w, borne.q);
        ASSERT_LT(problem.residual(borne), 1e-9) << size << " " << spins << " " << k;
        const Vec3& n = problem.contact.coulomb.n;
        const double rn = n.dot(borne.r), across = (borne.q - n.dot(borne.q)*n).norm();
        if (rn == 0.0) ++open;
        else
        {
            ++(across < 0.999*size*rn ? held : turning);
            if ((borne.r - rn*n).norm() > 0.999*friction*rn) ++sliding;
        }
    }
    for (int count : {held, turning, sliding}) EXPECT_GT(count, 100);
    EXPECT_GT(open, 10);
}

TEST(GeneralMoments, whatIsHeldIsSolvedAtOnce)
{
    Random random;
    int held = 0;
    for (int k = 0; k < 200; ++k)
    {
        const Problem problem(random, 3.0, 3.0);
        const nscd::BorneByContact borne = nscd::solveWithMoment(problem.contact, problem.u, problem.w, Vec3::Zero());
        const double limit = 3.0*problem.contact.coulomb.n.dot(borne.r);
        if (!(borne.q.norm() < 0.99*limit)) continue;
        ++held;
        EXPECT_LT(problem.residual(borne), 1e-11);
    }
    EXPECT_GT(held, 50);
}
