// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Smoothed projection on the second-order cone.
#include "nscd/solvers/direct/coulombCone.hpp"

#include <cmath>

namespace nscd
{

namespace
{

/// Smoothed max(0, x) and its derivative.
struct Plus
{
    double value;
    double slope;

    Plus(double x, double eta)
    {
        const double root = std::sqrt(x*x + 4.0*eta*eta);
        // The sum would cancel for x < 0.
        value = x > 0.0 ? 0.5*(x + root) : 2.0*eta*eta/(root - x);
        slope = value/root;
    }
};

} // namespace

ConePoint smoothedImpulse(const Vec3& r, const Vec3& u, const Vec3& n, double friction, double penalty, double smoothing)
{
    const double rn = r.dot(n), un = u.dot(n);
    if (friction == 0.0)
    {
        const Plus normal(rn/penalty - un, smoothing);
        return {penalty*normal.value*n, penalty*normal.slope*n*n.transpose()};
    }
    const double rho = penalty*friction;
    const double x0 = friction*rn/rho - un/friction;
    const Vec3 xt = (r - rn*n)/rho - (u - un*n);
    const double tau = xt.norm();
    const Plus low(x0 - tau, smoothing), high(x0 + tau, smoothing);
    const double along = 0.5*(high.slope + low.slope);
    const double coupled = 0.5*(high.slope - low.slope);
    // (f_2 - f_1)/(2 tau) without the cancellation for small tau.
    const double across = tau > 1e-6*(std::abs(x0) + smoothing) ? 0.5*(high.value - low.value)/tau : along;
    const Vec3 t = tau > 0.0 ? Vec3(xt/tau) : Vec3(Vec3::Zero());

    const Vec3 impulse = rho*(0.5*(high.value + low.value)/friction*n + 0.5*(high.value - low.value)*t);
    // Back from (R, U) to (r, u): the normal component is divided by mu on either side.
    const Vec3 m = n/friction;
    const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - n*n.transpose();
    return {impulse, rho*(along*m*m.transpose() + coupled*(m*t.transpose() + t*m.transpose()) + across*tangent
                          + (along - across)*t*t.transpose())};
}

} // namespace nscd
