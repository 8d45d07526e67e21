// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Packed contacts: nothing is lost, what comes in later is taken in, and the solution is that of the whole problem.
#include "nscd/solvers/help/packedContacts.hpp"
#include "unit/nscd/scenes/fallingColumn.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

using namespace scenes;

namespace
{

/// Unit masses on a square grid that fly about, with contacts between neighbors of which half are open.
struct Grid
{
    static constexpr int side = 50;
    std::vector<nscd::Body> bodies, freeBodies;
    std::vector<nscd::ContactBlock> blocks;
    std::vector<std::uint32_t> awake;
    std::vector<Vec3> position;
    nscd::Halo alone;
    nscd::SweepKernels kernels = nscd::chooseKernels("portable");
    bool isFrictional;
    std::vector<nscd::LawBlock> moments;   ///< of grids that roll

    explicit Grid(bool hasFriction) : isFrictional(hasFriction)
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (int i = 0; i < side*side; ++i)
        {
            position.push_back(Vec3(i % side, i/side, 0));
            bodies.push_back({{unit(random), unit(random), unit(random)}, 1.0, {0, 0, 0}, 2.5});
        }
        const int staticBody = side*side;
        bodies.push_back({{0, 0, 0}, 0.0, {0, 0, 0}, 0.0});
        freeBodies = bodies;

        std::vector<nscd::Candidate> contacts;
        for (int i = 0; i < side*side; ++i)
        {
            if (i % side + 1 < side) contacts.push_back({i, i + 1, -1, {0, 0, 0}});
            if (i + side < side*side) contacts.push_back({i, i + side, -1, {0, 0, 0}});
        }
        std::vector<std::uint32_t> order(contacts.size());
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<std::uint32_t>(k);
        const nscd::Batches batches = nscd::batchContacts(contacts, order, staticBody);
        blocks.assign(batches.blocks, nscd::emptyBlock(staticBody));
        for (std::size_t k = 0; k < contacts.size(); ++k)
        {
            nscd::ContactBlock& block = blocks[batches.slotOf[k]/nscd::blockLanes];
            const std::size_t lane = batches.slotOf[k] % nscd::blockLanes;
            block.a[lane] = contacts[k].a;
            block.b[lane] = contacts[k].b;
            const Vec3 n = (position[contacts[k].a] - position[contacts[k].b]).normalized();
            for (int m = 0; m < 3; ++m) block.n[m][lane] = n[m];
            block.bias[lane] = std::max(0.0, unit(random));
            block.invWn[lane] = 0.5;
            block.invWt[lane] = 1.0/7.0;
            block.friction[lane] = hasFriction ? 0.3 : 0.0;
        }
        for (std::uint32_t k = 0; k < blocks.size(); ++k) awake.push_back(k);
    }

    nscd::ContactProblem problem()
    {
        nscd::ContactProblem problem{bodies, blocks, awake, blocks.size(), alone, kernels, isFrictional, 1.0, 1.0, 1.0, position};
        if (!moments.empty()) problem.lawBlocks = &moments;
        return problem;
    }

    /// Lets contacts bear moments.
    void roll()
    {
        moments.resize(blocks.size(), nscd::LawBlock());
        for (nscd::LawBlock& block : moments)
        {
            std::fill_n(block.of[nscd::momentLaw::across], nscd::blockLanes, 0.1);
            std::fill_n(block.of[nscd::momentLaw::along], nscd::blockLanes, 0.05);
            std::fill_n(block.of[nscd::momentLaw::shareA], nscd::blockLanes, 0.5);
            std::fill_n(block.of[nscd::momentLaw::shareB], nscd::blockLanes, 0.5);
        }
    }

    std::size_t loaded() const
    {
        std::size_t count = 0;
        for (const nscd::ContactBlock& block : blocks)
        for (int lane = 0; lane < nscd::blockLanes; ++lane) count += block.r[0][lane] != 0.0 || block.r[1][lane] != 0.0 || block.r[2][lane] != 0.0;
        return count;
    }

