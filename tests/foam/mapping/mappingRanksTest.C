// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// The mapping over the ranks of a decomposed mesh, against the serial mapping of the same grains on the whole mesh.

#include "mappingTools.H"
#include "ranksMesh.H"

#include <gtest/gtest.h>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

struct Scene
{
    BoxMeshSettings settings;
    Decomposition decomposition;
    ::nscd::Grains grains;
    std::vector<const char*> methods = {"centroid", "satellite", "exact"};
    bool smoothsAll = false;  // else `exact` alone is smoothed too: smoothing comes behind the method, whichever it is
};

// Grains of several radii, none of which touch, on a jittered lattice; with ids in their order.
::nscd::Grains looseGrains(const point& size, const scalar largest, const bool isFlat = false)
{
    ::nscd::Grains grains;
    std::mt19937 generator(11);
    std::uniform_real_distribution<scalar> random(-1, 1);
    const scalar spacing = 2.5*largest;
    for (scalar z = 0.1; z < (isFlat ? 0.2 : size.z()); z += spacing)
    for (scalar y = 0.1; y < size.y(); y += spacing)
    for (scalar x = 0.1; x < size.x(); x += spacing)
    {
        const Vec3 jitter(random(generator), random(generator), isFlat ? 0 : random(generator));
        const scalar radius = largest*(0.85 + 0.15*random(generator));
        const Vec3 upper(size.x(), size.y(), size.z());
        const Vec3 position = (Vec3(x, y, z) + 0.25*largest*jitter).cwiseMax(0.01).cwiseMin(upper - Vec3::Constant(0.01));
        grains.add(position, radius, 2500, 0, std::int64_t(grains.size()));
    }
    if (isFlat)
    {
        grains.shape.dimensions = 2;
        grains.shape.thickness = size.z();
    }
    return grains;
}

::nscd::Grains chosen(const ::nscd::Grains& grains, const std::vector<std::size_t>& which)
{
    ::nscd::Grains result;
    for (const std::size_t i : which) result.add(grains.position[i], grains.radius[i], 2500, 0, grains.id[i]);
    result.shape = grains.shape;
    return result;
}

template<class Type>
std::vector<Type> chosen(const std::vector<Type>& values, const std::vector<std::size_t>& which)
{
    std::vector<Type> result;
    for (const std::size_t i : which) result.push_back(values[i]);
    return result;
}

// Amounts and fields that are spread and sampled, the same on all ranks.
struct Amounts
{
    std::vector<scalar> masses;
    std::vector<Vec3> forces;
    scalarField pressures;
    vectorField velocities;

    Amounts(const std::size_t nGrains, const label nCells)
    :
        forces(randomPoints(nGrains, Vec3(-1, -1, -1), Vec3(1, 1, 1), 5)),
        pressures(randomField(nCells, 4)),
        velocities(randomVectors(nCells, 5))
    {
        for (const Vec3& force : forces) masses.push_back(force.norm());
    }
};

struct Mapped
{
    MappingReport report;
    scalarField solid;
    scalarField mass;
    vectorField force;
    std::vector<scalar> pressure;
    std::vector<Vec3> velocity;

    Mapped
    (
        GrainMapping& mapping, const fvMesh& mesh, const ::nscd::Grains& grains, const std::vector<scalar>& masses,
        const std::vector<Vec3>& forces, const scalarField& pressures, const vectorField& velocities
    )
    {
        report = mapping.update(grains, {});
        volScalarField fluidFraction(IOobject("alpha", mesh.time().timeName(), mesh), mesh, dimensionedScalar("one", dimless, 1));
        mapping.setFluidFraction(fluidFraction);
        solid = 1 - fluidFraction.primitiveField();
        mapping.spread({{masses, mass}}, {{forces, force}});
        mapping.sample({{pressures, pressure}}, {{velocities, velocity}});
    }
};

void expectSameFields(const RanksMesh& mesh, const Mapped& whole, const Mapped& part, const scalar tolerance)
{
    const scalar solidScale = max(mag(whole.solid));
    EXPECT_LE(max(mag(part.solid - mesh.partOf(whole.solid)))/solidScale, tolerance);
    EXPECT_LE(max(mag(part.mass - mesh.partOf(whole.mass)))/max(mag(whole.mass)), tolerance);
    EXPECT_LE(max(mag(part.force - mesh.partOf(whole.force)))/max(mag(whole.force)), tolerance);
}

