// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Dense Newton steps on a cluster of contacts.
// Tested by tests/unit/nscd/solvers/help/clusterSolveTest.cpp
#include "nscd/solvers/help/clusterSolve.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

constexpr double proximal = 1e-7;
constexpr int mostSteps = 12, mostRounds = 2, sweepsBetween = 20;
constexpr int mostHalvings = 8;
constexpr double leastFall = 0.1;   ///< of |F|^2, per share of a step

Eigen::Vector2d inDisc(const Eigen::Vector2d& x, double bound)
{
    const double size = x.norm();
    return (size > bound ? bound/size : 1.0)*x;
}

double within(double x, double bound) { return std::max(-bound, std::min(bound, x)); }

} // namespace

/// p, which may be negative.
double ClusterSolve::pressing(int k, const Vector& r, const Vector& u) const { return r[at(k)] - (u[at(k)] + bias_[k])/wn_[k]; }

ClusterSolve::Vector ClusterSolve::naturalMap(const Vector& r, const Vector& u) const
{
    Vector f(at(size_));
    for (int k = 0; k < size_; ++k)
    {
        const double p = std::max(0.0, pressing(k, r, u));
        const auto setDisc = [&](int row, double w, double bound)
        {
            f.segment<2>(row) = w*(r.segment<2>(row) - inDisc(r.segment<2>(row) - u.segment<2>(row)/w, bound));
        };
        f[at(k)] = wn_[k]*(r[at(k)] - p);
        setDisc(at(k) + 1, wt_[k], friction_[k]*p);
        if (!problem_.lawBlocks) continue;
        f[moment(k)] = wr_[k]*(r[moment(k)] - within(r[moment(k)] - u[moment(k)]/wr_[k], along_[k]*p));
        setDisc(moment(k) + 1, wr_[k], across_[k]*p);
    }
    return f;
}

/// Two rows x at the bound c p: F/w = x - c p y/|y|, y = x - u/w.
void ClusterSolve::addSlipping(Matrix& jacobian, int k, int row, double w, double coefficient, double p, const Eigen::Vector2d& y) const
{
    const Eigen::Vector2d t = y.normalized();
    const Eigen::Matrix2d turning = coefficient*p/y.norm()*(Eigen::Matrix2d::Identity() - t*t.transpose());
    auto rows = jacobian.middleRows<2>(row);
    rows = turning*W_.middleRows<2>(row) + (w/wn_[k]*coefficient)*t*W_.row(at(k));
    rows.col(at(k)) -= w*coefficient*t;
    rows.middleCols<2>(row) += w*(Eigen::Matrix2d::Identity() - turning);
}

/// Two rows x with |x| <= c p.
void ClusterSolve::addDisc(Matrix& jacobian, int k, int row, double w, double coefficient) const
{
    const double p = pressing(k, r_, u_);
    const Eigen::Vector2d y = r_.segment<2>(row) - u_.segment<2>(row)/w;
    const bool isClosed = p > 0.0, sticks = isClosed && y.norm() <= coefficient*p;
    if (isClosed && !sticks) addSlipping(jacobian, k, row, w, coefficient, p, y);
    else if (sticks) jacobian.middleRows<2>(row) = W_.middleRows<2>(row);
    if (!isClosed || sticks) jacobian.diagonal().segment<2>(row).array() += sticks ? proximal*w : w;
}

/// The row of the moment along the normal.
void ClusterSolve::addSpinning(Matrix& jacobian, int k) const
{
    const int row = moment(k);
    const double p = pressing(k, r_, u_), w = wr_[k], y = r_[row] - u_[row]/w, slope = std::copysign(w*along_[k], y);
    const bool isClosed = p > 0.0, sticks = isClosed && std::abs(y) <= along_[k]*p;
    if (sticks) jacobian.row(row) = W_.row(row);
    else if (isClosed)
    {
        jacobian.row(row) = slope/wn_[k]*W_.row(at(k));
        jacobian(row, at(k)) -= slope;
    }
    jacobian(row, row) += sticks ? proximal*w : w;
}

ClusterSolve::Matrix ClusterSolve::derivative() const
{
    Matrix jacobian = Matrix::Zero(at(size_), at(size_));
    for (int k = 0; k < size_; ++k)
    {
        const bool isClosed = pressing(k, r_, u_) > 0.0;
        if (isClosed) jacobian.row(at(k)) = W_.row(at(k));
        jacobian(at(k), at(k)) += isClosed ? proximal*wn_[k] : wn_[k];
        addDisc(jacobian, k, at(k) + 1, wt_[k], friction_[k]);
        if (!problem_.lawBlocks) continue;
        addSpinning(jacobian, k);
        addDisc(jacobian, k, moment(k) + 1, wr_[k], across_[k]);
    }
    return jacobian;
}

/// A share of the step that makes |F| smaller. Returns whether there is one.
bool ClusterSolve::moveAlong(const Vector& step)
{
    const Vector change = W_*step;
    double share = 1.0;
    for (int k = 0; k < mostHalvings; ++k, share *= 0.5)
    {
        const Vector r = r_ + share*step, u = u_ + share*change, f = naturalMap(r, u);
        if (!(f.squaredNorm() < (1.0 - leastFall*share)*f_.squaredNorm())) continue;
        r_ = r;
        u_ = u;
        f_ = f;
        return true;
    }
    return false;
}

int ClusterSolve::newton(double limit)
{
    for (int steps = 0; steps < mostSteps; ++steps)
    {
        if (f_.cwiseAbs().maxCoeff() <= limit) return steps;
        const Vector step = -derivative().partialPivLu().solve(f_);
        if (!step.allFinite() || !moveAlong(step)) return steps + 1;
    }
    return mostSteps;
}

void ClusterSolve::sweep()
{
    for (int k = 0; k < size_; ++k)
    {
        const double p = std::max(0.0, pressing(k, r_, u_));
        Vec3 change;
        change[0] = p - r_[at(k)];
        change.tail<2>() = inDisc(r_.segment<2>(at(k) + 1) - u_.segment<2>(at(k) + 1)/wt_[k], friction_[k]*p) - r_.segment<2>(at(k) + 1);
        r_.segment<3>(at(k)) += change;
        u_ += W_.middleCols<3>(at(k))*change;
        if (problem_.lawBlocks) sweepMoment(k, p);
    }
}

void ClusterSolve::sweepMoment(int k, double p)
{
    const Vec3 y = r_.segment<3>(moment(k)) - u_.segment<3>(moment(k))/wr_[k];
    Vec3 change;
    change[0] = within(y[0], along_[k]*p);
    change.tail<2>() = inDisc(y.tail<2>(), across_[k]*p);
    change -= r_.segment<3>(moment(k));
    r_.segment<3>(moment(k)) += change;
    u_ += W_.middleCols<3>(moment(k))*change;
}

int ClusterSolve::run(double limit)
{
    const double before = f_.squaredNorm();
    int steps = 0;
    for (int round = 0; round < mostRounds; ++round)
    {
        steps += newton(limit);
        if (f_.cwiseAbs().maxCoeff() <= limit) break;
        for (int k = 0; k < sweepsBetween; ++k) sweep();
        f_ = naturalMap(r_, u_);
    }
    if (f_.squaredNorm() < before) give();
    return steps;
}

} // namespace nscd
