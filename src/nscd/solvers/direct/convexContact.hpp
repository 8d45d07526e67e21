// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The convex problem inside a direct contact solve: velocities of the bodies against stiff contacts.
#pragma once

#include "nscd/solvers/direct/contactStiffness.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace nscd
{

/// A contact of a convex problem.
struct ConeContact
{
    std::size_t slot;
    JoinedBodies joined;     ///< bodies by number in the problem, -1: one that does not move
    Vec3 n;                  ///< unit, from B to A
    Vec3 wallVelocity;       ///< part of u that is given: of bodies that do not move [m/s]
    double bias;             ///< [m/s]
    double friction;
    double penalty;          ///< rho [kg]
    Vec3 multiplier;         ///< r [N s]
    double slip = 0.0;       ///< s [m/s]
    Vec3 impulse;            ///< p [N s]
};

/// Minimizes the convex J(x) with gradient M (x - x_free) - sum of B^T p, p = smoothedImpulse(r, u + (b + mu s) n), u = B x: at the
/// minimum x = x_free + M^-1 B^T p, so that p are impulses that make x. Its Hessian is M + sum of B^T (-dp/du) B.
class ConvexContact
{
public:
    /// `motion`, with the impulses p of `contacts` in it, and `mass`: six numbers a body, v and s.
    ConvexContact(std::vector<ConeContact> contacts, const Eigen::VectorXd& motion, Eigen::VectorXd mass, MotionComponents components);

    std::vector<ConeContact>& contacts() { return contacts_; }
    const std::vector<ConeContact>& contacts() const { return contacts_; }

    /// Newton steps from `x`, each as long as J falls along it, until no body's velocity is off by more than `limit` [m/s] or rounding
    /// ends it. Without smoothing the contacts of a stack close one by one, a step each: so it starts at `firstSmoothing` and shrinks to
    /// `lastSmoothing` [m/s]. Impulses are those of the x found. Returns the steps made.
    int minimize(Eigen::VectorXd& x, double limit, double firstSmoothing, double lastSmoothing);

    /// x_free + M^-1 B^T p of the present impulses.
    Eigen::VectorXd motion() const;

    /// Relative velocity of a contact [m/s].
    Vec3 relativeVelocity(const ConeContact& contact, const Eigen::VectorXd& x) const;

private:
    Eigen::VectorXd gradient(const Eigen::VectorXd& x);
    Eigen::VectorXd impulsesOnBodies() const;
    Eigen::VectorXd newtonStep(const Eigen::VectorXd& gradient);
    double slope(const Eigen::VectorXd& x, const Eigen::VectorXd& step) { return gradient(x).dot(step); }
    double moveAlong(Eigen::VectorXd& x, const Eigen::VectorXd& step, double startSlope);

    std::vector<ConeContact> contacts_;
    std::vector<Eigen::Matrix3d> stiffnesses_;   ///< -dp/du at the x of the last gradient
    double smoothing_ = 0.0;                     ///< eta [m/s]
    Eigen::VectorXd free_;
    Eigen::VectorXd mass_;
    ContactStiffness stiffness_;
};

} // namespace nscd
