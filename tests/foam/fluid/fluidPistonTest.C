// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Grains that move as prescribed through a closed tube displace the fluid, without pressure spikes (B06).

#include "fluidCase.H"
#include "linear.H"

#include "accuracy/expectNear.hpp"

#include <gtest/gtest.h>

#include <random>

namespace
{

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

const scalar speed = 0.05, length = 0.4;
const label nCells = 80;

/// Solid fractions of pieces that lie beside each other; ends has one more entry than fractions.
struct Slab
{
    std::vector<scalar> ends, fractions;

    /// Solid length left of x.
    scalar solidUpTo(const scalar x) const
    {
        scalar sum = 0;
        for (std::size_t i = 0; i < fractions.size(); ++i)
        {
            sum += fractions[i]*max(scalar(0), min(x, ends[i + 1]) - ends[i]);
        }
        return sum;
    }
};

Slab uniformSlab()
{
    return {{0.1, 0.2}, {0.3}};
}

// Edges where they fall, pieces from narrower than a cell to three cells wide.
Slab randomSlab()
{
    std::minstd_rand engine(3);
    std::uniform_real_distribution<double> width(0.7, 3), fraction(0, 0.6);
    Slab slab{{0.1}, {}};
    while (slab.ends.back() < 0.2)
    {
        slab.fractions.push_back(fraction(engine));
        slab.ends.push_back(slab.ends.back() + width(engine)*length/nCells);
    }
    return slab;
}

struct PistonResult { scalar netFlux = 0, peakPressure = 0; };

class Piston
{
public:

    Piston(const Slab& slab, const scalar drag, const scalar deltaT)
    :
        slab_(slab), drag_(drag), tube_(settings(deltaT))
    {
        writeSources();
    }

    // Two seconds: the slab crosses 20 cells. The first 0.2 s, in which the fluid is set in motion, are left out.
    PistonResult run()
    {
        PistonResult result;
        while (tube_.time().value() < 2)
        {
            tube_.step([this] { writeSources(); });
            result.netFlux = max(result.netFlux, netFlux());
            if (tube_.time().value() < 0.2) continue;
            const volScalarField& p = tube_.fluid().pRgh();
            result.peakPressure = max(result.peakPressure, max(p).value() - min(p).value());
        }
        return result;
    }

private:

    static FluidCaseSettings settings(const scalar deltaT)
    {
        FluidCaseSettings settings = tubeCase(nCells, length);
        settings.box.deltaT = deltaT;
        settings.convection = "Gauss linearUpwind grad(U)";
        return settings;
    }

    scalar solidFraction(const point& x) const
    {
        const scalar start = x.x() - speed*tube_.time().value(), half = 0.5*length/nCells;
        return (slab_.solidUpTo(start + half) - slab_.solidUpTo(start - half))/(2*half);
    }

    // Prescribed motion: the grains answer with v whatever the fluid does.
    void writeSources()
    {
        GrainSources& sources = tube_.sources();
        const vector v(speed, 0, 0);
        sources.hasResponse = true;
        setCells(sources.fluidFraction, [&](const point& x) { return 1 - solidFraction(x); });
        setCells(sources.carried, [&](const point& x) { return solidFraction(x)*v; });
        setCells(sources.drag, [&](const point& x) { return drag_*solidFraction(x); });
        setCells(sources.acceleration, [&](const point& x) { return drag_*solidFraction(x)*v; });
    }

    /// Largest sum of the fluxes of fluid and grains through a face, in units of the grains' speed.
    scalar netFlux()
    {
        const auto& mesh = tube_.mesh();
        const surfaceScalarField grains(linearInterpolate(tube_.sources().carried) & mesh.Sf());
        scalar largest = 0;
        forAll(tube_.fluid().phi(), i)
        {
            largest = max(largest, mag(tube_.fluid().phi()[i] + grains[i])/mesh.magSf()[i]/speed);
        }
        return largest;
    }

    const Slab slab_;
    const scalar drag_;
    mutable FluidCase tube_;
};

void expectNoSpikes(const char* name, const Slab& slab, const scalar drag)
{
    const PistonResult coarse = Piston(slab, drag, 0.02).run(), fine = Piston(slab, drag, 0.002).run();
    std::cout << name << ", drag " << drag << ": net flux/v " << coarse.netFlux << ' ' << fine.netFlux
        << ", largest pressure difference " << coarse.peakPressure << ' ' << fine.peakPressure << " Pa\n";
    const std::string scene = std::string("B06 ") + name + ", drag " + figures::text(drag);
    figures::expectBelow(scene, "flux of both through a face over v", max(coarse.netFlux, fine.netFlux), 1e-8);
    figures::expectBelow(scene, "peak pressure at dt/10 over that at dt", fine.peakPressure/coarse.peakPressure, 1.5);
    EXPECT_GT(fine.peakPressure, 0) << name;
}

TEST(fluidPiston, aMovingSlabDisplacesItsVolumeQuietly)
{
    expectNoSpikes("slab", uniformSlab(), 0);
    expectNoSpikes("slab", uniformSlab(), 100);
    expectNoSpikes("random slab", randomSlab(), 0);
    expectNoSpikes("random slab", randomSlab(), 100);
}

} // End anonymous namespace
