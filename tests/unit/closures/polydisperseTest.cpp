// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Laws for equal spheres given to spheres of several sizes.
#include "closures/polydisperse.hpp"
#include "dragStates.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using namespace dragStates;

const double mu = 1e-3, rho = 1000;

DragState stateOf(const closures::GrainSize& size, double slip, double alpha)
{
    return {size, slip, alpha, rho, mu};
}

/// A bed of three sizes: diameters, and numbers per volume that make up phi.
struct Mixture
{
    double phi = 0.55;
    std::vector<double> d = {0.5e-3, 1e-3, 2.3e-3};
    std::vector<double> volumeShare = {0.2, 0.5, 0.3};

    double number(std::size_t i) const { return phi*volumeShare[i]/(pi*d[i]*d[i]*d[i]/6); }

    double sauter() const
    {
        double cubes = 0, squares = 0;
        for (std::size_t i = 0; i < d.size(); ++i)
        {
            cubes += number(i)*d[i]*d[i]*d[i];
            squares += number(i)*d[i]*d[i];
        }
        return cubes/squares;
    }
};

} // namespace

TEST(Polydisperse, everyLawGivesTheSquareOfTheDiameterOverTheMean)
{
    for (const DragLawRow& row : closures::dragLaws())
    {
        for (double d : {0.4e-3, 1e-3, 3e-3})
        {
            const double mean = 1e-3, y = d/mean;
            const double gamma = row.law(stateOf(closures::polydisperseSize(d, mean), 0.02, 0.45));
            EXPECT_NEAR(gamma/(y*y*row.law(stateOf(sphereSize(mean), 0.02, 0.45))), 1, 1e-13) << row.name << " " << d;
        }
    }
}

TEST(Polydisperse, equalSpheresAreAsWithoutIt)
{
    const closures::GrainSize size = closures::polydisperseSize(1e-3, 1e-3), equal = sphereSize(1e-3);
    EXPECT_EQ(size.diameter, equal.diameter);
    EXPECT_NEAR(size.frontalArea/equal.frontalArea, 1, 1e-15);
    EXPECT_NEAR(size.volume/equal.volume, 1, 1e-15);
}

// Together they have the pressure gradient that equal spheres of Sauter's mean have.
TEST(Polydisperse, theBedHasThePressureGradientOfItsMean)
{
    const Mixture bed;
    const double alpha = 1 - bed.phi, mean = bed.sauter();
    for (const DragLawRow& row : closures::dragLaws())
    {
        double sum = 0;
        for (std::size_t i = 0; i < bed.d.size(); ++i)
        {
            sum += bed.number(i)*row.law(stateOf(closures::polydisperseSize(bed.d[i], mean), 0.01, alpha));
        }
        const double equal = bed.phi/(pi*mean*mean*mean/6)*row.law(stateOf(sphereSize(mean), 0.01, alpha));
        EXPECT_NEAR(sum/equal, 1, 1e-13) << row.name;
    }
}

// Drag and the pressure gradient's part V grad p make up 3 pi mu d U_s F (alpha y + phi y^2), the published force on one of them.
TEST(Polydisperse, dragAndPressureForceAreThePublishedForce)
{
    const Mixture bed;
    const double alpha = 1 - bed.phi, mean = bed.sauter(), slip = 0.01;
    const closures::DragLaw law = closures::findDragLaw("Beetstra").law;
    const double equal = law(stateOf(sphereSize(mean), slip, alpha))*slip;
    const double gradient = bed.phi/(pi*mean*mean*mean/6)*equal/alpha, F = equal/alpha/(3*pi*mu*mean*alpha*slip);
    for (double d : bed.d)
    {
        const double y = d/mean, whole = 3*pi*mu*d*alpha*slip*F*(alpha*y + bed.phi*y*y);
        const double drag = law(stateOf(closures::polydisperseSize(d, mean), slip, alpha))*slip;
        EXPECT_NEAR((drag + pi*d*d*d/6*gradient)/whole, 1, 1e-13);
    }
}
