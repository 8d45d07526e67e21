// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Ghosts against brute force over all grains.
#include "parallel/ghostSearch.hpp"
#include "sharedScene.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

using namespace nscd;

namespace
{

const RankTree& tree()
{
    static const RankTree* const theTree = new RankTree{Communicator()};  // lives on: MPI ends before static objects do
    return *theTree;
}

/// Calls `visit` with a grain's center and all its images.
template<class Visit>
void visitImages(const PeriodicBox& box, const Vec3& center, Visit visit)
{
    const auto reachOf = [&](int axis) { return box.isPeriodic(axis) ? 2 : 0; };
    for (int a = -reachOf(0); a <= reachOf(0); ++a)
    {
        for (int b = -reachOf(1); b <= reachOf(1); ++b)
        {
            for (int c = -reachOf(2); c <= reachOf(2); ++c) visit(Vec3(center + box.length.cwiseProduct(Vec3(a, b, c))));
        }
    }
}

Vec3 pathOf(const SharedScene& scene, int i) { return scene.path.empty() ? Vec3(Vec3::Zero()) : scene.path[i]; }

/// Around the middle of its path.
Vec3 center(const SharedScene& scene, int i) { return scene.box.wrap(scene.all.position[i] + 0.5*pathOf(scene, i)); }
double size(const SharedScene& scene, int i) { return scene.all.radius[i] + scene.range + scene.reach[i] + 0.5*(pathOf(scene, i) - scene.meanPath).norm(); }

bool meets(const SharedScene& scene, int i, int j)
{
    bool isMet = false;
    const double reach = scene.all.radius[i] + scene.all.radius[j] + scene.reach[i] + scene.reach[j] + 2.0*scene.range;
    const Vec3 way = pathOf(scene, i) - pathOf(scene, j);
    visitImages(scene.box, scene.box.wrap(scene.all.position[i]), [&](const Vec3& image)
    {
        const Vec3 x = image - scene.box.wrap(scene.all.position[j]);
        const double share = way.squaredNorm() > 0.0 ? std::clamp(-x.dot(way)/way.squaredNorm(), 0.0, 1.0) : 0.0;
        isMet = isMet || (x + share*way).norm() <= reach;
    });
    return isMet;
}

bool meetsBox(const SharedScene& scene, int i, const Eigen::AlignedBox3d& around)
{
    bool isMet = false;
    visitImages(scene.box, center(scene, i), [&](const Vec3& image)
    {
        isMet = isMet || around.exteriorDistance(image) <= (1.0 + 1e-6)*size(scene, i);
    });
    return isMet;
}

Eigen::AlignedBox3d boxAround(const SharedScene& scene, const std::vector<int>& members)
{
    Eigen::AlignedBox3d around;
    for (int j : members)
    {
        const Vec3 x = center(scene, j), extent = Vec3::Constant(size(scene, j));
        around.extend(Eigen::AlignedBox3d(x - extent, x + extent));
    }
    return around;
}

/// The same box where, along periodic axes, grains behind the longest gap between centers are meant by their images in the next period.
Eigen::AlignedBox3d shortestAround(const SharedScene& scene, const std::vector<int>& members)
{
    Eigen::AlignedBox3d around = boxAround(scene, members);
    for (int axis = 0; axis < 3; ++axis)
    {
        if (!scene.box.isPeriodic(axis) || members.empty()) continue;
        std::map<double, double> sizeAt;
        for (int j : members)
        {
            double& largest = sizeAt[center(scene, j)[axis]];
            largest = std::max(largest, size(scene, j));
        }
        const double period = scene.box.length[axis];
        double before = sizeAt.rbegin()->first - period, longest = 0.0, first = 0.0;
        for (const auto& [x, size] : sizeAt)
        {
            if (x - before > longest) { longest = x - before; first = x; }
            before = x;
        }
        around.min()[axis] = around.max()[axis] = first;
        for (const auto& [x, size] : sizeAt)
        {
            const double image = x < first ? x + period : x;
            around.min()[axis] = std::min(around.min()[axis], image - size);
            around.max()[axis] = std::max(around.max()[axis], image + size);
        }
    }
    return around;
}

void expectGrain(const SharedScene& scene, int i, const GhostGrain& ghost)
{
    EXPECT_EQ(ghost.owner, scene.owner[i]);
    EXPECT_EQ(scene.of(ghost.owner)[ghost.index], i);
    EXPECT_EQ(ghost.position, scene.box.wrap(scene.all.position[i]));
    EXPECT_EQ(ghost.radius, scene.all.radius[i]);
    EXPECT_EQ(ghost.slack, scene.reach[i]);
    EXPECT_EQ(ghost.path, pathOf(scene, i));
    EXPECT_EQ(ghost.inverseMass, scene.all.isFixed[i] ? 0.0 : 1.0/scene.all.mass[i]);
    EXPECT_EQ(ghost.material, scene.all.material[i]);
}

void moveBy(SharedScene& scene, const Vec3& shift)
{
    scene.box.lower += shift;
    for (Vec3& x : scene.all.position) x += shift;
}

/// All that meet a grain of this rank are there, none that misses its box, none twice, none of its own.
void expectGhosts(const SharedScene& scene, const std::vector<GhostGrain>& ghosts)
{
    const int rank = tree().all().rank();
    const std::vector<int> own = scene.of(rank);
    const Eigen::AlignedBox3d around = boxAround(scene, own), shortest = shortestAround(scene, own);
    std::map<std::int64_t, const GhostGrain*> found;
    for (const GhostGrain& ghost : ghosts) EXPECT_TRUE(found.emplace(ghost.id, &ghost).second) << ghost.id << " comes twice";
    for (std::size_t i = 0; i < scene.owner.size(); ++i)
    {
        const auto ghost = found.find(scene.all.id[i]);
        const bool isFound = ghost != found.end();
        if (isFound) expectGrain(scene, i, *ghost->second);
        if (scene.owner[i] == rank) { EXPECT_FALSE(isFound); }
        else if (isFound) { EXPECT_TRUE(meetsBox(scene, i, around) || meetsBox(scene, i, shortest)); }
        else
        {
            for (int j : own) EXPECT_FALSE(meets(scene, i, j)) << "grain " << i << " meets " << j;
        }
    }
}

std::vector<GhostGrain> ghostsOf(const SharedScene& scene, CoveredBoxes& covered)
{
    const int rank = tree().all().rank();
    return findGhosts(tree(), scene.grainsOf(rank), scene.pathsOf(rank), scene.box, covered);
}

std::vector<GhostGrain> ghostsOf(const SharedScene& scene)
{
    CoveredBoxes covered;
    return ghostsOf(scene, covered);
}

std::vector<std::tuple<int, int>> keys(const std::vector<GhostGrain>& ghosts)
{
    std::vector<std::tuple<int, int>> found;
    for (const GhostGrain& ghost : ghosts) found.emplace_back(ghost.owner, ghost.index);
    return found;
}

class GhostSearch : public testing::TestWithParam<std::tuple<int, Ownership>>
{
};

} // namespace

