// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Dense Newton steps on a cluster of contacts.
#include "nscd/solvers/help/clusterSolve.hpp"

#include "nscd/kernels/applyImpulse.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nscd
{

namespace
{

constexpr double proximal = 1e-7;
constexpr int mostSteps = 12, mostRounds = 2, sweepsBetween = 20;
constexpr int mostHalvings = 8;
constexpr double leastFall = 0.1;   ///< of |F|^2, per share of a step

Eigen::Matrix3d crossProduct(const Vec3& a)
{
    Eigen::Matrix3d matrix;
    matrix << 0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0;
    return matrix;
}

Vec3 vec3(const double (&of)[3][blockLanes], int lane) { return Vec3(of[0][lane], of[1][lane], of[2][lane]); }

std::array<int, 2> bodiesOf(const ContactProblem& problem, std::uint32_t slot)
{
    const ContactBlock& block = problem.blocks[slot/blockLanes];
    return {block.a[slot % blockLanes], block.b[slot % blockLanes]};
}

} // namespace

ClusterSolve::ClusterSolve(ContactProblem& problem, std::vector<std::uint32_t> slots)
:
    problem_(problem),
    slots_(std::move(slots)),
    size_(static_cast<int>(slots_.size())),
    W_(3*size_, 3*size_),
    r_(3*size_),
    u_(3*size_),
    bias_(size_),
    wn_(size_),
    wt_(size_),
    friction_(size_)
{
    for (int k = 0; k < size_; ++k) read(k);
    for (int k = 0; k < size_; ++k)
    for (int m = 0; m < size_; ++m) W_.block<3, 3>(3*k, 3*m) = mobility(k, m);
    f_ = naturalMap(r_, u_);
}

void ClusterSolve::read(int k)
{
    const ContactBlock& block = problem_.blocks[slots_[k]/blockLanes];
    const int lane = slots_[k] % blockLanes;
    const Vec3 n(block.n[0][lane], block.n[1][lane], block.n[2][lane]), t = n.unitOrthogonal();
    frame_[k].row(0) = n;
    frame_[k].row(1) = t;
    frame_[k].row(2) = n.cross(t);
    bias_[k] = block.bias[lane];
    wn_[k] = 1.0/block.invWn[lane];
    wt_[k] = 1.0/block.invWt[lane];
    friction_[k] = problem_.isFrictional ? block.friction[lane] : 0.0;
    const Body &a = problem_.bodies[block.a[lane]], &b = problem_.bodies[block.b[lane]];
    r_.segment<3>(3*k) = frame_[k]*vec3(block.r, lane);
    u_.segment<3>(3*k) = frame_[k]*(Vec3(a.v) - Vec3(b.v) - (Vec3(a.s) + Vec3(b.s)).cross(n));
}

/// What an impulse in contact m changes of u in contact k.
Eigen::Matrix3d ClusterSolve::mobility(int k, int m) const
{
    const std::array<int, 2> here = bodiesOf(problem_, slots_[k]), there = bodiesOf(problem_, slots_[m]);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int side = 0; side < 2; ++side)
    for (int other = 0; other < 2; ++other)
    {
        const Body& body = problem_.bodies[here[side]];
        if (here[side] != there[other] || !(body.invMass > 0.0)) continue;
        const double sign = side == other ? 1.0 : -1.0;
        sum += sign*body.invMass*Eigen::Matrix3d::Identity() - body.invSpin*crossProduct(frame_[k].row(0))*crossProduct(frame_[m].row(0));
    }
    return frame_[k]*sum*frame_[m].transpose();
}

ClusterSolve::Vector ClusterSolve::naturalMap(const Vector& r, const Vector& u) const
{
    Vector f(3*size_);
    for (int k = 0; k < size_; ++k)
    {
        const double p = std::max(0.0, r[3*k] - (u[3*k] + bias_[k])/wn_[k]), bound = friction_[k]*p;
        const Eigen::Vector2d q = r.segment<2>(3*k + 1) - u.segment<2>(3*k + 1)/wt_[k];
        const double size = q.norm();
        f[3*k] = wn_[k]*(r[3*k] - p);
        f.segment<2>(3*k + 1) = wt_[k]*(r.segment<2>(3*k + 1) - (size > bound ? bound/size : 1.0)*q);
    }
    return f;
}

/// Rows of a contact that slips: F_t/W_tt = r_t - mu p q/|q|.
void ClusterSolve::addSlipping(Matrix& jacobian, int k, double p, const Eigen::Vector2d& q) const
{
    const Eigen::Vector2d t = q.normalized();
    const Eigen::Matrix2d turning = friction_[k]*p/q.norm()*(Eigen::Matrix2d::Identity() - t*t.transpose());
    auto rows = jacobian.middleRows<2>(3*k + 1);
    rows = turning*W_.middleRows<2>(3*k + 1) + (wt_[k]/wn_[k]*friction_[k])*t*W_.row(3*k);
    rows.col(3*k) -= wt_[k]*friction_[k]*t;
    rows.middleCols<2>(3*k + 1) += wt_[k]*(Eigen::Matrix2d::Identity() - turning);
}

ClusterSolve::Matrix ClusterSolve::derivative() const
{
    Matrix jacobian = Matrix::Zero(3*size_, 3*size_);
    for (int k = 0; k < size_; ++k)
    {
        const double p = r_[3*k] - (u_[3*k] + bias_[k])/wn_[k];
        const Eigen::Vector2d q = r_.segment<2>(3*k + 1) - u_.segment<2>(3*k + 1)/wt_[k];
        const bool isClosed = p > 0.0, sticks = isClosed && q.norm() <= friction_[k]*p;
        if (isClosed) jacobian.row(3*k) = W_.row(3*k);
        jacobian(3*k, 3*k) += isClosed ? proximal*wn_[k] : wn_[k];
        if (isClosed && !sticks) addSlipping(jacobian, k, p, q);
        else if (sticks) jacobian.middleRows<2>(3*k + 1) = W_.middleRows<2>(3*k + 1);
        if (!isClosed || sticks) jacobian.diagonal().segment<2>(3*k + 1).array() += sticks ? proximal*wt_[k] : wt_[k];
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
        const double p = std::max(0.0, r_[3*k] - (u_[3*k] + bias_[k])/wn_[k]), bound = friction_[k]*p;
        const Eigen::Vector2d q = r_.segment<2>(3*k + 1) - u_.segment<2>(3*k + 1)/wt_[k];
        const double size = q.norm();
        Vec3 change;
        change[0] = p - r_[3*k];
        change.tail<2>() = (size > bound ? bound/size : 1.0)*q - r_.segment<2>(3*k + 1);
        r_.segment<3>(3*k) += change;
        u_ += W_.middleCols<3>(3*k)*change;
    }
}

void ClusterSolve::give()
{
    for (int k = 0; k < size_; ++k)
    {
        ContactBlock& block = problem_.blocks[slots_[k]/blockLanes];
        const int lane = slots_[k] % blockLanes;
        const Vec3 change = frame_[k].transpose()*r_.segment<3>(3*k) - vec3(block.r, lane);
        const double n[3] = {block.n[0][lane], block.n[1][lane], block.n[2][lane]};
        for (int i = 0; i < 3; ++i) block.r[i][lane] += change[i];
        applyImpulse(problem_.bodies[block.a[lane]], problem_.bodies[block.b[lane]], n, change.data());
    }
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
