// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The local solver with a full Delassus operator: Coulomb's law itself is the judge.
#include "nscd/contacts/general/generalContact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace nscd;

namespace
{

class Random
{
public:
    double operator()() { return uniform_(engine_); }
    Vec3 vector() { return Vec3((*this)(), (*this)(), (*this)()); }

private:
    std::mt19937 engine_{7};
    std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

/// W of a body of unit mass with principal moments `moments`, pushed at `arm`.
GeneralContact contactAt(const Vec3& arm, const Vec3& moments, const Vec3& n, double bias, double friction)
{
    Eigen::Matrix3d cross;
    cross << 0, -arm[2], arm[1], arm[2], 0, -arm[0], -arm[1], arm[0], 0;
    const Eigen::Matrix3d inverseInertia = moments.cwiseInverse().asDiagonal();
    const Eigen::Matrix3d w = Eigen::Matrix3d::Identity() - cross*inverseInertia*cross;
    return {w, w.inverse(), n, bias, friction};
}

/// How far an impulse is from Coulomb's law, in velocities and in impulses turned into velocities.
double violation(const GeneralContact& c, const Vec3& freeVelocity, const Vec3& r)
{
    const Vec3 u = freeVelocity + c.w*r;
    const double rn = c.n.dot(r), un = c.n.dot(u) + c.bias, scale = c.n.dot(c.w*c.n);
    const Vec3 rt = r - rn*c.n, ut = u - c.n.dot(u)*c.n;
    double worst = std::max({0.0, -rn*scale, -un, std::abs(std::min(rn*scale, un))});
    worst = std::max(worst, scale*(rt.norm() - c.friction*rn));
    // Maximal dissipation: r_t = -mu r_n u_t/|u_t|.
    return std::max(worst, scale*(ut.norm()*rt + c.friction*rn*ut).norm());
}

} // namespace

TEST(GeneralContact, obeysCoulombsLawForAnyBody)
{
    Random random;
    for (double friction : {0.0, 0.1, 0.5, 1.0, 3.0})
    {
        int sliding = 0, sticking = 0, open = 0;
        double worst = 0.0;
        for (int k = 0; k < 2000; ++k)
        {
            const Vec3 moments = Vec3(0.5, 0.6, 0.7) + 0.2*random.vector();
            const GeneralContact contact = contactAt(1.5*random.vector(), moments, random.vector().normalized(), 0.3*random(), friction);
            const Vec3 freeVelocity = random.vector();
            const Vec3 r = solveCoulomb(contact, freeVelocity);
            worst = std::max(worst, violation(contact, freeVelocity, r));
            const double rn = contact.n.dot(r), slack = friction*rn - (r - rn*contact.n).norm();
            if (rn == 0.0) ++open;
            else (slack > 1e-9*rn ? sticking : sliding) += 1;
        }
        EXPECT_LT(worst, 1e-9) << "friction " << friction;
        EXPECT_GT(open, 400);
        EXPECT_GT(friction == 0.5 ? std::min(sliding, sticking) : 1000, 100);
    }
}

/// For a sphere W is diagonal, and the solution known.
TEST(GeneralContact, comesToTrescasLaw)
{
    Random random;
    int sliding = 0;
    for (int trial = 0; trial < 200; ++trial)
    {
        const Vec3 moments = (random.vector().array().abs() + 0.1).matrix(), u = 2.0*random.vector();
        const double bound = 2.0*std::abs(random());
        const GeneralContact contact = contactAt(random.vector(), moments, random.vector().normalized(), 0.1*std::abs(random()), bound);
        const auto energy = [&](const Vec3& r) { return 0.5*r.dot(contact.w*r) + r.dot(u + contact.bias*contact.n); };
        Vec3 r = Vec3::Zero();
        for (int k = 0; k < 2000; ++k)
        {
            const Vec3 next = approachTresca(contact, r, u + contact.w*r);
            ASSERT_LE(energy(next), energy(r) + 1e-14) << trial;
            r = next;
        }
        const Vec3 after = u + contact.w*r, tangential = r - contact.n.dot(r)*contact.n, slip = after - contact.n.dot(after)*contact.n;
        EXPECT_NEAR(std::min(contact.n.dot(r), contact.n.dot(after) + contact.bias), 0.0, 1e-10) << trial;
        EXPECT_LE(tangential.norm(), bound*(1 + 1e-12)) << trial;
        EXPECT_NEAR((slip.norm()*tangential + bound*slip).norm(), 0.0, 1e-10) << trial;
        sliding += slip.norm() > 1e-6;
    }
    EXPECT_GT(sliding, 50);
    EXPECT_LT(sliding, 190);
}

TEST(GeneralContact, isTheClosedFormOfSpheres)
{
    Random random;
    for (int k = 0; k < 200; ++k)
    {
        const Vec3 n = random.vector().normalized(), u = random.vector();
        const double wn = 2.0, wt = 7.0, friction = 0.4, bias = 0.1;
        const Eigen::Matrix3d w = wt*Eigen::Matrix3d::Identity() + (wn - wt)*n*n.transpose();
        const double pn = std::max(0.0, -(n.dot(u) + bias)/wn);
        Vec3 q = -(u - n.dot(u)*n)/wt;
        if (q.norm() > friction*pn) q *= friction*pn/q.norm();
        const Vec3 r = solveCoulomb({w, w.inverse(), n, bias, friction}, u);
        EXPECT_LT((r - pn*n - q).norm(), 1e-13);
    }
}
