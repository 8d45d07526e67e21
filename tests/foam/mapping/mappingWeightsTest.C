// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The shares of grains in cells: exact values, conservation, continuity, translation, for every method.

#include "mappingTools.H"

#include "accuracy/expectNear.hpp"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

const char* const methods[] = {"centroid", "satellite", "exact"};

label cellAt(const fvMesh& mesh, const point& p)
{
    return mesh.findNearestCell(p);
}

WeightMatrix weightsOf(const fvMesh& mesh, const word& method, const ::nscd::Grains& grains)
{
    GrainMapping mapping(mesh, mappingDict(method));
    mapping.update(grains, {});
    return mapping.weights();
}

// Shares of a ball (or disc) in the cells of a mesh, by sampling it at n points of the additive recurrence of Roberts (2018).
std::vector<scalar> sampledShares(const fvMesh& mesh, const point& center, const scalar radius, const label n, const bool isFlat)
{
    const scalar ratio = isFlat ? 1.32471795724474602596 : 1.22074408460575947536;
    std::vector<scalar> shares(mesh.nCells(), 0);
    label nInBall = 0;
    for (label k = 0; k < n; ++k)
    {
        vector offset(Zero);
        for (direction axis = 0; axis < (isFlat ? 2 : 3); ++axis)
        {
            const scalar sequence = k*std::pow(ratio, -(axis + 1));
            offset[axis] = 2*radius*(sequence - std::floor(sequence) - 0.5);
        }
        if (magSqr(offset) > sqr(radius)) continue;
        ++nInBall;
        for (label cellI = 0; cellI < mesh.nCells(); ++cellI)
        {
            if (isInCell(mesh, cellI, center + offset))
            {
                shares[cellI] += 1;
                break;
            }
        }
    }
    for (scalar& share : shares) share /= nInBall;
    return shares;
}

// Catalog C25; the references with seven digits are from quadrature and Monte Carlo.
TEST(mappingWeights, sharesOfABallNearACorner)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4)));
    struct Case { Vec3 fromCorner; scalar share; scalar tolerance; };
    const Case cases[] =
    {
        {Vec3(0, 0, 0), 0.125, 1e-13},
        {Vec3(0.1, 0.2, 0.15), 0.4265589, 5e-8},
        {Vec3(-0.1, -0.1, -0.1), 0.0273902, 5e-8},
        {Vec3(0.1, 0.2, 0.5), 0.5701075, 5e-8},
        {Vec3(0.2, 0.5, 0.5), 0.84375, 1e-13},
        {Vec3(0.5, 0.5, 0.5), 1, 0},
    };
    const label octant = cellAt(box.mesh(), point(2.5, 2.5, 2.5));
    for (const Case& c : cases)
    {
        const WeightMatrix weights = weightsOf(box.mesh(), "exact", makeGrains({Vec3(2, 2, 2) + c.fromCorner}, 0.4));
        EXPECT_NEAR(shareIn(weights, 0, octant), c.share, c.tolerance) << c.fromCorner.transpose();
    }
}

TEST(mappingWeights, sharesByTheWallAndOnAShakenMeshAgreeWithSampling)
{
    BoxMeshSettings settings = unitCells(labelVector(3, 3, 3));
    shake(settings, 0.2);
    BoxMesh box(settings);
    for (const point& center : {point(1.4, 1.3, 1.7), point(0.3, 0.4, 0.2), point(2.2, 1.0, 1.1)})
    {
        const std::vector<scalar> sampled = sampledShares(box.mesh(), center, 0.7, 300000, false);
        GrainMapping mapping(box.mesh(), mappingDict("exact"));
        const ::nscd::Grains grains = makeGrains({toVec3(center)}, 0.7);
        const scalar lost = mapping.update(grains, {}).lostOutside/grains.volume(0);
        for (label cellI = 0; cellI < box.mesh().nCells(); ++cellI)
        {
            EXPECT_NEAR(shareIn(mapping.weights(), 0, cellI)*(1 - lost), sampled[cellI], 2e-3) << toVec3(center).transpose() << " cell " << cellI;
        }
    }
}

