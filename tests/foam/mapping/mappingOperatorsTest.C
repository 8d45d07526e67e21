// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Smoothing, redistribution, and the duality of spreading and sampling.

#include "mappingTools.H"

#include "coupling/case/walls/grainExits.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

scalar volumeProduct(const fvMesh& mesh, const scalarField& a, const scalarField& b)
{
    return sum(mesh.V().field()*a*b);
}

BoxMeshSettings shakenPartlyCyclic()
{
    BoxMeshSettings settings = unitCells(labelVector(6, 5, 4), {"cyclic", "cyclic", "wall", "patch", "wall", "wall"});
    shake(settings, 0.2);
    return settings;
}

TEST(mappingSmoother, keepsSumsAndUniformFieldsToRoundOff)
{
    BoxMesh box(shakenPartlyCyclic());
    for (const scalar length : {0.5, 3.0, 20.0})
    {
        const DiffusionSmoother smoother(box.mesh(), length);
        scalarField field = randomField(box.mesh().nCells(), 3) + 2.0;
        const scalar before = sum(box.mesh().V().field()*field);
        smoother.smooth(field);
        EXPECT_NEAR(sum(box.mesh().V().field()*field)/before, 1, 1e-14) << length;

        scalarField uniform(box.mesh().nCells(), 0.7);
        smoother.smooth(uniform);
        EXPECT_EQ(uniform, scalarField(box.mesh().nCells(), 0.7));
    }
}

TEST(mappingSmoother, isItsOwnTranspose)
{
    BoxMesh box(shakenPartlyCyclic());
    const fvMesh& mesh = box.mesh();
    for (const scalar length : {0.5, 3.0, 20.0})
    {
        const DiffusionSmoother smoother(mesh, length);
        const scalarField f = randomField(mesh.nCells(), 1);
        const scalarField g = randomField(mesh.nCells(), 2);
        scalarField smoothF = f;
        scalarField smoothG = g;
        smoother.smooth(smoothF);
        smoother.smooth(smoothG);
        const scalar scale = std::sqrt(volumeProduct(mesh, f, f)*volumeProduct(mesh, g, g));
        EXPECT_NEAR(volumeProduct(mesh, smoothF, g)/scale, volumeProduct(mesh, f, smoothG)/scale, 1e-14) << length;
    }
}

// Around cells that are used, what is spread in them and what is sampled from them are as over the whole mesh.
TEST(mappingSmoother, leavesOutWhatIsFarFromCellsUsed)
{
    BoxMesh box(unitCells(labelVector(40, 5, 4), {"cyclic", "cyclic", "wall", "patch", "wall", "wall"}));
    const label nCells = box.mesh().nCells();
    const DiffusionSmoother whole(box.mesh(), 3);
    DiffusionSmoother restricted(box.mesh(), 3);
    scalarField used(nCells, Zero);
    for (const label cell : {0, 41, 38}) used[cell] = 1 + cell;
    restricted.restrictTo(used);

    scalarField spread = used, spreadByAll = used;
    restricted.smooth(spread);
    whole.smooth(spreadByAll);
    EXPECT_EQ(spread, spreadByAll);

    const scalarField random = randomField(nCells, 5);
    scalarField seen = random, seenByAll = random;
    restricted.smooth(seen);
    whole.smooth(seenByAll);
    label untouched = 0;
    forAll(seen, cell)
    {
        if (used[cell] > 0) EXPECT_EQ(seen[cell], seenByAll[cell]);
        untouched += seen[cell] == random[cell];
    }
    EXPECT_GT(untouched, nCells/2);
}

// On a uniform mesh smoothing widens a peak by exactly 2 D T = length^2/(8 ln 2) per direction.
TEST(mappingSmoother, hasTheVarianceItPromises)
{
    BoxMesh box(unitCells(labelVector(61, 3, 3), {"wall", "wall", "cyclic", "cyclic", "cyclic", "cyclic"}));
    const scalar length = 4;
    const DiffusionSmoother smoother(box.mesh(), length);
    scalarField peak(box.mesh().nCells(), Zero);
    forAll(peak, cellI) peak[cellI] = mag(box.mesh().cellCentres()[cellI].x() - 30.5) < 0.1 ? 1 : 0;
    smoother.smooth(peak);
    scalar variance = 0;
    forAll(peak, cellI) variance += peak[cellI]*sqr(box.mesh().cellCentres()[cellI].x() - 30.5)/sum(peak);
    EXPECT_NEAR(variance, sqr(length)/(8*std::log(2.0)), 1e-12);
}

