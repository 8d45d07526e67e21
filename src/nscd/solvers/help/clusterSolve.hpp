// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A few contacts solved together by Newton's method, all others held.
// Tested by tests/unit/nscd/solvers/help/clusterSolveTest.cpp
#pragma once

#include "nscd/solvers/problem/contactProblem.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace nscd
{

/// Semi-smooth Newton's method on the natural map of a few contacts (Alart & Curnier 1991, with rho = 1/W): sweeps pass the load of a heavy body on to a light
/// one that sticks between it and another by the ratio of their masses, a thousandth a sweep; solved together its contacts take all of it at once.
/// one. Moments that contacts bear are solved along, with bounds on them in the place of mu max(0, p).
/// Equation: F(r) = 0, F_n = W_nn (r_n - max(0, p)), F_t = W_tt (r_t - Proj_{mu max(0, p)}(r_t - u_t/W_tt)), p = r_n - (u_n + b)/W_nn, u = u_0 + W r; steps
///           solve a derivative of F, each with a line search on |F|. `proximal` W_nn of closed contacts is added to it: more contacts than bodies can move make W singular
class ClusterSolve
{
public:
    /// What there is room for.
    static int mostContacts(const ContactProblem& problem) { return most/unknowns(problem); }

    /// Of up to mostContacts() slots, none of general bodies.
    ClusterSolve(ContactProblem& problem, std::vector<std::uint32_t> slots);

    /// Newton steps until no |F| exceeds `limit` [m/s], with sweeps in between where they end early; the problem gets the result if |F| is less than it was.
    /// Returns the steps made.
    int run(double limit);

private:
    static constexpr int most = 120;   ///< unknowns: what a thread's stack has room for
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;

    static int unknowns(const ContactProblem& problem) { return problem.lawBlocks ? 6 : 3; }
    int at(int k) const { return unknowns_*k; }
    int moment(int k) const { return unknowns_*k + 3; }
    double pressing(int k, const Vector& r, const Vector& u) const;

    void read(int k);
    void readMoment(int k);
    Eigen::Matrix3d mobility(int k, int m) const;
    void setMomentMobility(int k, int m);
    Vector naturalMap(const Vector& r, const Vector& u) const;
    Matrix derivative() const;
    void addDisc(Matrix& jacobian, int k, int row, double w, double coefficient) const;
    void addSlipping(Matrix& jacobian, int k, int row, double w, double coefficient, double p, const Eigen::Vector2d& q) const;
    void addSpinning(Matrix& jacobian, int k) const;
    int newton(double limit);
    bool moveAlong(const Vector& step);
    void sweep();
    void sweepMoment(int k, double p);
    void give();
    void giveMoment(int k);

    ContactProblem& problem_;
    std::vector<std::uint32_t> slots_;
    int size_;                              ///< contacts
    int unknowns_;                          ///< of each: impulse, and moment over R' behind it
    Matrix W_;                              ///< [1/kg], in the contacts' frames n, t1, t2
    Vector r_, u_, f_;                      ///< [N s], [m/s], F [m/s]
    Vector bias_, wn_, wt_, friction_;
    Vector wr_, across_, along_;            ///< of moments
    Eigen::Matrix3d frame_[most/3];         ///< rows n, t1, t2
};

} // namespace nscd