TEST(mappingWeights, sharesOfDiscsAgreeWithSampling)
{
    for (const bool isShaken : {false, true})
    {
        BoxMeshSettings settings = unitCells(labelVector(4, 4, 1), {"wall", "wall", "wall", "wall", "empty", "empty"});
        settings.max.z() = 0.3;
        if (isShaken) shake(settings, 0.2, true);
        BoxMesh box(settings);
        ::nscd::Grains grains = makeGrains({Vec3(1.6, 2.1, 0.15), Vec3(0.2, 0.3, 0.15), Vec3(2, 2, 0.15)}, 0.8);
        grains.shape.dimensions = 2;
        grains.shape.thickness = 0.3;
        GrainMapping mapping(box.mesh(), mappingDict("exact"));
        mapping.update(grains, {});
        for (label i = 0; i < 3; ++i)
        {
            const std::vector<scalar> sampled = sampledShares(box.mesh(), toFoam(grains.position[i]), 0.8, 100000, true);
            const scalar inside = std::accumulate(sampled.begin(), sampled.end(), 0.0);
            for (label cellI = 0; cellI < box.mesh().nCells(); ++cellI)
            {
                EXPECT_NEAR(shareIn(mapping.weights(), i, cellI), sampled[cellI]/inside, 1.5e-3) << "disc " << i;
            }
        }
    }
}

/// A layer of 4 x 4 cells that just holds spheres of 0.8 m radius, empty across or with walls there.
BoxMeshSettings layer(const word& across, const bool isShaken)
{
    BoxMeshSettings settings = unitCells(labelVector(4, 4, 1), {"wall", "wall", "wall", "wall", across, across});
    settings.max.z() = 1.6;
    if (isShaken) shake(settings, 0.2, true);
    return settings;
}

// On faces and on a corner, too, where the sum of cones takes over.
TEST(mappingWeights, spheresOnA2DMeshHaveTheSharesOfA3DOne)
{
    const std::vector<Vec3> positions =
        {Vec3(1.6, 2.1, 0.8), Vec3(0.2, 0.3, 0.8), Vec3(2, 1.7, 0.8), Vec3(2, 2, 0.8), Vec3(0, 0, 0.8), Vec3(2.3, 4, 0.8), Vec3(1.5, 1.5, 0.8)};
    for (const bool isShaken : {false, true})
    {
        BoxMesh flat(layer("empty", isShaken)), full(layer("wall", isShaken));
        const ::nscd::Grains grains = makeGrains(positions, 0.8);
        for (const char* method : methods)
        {
            GrainMapping mapping(flat.mesh(), mappingDict(method), 0.8, 3);
            mapping.update(grains, {});
            GrainMapping expected(full.mesh(), mappingDict(method));
            EXPECT_NEAR(mapping.report().lostOutside, expected.update(grains, {}).lostOutside, 1e-12*::nscd::totalVolume(grains)) << method;
            EXPECT_NEAR(mapping.report().volumeDeposited/::nscd::totalVolume(grains), 1, 1e-12) << method;
            for (label i = 0; i < label(positions.size()); ++i)
            {
                for (label cellI = 0; cellI < flat.mesh().nCells(); ++cellI)
                {
                    EXPECT_NEAR(shareIn(mapping.weights(), i, cellI), shareIn(expected.weights(), i, cellI), 1e-12) << method << " sphere " << i;
                }
            }
        }
    }
}

// Catalog C26: whatever the place, in the open, at walls, corners, faces, edges, cell corners and through cyclic borders.
void expectConservation(const BoxMeshSettings& settings, const std::vector<Vec3>& positions, const scalar radius)
{
    BoxMesh box(settings);
    for (const char* method : methods)
    {
        GrainMapping mapping(box.mesh(), mappingDict(method));
        const ::nscd::Grains grains = makeGrains(positions, radius);
        const MappingReport& report = mapping.update(grains, {});
        ASSERT_TRUE(report.outsideMesh.empty()) << method;
        const std::string scene = std::string("C26 ") + method + ", radius " + figures::text(radius);
        figures::expectNear(scene, "volume in cells over the grains'", report.volumeDeposited/::nscd::totalVolume(grains), 1, 1e-12);
        for (std::size_t i = 0; i < positions.size(); ++i)
        {
            EXPECT_NEAR(rowSum(mapping.weights(), label(i)), 1, 1e-13) << method << positions[i].transpose();
        }
        for (const CellShare& share : mapping.weights().shares) EXPECT_GT(share.share, 0);
        if (settings.patchTypes[0] == "cyclic")
        {
            EXPECT_NEAR(report.lostOutside/report.grainVolume, 0, 1e-12) << method << " radius " << radius;
        }
    }
}