    /// Largest error of v = v_free + M^-1 sum of impulses.
    double momentumError() const
    {
        std::vector<Vec3> v;
        for (const nscd::Body& body : freeBodies) v.push_back(Vec3(body.v));
        for (const nscd::ContactBlock& block : blocks)
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            const Vec3 r(block.r[0][lane], block.r[1][lane], block.r[2][lane]);
            v[block.a[lane]] += freeBodies[block.a[lane]].invMass*r;
            v[block.b[lane]] -= freeBodies[block.b[lane]].invMass*r;
        }
        double worst = 0.0;
        for (std::size_t i = 0; i < v.size(); ++i) worst = std::max(worst, (v[i] - Vec3(bodies[i].v)).norm());
        return worst;
    }
};

nscd::ContactSettings exact()
{
    nscd::ContactSettings settings;
    settings.tolerance = settings.displacementTolerance = 1e-10;
    settings.maxSweeps = 20000;
    return settings;
}

} // namespace

TEST(PackedContacts, areWorthwhileInLongSolvesOfLargeFlows)
{
    Grid grid(true);
    nscd::ContactProblem problem = grid.problem();
    nscd::PackedContacts packing;
    EXPECT_FALSE(packing.isWorthwhile(problem, {}));
    packing.note(false, 100);
    EXPECT_TRUE(packing.isWorthwhile(problem, {}));
    problem.isShock = true;
    EXPECT_FALSE(packing.isWorthwhile(problem, {}));
    packing.note(true, 12);
    EXPECT_TRUE(packing.isWorthwhile(problem, {}));
    packing.forget();
    EXPECT_FALSE(packing.isWorthwhile(problem, {}));
    problem.isShock = false;
    packing.note(false, 100);
    problem.motion = 0.1;
    EXPECT_FALSE(packing.isWorthwhile(problem, {}));
    Column column(3, Vec3::UnitZ());
    EXPECT_FALSE(packing.isWorthwhile(column.problem(), {}));
}

TEST(PackedContacts, comeBackToTheBit)
{
    Grid grid(true);
    nscd::ContactProblem problem = grid.problem();
    for (int k = 0; k < 3; ++k) nscd::sweepActive(problem);
    const std::vector<nscd::ContactBlock> before = grid.blocks;
    const std::vector<std::uint32_t> awake = grid.awake;
    const std::size_t loaded = grid.loaded();
    nscd::PackedContacts packing;
    nscd::ContactProblem packed = packing.pack(problem, 0.008);
    EXPECT_LT(packed.blocks.size(), before.size());
    EXPECT_EQ(grid.loaded(), 0u);
    EXPECT_EQ(packing.defects(packed).sumSquares, 0.0);   // whatever closes is packed
    std::size_t there = 0;
    for (const nscd::ContactBlock& block : packed.blocks)
    for (int lane = 0; lane < nscd::blockLanes; ++lane) there += block.r[0][lane] != 0.0 || block.r[1][lane] != 0.0 || block.r[2][lane] != 0.0;
    EXPECT_EQ(there, loaded);
    packing.giveBack(problem);
    EXPECT_EQ(grid.awake, awake);
    EXPECT_EQ(std::memcmp(grid.blocks.data(), before.data(), before.size()*sizeof(nscd::ContactBlock)), 0);
}

TEST(PackedContacts, areSolvedAsTheWholeIs)
{
    for (bool hasFriction : {false, true})
    {
        Grid whole(hasFriction), packed(hasFriction);
        nscd::ContactProblem a = whole.problem(), b = packed.problem();
        nscd::PackedContacts packing;
        packing.note(false, 100);
        b.packing = &packing;
        EXPECT_TRUE(nscd::solveNlgs(a, exact()).converged);
        const nscd::SolveReport report = nscd::solveNlgs(b, exact());
        EXPECT_TRUE(report.converged);
        EXPECT_LT(packed.momentumError(), 1e-12);
        const nscd::DefectSums left = nscd::residual(b);
        EXPECT_LE(nscd::rms(left), 1.0001e-10);
        EXPECT_NEAR(nscd::rms(left), report.residualRms, 1e-3*report.residualRms);
        EXPECT_EQ(static_cast<std::size_t>(left.active), report.contacts);
        if (hasFriction) continue;   // which is not unique then
        for (std::size_t i = 0; i < whole.bodies.size(); ++i)
        {
            ASSERT_NEAR((Vec3(whole.bodies[i].v) - Vec3(packed.bodies[i].v)).norm(), 0.0, 1e-7) << i;
        }
    }
}

