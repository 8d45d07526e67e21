// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Start of a step by every vector path against the formulas it stands for.
#include "nscd/kernels/applyImpulse.hpp"
#include "unit/nscd/scenes/randomProblem.hpp"

#include <limits>

using namespace scenes;
using nscd::Vec3;

namespace
{

template<class Test>
void onEveryPath(const Test& test)
{
    for (const char* path : {"portable", "AVX2", "AVX512"})
    {
        SCOPED_TRACE(path);
        if (isAvailable(path)) test(nscd::chooseKernels(path));
    }
}

Vec3 at(const double (&x)[3][nscd::blockLanes], int lane) { return Vec3(x[0][lane], x[1][lane], x[2][lane]); }

constexpr nscd::LawOfStep law{1e-3, 1e-4, nscd::unreachable};

/// One block of eight contacts at rest with these gaps, without impulses; the last lane is not used.
struct OpenBlock
{
    RandomProblem random{1};
    nscd::ContactBlock& block = random.blocks[0];
    double gap[nscd::blockLanes] = {1e-3, 2e-3, 5e-3, 0.1, 1.0, 1e3, std::numeric_limits<double>::max(), 0.0};

    OpenBlock()
    {
        for (nscd::Body& body : random.bodies) std::fill(body.v, body.v + 3, 0.0);
        for (auto& component : block.r) std::fill(component, component + nscd::blockLanes, 0.0);
        random.bodies.push_back({});
        block.a[7] = block.b[7] = static_cast<int>(random.bodies.size()) - 1;
    }

    bool isAwake(const nscd::SweepKernels& kernels) { return kernels.setLaws(random.bodies.data(), block, gap, law); }
};

} // namespace

TEST(StartKernel, setsOperatorsAndTheBiasOfEachGap)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        OpenBlock open;
        open.gap[1] = 0.99e-4;   // within the dead band
        open.gap[2] = -5e-3;
        open.isAwake(kernels);
        const double expected[] = {1.0, 0.0, 0.0, 100.0, 1e3, 1e6, nscd::unreachable, 0.0};
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            const nscd::Body& a = open.random.bodies[open.block.a[lane]];
            const nscd::Body& b = open.random.bodies[open.block.b[lane]];
            EXPECT_DOUBLE_EQ(open.block.bias[lane], expected[lane]);
            const double wn = a.invMass + b.invMass, wt = wn + a.invSpin + b.invSpin;
            EXPECT_DOUBLE_EQ(open.block.invWn[lane], lane < 7 ? 1/wn : 0.0);
            EXPECT_DOUBLE_EQ(open.block.invWt[lane], lane < 7 ? 1/wt : 0.0);
        }
    });
}

TEST(StartKernel, blocksAreAwakeWithAContactThatIsClosedClosesOrIsLoaded)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        for (int lane = 0; lane < 7; ++lane)
        {
            EXPECT_FALSE(OpenBlock().isAwake(kernels));
            OpenBlock closed, closing, slow, loaded;
            closed.gap[lane] = 0.5*law.deadBand;
            EXPECT_TRUE(closed.isAwake(kernels)) << lane;
            closing.gap[lane] = slow.gap[lane] = 1e-3;
            for (int k = 0; k < 3; ++k)
            {
                closing.random.bodies[closing.block.a[lane]].v[k] = -1.01*closing.block.n[k][lane];
                slow.random.bodies[slow.block.a[lane]].v[k] = -0.99*slow.block.n[k][lane];
            }
            EXPECT_TRUE(closing.isAwake(kernels)) << lane;
            EXPECT_FALSE(slow.isAwake(kernels)) << lane;
            loaded.block.r[1][lane] = -1e-9;
            EXPECT_TRUE(loaded.isAwake(kernels)) << lane;
        }
    });
}

TEST(StartKernel, warmImpulsesAreScaledAdmissibleAndGivenToTheBodies)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        RandomProblem random(6), start(6);
        for (std::size_t k = 0; k < 6; ++k)
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            // Some attract, some slide, some stick.
            const Vec3 n = at(start.blocks[k].n, lane), r = (lane % 3 - 0.5)*n + 0.2*lane*n.unitOrthogonal();
            for (int m = 0; m < 3; ++m) start.blocks[k].r[m][lane] = random.blocks[k].r[m][lane] = r[m];
        }
        kernels.startWarm(random.bodies.data(), random.blocks.data(), random.all(), 0.7);
        for (std::size_t k = 0; k < 6; ++k)
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            const nscd::ContactBlock& block = start.blocks[k];
            const Vec3 n = at(block.n, lane), r = 0.7*at(block.r, lane);
            const double rn = std::max(0.0, r.dot(n));
            const Vec3 rt = r - r.dot(n)*n;
            const Vec3 p = rn*n + std::min(1.0, block.friction[lane]*rn/std::max(rt.norm(), 1e-300))*rt;
            EXPECT_LT((at(random.blocks[k].r, lane) - p).norm(), 1e-14) << k << ' ' << lane;
            nscd::applyImpulse(start.bodies[block.a[lane]], start.bodies[block.b[lane]], n.data(), p.data());
        }
        expectSameBodies(random.bodies, start.bodies, 1e-13);
    });
}

TEST(StartKernel, impulsesAreGivenAsTheyAre)
{
    onEveryPath([](const nscd::SweepKernels& kernels)
    {
        RandomProblem random(6), start(6);
        kernels.giveImpulses(random.bodies.data(), random.blocks.data(), random.all());
        for (const nscd::ContactBlock& block : start.blocks)
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            const Vec3 n = at(block.n, lane), p = at(block.r, lane);
            nscd::applyImpulse(start.bodies[block.a[lane]], start.bodies[block.b[lane]], n.data(), p.data());
        }
        expectSameBodies(random.bodies, start.bodies, 1e-13);
    });
}