std::vector<Vec3> awkwardPoints(const labelVector& n)
{
    const Vec3 upper(n.x(), n.y(), n.z());
    std::vector<Vec3> points = randomPoints(200, Vec3(0, 0, 0), upper);
    for (int k = 0; k < 8; ++k)
    {
        points.push_back(Vec3(k & 1 ? 0 : 0.37, k & 2 ? 0 : 0.41, k & 4 ? 0 : 0.83));
        points.push_back(Vec3(k & 1 ? 1 : 0.37, k & 2 ? 1 : 0.41, k & 4 ? 1 : 0.83).cwiseMin(upper));
    }
    return points;
}

TEST(mappingWeights, conserveAtWallsAndThroughCyclicBorders)
{
    for (const wordList& types : {wordList(6, word("wall")), allCyclic()})
    {
        for (const scalar radius : {0.1, 0.25, 0.5, 1.3})
        {
            const labelVector n(4, 3, 5);
            expectConservation(unitCells(n, types), awkwardPoints(n), radius);
        }
    }
}

TEST(mappingWeights, conserveOnAShakenMesh)
{
    for (const wordList& types : {wordList(6, word("wall")), allCyclic()})
    {
        const labelVector n(4, 3, 5);
        BoxMeshSettings settings = unitCells(n, types);
        shake(settings, 0.2);
        expectConservation(settings, awkwardPoints(n), 0.4);
    }
}

// Stress S13: one or two cells across the period, where a ball meets several images of the same cell.
TEST(mappingWeights, conserveWithOneOrTwoCellsAcrossThePeriod)
{
    for (const labelVector& n : {labelVector(1, 1, 1), labelVector(2, 2, 2), labelVector(1, 2, 3)})
    {
        expectConservation(unitCells(n, allCyclic()), awkwardPoints(n), 0.45);
        expectConservation(unitCells(n, allCyclic()), {Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0)}, 1.7);
        expectConservation(unitCells(n), {Vec3(0.5, 0.5, 0.5)}, 0.5);
    }
}

// Stress S7: a cell that lies inside a ball holds its own volume of it.
TEST(mappingWeights, grainsFiveAndTenTimesTheCell)
{
    BoxMesh box(unitCells(labelVector(14, 14, 14)));
    for (const scalar radius : {2.5, 5.0})
    {
        const Vec3 center(6.9, 7.2, 7.4);
        const ::nscd::Grains grains = makeGrains({center}, radius);
        const WeightMatrix weights = weightsOf(box.mesh(), "exact", grains);
        EXPECT_NEAR(rowSum(weights, 0), 1, 1e-13);
        label nInside = 0;
        for (const CellShare& share : weights.shares)
        {
            const Vec3 away = toVec3(box.mesh().cellCentres()[share.cell]) - center;
            const bool isInside = (away.cwiseAbs() + Vec3::Constant(0.5)).norm() < radius;
            if (isInside)
            {
                EXPECT_NEAR(share.share*grains.volume(0), 1, 1e-11);
            }
            nInside += isInside ? 1 : 0;
        }
        EXPECT_GT(nInside, radius > 4 ? 300 : 20);
    }
}

TEST(mappingWeights, moveWithTheGrainByAWholeCell)
{
    BoxMesh box(unitCells(labelVector(5, 5, 5), allCyclic()));
    const std::vector<Vec3> positions = randomPoints(50, Vec3(0, 0, 0), Vec3(5, 5, 5));
    for (const char* method : methods)
    {
        const WeightMatrix before = weightsOf(box.mesh(), method, makeGrains(positions, 0.6));
        std::vector<Vec3> moved = positions;
        for (Vec3& x : moved) x[1] = x[1] + 1 < 5 ? x[1] + 1 : x[1] - 4;
        const WeightMatrix after = weightsOf(box.mesh(), method, makeGrains(moved, 0.6));
        ASSERT_EQ(before.shares.size(), after.shares.size());
        for (label i = 0; i < before.nRows(); ++i)
        {
            for (label k = before.rowStart[i]; k < before.rowStart[i + 1]; ++k)
            {
                const label cell = before.shares[k].cell;
                const label next = cell + (cell/5 % 5 == 4 ? -20 : 5);
                EXPECT_NEAR(shareIn(after, i, next), before.shares[k].share, 1e-13) << method;
            }
        }
    }
}

