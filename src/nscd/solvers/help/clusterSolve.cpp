// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a cluster of contacts takes from its problem, and gives back: steps are in clusterNewton.cpp.
#include "nscd/solvers/help/clusterSolve.hpp"

#include "nscd/kernels/applyImpulse.hpp"

#include <array>
#include <utility>

namespace nscd
{

namespace
{

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
    const LawBlock& block = (*problem.lawBlocks)[slot/blockLanes];
    return {block.of[momentLaw::shareA][slot % blockLanes], -block.of[momentLaw::shareB][slot % blockLanes]};
}

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
        if (problem.lawBlocks) readMoment(k);
    }
    for (int k = 0; k < size_; ++k)
    for (int m = 0; m < size_; ++m)
    {
        W_.block<3, 3>(at(k), at(m)) = mobility(k, m);
        if (problem.lawBlocks) setMomentMobility(k, m);
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
    const LawBlock& block = (*problem_.lawBlocks)[slots_[k]/blockLanes];
    const int lane = slots_[k] % blockLanes;
    across_[k] = block.of[momentLaw::across][lane];
    along_[k] = block.of[momentLaw::along][lane];
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
        if (problem_.lawBlocks) giveMoment(k);
    }
}

void ClusterSolve::giveMoment(int k)
{
    LawBlock& block = (*problem_.lawBlocks)[slots_[k]/blockLanes];
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

} // namespace nscd