void expectSameSamples
(
    const Mapped& whole, const Mapped& part, const std::vector<std::size_t>& mine, const scalar tolerance
)
{
    for (std::size_t i = 0; i < mine.size(); ++i)
    {
        EXPECT_NEAR(part.pressure[i], whole.pressure[mine[i]], tolerance) << "grain " << mine[i];
        EXPECT_LE((part.velocity[i] - whole.velocity[mine[i]]).norm(), tolerance) << "grain " << mine[i];
    }
}

void expectSameRows
(
    const RanksMesh& mesh, const GrainMapping& whole, const GrainMapping& part, const std::vector<std::size_t>& mine
)
{
    for (std::size_t i = 0; i < mine.size(); ++i)
    {
        const WeightMatrix& weights = part.weights();
        const std::vector<label>& wholeStart = whole.weights().rowStart;
        ASSERT_EQ(weights.rowStart[i + 1] - weights.rowStart[i], wholeStart[mine[i] + 1] - wholeStart[mine[i]])
            << "grain " << mine[i];
        EXPECT_NEAR(rowSum(weights, label(i)), 1, 1e-14);
        for (label k = weights.rowStart[i]; k < weights.rowStart[i + 1]; ++k)
        {
            const CellHome home = part.mappingMesh().home(weights.shares[k].cell);
            const label cell = mesh.wholeCell(home.rank, home.cell);
            EXPECT_NEAR(weights.shares[k].share, shareIn(whole.weights(), label(mine[i]), cell), 1e-13) << "grain " << mine[i];
        }
    }
}

// sum_i q_i sample_i(f) = sum_j V_j spread(q)_j f_j over all ranks.
void expectDuality
(
    const Mapped& part, const fvMesh& mesh, const std::vector<Vec3>& forces, const vectorField& velocities, const scalar tolerance
)
{
    scalar onGrains = 0;
    scalar scale = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
    {
        onGrains += forces[i].dot(part.velocity[i]);
        scale += forces[i].norm();
    }
    const scalar inCells = gSum(mesh.V().field()*(part.force & velocities));
    reduce(onGrains, sumOp<scalar>());
    reduce(scale, sumOp<scalar>());
    EXPECT_NEAR(onGrains/scale, inCells/scale, tolerance);
}

std::vector<std::size_t> grainsAtHome(const RanksMesh& mesh, const std::vector<label>& wholeCells)
{
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < wholeCells.size(); ++i)
    {
        if (wholeCells[i] >= 0 && mesh.rankOf(wholeCells[i]) == Pstream::myProcNo()) mine.push_back(i);
    }
    return mine;
}

void compareMappings(RanksMesh& mesh, const ::nscd::Grains& grains, const dictionary& dict, const Amounts& amounts)
{
    const bool isSmoothed = dict.get<scalar>("diffusionLength") > 0;
    std::unique_ptr<GrainMapping> wholeMapping;
    std::unique_ptr<Mapped> whole;
    {
        const SerialSection serial;
        wholeMapping.reset(new GrainMapping(mesh.whole(), dict));
        whole.reset
        (
            new Mapped
            (
                *wholeMapping, mesh.whole(), grains, amounts.masses, amounts.forces, amounts.pressures, amounts.velocities
            )
        );
    }
    const std::vector<std::size_t> mine = grainsAtHome(mesh, wholeMapping->cells());
    const std::vector<Vec3> forces = chosen(amounts.forces, mine);
    const vectorField velocities = mesh.partOf(amounts.velocities);
    GrainMapping partMapping(mesh.part(), dict);
    const Mapped part
    (
        partMapping, mesh.part(), chosen(grains, mine), chosen(amounts.masses, mine), forces,
        mesh.partOf(amounts.pressures), velocities
    );
    EXPECT_TRUE(part.report.away.empty());
    EXPECT_TRUE(part.report.outsideMesh.empty());
    EXPECT_NEAR(part.report.grainVolume/whole->report.grainVolume, 1, 1e-13);
    EXPECT_NEAR(part.report.volumeDeposited/whole->report.grainVolume, 1, 1e-12);
    EXPECT_NEAR(part.report.lostOutside/whole->report.grainVolume, whole->report.lostOutside/whole->report.grainVolume, 1e-13);
    expectSameRows(mesh, *wholeMapping, partMapping, mine);
    const bool isRedistributed = whole->report.redistribution.passes > 0;
    EXPECT_EQ(part.report.redistribution.passes > 0, isRedistributed);
    const scalar tolerance = isSmoothed || isRedistributed ? 1e-12 : 1e-13;
    expectDuality(part, mesh.part(), forces, velocities, isSmoothed ? 1e-12 : 1e-13);
    expectSameFields(mesh, *whole, part, tolerance);
    expectSameSamples(*whole, part, mine, tolerance);
    EXPECT_NEAR(part.report.redistribution.movedVolume, whole->report.redistribution.movedVolume, 1e-11*whole->report.grainVolume);
    EXPECT_EQ(part.report.redistribution.unresolvedVolume, whole->report.redistribution.unresolvedVolume);
}

