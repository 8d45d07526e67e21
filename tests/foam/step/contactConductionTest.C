// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Heat through contacts: the law's value, chains between two temperatures, networks beside a direct solution, sums over all grains.
#include "coupling/step/contactConduction.H"

#include "coupling/step/heatBalance.H"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace Foam;
using namespace Foam::nscdCoupling;
using ::nscd::Vec3;

namespace
{

GrainHeatProperties glass()
{
    GrainHeatProperties material;
    material.heatCapacity = 840;
    material.conductivity = 1.1;
    material.youngModulus = 7e10;
    material.poissonRatio = 0.2;
    return material;
}

/// Material 0 is free to warm, 1 keeps its temperature.
HeatSettings settings()
{
    HeatSettings both;
    both.materials = {glass(), glass()};
    both.materials[1].isHeld = true;
    return both;
}

/// A chain of grains of 2 mm, those at its ends of material `ends`, and contacts of forces that grow along it.
struct Chain
{
    ::nscd::Grains grains;
    std::vector<::nscd::LoadedContact> contacts;
    std::vector<scalar> temperature;

    Chain(std::size_t count, int ends)
    {
        for (std::size_t i = 0; i < count; ++i)
        {
            const bool isEnd = i == 0 || i + 1 == count;
            grains.add(Vec3(0, 0, 2e-3*double(i)), 1e-3, 2500, isEnd ? ends : 0, std::int64_t(i));
            temperature.push_back(i == 0 ? 400 : 300);
            if (i > 0) contacts.push_back(contact(int(i), int(i) - 1, 1e-3*double(i)));
        }
    }

    static ::nscd::LoadedContact contact(int a, int b, double impulse)
    {
        ::nscd::LoadedContact loaded;
        loaded.a = a;
        loaded.b = b;
        loaded.normal = Vec3::UnitZ();
        loaded.impulse = impulse*Vec3::UnitZ();
        loaded.radiusB = 1e-3;
        return loaded;
    }

    std::vector<ContactConductance> conductances() const { return contactConductances(settings(), grains, {}, contacts, 1e-3); }

