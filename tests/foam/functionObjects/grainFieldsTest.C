// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of grainFields on meshes in memory: momentum, sums over grains by brute force, and grains owned by any rank.
#include "functionObjects/grainFields.H"

#include "caseTools.H"
#include "coupling/step/grainHomes.H"
#include "mappingTools.H"
#include "ranksMesh.H"
#include "functionObjects/shownGrains.H"

#include "parallel/mpiExchange.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const labelVector nCells(6, 5, 8);

/// Spheres of two densities, of several sizes and of any velocity, in the lower half of the box. They overlap here and there.
::nscd::Grains movingGrains(const Vec3& mean = Vec3(3, -1, 2), scalar spread = 1)
{
    const std::size_t n = 150;
    const std::vector<Vec3> positions = randomPoints(n, Vec3(0.3, 0.3, 0.3), Vec3(5.7, 4.7, 3.7));
    const std::vector<Vec3> velocities = randomPoints(n, Vec3::Constant(-spread), Vec3::Constant(spread), 2);
    ::nscd::Grains grains;
    for (std::size_t i = 0; i < n; ++i)
    {
        grains.add(positions[i], 0.2 + 0.001*scalar(i), i % 3 ? 2500 : 900, 0, std::int64_t(i));
        grains.velocity.back() = mean + velocities[i];
    }
    return grains;
}

/// What grainFields makes of grains on a mesh.
struct FieldsOf : ShownGrains
{
    FieldsOf(const fvMesh& fvMesh, const ::nscd::Grains& own, const dictionary& dict, const GrainsAtHome& atHome = GrainsAtHome())
    :
        ShownGrains(fvMesh, own, dict, atHome)
    {
        functionObjects::GrainFields("fields", mesh.time(), dictionaryOf("type grainFields;"));
    }

    template<class Field>
    const typename Field::Internal::FieldType& field(const char* name) const { return mesh.lookupObject<Field>(name).primitiveField(); }

    const scalarField& density() const { return field<volScalarField>("bulkDensity.grains"); }
    const vectorField& velocity() const { return field<volVectorField>("U.grains"); }
    const scalarField& temperature() const { return field<volScalarField>("T.grains"); }
    const symmTensorField& stress() const { return field<volSymmTensorField>("kineticStress.grains"); }
};

Vec3 momentumOf(const ::nscd::Grains& grains)
{
    Vec3 momentum = Vec3::Zero();
    for (std::size_t i = 0; i < grains.size(); ++i) momentum += grains.mass[i]*grains.velocity[i];
    return momentum;
}

/// One cell's mean velocity, and its fluctuations about that, grain by grain.
struct CellOfGrains
{
    scalar mass = 0;
    vector velocity = Zero;
    symmTensor fluctuations = Zero;   ///< [J]

    CellOfGrains(const WeightMatrix& weights, const ::nscd::Grains& grains, label cell)
    {
        for (label i = 0; i < weights.nRows(); ++i)
        {
            const scalar m = shareIn(weights, i, cell)*grains.mass[i];
            mass += m;
            velocity += m*toFoam(grains.velocity[i]);
        }
        if (mass > 0) velocity /= mass;
        for (label i = 0; i < weights.nRows(); ++i)
        {
            fluctuations += shareIn(weights, i, cell)*grains.mass[i]*sqr(toFoam(grains.velocity[i]) - velocity);
        }
    }
};

/// Loose enough that nothing is moved out of cells that are too full.
dictionary looseDict(const word& method) { return mappingDict(method, 0, 0.001); }

void expectSumsByBruteForce(const word& method)
{
    const BoxMesh box(unitCells(nCells));
    const ::nscd::Grains grains = movingGrains();
    const FieldsOf fields(const_cast<BoxMesh&>(box).mesh(), grains, looseDict(method));
    label empty = 0;
    forAll(fields.density(), cell)
    {
        const CellOfGrains expected(fields.mapping->weights(), grains, cell);
        const scalar tolerance = 1e-12*(1 + expected.mass);
        EXPECT_NEAR(fields.density()[cell], expected.mass, tolerance);
        EXPECT_LT(mag(fields.velocity()[cell] - expected.velocity), 1e-9) << cell;
        EXPECT_LT(mag(fields.stress()[cell] - expected.fluctuations), 1e2*tolerance) << cell;
        EXPECT_NEAR(fields.temperature()[cell]*3*expected.mass, tr(expected.fluctuations), 1e2*tolerance) << cell;
        if (expected.mass > 0) continue;
        ++empty;
        EXPECT_EQ(fields.velocity()[cell], vector::zero);
        EXPECT_EQ(fields.temperature()[cell], 0);
        EXPECT_EQ(fields.stress()[cell], symmTensor::zero);
    }
    EXPECT_GT(empty, 30);
    EXPECT_LT(empty, 200);
    EXPECT_GT(max(fields.temperature()), 0.1);
}

} // namespace

TEST(GrainFields, areSumsOverGrainsByTheSharesOfTheVoidFraction)
{
    for (const char* method : {"centroid", "satellite", "exact"}) expectSumsByBruteForce(method);
}

