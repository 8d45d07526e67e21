// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Sweeps over contacts that bear moments, on every vector path, against plain code.
#include "nscd/kernels/applyImpulse.hpp"
#include "nscd/solvers/help/sweepMomentum.hpp"
#include "unit/nscd/scenes/randomProblem.hpp"

#include <cmath>
#include <cstring>

using namespace scenes;
using nscd::blockLanes;
using nscd::Vec3;

namespace
{

const char* const vectorPaths[] = {"portable", "AVX2", "AVX512"};

Vec3 vec3(const double (&of)[3][blockLanes], int lane) { return Vec3(of[0][lane], of[1][lane], of[2][lane]); }

/// Random contacts, every fifth one at a wall, which bear moments that velocities do not hold.
struct MomentProblem : RandomProblem
{
    std::vector<nscd::LawBlock> moments;

    explicit MomentProblem(int count) : RandomProblem(count), moments(count)
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(0.1, 0.9);
        bodies.push_back({{0.1, 0.0, 0.2}, 0.0, {0.0, 0.3, 0.0}, 0.0});
        for (int k = 0; k < count; ++k)
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            const double b = unit(random);
            moments[k].of[nscd::momentLaw::across][lane] = 0.3*unit(random);
            moments[k].of[nscd::momentLaw::along][lane] = 0.2*unit(random);
            moments[k].of[nscd::momentLaw::shareA][lane] = 1.0 - b;
            moments[k].of[nscd::momentLaw::shareB][lane] = b;
            for (int m = 0; m < 3; ++m) moments[k].q[m][lane] = 0.02*unit(random);
            if (lane % 5 == 0) putAtWall(k, lane);
        }
    }

    void putAtWall(int k, int lane)
    {
        nscd::ContactBlock& block = blocks[k];
        block.b[lane] = static_cast<int>(bodies.size()) - 1;
        moments[k].of[nscd::momentLaw::shareA][lane] = moments[k].of[nscd::momentLaw::shareB][lane] = 1.0;
        const nscd::Body& a = bodies[block.a[lane]];
        block.invWn[lane] = 1.0/a.invMass;
        block.invWt[lane] = 1.0/(a.invMass + a.invSpin);
    }

    nscd::DefectSums sweep(const nscd::SweepKernels& of) { return of.sweepLaw(bodies.data(), blocks.data(), moments.data(), all()); }
};

Vec3 inDisc(const Vec3& x, double limit) { return x.norm() > limit ? Vec3(x*(limit/x.norm())) : x; }

/// One contact in plain code.
class PlainContact
{
public:
    PlainContact(MomentProblem& problem, int k, int lane)
    :
        block_(problem.blocks[k]), moments_(problem.moments[k]), lane_(lane), A_(problem.bodies[block_.a[lane]]), B_(problem.bodies[block_.b[lane]]),
        a_(moments_.of[nscd::momentLaw::shareA][lane]), b_(moments_.of[nscd::momentLaw::shareB][lane]), n_(vec3(block_.n, lane)), r_(vec3(block_.r, lane)), q_(vec3(moments_.q, lane)),
        u_(Vec3(A_.v) - Vec3(B_.v) - (Vec3(A_.s) + Vec3(B_.s)).cross(n_)), w_(a_*Vec3(A_.s) - b_*Vec3(B_.s)),
        wr_(a_*a_*A_.invSpin + b_*b_*B_.invSpin)
    {}

    /// The impulse along the normal, what is in the tangent plane, the moment along the normal. Returns the larger squared defect.
    double solve()
    {
        const double wn = A_.invMass + B_.invMass, wt = wn + A_.invSpin + B_.invSpin, c = a_*A_.invSpin - b_*B_.invSpin;
        const double pn = std::max(0.0, n_.dot(r_) - (n_.dot(u_) + block_.bias[lane_])/wn), friction = block_.friction[lane_]*pn;
        const Vec3 rt = across(r_), qt = across(q_), ut = across(u_), wq = across(w_);
        // c couples them: u changes by W_tt dr - c dq x n, w by W_r dq - c n x dr.
        Vec3 sticking = inDisc(qt - (wq + c/wt*n_.cross(ut))/(wr_ - c*c/wt), moments_.of[nscd::momentLaw::across][lane_]*pn);
        Vec3 newR = rt - (ut - c*(sticking - qt).cross(n_))/wt;
        if (newR.norm() > friction)
        {
            newR = inDisc(rt - ut/wt, friction);
            sticking = inDisc(qt - (wq - c*n_.cross(newR - rt))/wr_, moments_.of[nscd::momentLaw::across][lane_]*pn);
        }
        const double most = moments_.of[nscd::momentLaw::along][lane_]*pn, spinning = std::max(-most, std::min(most, n_.dot(q_) - n_.dot(w_)/wr_));
        const Vec3 dr = pn*n_ + newR - r_, dq = sticking + spinning*n_ - q_;
        const double tangential = wt*(newR - rt).norm(), normal = wn*(pn - n_.dot(r_));
        give(dr, dq);
        return std::max(tangential*tangential + normal*normal, std::pow(wr_*dq.norm(), 2));
    }