void compareMappings(const Scene& scene)
{
    RanksMesh mesh(scene.settings, scene.decomposition);
    const Amounts amounts(scene.grains.nOwned, mesh.whole().nCells());
    for (const char* method : scene.methods)
    {
        for (const scalar length : {0., 1.5})
        {
            if (length > 0 && !scene.smoothsAll && word(method) != "exact") continue;
            SCOPED_TRACE(std::string(method) + ", diffusionLength " + std::to_string(length));
            compareMappings(mesh, scene.grains, mappingDict(method, length, 1e-12), amounts);
        }
    }
}

BoxMeshSettings shakenCells(const labelVector& n, const wordList& types = wordList(6, word("wall")))
{
    BoxMeshSettings settings = unitCells(n, types);
    shake(settings, 0.2);
    return settings;
}

TEST(mappingRanks, slicesAcrossABed)
{
    Scene scene = {shakenCells(labelVector(9, 4, 5)), slices(), looseGrains(point(9, 4, 5), 0.35)};
    scene.smoothsAll = true;
    compareMappings(scene);
}

TEST(mappingRanks, blocksThatMeetInACorner)
{
    compareMappings({unitCells(labelVector(6, 6, 6)), blocks(), looseGrains(point(6, 6, 6), 0.4)});
}

TEST(mappingRanks, scatteredCells)
{
    compareMappings({shakenCells(labelVector(6, 5, 4)), scattered(), looseGrains(point(6, 5, 4), 0.4)});
}

TEST(mappingRanks, cyclicBordersBetweenRanks)
{
    const wordList types({"cyclic", "cyclic", "cyclic", "cyclic", "wall", "wall"});
    compareMappings({shakenCells(labelVector(8, 5, 4), types), slices(), looseGrains(point(8, 5, 4), 0.4)});
    compareMappings({shakenCells(labelVector(5, 6, 4), types), blocks(), looseGrains(point(5, 6, 4), 0.6)});
}

TEST(mappingRanks, allCyclicAndScattered)
{
    compareMappings({shakenCells(labelVector(4, 3, 4), allCyclic()), scattered(), looseGrains(point(4, 3, 4), 0.45)});
}

// A ball meets several images of a cell, own or not.
TEST(mappingRanks, fewCellsAcrossThePeriod)
{
    const ::nscd::Grains grains = makeGrains(randomPoints(4, Vec3(0, 0, 0), Vec3(8, 1, 2)), 0.7);
    compareMappings({unitCells(labelVector(8, 1, 2), allCyclic()), slices(), grains});
}

TEST(mappingRanks, gradedCells)
{
    BoxMeshSettings settings = unitCells(labelVector(8, 6, 5));
    settings.movePoint = [](const point& p)
    {
        return point(8*std::pow(p.x()/8, 1.6), 6*std::pow(p.y()/6, 1.3), p.z());
    };
    compareMappings({settings, blocks(), looseGrains(point(8, 6, 5), 0.45)});
}

