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

/// Shares of both bodies' spins in a moment, with their signs: a, -b.
std::array<double, 2> sharesOf(const ContactProblem& problem, std::uint32_t slot)
{
    const MomentBlock& block = (*problem.moments)[slot/blockLanes];
    return {block.shareA[slot % blockLanes], -block.shareB[slot % blockLanes]};
}

Eigen::Vector2d inDisc(const Eigen::Vector2d& x, double bound)
{
    const double size = x.norm();
    return (size > bound ? bound/size : 1.0)*x;
}

double within(double x, double bound) { return std::max(-bound, std::min(bound, x)); }

} // namespace

ClusterSolve::ClusterSolve(ContactProblem& problem, std::vector<std::uint32_t> slots)
:
    problem_(problem),
    slots_(std::move(slots)),
    size_(static_cast<int>(slots_.size())),
    unknowns_(unknowns(problem)),
    W_(at(size_), at(size_)),
    r_(at(size_)),
    u_(at(size_)),
    bias_(size_),
    wn_(size_),
    wt_(size_),
    friction_(size_),
    wr_(size_),
    across_(size_),
    along_(size_)
{
    for (int k = 0; k < size_; ++k)
    {
        read(k);
        if (problem.moments) readMoment(k);
    }
    for (int k = 0; k < size_; ++k)
    for (int m = 0; m < size_; ++m)
    {
        W_.block<3, 3>(at(k), at(m)) = mobility(k, m);
        if (problem.moments) setMomentMobility(k, m);
    }
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
    r_.segment<3>(at(k)) = frame_[k]*vec3(block.r, lane);
    u_.segment<3>(at(k)) = frame_[k]*(Vec3(a.v) - Vec3(b.v) - (Vec3(a.s) + Vec3(b.s)).cross(n));
}

void ClusterSolve::readMoment(int k)
{
    const auto [a, b] = bodiesOf(problem_, slots_[k]);
    const std::array<double, 2> share = sharesOf(problem_, slots_[k]);
    const MomentBlock& block = (*problem_.moments)[slots_[k]/blockLanes];
    const int lane = slots_[k] % blockLanes;
    across_[k] = block.across[lane];
    along_[k] = block.along[lane];
    r_.segment<3>(moment(k)) = frame_[k]*vec3(block.q, lane);
    u_.segment<3>(moment(k)) = frame_[k]*(share[0]*Vec3(problem_.bodies[a].s) + share[1]*Vec3(problem_.bodies[b].s));
    wr_[k] = share[0]*share[0]*problem_.bodies[a].invSpin + share[1]*share[1]*problem_.bodies[b].invSpin;
    if (wr_[k] > 0.0) return;
    // Spins that nothing changes ask for nothing.
    wr_[k] = 1.0;
    u_.segment<3>(moment(k)).setZero();
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

/// What a moment in contact m changes of u and w in contact k, and what an impulse there changes of w.
void ClusterSolve::setMomentMobility(int k, int m)
{
    const std::array<int, 2> here = bodiesOf(problem_, slots_[k]), there = bodiesOf(problem_, slots_[m]);
    const std::array<double, 2> share = sharesOf(problem_, slots_[k]), shareThere = sharesOf(problem_, slots_[m]);
    Eigen::Matrix3d ofMoment = Eigen::Matrix3d::Zero(), ofImpulse = Eigen::Matrix3d::Zero();
    double own = 0.0;
    for (int side = 0; side < 2; ++side)
    for (int other = 0; other < 2; ++other)
    {
        const Body& body = problem_.bodies[here[side]];
        if (here[side] != there[other] || !(body.invMass > 0.0)) continue;
        ofMoment += body.invSpin*shareThere[other]*crossProduct(frame_[k].row(0));
        ofImpulse -= body.invSpin*share[side]*crossProduct(frame_[m].row(0));
        own += body.invSpin*share[side]*shareThere[other];
    }
    W_.block<3, 3>(at(k), moment(m)) = frame_[k]*ofMoment*frame_[m].transpose();
    W_.block<3, 3>(moment(k), at(m)) = frame_[k]*ofImpulse*frame_[m].transpose();
    W_.block<3, 3>(moment(k), moment(m)) = own*frame_[k]*frame_[m].transpose();
}

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
        if (!problem_.moments) continue;
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
        if (!problem_.moments) continue;
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
        if (problem_.moments) sweepMoment(k, p);
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

void ClusterSolve::give()
{
    for (int k = 0; k < size_; ++k)
    {
        ContactBlock& block = problem_.blocks[slots_[k]/blockLanes];
        const int lane = slots_[k] % blockLanes;
        const Vec3 change = frame_[k].transpose()*r_.segment<3>(at(k)) - vec3(block.r, lane);
        const double n[3] = {block.n[0][lane], block.n[1][lane], block.n[2][lane]};
        for (int i = 0; i < 3; ++i) block.r[i][lane] += change[i];
        applyImpulse(problem_.bodies[block.a[lane]], problem_.bodies[block.b[lane]], n, change.data());
        if (problem_.moments) giveMoment(k);
    }
}

void ClusterSolve::giveMoment(int k)
{
    MomentBlock& block = (*problem_.moments)[slots_[k]/blockLanes];
    const int lane = slots_[k] % blockLanes;
    const Vec3 change = frame_[k].transpose()*r_.segment<3>(moment(k)) - vec3(block.q, lane);
    const std::array<int, 2> bodies = bodiesOf(problem_, slots_[k]);
    const std::array<double, 2> share = sharesOf(problem_, slots_[k]);
    for (int i = 0; i < 3; ++i)
    {
        block.q[i][lane] += change[i];
        for (int side = 0; side < 2; ++side) problem_.bodies[bodies[side]].s[i] += problem_.bodies[bodies[side]].invSpin*share[side]*change[i];
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