    /// Squared defect of the moment.
    double defect() const
    {
        const double rn = std::max(0.0, n_.dot(r_)), most = moments_.of[nscd::momentLaw::along][lane_]*rn;
        const Vec3 rolls = inDisc(across(q_) - across(w_)/wr_, moments_.of[nscd::momentLaw::across][lane_]*rn) - across(q_);
        const double spinning = std::max(-most, std::min(most, n_.dot(q_) - n_.dot(w_)/wr_)) - n_.dot(q_);
        return wr_*wr_*(rolls.squaredNorm() + spinning*spinning);
    }

private:
    Vec3 across(const Vec3& x) const { return x - n_.dot(x)*n_; }

    void give(const Vec3& dr, const Vec3& dq)
    {
        nscd::applyImpulse(A_, B_, n_.data(), dr.data());
        for (int m = 0; m < 3; ++m)
        {
            block_.r[m][lane_] += dr[m];
            moments_.q[m][lane_] += dq[m];
            A_.s[m] += A_.invSpin*a_*dq[m];
            B_.s[m] -= B_.invSpin*b_*dq[m];
        }
    }

    nscd::ContactBlock& block_;
    nscd::LawBlock& moments_;
    int lane_;
    nscd::Body &A_, &B_;
    double a_, b_;
    Vec3 n_, r_, q_, u_, w_;
    double wr_;
};

/// Calls visit(contact) for all contacts; returns the largest of what it returns.
template<class Visit>
double largestOf(MomentProblem& problem, const Visit& visit)
{
    double largest = 0.0;
    for (int k = 0; k < static_cast<int>(problem.blocks.size()); ++k)
    for (int lane = 0; lane < blockLanes; ++lane) largest = std::max(largest, visit(PlainContact(problem, k, lane)));
    return largest;
}

void expectSameImpulses(const MomentProblem& x, const MomentProblem& y, double tolerance)
{
    for (std::size_t k = 0; k < x.blocks.size(); ++k)
    for (int lane = 0; lane < blockLanes; ++lane)
    {
        ASSERT_LT((vec3(x.blocks[k].r, lane) - vec3(y.blocks[k].r, lane)).norm(), tolerance);
        ASSERT_LT((vec3(x.moments[k].q, lane) - vec3(y.moments[k].q, lane)).norm(), tolerance);
    }
}

/// Calls test(kernels) for each vector path there is.
template<class Test>
void onEveryPath(const Test& test)
{
    for (const char* path : vectorPaths)
    {
        SCOPED_TRACE(path);
        if (isAvailable(path)) test(nscd::chooseKernels(path));
    }
}

} // namespace

TEST(MomentKernels, sweepAsPlainCodeDoes)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        MomentProblem x(30), y(30);
        for (int sweep = 0; sweep < 5; ++sweep)
        {
            const double largest = largestOf(x, [](PlainContact contact) { return contact.solve(); });
            EXPECT_NEAR(y.sweep(kernels).maxSquare, largest, 1e-11*largest);
        }
        expectSameBodies(x.bodies, y.bodies, 1e-12);
        expectSameImpulses(x, y, 1e-12);
    });
}

TEST(MomentKernels, evaluateTheNaturalMapOfMoments)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        MomentProblem problem(10);
        double sum = 0.0;
        const double largest = largestOf(problem, [&](const PlainContact& contact) { sum += contact.defect(); return contact.defect(); });
        const nscd::DefectSums sums = kernels.evaluateLaw(problem.bodies.data(), problem.blocks.data(), problem.moments.data(), problem.all());
        EXPECT_NEAR(sums.maxSquare, largest, 1e-12*largest);
        EXPECT_NEAR(sums.sumSquares, sum, 1e-12*sum);
        EXPECT_EQ(sums.active, 0.0);
    });
}

TEST(MomentKernels, withoutBoundsForMomentsTheyAreThoseOfFriction)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        MomentProblem x(30), y(30);
        for (MomentProblem* problem : {&x, &y})
        {
            for (nscd::LawBlock& block : problem->moments)
            {
                std::fill_n(&block.q[0][0], 3*blockLanes, 0.0);
                std::fill_n(block.of[nscd::momentLaw::across], blockLanes, 0.0);
                std::fill_n(block.of[nscd::momentLaw::along], blockLanes, 0.0);
            }
        }
        for (int sweep = 0; sweep < 5; ++sweep)
        {
            const nscd::DefectSums plain = kernels.sweep(x.bodies.data(), x.blocks.data(), x.all()), sums = y.sweep(kernels);
            EXPECT_NEAR(sums.sumSquares, plain.sumSquares, 1e-11*plain.sumSquares);
            EXPECT_EQ(sums.active, plain.active);
        }
        expectSameBodies(x.bodies, y.bodies, 1e-12);
    });
}