TEST(mappingRanks, twoDimensions)
{
    const wordList types({"cyclic", "cyclic", "wall", "wall", "empty", "empty"});
    for (const Decomposition& decomposition : {blocks(), scattered()})
    {
        BoxMeshSettings settings = unitCells(labelVector(9, 8, 1), types);
        settings.max.z() = 0.3;
        shake(settings, 0.2, true);
        Decomposition flat = decomposition;
        if (flat.parts.z() > 1) flat.parts = labelVector(flat.parts.x()*flat.parts.z(), flat.parts.y(), 1);
        compareMappings({settings, flat, looseGrains(point(9, 8, 0.3), 0.6, true)});
    }
}

// Several layers of halo cells, and images of the own cells among what lies behind them.
TEST(mappingRanks, grainsLargerThanCells)
{
    const std::vector<const char*> exact = {"exact"};
    const ::nscd::Grains three = makeGrains({Vec3(2.1, 3.4, 3.6), Vec3(6, 3.3, 3.7), Vec3(9.9, 3.6, 3.4)}, 1.9);
    compareMappings({shakenCells(labelVector(12, 7, 7)), slices(), three, exact});
    const wordList types({"cyclic", "cyclic", "wall", "wall", "cyclic", "cyclic"});
    const ::nscd::Grains two = makeGrains({Vec3(0.4, 2.6, 0.3), Vec3(3.2, 3.3, 4.1)}, 1.7);
    compareMappings({unitCells(labelVector(6, 6, 7), types), scattered(), two, exact});
}

TEST(mappingRanks, satellitesOfGrainsLargerThanCells)
{
    const wordList types({"cyclic", "cyclic", "wall", "wall", "cyclic", "cyclic"});
    const ::nscd::Grains two = makeGrains({Vec3(0.4, 2.6, 0.3), Vec3(3.2, 3.3, 4.1)}, 1.4);
    compareMappings({shakenCells(labelVector(6, 6, 7), types), blocks(), two, {"satellite"}});
}

// A dense cluster with one large grain, so that there are overfull cells at the borders of many ranks.
::nscd::Grains denseGrains()
{
    ::nscd::Grains grains = makeGrains(randomPoints(150, Vec3(1, 1, 1), Vec3(7, 4, 4)), 0.35);
    grains.add(Vec3(4.1, 3.2, 2.9), 1.4, 2500, 0, 7);
    return grains;
}

void expectLimitAndConservation
(
    const Mapped& part, const fvMesh& mesh, const ::nscd::Grains& grains, const std::vector<Vec3>& forces, const scalar limit
)
{
    EXPECT_GT(part.report.redistribution.movedVolume, 0);
    EXPECT_EQ(part.report.redistribution.unresolvedVolume, 0);
    EXPECT_NEAR(part.report.volumeDeposited/::nscd::totalVolume(grains), 1, 1e-12);
    EXPECT_LE(gMax(part.solid), limit*(1 + 1e-11));
    EXPECT_GE(gMin(part.solid), -1e-12);
    vector total = Zero;
    for (const Vec3& force : forces) total += toFoam(force);
    EXPECT_NEAR(mag(gSum(mesh.V().field()*part.force) - total), 0, 1e-12*scalar(grains.nOwned));
}

// The operator that was recorded is the one that changed the solid fraction, and a uniform field stays uniform.
void expectRecordedOperator(const GrainMapping& mapping, const ::nscd::Grains& mine, const Mapped& part, const scalar tolerance)
{
    std::vector<scalar> volumes;
    for (std::size_t i = 0; i < mine.nOwned; ++i) volumes.push_back(mine.volume(i));
    scalarField solid;
    mapping.spread(volumes, solid);
    EXPECT_LE(gMax(mag(solid - part.solid)()), tolerance);
    std::vector<scalar> ones;
    mapping.sample(scalarField(solid.size(), 1), ones);
    for (const scalar one : ones) EXPECT_NEAR(one, 1, tolerance);
}