TEST_P(GhostSearch, findsWhatBruteForceFinds)
{
    const auto [periodicAxes, ownership] = GetParam();
    for (unsigned seed : {1, 2, 3})
    {
        SharedScene scene = randomScene(300, periodicAxes, ownership, tree().all().size(), seed);
        moveBy(scene, Vec3(0.5, -0.5, 2.0)*(seed - 1.0));
        const std::vector<GhostGrain> ghosts = ghostsOf(scene);
        expectGhosts(scene, ghosts);
        const auto order = keys(ghosts);
        EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
        EXPECT_EQ(keys(ghostsOf(scene)), order) << "the same from run to run";
    }
}

TEST(GhostSearchAlone, knowsTheShortWayAroundAPeriodThatBeginsAnywhere)
{
    for (const double lower : {0.0, -0.5, -20.0, 3.0})
    {
        SharedScene scene;
        scene.box.length[0] = 1.0;
        for (int i = 0; i < 20; ++i)
        {
            // Rank 0 has those at both ends of the period, the last rank those in its middle.
            const bool isAtEnd = i % 2 == 0;
            scene.all.add(Vec3((isAtEnd ? 0.9 + 0.02*i : 0.4 + 0.01*i), 0, 0), 0.01, 2500.0, 0, i);
            scene.reach.push_back(0.0);
            scene.owner.push_back(isAtEnd ? 0 : tree().all().size() - 1);
        }
        moveBy(scene, Vec3(lower, 0, 0));
        CoveredBoxes covered;
        EXPECT_TRUE(ghostsOf(scene, covered).empty() || tree().all().size() == 1) << lower;
        const int rank = tree().all().rank(), last = tree().all().size() - 1;
        if (last == 0) continue;
        EXPECT_EQ(covered.isOfThisRankAlone(Vec3(lower + 0.05, 0, 0), 0.01), rank == 0) << lower;
        EXPECT_EQ(covered.isOfThisRankAlone(Vec3(lower + 0.5, 0, 0), 0.01), rank == last) << lower;
        EXPECT_FALSE(covered.isOfThisRankAlone(Vec3(lower + 0.35, 0, 0), 0.01)) << lower;
    }
}

TEST_P(GhostSearch, findsThoseThatMeetOnTheirPaths)
{
    const auto [periodicAxes, ownership] = GetParam();
    SharedScene scene = randomScene(300, periodicAxes, ownership, tree().all().size(), 4);
    scene.range = 0.003;
    scene.meanPath = Vec3(0.3, -0.2, 0.1);
    for (std::size_t i = 0; i < scene.owner.size(); ++i)
    {
        const Vec3& v = scene.all.velocity[i];
        scene.path.push_back(scene.meanPath + 0.1*Vec3(v[0], std::sin(v[1]), std::cos(v[2])));
    }
    expectGhosts(scene, ghostsOf(scene));
}