TEST(MomentKernels, whatIsNoLongerPressedBearsNothingToTheBit)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        MomentProblem problem(10);
        for (nscd::ContactBlock& block : problem.blocks) std::fill_n(block.bias, blockLanes, nscd::unreachable);
        problem.sweep(kernels);
        for (std::size_t k = 0; k < problem.blocks.size(); ++k)
        for (int i = 0; i < 3*blockLanes; ++i)
        {
            EXPECT_EQ((&problem.blocks[k].r[0][0])[i], 0.0);
            EXPECT_EQ((&problem.moments[k].q[0][0])[i], 0.0);
        }
    });
}

TEST(MomentKernels, sweepOnWhatMovingOnAndSweepingDoes)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        MomentProblem one(7), other(7);
        std::vector<double> before(7*3*blockLanes, 0.03), momentsBefore(7*3*blockLanes, 0.01);
        kernels.extrapolate(one.blocks.data(), one.all(), std::vector<double>(before).data(), 0.7);
        for (nscd::LawBlock& block : one.moments)
        {
            for (int i = 0; i < 3*blockLanes; ++i) (&block.q[0][0])[i] += 0.7*((&block.q[0][0])[i] - 0.01);
        }
        one.sweep(kernels);
        const nscd::LawBlock start = other.moments[6];
        kernels.sweepLawOn(other.bodies.data(), other.blocks.data(), other.moments.data(), other.all(), before.data(), momentsBefore.data(), 0.7);
        expectSameBodies(one.bodies, other.bodies, 1e-13);
        expectSameImpulses(one, other, 1e-13);
        EXPECT_EQ(std::memcmp(&momentsBefore[6*3*blockLanes], start.q, sizeof start.q), 0);
    });
}

TEST(MomentKernels, momentumMovesMomentsAndVelocitiesAlikeAndTakesThemBackToTheBit)
{
    using Kind = nscd::SweepMomentum::Kind;
    for (const Kind kind : {Kind::falling, Kind::flowing})
    {
        MomentProblem problem(20), unloaded(20);
        nscd::ContactProblem whole = problem.problem();
        whole.lawBlocks = &problem.moments;
        problem.position.resize(problem.bodies.size() - 1, Vec3::Zero());
        const nscd::SolverStrategy strategy;
        nscd::SweepMomentum momentum(whole, kind, strategy.momentum);
        nscd::sweepActive(whole);
        momentum.advance();
        nscd::sweepActive(whole, momentum.forNextSweep());
        const MomentProblem held = problem;
        momentum.advance();
        nscd::sweepActive(whole, momentum.forNextSweep());
        // v - v_start = M^-1 H (r - r_start), for moments as for impulses: taken off again, the start is there.
        for (std::size_t k = 0; k < problem.blocks.size(); ++k)
        for (int lane = 0; lane < blockLanes; ++lane)
        {
            nscd::Body &a = problem.bodies[problem.blocks[k].a[lane]], &b = problem.bodies[problem.blocks[k].b[lane]];
            const Vec3 n = vec3(problem.blocks[k].n, lane), r = vec3(unloaded.blocks[k].r, lane) - vec3(problem.blocks[k].r, lane);
            const Vec3 q = vec3(unloaded.moments[k].q, lane) - vec3(problem.moments[k].q, lane);
            nscd::applyImpulse(a, b, n.data(), r.data());
            for (int m = 0; m < 3; ++m)
            {
                a.s[m] += a.invSpin*problem.moments[k].of[nscd::momentLaw::shareA][lane]*q[m];
                b.s[m] -= b.invSpin*problem.moments[k].of[nscd::momentLaw::shareB][lane]*q[m];
            }
        }
        expectSameBodies(problem.bodies, unloaded.bodies, 1e-12);
        momentum.revert();
        EXPECT_EQ(std::memcmp(problem.bodies.data(), held.bodies.data(), held.bodies.size()*sizeof(nscd::Body)), 0);
        EXPECT_EQ(std::memcmp(problem.moments.data(), held.moments.data(), held.moments.size()*sizeof(nscd::LawBlock)), 0);
        EXPECT_EQ(std::memcmp(problem.blocks.data(), held.blocks.data(), held.blocks.size()*sizeof(nscd::ContactBlock)), 0);
    }
}
