// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of parcels: every force on one is that on the real grains it stands for, taken together.
#include "stepTools.H"

#include "coupling/step/coarseGrains.H"

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Factors that differ from grain to grain.
scalar factorOf(std::size_t i) { return std::vector<scalar>{1, 2, 5, 1.7}[i % 4]; }

/// A random suspension, and the same with a parcel in the place of each grain, whose surface moves as fast.
struct Suspensions
{
    RandomSuspension real, parcels;
    std::vector<scalar> factor, numbers;
    CoarseGrains coarse{factor};

    Suspensions()
    {
        RandomNumbers random(7);
        real.at.convection = random.vecs(real.size());
        parcels = real;
        for (std::size_t i = 0; i < real.size(); ++i)
        {
            factor.push_back(factorOf(i));
            numbers.push_back(pow3(factor[i]));
            parcels.grains.radius[i] *= factor[i];
            parcels.grains.mass[i] *= numbers[i];
            parcels.grains.omega[i] /= factor[i];
            parcels.lastContactForce[i] *= numbers[i];
        }
        coarse.update(parcels.grains);
        parcels.at.dragFactor.assign(real.size(), 1.0);
        coarse.multiplyDrag(parcels.grains, parcels.at.dragFactor);
    }

    ForceInputs ofParcels() const { return {parcels.grains, parcels.at, parcels.density, parcels.gravity, nullptr, &coarse.radius()}; }
};

void expectNear(const Vec3& found, const Vec3& expected, const char* what, std::size_t i)
{
    EXPECT_LT((found - expected).norm(), 1e-12*expected.norm() + 1e-300) << what << ' ' << i;
}

} // namespace

TEST(CoarseGrains, feelWhatTheirRealGrainsFeelTogether)
{
    const Suspensions both;
    const GrainForces forces(forcesOf("drag { law Gidaspow; } addedMass on; saffmanLift on; magnusLift on;"), spheresInFluid);
    const std::vector<Vec3> lift = forces.exchanged(both.real.inputs()), liftOfParcels = forces.exchanged(both.ofParcels());
    const std::vector<Vec3> force = forces.explicitForces(both.real.inputs(), lift), ofParcels = forces.explicitForces(both.ofParcels(), liftOfParcels);
    const LinearDrag drag = forces.linearize(both.real.inputs(), {force, both.real.lastContactForce, 1e-3});
    const LinearDrag dragOfParcels = forces.linearize(both.ofParcels(), {ofParcels, both.parcels.lastContactForce, 1e-3});
    for (std::size_t i = 0; i < both.real.size(); ++i)
    {
        const scalar n = both.numbers[i];
        expectNear(liftOfParcels[i], n*lift[i], "lift", i);
        expectNear(ofParcels[i], n*force[i], "explicit forces", i);
        EXPECT_NEAR(dragOfParcels.implicit[i]/(n*drag.implicit[i]), 1, 1e-12) << i;
        EXPECT_NEAR(dragOfParcels.remainder[i]/(n*drag.remainder[i]), 1, 1e-9) << i;
        EXPECT_NEAR(dragOfParcels.velocityFactor[i], drag.velocityFactor[i], 1e-13) << i;
        EXPECT_NEAR(dragOfParcels.addedMass[i]/(n*drag.addedMass[i]), 1, 1e-13) << i;
    }
    EXPECT_NEAR(dragOfParcels.largestStiffness/drag.largestStiffness, 1, 1e-12);
    EXPECT_NEAR(dragOfParcels.beyond.Re, drag.beyond.Re, 1e-12);
}

/// The spin l omega of the real grains changes as it would without parcels: J_parcel d(omega)/dt l = n J d(l omega)/dt.
TEST(CoarseGrains, spinAsTheirRealGrains)
{
    const Suspensions both;
    const GrainForces forces(forcesOf(""), spheresInFluid);
    const std::vector<Vec3> none(both.real.size(), Vec3::Zero());
    const LinearDrag drag = forces.linearize(both.real.inputs(), {none, both.real.lastContactForce, 1e-3});
    const LinearDrag dragOfParcels = forces.linearize(both.ofParcels(), {none, both.parcels.lastContactForce, 1e-3});
    const ::nscd::ExternalForces real = forces.external(both.real.inputs(), none, drag), parcels = forces.external(both.ofParcels(), none, dragOfParcels);
    const auto inertia = [](const ::nscd::Grains& grains, std::size_t i) { return 0.4*grains.mass[i]*sqr(grains.radius[i]); };
    for (std::size_t i = 0; i < both.real.size(); ++i)
    {
        const Vec3 change = (real.torque[i] - real.implicitSpinDrag[i]*both.real.grains.omega[i])/inertia(both.real.grains, i);
        const Vec3 ofParcel = (parcels.torque[i] - parcels.implicitSpinDrag[i]*both.parcels.grains.omega[i])/inertia(both.parcels.grains, i);
        expectNear(both.factor[i]*ofParcel, change, "change of the spin", i);
    }
}

TEST(CoarseGrains, ofOneRealGrainEachAreThatGrainToTheBit)
{
    Suspensions both;
    const std::vector<scalar> ones(both.real.size(), 1.0);
    std::vector<scalar> factor = ones;
    CoarseGrains coarse(factor);
    coarse.update(both.real.grains);
    RandomSuspension marked = both.real;
    marked.at.dragFactor = ones;
    coarse.multiplyDrag(marked.grains, marked.at.dragFactor);
    const ForceInputs in{marked.grains, marked.at, marked.density, marked.gravity, nullptr, &coarse.radius()};
    const GrainForces forces(forcesOf("saffmanLift on; magnusLift on;"), spheresInFluid);
    EXPECT_EQ(forces.exchanged(in), forces.exchanged(both.real.inputs()));
    const std::vector<Vec3> force = forces.explicitForces(in, {});
    const LinearDrag a = forces.linearize(in, {force, marked.lastContactForce, 1e-3});
    const LinearDrag b = forces.linearize(both.real.inputs(), {force, marked.lastContactForce, 1e-3});
    EXPECT_EQ(a.implicit, b.implicit);
    EXPECT_EQ(a.remainder, b.remainder);
    EXPECT_EQ(a.spin, b.spin);
}

TEST(CoarseGrains, areCountedInRealGrains)
{
    Suspensions both;
    const ::nscd::Exchange alone{};
    GrainTotals totals = sumGrains(both.parcels.grains, alone);
    both.coarse.describe(both.parcels.grains, alone, totals);
    EXPECT_NEAR(totals.real.number, 5*(1 + 8 + 125 + pow3(1.7)), 1e-10);
    EXPECT_EQ(totals.real.perGrainMin, 1);
    EXPECT_EQ(totals.real.perGrainMax, 125);
    const GrainTotals real = sumGrains(both.real.grains, alone);
    EXPECT_NEAR(totals.real.diameterMin, real.diameterMin, 1e-18);
    EXPECT_NEAR(totals.real.diameterMax, real.diameterMax, 1e-18);
    both.coarse.dismiss(both.parcels.grains, {1, 2});
    both.coarse.setExited(both.coarse.exited(alone) + 7);
    EXPECT_EQ(both.coarse.exited(alone), 140);
}

TEST(CoarseGrains, thatEnterGetTheFactorOfTheirSource)
{
    std::vector<scalar> factor = {1, 1, 1, 1};
    CoarseGrains coarse(factor);
    std::vector<::nscd::EntrySource> sources(3);
    sources[2].coarseGraining = 4;
    coarse.welcome(1, {2, 0, 2}, sources);
    EXPECT_EQ(factor, (std::vector<scalar>{1, 4, 1, 4}));
}