// What is spread over a cell of width h has the variance h^2/12; smoothing makes up for what that lacks to a width of 4, in the direction in which
// cells are thin alone.
TEST(mappingSmoother, widensThinCellsAcross)
{
    BoxMeshSettings settings = unitCells(labelVector(61, 5, 3), {"wall", "wall", "wall", "wall", "cyclic", "cyclic"});
    settings.max = point(30.5, 30, 18);
    BoxMesh box(settings);
    SmoothingLengths lengths;
    lengths.width = 4;
    lengths.thinCell = 1;
    const DiffusionSmoother smoother(box.mesh(), lengths);
    scalarField peak(box.mesh().nCells(), Zero);
    const auto isOffMiddle = [&](label cell) { return mag(box.mesh().cellCentres()[cell].y() - 15) > 0.1; };
    forAll(peak, cell) peak[cell] = !isOffMiddle(cell) && mag(box.mesh().cellCentres()[cell].x() - 15.25) < 0.1 ? 1 : 0;
    smoother.smooth(peak);
    scalar variance = 0;
    forAll(peak, cell)
    {
        variance += peak[cell]*sqr(box.mesh().cellCentres()[cell].x() - 15.25)/sum(peak);
        if (isOffMiddle(cell)) EXPECT_EQ(peak[cell], 0);
    }
    EXPECT_NEAR(variance + sqr(0.5)/12, sqr(lengths.width)/(8*std::log(2.0)), 1e-12);

    lengths.thinCell = 0.5;
    EXPECT_FALSE(DiffusionSmoother(box.mesh(), lengths).isOn());
}

// In a mesh of cells 1 and 8 wide the former alone lack something to a width of 3.
TEST(mappingSmoother, widensNoWideCells)
{
    BoxMeshSettings settings = unitCells(labelVector(20, 1, 1), {"wall", "wall", "wall", "wall", "cyclic", "cyclic"});
    settings.movePoint = [](const point& p) { return point(p.x() < 10 ? p.x() : 10 + 8*(p.x() - 10), 8*p.y(), 8*p.z()); };
    BoxMesh box(settings);
    SmoothingLengths lengths;
    lengths.width = 3;
    const DiffusionSmoother smoother(box.mesh(), lengths);
    const scalarField f = randomField(box.mesh().nCells(), 1);
    scalarField smoothed = f;
    smoother.smooth(smoothed);
    EXPECT_NEAR(sum(box.mesh().V().field()*smoothed)/sum(box.mesh().V().field()*f), 1, 1e-14);
    // The first of the large ones shares a face with a small one.
    forAll(f, cell) EXPECT_EQ(smoothed[cell] == f[cell], box.mesh().cellCentres()[cell].x() > 18) << cell;
}

