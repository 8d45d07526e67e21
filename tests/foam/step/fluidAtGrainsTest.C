// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The fluid at the grains: a flow whose values are known everywhere, sampled through the real weights.
#include "coupling/step/fluidAtGrains.H"
#include "fluidCase.H"
#include "mappingTools.H"

#include <gtest/gtest.h>

#include <map>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

const vector drift(0.3, -0.1, 0.2);
const tensor gradient(0.1, -2, 0.5, 0.7, -0.3, 1.1, -0.4, 0.9, 0.2);

/// u = drift + gradient^T x, sampled for grains in the middle of a box or, with one cell across, of a flat one.
struct LinearFlow
{
    FluidCase box;
    ::nscd::Grains grains;
    std::unique_ptr<GrainMapping> mapping;
    FluidAtGrains at;

    static FluidCaseSettings settings(bool isFlat)
    {
        FluidCaseSettings settings = isFlat ? planeCase(6, 6, 6, 6) : FluidCaseSettings();
        if (!isFlat)
        {
            settings.setCells(6, 6, 6);
            settings.setSize(6, 6, 6);
        }
        settings.rho = 900;
        settings.nu = 2e-6;
        return settings;
    }

    explicit LinearFlow(bool isFlat = false) : box(settings(isFlat))
    {
        box.setVelocity([](const point& x) { return drift + (x & gradient); });
        const scalar middle = isFlat ? 0.5 : 3;
        if (isFlat) grains.shape = {2, 1.0, 2};
        for (const Vec3& x : randomPoints(8, Vec3(1.5, 1.5, middle - 0.4*!isFlat), Vec3(4.5, 4.5, middle + 0.4*!isFlat)))
        {
            grains.add(Vec3(x.x(), x.y(), isFlat ? middle : x.z()), 0.2, 2500, 0, std::int64_t(grains.size()));
        }
        mapping = std::make_unique<GrainMapping>(box.mesh(), mappingDict("centroid"), 0.2);
        mapping->update(grains, ::nscd::PeriodicBox());
    }

    void sample(unsigned wanted, const volScalarField* fluidFraction = nullptr)
    {
        sampleFluid(box.fluid(), fluidFraction, *mapping, GrainsAtHome(), wanted, at);
    }
};

} // namespace

TEST(FluidAtGrains, velocityAndSpinAreThoseOfTheFlow)
{
    LinearFlow flow;
    flow.sample(reads::spin);
    const vector curl(gradient.yz() - gradient.zy(), gradient.zx() - gradient.xz(), gradient.xy() - gradient.yx());
    for (std::size_t i = 0; i < flow.grains.size(); ++i)
    {
        const vector center = flow.box.mesh().C()[flow.mapping->cells()[i]];
        EXPECT_LT((flow.at.velocity[i] - toVec3(drift + (center & gradient))).norm(), 1e-13);
        EXPECT_LT((flow.at.spin[i] - 0.5*toVec3(curl)).norm(), 1e-12);
    }
}

TEST(FluidAtGrains, onlyWhatIsWantedIsSampled)
{
    LinearFlow flow;
    flow.sample(reads::nothing);
    EXPECT_EQ(flow.at.velocity.size(), flow.grains.size());
    EXPECT_TRUE(flow.at.spin.empty() && flow.at.divTau.empty() && flow.at.pressureGradient.empty());
    EXPECT_TRUE(flow.at.viscosity.empty() && flow.at.fluidFraction.empty());
    flow.sample(reads::divTau | reads::pressureGradient);
    EXPECT_EQ(flow.at.divTau.size(), flow.grains.size());
    EXPECT_EQ(flow.at.pressureGradient.size(), flow.grains.size());
    EXPECT_TRUE(flow.at.spin.empty() && flow.at.viscosity.empty() && flow.at.fluidFraction.empty());
}

TEST(FluidAtGrains, whatIsNotSampledAgainStaysAsItIs)
{
    LinearFlow flow;
    setCells(flow.box.sources().fluidFraction, [](const point& x) { return 0.1*x.x(); });
    flow.sample(reads::viscosity | reads::fluidFraction, &flow.box.sources().fluidFraction);
    const FluidAtGrains before = flow.at;
    for (std::size_t i = 0; i < flow.grains.size(); ++i)
    {
        EXPECT_NEAR(flow.at.viscosity[i], 900*2e-6, 1e-15);
        EXPECT_NEAR(flow.at.fluidFraction[i], 0.1*flow.box.mesh().C()[flow.mapping->cells()[i]].x(), 1e-14);
    }
    flow.sample(reads::spin, &flow.box.sources().fluidFraction);
    EXPECT_EQ(flow.at.viscosity, before.viscosity);
    EXPECT_EQ(flow.at.fluidFraction, before.fluidFraction);
    flow.sample(reads::fluidFraction);
    EXPECT_EQ(flow.at.fluidFraction, std::vector<scalar>(flow.grains.size(), 1.0)) << "without feedback";
}