TEST(PackedContacts, takeMomentsAlong)
{
    Grid grid(true);
    grid.roll();
    nscd::ContactProblem problem = grid.problem();
    for (int k = 0; k < 3; ++k) nscd::sweepActive(problem);
    const std::vector<nscd::LawBlock> before = grid.moments;
    const nscd::DefectSums whole = nscd::residual(problem);
    nscd::PackedContacts packing;
    nscd::ContactProblem packed = packing.pack(problem, 0.008);
    EXPECT_NEAR(nscd::residual(packed).sumSquares, whole.sumSquares, 1e-12*whole.sumSquares);
    packing.giveBack(problem);
    EXPECT_EQ(std::memcmp(grid.moments.data(), before.data(), before.size()*sizeof(nscd::LawBlock)), 0);

    packing.note(false, 100);
    problem.packing = &packing;
    EXPECT_TRUE(nscd::solveNlgs(problem, exact()).converged);
    EXPECT_LE(nscd::rms(nscd::residual(problem)), 1.0001e-10);
}

TEST(PackedContacts, takeInWhatComesToClose)
{
    Grid grid(true);
    nscd::ContactProblem problem = grid.problem();
    nscd::PackedContacts packing;
    nscd::ContactProblem packed = packing.pack(problem, 0.008);
    EXPECT_FALSE(nscd::wakeBlocks(packed));
    const std::size_t before = packed.blocks.size();
    for (nscd::Body& body : grid.bodies)
    {
        for (double& v : body.v) v *= 3.0;
    }
    EXPECT_GT(packing.defects(packed).sumSquares, 0.0);
    EXPECT_TRUE(nscd::wakeBlocks(packed));
    EXPECT_GT(packed.blocks.size(), before);
    EXPECT_EQ(packed.awake.size(), packed.blocks.size());
    EXPECT_EQ(packing.defects(packed).sumSquares, 0.0);
    EXPECT_FALSE(nscd::wakeBlocks(packed));
}

TEST(PackedContacts, withOtherRanksStandBehindThoseWithinThisOne)
{
    Grid grid(true);
    nscd::ContactProblem problem = grid.problem();
    problem.interfaceBlock = grid.blocks.size()/3;
    const std::vector<nscd::ContactBlock> home = grid.blocks;
    const auto isInner = [&](const nscd::ContactBlock& block, int lane)
    {
        for (std::size_t k = 0; k < problem.interfaceBlock; ++k)
        for (int l = 0; l < nscd::blockLanes; ++l)
        {
            if (home[k].a[l] == block.a[lane] && home[k].b[l] == block.b[lane]) return true;
        }
        return false;
    };
    nscd::PackedContacts packing;
    nscd::ContactProblem packed = packing.pack(problem, 0.008);
    for (int round = 0; round < 2; ++round)
    {
        std::size_t inner = 0, contacts = 0;
        for (std::size_t k = 0; k < packed.blocks.size(); ++k)
        for (int lane = 0; lane < nscd::blockLanes; ++lane)
        {
            const nscd::ContactBlock& block = packed.blocks[k];
            if (block.a[lane] == Grid::side*Grid::side) continue;
            ++contacts;
            inner += isInner(block, lane);
            ASSERT_EQ(isInner(block, lane), k < packed.interfaceBlock) << k;
        }
        EXPECT_GT(inner, 100u);
        EXPECT_GT(contacts, inner + 100u);
        EXPECT_EQ(packed.inner().count + packed.interface().count, packed.blocks.size());
        for (nscd::Body& body : grid.bodies)
        {
            for (double& v : body.v) v *= 3.0;
        }
        EXPECT_TRUE(nscd::wakeBlocks(packed));
    }
}