TEST(GrainFields, holdTheMomentumOfTheGrains)
{
    // 0.5: what exceeds a solid fraction of 0.5 is moved to neighboring cells. 3: smoothed over three cells.
    for (const dictionary& dict : {looseDict("exact"), mappingDict("centroid", 0, 0.5), mappingDict("exact", 3, 0.5)})
    {
        BoxMesh box(unitCells(nCells));
        const ::nscd::Grains grains = movingGrains();
        const FieldsOf fields(box.mesh(), grains, dict);
        const scalarField masses(box.mesh().V()*fields.density());
        EXPECT_NEAR(sum(masses)/grains.mass.size(), std::accumulate(grains.mass.begin(), grains.mass.end(), 0.0)/grains.mass.size(), 1e-10);
        const Vec3 momentum = momentumOf(grains);
        EXPECT_LT(mag(sum(masses*fields.velocity()) - toFoam(momentum)), 1e-12*momentum.norm()) << dict.get<scalar>("diffusionLength");
        const symmTensorField whole(masses*sqr(fields.velocity()) + box.mesh().V()*fields.stress());
        scalar energy = 0;
        for (std::size_t i = 0; i < grains.size(); ++i) energy += grains.mass[i]*grains.velocity[i].squaredNorm();
        EXPECT_NEAR(tr(sum(whole)), energy, 1e-11*energy) << dict.get<scalar>("diffusionLength");
    }
}

TEST(GrainFields, ofGrainsThatMoveAlikeAreUniformAndCold)
{
    const vector velocity(3, -1, 2);
    for (const scalar smoothed : {0.0, 3.0})
    {
        BoxMesh box(unitCells(labelVector(6, 5, 60)));
        const FieldsOf fields(box.mesh(), movingGrains(toVec3(velocity), 0), mappingDict("exact", smoothed));
        // Where smoothing leaves little of the grains its round-off is the larger part.
        const scalar tolerance = smoothed > 0 ? 1e-9*mag(velocity) : 1e-13;
        EXPECT_EQ(min(fields.density()), 0);
        forAll(fields.density(), cell)
        {
            const bool hasGrains = fields.density()[cell] > 0;
            EXPECT_LT(mag(fields.velocity()[cell] - (hasGrains ? velocity : vector::zero)), tolerance) << fields.density()[cell];
            EXPECT_GE(fields.temperature()[cell], 0);
            EXPECT_LT(fields.temperature()[cell], 1e-13) << fields.density()[cell];
        }
    }
}

TEST(GrainFields, areZeroBeforeTheFirstGrain)
{
    BoxMesh box(unitCells(nCells));
    const FieldsOf fields(box.mesh(), ::nscd::Grains(), mappingDict("exact", 3));
    EXPECT_EQ(max(fields.density()), 0);
    EXPECT_EQ(max(mag(fields.velocity())), 0);
    EXPECT_EQ(max(mag(fields.stress())), 0);
}

TEST(GrainFields, ofDiscsHaveATemperatureOfTwoDirections)
{
    BoxMesh box(unitCells(labelVector(1, 1, 1), {"wall", "wall", "wall", "wall", "empty", "empty"}));
    ::nscd::Grains discs;
    discs.shape.dimensions = 2;
    discs.shape.thickness = 1;
    for (const scalar x : {0.3, 0.7})
    {
        discs.add(Vec3(x, 0.5, 0.5), 0.1, 1000, 0, std::int64_t(10*x));
        discs.velocity.back() = Vec3(x < 0.5 ? 3 : -1, 0, 0);
    }
    const FieldsOf fields(box.mesh(), discs, looseDict("exact"));
    EXPECT_NEAR(fields.velocity()[0].x(), 1, 1e-12);
    EXPECT_NEAR(fields.temperature()[0], 4.0/2, 1e-12);
}

TEST(grainFieldsRanks, areThoseOfOneRank)
{
    if (!Pstream::parRun()) GTEST_SKIP() << "on several ranks";
    for (const scalar smoothed : {0.0, 2.0})
    {
        RanksMesh mesh(unitCells(nCells), blocks());
        const ::nscd::Grains all = movingGrains();
        // Grains are dealt out to ranks as cards are: few are where they are at home.
        ::nscd::Grains own;
        for (std::size_t i = std::size_t(Pstream::myProcNo()); i < all.size(); i += std::size_t(Pstream::nProcs()))
        {
            own.add(all.position[i], all.radius[i], all.mass[i]/all.volume(i), 0, all.id[i]);
            own.velocity.back() = all.velocity[i];
        }
        const ::nscd::MpiExchange exchange;
        GrainHomes homes(mesh.part(), exchange.tree(), findHomeIn(mesh.part()));
        GrainsAtHome atHome(exchange.tree());
        atHome.update(own, homes.update(own), MappedBodies());
        const dictionary dict = mappingDict("exact", smoothed, 0.5);
        const FieldsOf here(mesh.part(), own, dict, atHome);

        const SerialSection serial;
        const FieldsOf whole(mesh.whole(), all, dict);
        // Smoothing is solved to 1e-13, by another way on each number of ranks.
        const scalar tolerance = smoothed > 0 ? 1e-11 : 1e-13;
        const scalarField density(mesh.partOf(whole.density()));
        EXPECT_LT(max(mag(here.density() - density)), tolerance*max(whole.density()));
        EXPECT_LT(max(mag(here.density()*here.velocity() - density*mesh.partOf(whole.velocity()))), tolerance*max(whole.density())*5);
        EXPECT_LT(max(mag(here.stress() - mesh.partOf(whole.stress()))), tolerance*max(whole.density())*25);
        EXPECT_LT(max(mag(density*(here.temperature() - mesh.partOf(whole.temperature())))), tolerance*max(whole.density())*25);
    }
}