// What the pipeline gives with each method, smoothed or not, redistributing or not.
void expectDuality(const BoxMeshSettings& settings, const ::nscd::Grains& grains)
{
    BoxMesh box(settings);
    const fvMesh& mesh = box.mesh();
    for (const char* method : {"centroid", "satellite", "exact"})
    {
        for (const scalar length : {0.0, 1.5})
        {
            GrainMapping mapping(mesh, mappingDict(method, length, 0.4));
            const MappingReport& report = mapping.update(grains, {});
            EXPECT_GT(report.redistribution.movedVolume, 0);
            EXPECT_EQ(report.redistribution.unresolvedVolume, 0);
            EXPECT_NEAR(report.volumeDeposited/report.grainVolume, 1, 1e-12);

            const vectorField cells = randomVectors(mesh.nCells(), 7);
            std::vector<Vec3> amounts = randomPoints(grains.nOwned, Vec3(-1, -1, -1), Vec3(1, 1, 1), 5);
            vectorField spread;
            std::vector<Vec3> sampled;
            mapping.spread(amounts, spread);
            mapping.sample(cells, sampled);
            scalar onGrains = 0;
            scalar scale = 0;
            Vec3 total = Vec3::Zero();
            for (std::size_t i = 0; i < amounts.size(); ++i)
            {
                onGrains += amounts[i].dot(sampled[i]);
                scale += std::abs(amounts[i].dot(sampled[i]));
                total += amounts[i];
            }
            const scalar inCells = sum(mesh.V().field()*(spread & cells));
            EXPECT_NEAR(onGrains/scale, inCells/scale, length > 0 ? 1e-12 : 1e-14) << method << " length " << length;
            EXPECT_NEAR(mag(sum(mesh.V().field()*spread) - toFoam(total)), 0, 1e-13*amounts.size()) << method;
        }
    }
}

TEST(grainMapping, spreadingAndSamplingAreDual)
{
    // A cluster dense enough to be redistributed.
    expectDuality(shakenPartlyCyclic(), makeGrains(randomPoints(60, Vec3(0.1, 1.5, 1.5), Vec3(1.5, 3, 3)), 0.35));
}

TEST(grainMapping, severalFieldsAtOnceAreTheSameAsOneByOne)
{
    BoxMesh box(shakenPartlyCyclic());
    const label nCells = box.mesh().nCells();
    const ::nscd::Grains grains = makeGrains(randomPoints(60, Vec3(0.1, 1.5, 1.5), Vec3(1.5, 3, 3)), 0.35);
    GrainMapping mapping(box.mesh(), mappingDict("exact", 1, 0.4));
    mapping.update(grains, {});

    std::vector<scalar> amounts(60, 0.3);
    const std::vector<Vec3> forces = randomPoints(60, Vec3(-1, -1, -1), Vec3(1, 1, 1));
    scalarField amountsAlone, amountsTogether;
    vectorField forcesAlone, forcesTogether;
    mapping.spread(amounts, amountsAlone);
    mapping.spread(forces, forcesAlone);
    mapping.spread({{amounts, amountsTogether}}, {{forces, forcesTogether}});
    EXPECT_EQ(amountsAlone, amountsTogether);
    EXPECT_EQ(forcesAlone, forcesTogether);

    const scalarField pressures = randomField(nCells, 4);
    const vectorField velocities = randomVectors(nCells, 5);
    std::vector<scalar> pressureAlone, pressureTogether;
    std::vector<Vec3> velocityAlone, velocityTogether;
    mapping.sample(pressures, pressureAlone);
    mapping.sample(velocities, velocityAlone);
    mapping.sample({{pressures, pressureTogether}}, {{velocities, velocityTogether}});
    EXPECT_EQ(pressureAlone, pressureTogether);
    EXPECT_EQ(velocityAlone, velocityTogether);
}

TEST(grainMapping, voidFractionIsOneLessTheVolumeSpread)
{
    BoxMesh box(shakenPartlyCyclic());
    const fvMesh& mesh = box.mesh();
    const ::nscd::Grains grains = makeGrains(randomPoints(60, Vec3(0.1, 1.5, 1.5), Vec3(1.5, 3, 3)), 0.35);
    GrainMapping mapping(mesh, mappingDict("exact", 1, 0.4));
    mapping.update(grains, {});
    std::vector<scalar> volumes(60, grains.volume(0));
    scalarField solid;
    mapping.spread(volumes, solid);
    volScalarField fluidFraction(IOobject("alpha", box.time().timeName(), mesh), mesh, dimensionedScalar("one", dimless, 1));
    mapping.setFluidFraction(fluidFraction);
    forAll(fluidFraction, cellI) EXPECT_NEAR(fluidFraction[cellI], 1 - solid[cellI], 1e-13);
    EXPECT_GT(min(fluidFraction).value(), 0.4 - 1e-9);
}