/// No two spheres that two ranks hold to be theirs alone meet, nor any with the path of another rank's grain; in slabs there are some.
TEST_P(GhostSearch, tellsWhatIsOfOneRankAlone)
{
    const auto [periodicAxes, ownership] = GetParam();
    SharedScene scene = randomScene(300, periodicAxes, ownership, tree().all().size(), 5);
    scene.range = 0.002;
    scene.meanPath = Vec3(0.02, 0.03, -0.02);
    for (std::size_t i = 0; i < scene.owner.size(); ++i) scene.path.push_back(scene.meanPath + 0.02*scene.all.orientation[i].vec());
    CoveredBoxes covered;
    ghostsOf(scene, covered);
    SharedScene spheres = randomScene(2000, periodicAxes, Ownership::lastRank, tree().all().size(), 6);
    for (Vec3& x : spheres.all.position)
    {
        for (int axis = periodicAxes; axis < 3; ++axis) x[axis] += 0.6*(x[axis] - 0.5);   // some lie in no rank's box
    }
    const auto isOfRank = [&](int i) { return covered.isOfThisRankAlone(spheres.box.wrap(spheres.all.position[i]), spheres.all.radius[i]); };
    double alone = 0.0;
    std::vector<double> owner(2000, -1.0);   // of spheres
    for (int i = 0; i < 2000; ++i)
    {
        double ranks = isOfRank(i) ? 1.0 : 0.0, here = ranks;
        tree().all().sum(&ranks, 1);
        EXPECT_LE(ranks, 1.0) << i;
        if (here == 0.0) continue;
        ++alone;
        owner[i] = tree().all().rank();
        for (std::size_t j = 0; j < scene.owner.size(); ++j)
        {
            if (scene.owner[j] == tree().all().rank()) continue;
            visitImages(scene.box, center(scene, static_cast<int>(j)), [&](const Vec3& image)
            {
                EXPECT_GT((image - scene.box.wrap(spheres.all.position[i])).norm(), spheres.all.radius[i] + size(scene, static_cast<int>(j))) << i << " " << j;
            });
        }
    }
    tree().all().max(owner.data(), static_cast<int>(owner.size()));
    for (int i = 0; i < 2000; i += 4)
    for (int j = 0; j < i; ++j)
    {
        if (owner[i] < 0.0 || owner[j] < 0.0 || owner[i] == owner[j]) continue;
        const double sizes = spheres.all.radius[i] + spheres.all.radius[j];
        const Vec3 x = spheres.box.wrap(spheres.all.position[j]);
        visitImages(scene.box, spheres.box.wrap(spheres.all.position[i]), [&](const Vec3& image) { EXPECT_GE((image - x).norm(), (1.0 - 1e-9)*sizes); });
    }
    tree().all().sum(&alone, 1);
    if (ownership == Ownership::slabs) { EXPECT_GT(alone, 50); }   // seen: 84 and more
}

INSTANTIATE_TEST_SUITE_P
(
    Scenes, GhostSearch,
    testing::Combine
    (
        testing::Values(0, 1, 3),
        testing::Values(Ownership::slabs, Ownership::scattered, Ownership::evenRanks, Ownership::lastRank)
    )
);

TEST(GhostSearchAlone, findsSpheresThatTouchToTheLastDigit)
{
    SharedScene scene;
    const int count = 40;
    scene.box.length[0] = 0.1*count;
    for (int i = 0; i < count; ++i)
    {
        scene.all.add({0.1*i, 1e3, -1e3}, 0.05, 2500.0, 0, i);
        scene.reach.push_back(0.0);
        scene.owner.push_back(ownerOf(Ownership::slabs, (i + 0.5)/count, 0, tree().all().size()));
    }
    const std::vector<GhostGrain> ghosts = ghostsOf(scene);
    EXPECT_EQ(ghosts.size(), tree().all().size() > 1 ? 2u : 0u);
}

TEST(GhostSearchAlone, aGrainAcrossAPeriodicSideDoesNotMakeItsRankNeighborOfAll)
{
    const int size = tree().all().size(), perRank = 40, count = perRank*size;
    SharedScene scene;
    scene.box.length[0] = 0.12*count;
    for (int i = 0; i < count; ++i)
    {
        const double x = i == 0 ? scene.box.length[0] - 0.02 : 0.12*i;
        scene.all.add({x, 0, 0}, 0.05, 2500.0, 0, i);
        scene.reach.push_back(0.02);
        scene.owner.push_back(i/perRank);
    }
    const std::vector<GhostGrain> ghosts = ghostsOf(scene);
    if (size > 1) expectGhosts(scene, ghosts);
    EXPECT_LE(ghosts.size(), 3u);
}

TEST(GhostSearchAlone, noGrainsNoGhosts)
{
    EXPECT_TRUE(ghostsOf(SharedScene()).empty());
}

TEST(GhostSearchAlone, refusesAMissingReach)
{
    const Grains grains = randomScene(3, 0, Ownership::lastRank, 1).grainsOf(0);
    CoveredBoxes covered;
    EXPECT_THROW(findGhosts(tree(), grains, {{0.1, 0.1}}, PeriodicBox(), covered), std::invalid_argument);
    EXPECT_THROW(findGhosts(tree(), grains, {{0.1, 0.1, 0.1}, {Vec3::Zero()}}, PeriodicBox(), covered), std::invalid_argument);
}