void expectRedistribution(RanksMesh& mesh, const ::nscd::Grains& grains, const dictionary& dict)
{
    const Amounts amounts(grains.nOwned, mesh.whole().nCells());
    compareMappings(mesh, grains, dict, amounts);
    std::vector<label> cells;
    {
        const SerialSection serial;
        GrainMapping whole(mesh.whole(), dict);
        EXPECT_GT(whole.update(grains, {}).redistribution.passes, 0);
        cells = whole.cells();
    }
    const std::vector<std::size_t> which = grainsAtHome(mesh, cells);
    const ::nscd::Grains mine = chosen(grains, which);
    const std::vector<Vec3> forces = chosen(amounts.forces, which);
    const vectorField velocities = mesh.partOf(amounts.velocities);
    const scalar tolerance = dict.get<scalar>("diffusionLength") > 0 ? 1e-12 : 1e-13;
    GrainMapping mapping(mesh.part(), dict);
    const Mapped part
    (
        mapping, mesh.part(), mine, chosen(amounts.masses, which), forces, mesh.partOf(amounts.pressures), velocities
    );
    expectLimitAndConservation(part, mesh.part(), grains, amounts.forces, 1 - dict.get<scalar>("minFluidFraction"));
    expectDuality(part, mesh.part(), forces, velocities, tolerance);
    expectRecordedOperator(mapping, mine, part, 10*tolerance);
    const Mapped again
    (
        mapping, mesh.part(), mine, chosen(amounts.masses, which), forces, mesh.partOf(amounts.pressures), velocities
    );
    EXPECT_EQ(again.solid, part.solid);
    EXPECT_EQ(again.force, part.force);
}

TEST(mappingRanks, redistributeAcrossRanks)
{
    for (const Decomposition& decomposition : {slices(), blocks(), scattered()})
    {
        RanksMesh mesh(shakenCells(labelVector(8, 6, 6), {"cyclic", "cyclic", "wall", "wall", "wall", "wall"}), decomposition);
        expectRedistribution(mesh, denseGrains(), mappingDict("centroid", 0, 0.6));
        expectRedistribution(mesh, denseGrains(), mappingDict("exact", 1, 0.6));
    }
}

// Discs in rows, each in the gaps of the row below: 0.907 of the area, more than the default limit, in much of the mesh.
::nscd::Grains closeDiscs(const scalar width, const scalar height, const scalar radius, const scalar thickness)
{
    std::vector<Vec3> centers;
    label row = 0;
    for (scalar y = radius; y < height; y += std::sqrt(3.0)*radius, ++row)
    {
        for (scalar x = radius*(1 + row % 2); x < width; x += 2*radius) centers.push_back(Vec3(x, y, thickness/2));
    }
    ::nscd::Grains grains = makeGrains(centers, radius);
    grains.shape.dimensions = 2;
    grains.shape.thickness = thickness;
    return grains;
}

// All cells alike, so that what is decided on a cell's own number or by round-off would show; and cells none of which are alike.
TEST(mappingRanks, redistributeClosePackedDiscs)
{
    const wordList types({"cyclic", "cyclic", "wall", "wall", "empty", "empty"});
    for (const scalar shaken : {0.0, 0.2})
    {
        for (const bool isScattered : {false, true})
        {
            BoxMeshSettings settings = unitCells(labelVector(20, 16, 1), types);
            settings.max.z() = 0.3;
            shake(settings, shaken, true);
            RanksMesh mesh(settings, isScattered ? scattered() : slices());
            expectRedistribution(mesh, closeDiscs(20, 10, 0.5, 0.3), mappingDict("exact"));
            expectRedistribution(mesh, closeDiscs(20, 10, 0.25, 0.3), mappingDict("centroid"));
            expectRedistribution(mesh, closeDiscs(20, 9, 5, 0.3), mappingDict("exact", 0, 0.3));
        }
    }
}

// More than all cells can hold stays where it is, and what is too much is told.
TEST(mappingRanks, tellWhatFitsNowhere)
{
    RanksMesh mesh(shakenCells(labelVector(7, 4, 4)), scattered());
    const scalarField whole = 1.0 + 0.15*randomField(mesh.whole().nCells(), 3);
    LimitedPacking packing(mesh.part(), 0.8);
    PackingRedistribution& redistribution = packing.redistribution;
    scalarField fraction = mesh.partOf(whole);
    const RedistributionReport report = redistribution.build(fraction);
    EXPECT_FALSE(redistribution.isActive());
    EXPECT_EQ(report.movedVolume, 0);
    EXPECT_EQ(fraction, mesh.partOf(whole));
    EXPECT_NEAR(report.unresolvedVolume/gSum(mesh.part().V()*(fraction - 0.8)), 1, 1e-13);
}