void expectSame(const GrainMapping& found, const GrainMapping& expected)
{
    EXPECT_EQ(found.weights().rowStart, expected.weights().rowStart);
    ASSERT_EQ(found.weights().shares.size(), expected.weights().shares.size());
    for (std::size_t k = 0; k < found.weights().shares.size(); ++k)
    {
        EXPECT_EQ(found.weights().shares[k].cell, expected.weights().shares[k].cell);
        EXPECT_EQ(found.weights().shares[k].share, expected.weights().shares[k].share);
    }
    EXPECT_EQ(found.cells(), expected.cells());
    EXPECT_EQ(found.volumes(), expected.volumes());
    EXPECT_EQ(found.report().grainVolume, expected.report().grainVolume);
    EXPECT_EQ(found.report().lostOutside, expected.report().lostOutside);
    EXPECT_EQ(found.report().volumeDeposited, expected.report().volumeDeposited);
    EXPECT_EQ(found.report().outsideMesh, expected.report().outsideMesh);
}

TEST(grainMapping, holdsGrainsOnlyWhileTheMeshIsAhead)
{
    BoxMesh box(unitCells(labelVector(3, 3, 3)));
    GrainMapping mapping(box.mesh(), mappingDict("exact"));
    const ::nscd::Grains grains = makeGrains({Vec3(1.5, 1.5, 1.5), Vec3(3.2, 1.5, 1.5)}, 0.4);
    mapping.setMeshAhead(true);
    mapping.lookFirstIn({-1, 14});
    EXPECT_TRUE(mapping.update(grains, {}).outsideMesh.empty());
    EXPECT_EQ(mapping.cells(), (std::vector<label>{13, 14}));
    EXPECT_EQ(mapping.weights().shares.back().cell, 14);
    EXPECT_EQ(mapping.weights().shares.back().share, 1);
    EXPECT_NEAR(mapping.report().volumeDeposited/mapping.report().grainVolume, 1, 1e-14);
    mapping.setMeshAhead(false);
    EXPECT_EQ(mapping.update(grains, {}).outsideMesh, std::vector<std::int64_t>{grains.id[1]});
}

TEST(grainMapping, isEmptyWhenTheLastBodyIsErased)
{
    BoxMesh box(unitCells(labelVector(3, 3, 3)));
    GrainMapping mapping(box.mesh(), mappingDict("exact"));
    const MappedBodies pair{{0, 0}, {0.5, 0.5}, {0.1}, 1};
    mapping.update(makeGrains({Vec3(1.5, 1.5, 1.5), Vec3(1.9, 1.5, 1.5)}, 0.3), {}, pair);
    EXPECT_NEAR(mapping.report().volumeDeposited, 0.1, 1e-15);
    mapping.erase({0, 1});
    mapping.update(makeGrains({}, 0.3), {}, MappedBodies());
    EXPECT_EQ(mapping.weights().nRows(), 0);
    EXPECT_EQ(mapping.report().volumeDeposited, 0);
    EXPECT_EQ(mapping.report().grainVolume, 0);
}

// Rows of grains that have not moved are kept, whatever the others do, or come and go.
TEST(grainMapping, anUpdateIsAsAMappingMadeAnew)
{
    BoxMesh box(shakenPartlyCyclic());
    const fvMesh& mesh = box.mesh();
    GrainMapping kept(mesh, mappingDict("exact", 1, 0.4));
    ::nscd::Grains grains = makeGrains(randomPoints(40, Vec3(0.1, 0.1, 0.1), Vec3(3.9, 3.9, 3.9)), 0.35);
    const auto expectAsAnew = [&](const char* change)
    {
        SCOPED_TRACE(change);
        kept.update(grains, {});
        GrainMapping anew(mesh, mappingDict("exact", 1, 0.4));
        anew.update(grains, {});
        expectSame(kept, anew);
    };
    expectAsAnew("first");
    expectAsAnew("nothing");
    grains.position[7] += Vec3(0.1, 0.2, 0);
    expectAsAnew("one moved");
    grains.radius[11] = 0.3;
    expectAsAnew("one shrank");
    grains.position[3] = Vec3(1, 1, 50);
    expectAsAnew("one left the mesh");
    grains.forEachArray([](auto& values) { values.erase(values.begin() + 3); });
    grains.nOwned = grains.size();
    expectAsAnew("one removed");
    grains.add(Vec3(2, 2, 2), 0.2, 2500, 0, 1000);
    expectAsAnew("one added");
    eraseGrains(grains, {0, 9, 39});
    kept.erase({0, 9, 39});
    EXPECT_EQ(kept.weights().nRows(), label(grains.size()));
    expectAsAnew("some erased, the mapping told");
}