    /// Over a step of a run on one rank.
    ConductedHeat conducted(scalar deltaT) const
    {
        ::nscd::Exchange alone;
        return ContactConduction(settings(), grains, conductances(), {}, alone).over(temperature, deltaT);
    }
};

/// Backward Euler's temperatures, by factors of the matrix.
Eigen::VectorXd directSolution(const Chain& chain, scalar deltaT)
{
    const auto n = Eigen::Index(chain.grains.nOwned);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(n);
    for (Eigen::Index i = 0; i < n; ++i)
    {
        const double storage = heatCapacityOf(settings(), chain.grains, std::size_t(i))/deltaT;
        entries.emplace_back(i, i, storage);
        right[i] = storage*chain.temperature[std::size_t(i)];
    }
    for (const ContactConductance& contact : chain.conductances())
    {
        for (const std::size_t i : {contact.a, contact.b}) entries.emplace_back(i, i, contact.conductance);
        entries.emplace_back(contact.a, contact.b, -contact.conductance);
        entries.emplace_back(contact.b, contact.a, -contact.conductance);
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
}

} // namespace

TEST(ContactConduction, isBatchelorAndOBriensOfHertzRadius)
{
    GrainHeatProperties other = glass();
    other.conductivity = 0.22;
    other.youngModulus = 3.5e10;
    // R = 1/(1/1 + 1/3) mm = 0.75 mm, 1/E = 0.96/7e10 + 0.96/3.5e10, a = (0.75 F R/E)^(1/3), k = 2*1.1*0.22/1.32.
    const double radius = std::cbrt(0.75*2*0.75e-3*0.96*(1/7e10 + 1/3.5e10));
    EXPECT_NEAR(contactConductance(glass(), other, 1e-3, 3e-3, 2), 2*(2*1.1*0.22/1.32)*radius, 1e-12*radius);
}

TEST(ContactConduction, isOfPressedPairsAlone)
{
    Chain chain(3, 0);
    chain.contacts[0].impulse *= -1;
    chain.contacts.push_back(Chain::contact(2, -1, 1));
    EXPECT_EQ(chain.conductances().size(), 1u);
}

/// Between two held temperatures the flux is their difference over the sum of the contacts' resistances, however long the step.
TEST(ContactConduction, ofAChainIsThatOfResistancesInSeries)
{
    Chain chain(12, 1);
    const std::vector<ContactConductance> contacts = chain.conductances();
    ASSERT_EQ(contacts.size(), 11u);
    double resistance = 0;
    for (const ContactConductance& contact : contacts) resistance += 1/contact.conductance;
    // 3e4 times what a contact takes to even out two grains.
    const double deltaT = 1e6;
    for (int step = 0; step < 6; ++step)
    {
        const std::vector<scalar> heat = chain.conducted(deltaT).heat;
        for (std::size_t i = 1; i < 11; ++i) chain.temperature[i] += heat[i]/heatCapacityOf(settings(), chain.grains, i);
        if (step < 5) continue;
        EXPECT_NEAR(heat[11]/deltaT, 100/resistance, 1e-9*100/resistance);
        EXPECT_NEAR(heat[0]/deltaT, -100/resistance, 1e-9*100/resistance);
    }
    for (std::size_t i = 0; i < 11; ++i)
    {
        EXPECT_NEAR(chain.temperature[i] - chain.temperature[i + 1], 100/resistance/contacts[i].conductance, 1e-7) << i;
    }
}

TEST(ContactConduction, keepsTheHeatOfAllGrainsAndTheirBounds)
{
    const Chain chain(12, 0);
    for (const double deltaT : {1e-6, 1.0, 1e6})
    {
        const std::vector<scalar> heat = chain.conducted(deltaT).heat;
        EXPECT_GT(heat[1], 0);
        EXPECT_NEAR(std::accumulate(heat.begin(), heat.end(), 0.0), 0, 1e-14*-heat[0]) << deltaT;
        for (std::size_t i = 0; i < heat.size(); ++i)
        {
            const double T = chain.temperature[i] + heat[i]/heatCapacityOf(settings(), chain.grains, i);
            EXPECT_GE(T, 300 - 1e-9);
            EXPECT_LE(T, 400 + 1e-9);
        }
    }
}

/// Grains of random temperatures, each in contact with some twenty others: in steps of 1e-3 to 1e6 times what a contact takes to even out two.
TEST(ContactConduction, ofANetworkIsThatOfADirectSolution)
{
    Chain chain(200, 0);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (scalar& T : chain.temperature) T = 300 + 100*uniform(random);
    for (int k = 0; k < 2000; ++k)
    {
        const int a = int(200*uniform(random)), b = int(200*uniform(random));
        if (a != b) chain.contacts.push_back(Chain::contact(a, b, uniform(random)));
    }
    for (const double deltaT : {1e-2, 1.0, 100.0, 1e7})
    {
        const ConductedHeat conducted = chain.conducted(deltaT);
        EXPECT_EQ(conducted.off, 0);
        const Eigen::VectorXd end = directSolution(chain, deltaT);
        for (std::size_t i = 0; i < 200; ++i)
        {
            const double T = chain.temperature[i] + conducted.heat[i]/heatCapacityOf(settings(), chain.grains, i);
            EXPECT_NEAR(T, end[Eigen::Index(i)], 1e-11*(1 + deltaT)) << i << ' ' << deltaT;
        }
    }
}

/// Heat would have to go farther in one step than the solver looks.
TEST(ContactConduction, tellsWhatItCouldNotSolve)
{
    Chain chain(11000, 0);
    for (::nscd::LoadedContact& contact : chain.contacts) contact.impulse = Vec3::UnitZ();
    const double deltaT = 1e9;
    const ConductedHeat conducted = chain.conducted(deltaT);
    const Eigen::VectorXd end = directSolution(chain, deltaT);
    double off = 0;
    for (std::size_t i = 0; i < chain.temperature.size(); ++i)
    {
        const double T = chain.temperature[i] + conducted.heat[i]/heatCapacityOf(settings(), chain.grains, i);
        off = std::max(off, std::abs(T - end[Eigen::Index(i)]));
    }
    EXPECT_GT(off, 0.1*conducted.off);
    EXPECT_LT(off, conducted.off);
    EXPECT_GT(conducted.off, 0);
    EXPECT_NEAR(std::accumulate(conducted.heat.begin(), conducted.heat.end(), 0.0), 0, 1e-12*-conducted.heat[0]);
}