// Grains that left their rank by less than a cell say where they belong; there, they are at home.
TEST(mappingRanks, grainsAwayFromHomeAreNamed)
{
    RanksMesh mesh(shakenCells(labelVector(8, 6, 5), {"cyclic", "cyclic", "wall", "wall", "wall", "wall"}), blocks());
    ::nscd::PeriodicBox period;
    period.length = Vec3(8, 0, 0);
    ::nscd::Grains grains = looseGrains(point(8, 6, 5), 0.3);
    std::vector<label> before, after;
    std::vector<Vec3> moved = grains.position;
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
        moved[i] += 0.4*Vec3(i % 2 ? 1 : -1, i % 3 ? -1 : 1, i % 5 ? 1 : -1);
        for (int axis = 1; axis < 3; ++axis) moved[i][axis] = min(max(moved[i][axis], 0.01), (axis == 1 ? 6 : 5) - 0.01);
    }
    {
        const SerialSection serial;
        GrainMapping whole(mesh.whole(), mappingDict("exact"));
        whole.update(grains, period);
        before = whole.cells();
        grains.position = moved;
        EXPECT_TRUE(whole.update(grains, period).outsideMesh.empty());
        after = whole.cells();
    }
    const std::vector<std::size_t> mine = grainsAtHome(mesh, before);
    const ::nscd::Grains carried = chosen(grains, mine);
    for (const bool knowsCells : {false, true})
    {
        GrainMapping mapping(mesh.part(), mappingDict("exact"), 0.35);
        std::vector<CellHome> homes;
        for (std::size_t i = 0; i < mine.size(); ++i)
        {
            const CellHome old = mapping.find(looseGrains(point(8, 6, 5), 0.3).position[mine[i]], -1);
            ASSERT_EQ(old.rank, Pstream::myProcNo());
            homes.push_back(mapping.find(period.wrap(carried.position[i]), knowsCells ? old.cell : -1));
        }
        const MappingReport& report = mapping.update(carried, period);
        EXPECT_TRUE(report.outsideMesh.empty());
        std::size_t nAway = 0;
        for (std::size_t i = 0; i < mine.size(); ++i)
        {
            ASSERT_GE(homes[i].rank, 0) << "grain " << mine[i];
            EXPECT_EQ(mesh.wholeCell(homes[i].rank, homes[i].cell), after[mine[i]]) << "grain " << mine[i];
            if (homes[i].rank == Pstream::myProcNo()) continue;
            ASSERT_LT(nAway, report.away.size());
            EXPECT_EQ(report.away[nAway].grain, i);
            EXPECT_EQ(report.away[nAway].id, carried.id[i]);
            EXPECT_TRUE(report.away[nAway].home == homes[i]);
            EXPECT_EQ(rowSum(mapping.weights(), label(i)), 0);
            ++nAway;
        }
        EXPECT_EQ(report.away.size(), nAway);
        label nAll = label(nAway);
        reduce(nAll, sumOp<label>());
        EXPECT_TRUE(!Pstream::parRun() || nAll > 0);
    }
}

TEST(mappingRanks, grainsOutsideAllCellsAreNamed)
{
    RanksMesh mesh(unitCells(labelVector(8, 3, 3)), slices());
    GrainMapping mapping(mesh.part(), mappingDict("exact"));
    ::nscd::Grains grains = makeGrains({Vec3(1, -3, 1), Vec3(50, 1, 1)}, 0.2);
    EXPECT_EQ(mapping.update(grains, {}).outsideMesh, (std::vector<std::int64_t>{100, 101}));
    EXPECT_TRUE(mapping.report().away.empty());
    EXPECT_EQ(mapping.report().volumeDeposited, 0);
    EXPECT_NEAR(mapping.report().grainVolume, 2*Pstream::nProcs()*grains.volume(0), 1e-13);
}