TEST(mappingRedistribution, doesNothingBelowTheLimit)
{
    BoxMesh box(unitCells(labelVector(4, 4, 4)));
    LimitedPacking packing(box.mesh(), 0.8);
    PackingRedistribution& redistribution = packing.redistribution;
    scalarField fraction(64, 0.8);
    const RedistributionReport report = redistribution.build(fraction);
    EXPECT_EQ(report.passes, 0);
    EXPECT_EQ(report.movedVolume, 0);
    EXPECT_FALSE(redistribution.isActive());
    EXPECT_EQ(fraction, scalarField(64, 0.8));
}

// A grain five cells wide that the centroid method puts into one cell; then one as large as the whole domain.
TEST(mappingRedistribution, clearsWhatFitsAndReportsWhatDoesNot)
{
    BoxMesh box(unitCells(labelVector(11, 11, 11)));
    LimitedPacking packing(box.mesh(), 0.8);
    PackingRedistribution& redistribution = packing.redistribution;
    scalarField fraction(1331, Zero);
    fraction[665] = 65.4;
    RedistributionReport report = redistribution.build(fraction);
    EXPECT_EQ(report.unresolvedVolume, 0);
    EXPECT_LE(max(fraction), 0.8*(1 + 1e-9));
    EXPECT_GE(min(fraction), 0);
    EXPECT_NEAR(sum(fraction), 65.4, 1e-11);
    EXPECT_LE(report.passes, 10);

    fraction = 0.9;
    report = redistribution.build(fraction);
    EXPECT_NEAR(report.unresolvedVolume, 133.1, 1e-9);
    EXPECT_NEAR(sum(fraction), 0.9*1331, 1e-9);
}

// Cells that give are full to the limit, those that get something have no more, and all others are as they were.
TEST(mappingRedistribution, movesNoMoreThanItMust)
{
    BoxMesh box(shakenPartlyCyclic());
    const scalarField& V = box.mesh().V();
    LimitedPacking packing(box.mesh(), 0.8);
    PackingRedistribution& redistribution = packing.redistribution;
    const scalarField before = 0.6 + 0.4*randomField(box.mesh().nCells(), 5);
    scalarField after = before;
    EXPECT_EQ(redistribution.build(after).unresolvedVolume, 0);
    EXPECT_NEAR(sum(V*after)/sum(V*before), 1, 1e-14);
    forAll(after, cell)
    {
        EXPECT_LE(after[cell], 0.8*(1 + 1e-12));
        EXPECT_GE(after[cell], min(before[cell], 0.8*(1 - 1e-12)));
    }
}

// Solid has only one way along a row of cells: each keeps what fits.
TEST(mappingRedistribution, fillsARowFromItsEnd)
{
    BoxMesh box(unitCells(labelVector(8, 1, 1)));
    LimitedPacking packing(box.mesh(), 0.5);
    PackingRedistribution& redistribution = packing.redistribution;
    scalarField fraction(8, 0.1);
    fraction[0] = 1.8;
    const RedistributionReport report = redistribution.build(fraction);
    const scalar expected[] = {0.5, 0.5, 0.5, 0.5, 0.2, 0.1, 0.1, 0.1};
    forAll(fraction, cell) EXPECT_NEAR(fraction[cell], expected[cell], 1e-13) << cell;
    EXPECT_NEAR(report.movedVolume, 1.3 + 0.9 + 0.5 + 0.1, 1e-12);
    EXPECT_EQ(report.passes, 4);
}

} // End anonymous namespace