// Catalog C27: d(alpha)/dt <= pi r^2 v/V_cell for the exact overlap, any direction, through faces, edges and corners.
TEST(mappingWeights, exactFractionChangesNoFasterThanTheSilhouetteAllows)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4), allCyclic()));
    GrainMapping mapping(box.mesh(), mappingDict("exact"));
    const scalar radius = 0.3;
    for (const Vec3& velocity : {Vec3(1, 0, 0), Vec3(1, 1, 1), Vec3(0.3, -0.7, 0.2)})
    {
        const scalar dt = 0.003;
        const scalar bound = M_PI*radius*radius*velocity.norm()*dt;
        ::nscd::PeriodicBox period;
        period.length = Vec3(4, 4, 4);
        ::nscd::Grains grains = makeGrains({Vec3(2, 2, 2)}, radius);
        std::vector<scalar> one = {grains.volume(0)};
        scalarField before;
        scalar fastest = 0;
        for (label step = 0; step < 700; ++step)
        {
            grains.position[0] = period.wrap(grains.position[0] + dt*velocity);
            mapping.update(grains, period);
            scalarField now;
            mapping.spread(one, now);
            if (step > 0)
            {
                EXPECT_LE(max(mag(now - before)), bound*(1 + 1e-10));
                fastest = max(fastest, max(mag(now - before)));
            }
            before = now;
        }
        figures::expectBelow("C27 exact", "rate of alpha over the silhouette's", fastest/bound, 1 + 1e-10);
    }
}

// The rule of 33 points is exact to degree 5, so its center of mass and second moment are the ball's.
TEST(mappingWeights, satelliteSharesApproachTheExactOnes)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4), allCyclic()));
    const std::vector<Vec3> positions = randomPoints(300, Vec3(0, 0, 0), Vec3(4, 4, 4));
    const ::nscd::Grains grains = makeGrains(positions, 0.5);
    const WeightMatrix exact = weightsOf(box.mesh(), "exact", grains);
    const WeightMatrix satellite = weightsOf(box.mesh(), "satellite", grains);
    scalar sum = 0;
    for (label i = 0; i < exact.nRows(); ++i)
    {
        for (label cellI = 0; cellI < 64; ++cellI)
        {
            const scalar difference = mag(shareIn(exact, i, cellI) - shareIn(satellite, i, cellI));
            EXPECT_LT(difference, 0.25);
            sum += difference;
        }
    }
    EXPECT_LT(sum/exact.nRows(), 0.2);
}

TEST(mappingWeights, refuseWhatTheyCannotDo)
{
    BoxMesh box(unitCells(labelVector(2, 2, 2)));
    const auto make = [&box](const dictionary& dict) { GrainMapping mapping(box.mesh(), dict); };
    EXPECT_NE(errorMessage([&] { make(mappingDict("divided")); }).find("centroid satellite exact"), std::string::npos);
    EXPECT_NE(errorMessage([&] { make(mappingDict("exact", -1)); }).find("diffusionLength"), std::string::npos);
    EXPECT_NE(errorMessage([&] { make(mappingDict("exact", 0, 1)); }).find("minFluidFraction"), std::string::npos);
    GrainMapping mapping(box.mesh(), dictionary());
    ::nscd::Grains discs = makeGrains({Vec3(1, 1, 1)}, 0.1);
    discs.shape.dimensions = 2;
    EXPECT_NE(errorMessage([&] { mapping.update(discs, {}); }).find("dimensions"), std::string::npos);
}

TEST(mappingWeights, noGrains)
{
    BoxMesh box(unitCells(labelVector(2, 2, 2)));
    GrainMapping mapping(box.mesh(), dictionary());
    const MappingReport& report = mapping.update(::nscd::Grains(), {});
    EXPECT_EQ(report.grainVolume, 0);
    EXPECT_EQ(report.volumeDeposited, 0);
    scalarField spread;
    mapping.spread(std::vector<scalar>(), spread);
    EXPECT_EQ(spread, scalarField(8, Zero));
}

} // End anonymous namespace