// Sauter's mean of what the cells hold: with the method `centroid` each grain has its cell's, sum of d^3 over sum of d^2.
TEST(FluidAtGrains, meanDiameterIsThatOfTheGrainsInTheCell)
{
    LinearFlow flow;
    const scalar radii[] = {0.05, 0.2, 0.11};
    for (std::size_t i = 0; i < flow.grains.size(); ++i) flow.grains.radius[i] = radii[i % 3];
    flow.mapping->update(flow.grains, ::nscd::PeriodicBox());
    flow.sample(reads::meanDiameter);
    std::map<label, std::pair<scalar, scalar>> sums;
    for (std::size_t i = 0; i < flow.grains.size(); ++i)
    {
        const scalar d = 2*flow.grains.radius[i];
        sums[flow.mapping->cells()[i]].first += d*d*d;
        sums[flow.mapping->cells()[i]].second += d*d;
    }
    EXPECT_LT(sums.size(), flow.grains.size()) << "some cells should hold several grains";
    for (std::size_t i = 0; i < flow.grains.size(); ++i)
    {
        const auto& [cubes, squares] = sums[flow.mapping->cells()[i]];
        EXPECT_NEAR(flow.at.meanDiameter[i]/(cubes/squares), 1, 1e-14);
    }
}

/// Parcels of 8 to 125 grains: the mean is that of these grains, sum of n d^3 over sum of n d^2.
TEST(FluidAtGrains, meanDiameterIsThatOfTheRealGrainsOfParcels)
{
    LinearFlow flow;
    std::vector<scalar> factor(flow.grains.size());
    for (std::size_t i = 0; i < factor.size(); ++i) factor[i] = scalar(2 + i % 4);
    sampleFluid(flow.box.fluid(), nullptr, *flow.mapping, GrainsAtHome(), reads::meanDiameter, flow.at, &factor);
    std::map<label, std::pair<scalar, scalar>> sums;
    for (std::size_t i = 0; i < factor.size(); ++i)
    {
        const scalar d = 0.4/factor[i], n = factor[i]*factor[i]*factor[i];
        sums[flow.mapping->cells()[i]].first += n*d*d*d;
        sums[flow.mapping->cells()[i]].second += n*d*d;
    }
    for (std::size_t i = 0; i < factor.size(); ++i)
    {
        const auto& [cubes, squares] = sums[flow.mapping->cells()[i]];
        EXPECT_NEAR(flow.at.meanDiameter[i]/(cubes/squares), 1, 1e-14);
    }
}

// Grains that lie in many cells: of equal ones every mean is theirs.
TEST(FluidAtGrains, meanDiameterOfEqualGrainsIsTheirs)
{
    LinearFlow flow;
    GrainMapping exact(flow.box.mesh(), mappingDict("exact", 0.7), 0.2);
    exact.update(flow.grains, ::nscd::PeriodicBox());
    sampleFluid(flow.box.fluid(), nullptr, exact, GrainsAtHome(), reads::meanDiameter, flow.at);
    for (const scalar mean : flow.at.meanDiameter) EXPECT_NEAR(mean/0.4, 1, 1e-14);
}

TEST(FluidAtGrains, onAFlatMeshVectorsLieInItsPlaneAndSpinsAcrossIt)
{
    LinearFlow flow(true);
    flow.sample(reads::spin | reads::divTau | reads::pressureGradient);
    for (std::size_t i = 0; i < flow.grains.size(); ++i)
    {
        EXPECT_EQ(flow.at.velocity[i].z(), 0);
        EXPECT_EQ(flow.at.divTau[i].z(), 0);
        EXPECT_EQ(flow.at.pressureGradient[i].z(), 0);
        EXPECT_EQ(flow.at.spin[i].x(), 0);
        EXPECT_EQ(flow.at.spin[i].y(), 0);
        EXPECT_NEAR(flow.at.spin[i].z(), 0.5*(gradient.xy() - gradient.yx()), 1e-12);
    }
}