TEST(mappingRanks, repeatToTheBitAndTheHaloGrowsWithTheGrains)
{
    RanksMesh mesh(shakenCells(labelVector(8, 6, 5)), blocks());
    const ::nscd::Grains grains = looseGrains(point(8, 6, 5), 0.8);
    std::vector<label> cells;
    {
        const SerialSection serial;
        GrainMapping whole(mesh.whole(), mappingDict("exact"));
        whole.update(grains, {});
        cells = whole.cells();
    }
    const std::vector<std::size_t> mine = grainsAtHome(mesh, cells);
    const ::nscd::Grains carried = chosen(grains, mine);
    std::vector<scalar> volumes;
    for (const std::size_t i : mine) volumes.push_back(grains.volume(i));
    scalarField first, second;
    GrainMapping grown(mesh.part(), mappingDict("exact", 1.0));
    const label small = grown.mappingMesh().nCells();
    grown.update(carried, {});
    EXPECT_TRUE(!Pstream::parRun() || grown.mappingMesh().nCells() > small);
    grown.spread(volumes, first);
    GrainMapping large(mesh.part(), mappingDict("exact", 1.0), 0.8);
    large.update(carried, {});
    large.spread(volumes, second);
    EXPECT_EQ(first, second);
}

TEST(mappingRanks, smoothingKeepsSumsAndIsItsOwnTranspose)
{
    for (const Decomposition& decomposition : {slices(), scattered()})
    {
        const wordList types({"cyclic", "cyclic", "wall", "wall", "cyclic", "cyclic"});
        RanksMesh mesh(shakenCells(labelVector(8, 5, 4), types), decomposition);
        const scalarField f = randomField(mesh.whole().nCells(), 1);
        const scalarField g = randomField(mesh.whole().nCells(), 2) + 2.0;
        for (const scalar length : {0.5, 3.0, 20.0})
        {
            scalarField whole = f;
            {
                const SerialSection serial;
                DiffusionSmoother(mesh.whole(), length).smooth(whole);
            }
            const DiffusionSmoother smoother(mesh.part(), length);
            scalarField smoothF = mesh.partOf(f);
            scalarField smoothG = mesh.partOf(g);
            smoother.smooth(smoothF);
            smoother.smooth(smoothG);
            const scalarField& V = mesh.part().V();
            EXPECT_LE(gMax(mag(smoothF - mesh.partOf(whole))()), 1e-13) << length;
            EXPECT_NEAR(gSum(V*smoothG)/gSum(V*mesh.partOf(g)), 1, 1e-14) << length;
            const scalar scale = gSum(V*mesh.partOf(g));
            EXPECT_NEAR(gSum(V*smoothF*mesh.partOf(g))/scale, gSum(V*smoothG*mesh.partOf(f))/scale, 1e-14) << length;
            scalarField used(mesh.whole().nCells(), Zero);
            used[17] = 1;
            DiffusionSmoother restricted(mesh.part(), length);
            restricted.restrictTo(mesh.partOf(used));
            scalarField spread = mesh.partOf(used), spreadByAll = spread;
            restricted.smooth(spread);
            smoother.smooth(spreadByAll);
            EXPECT_EQ(spread, spreadByAll);
            scalarField uniform(mesh.part().nCells(), 0.7);
            smoother.smooth(uniform);
            EXPECT_EQ(uniform, scalarField(mesh.part().nCells(), 0.7));
        }
    }
}

TEST(mappingRanks, refuseTheMeshOfOneRankInASerialRun)
{
    if (!Pstream::parRun()) return;
    RanksMesh mesh(unitCells(labelVector(8, 3, 3)), slices());
    const SerialSection serial;
    EXPECT_NE(errorMessage([&] { makeMappingMesh(mesh.part()); }).find("needs a parallel run"), std::string::npos);
}

TEST(mappingRanks, noGrainsAnywhere)
{
    RanksMesh mesh(unitCells(labelVector(8, 3, 3)), slices());
    GrainMapping mapping(mesh.part(), mappingDict("exact", 1));
    EXPECT_EQ(mapping.update(::nscd::Grains(), {}).grainVolume, 0);
    scalarField spread;
    mapping.spread(std::vector<scalar>(), spread);
    EXPECT_EQ(spread, scalarField(mesh.part().nCells(), Zero));
}

} // End anonymous namespace
