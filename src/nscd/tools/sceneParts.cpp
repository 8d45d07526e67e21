// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Making the parts of scenes.
#include "nscd/tools/sceneParts.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <random>

namespace nscd
{

namespace
{

void check(const GrainLattice& lattice)
{
    for (const int count : lattice.count)
    {
        if (count < 1) throw invalidValue("lattice count", count, ">= 1 along each axis");
    }
    if (!(lattice.spread >= 0.0 && lattice.spread < 1.0)) throw invalidValue("lattice spread", lattice.spread, "0 to 1, less than 1");
    if (!(lattice.jitter >= 0.0 && lattice.jitter <= 1.0)) throw invalidValue("lattice jitter", lattice.jitter, "0 to 1");
}

} // namespace

RandomNumbers randomNumbers(std::uint64_t seed)
{
    // The standard library's own distributions differ between implementations.
    return [engine = std::mt19937_64(seed)]() mutable { return static_cast<double>(engine() >> 11)*0x1.0p-53; };
}

void forEachGrain(const GrainLattice& lattice, const RandomNumbers& random, const std::function<void(const Vec3&, double)>& add)
{
    check(lattice);
    const std::array<int, 3>& count = lattice.count;
    const double largest = lattice.diameter*(1.0 + lattice.spread);
    const Vec3 spacing = (lattice.upper - lattice.lower).cwiseQuotient(Vec3(count[0], count[1], count[2]));
    const Vec3 shake = lattice.jitter*(spacing.array() - largest).max(0.0);
    for (int k = 0; k < count[2]; ++k)
    {
        for (int j = 0; j < count[1]; ++j)
        {
            for (int i = 0; i < count[0]; ++i)
            {
                Vec3 x = lattice.lower + Vec3(i + 0.5, j + 0.5, k + 0.5).cwiseProduct(spacing);
                for (int axis = 0; axis < 3; ++axis) x[axis] += shake[axis]*(random() - 0.5);
                const double offset = 2.0*random() - 1.0;
                add(x, lattice.diameter*(1.0 + lattice.spread*offset));
            }
        }
    }
}

void addLattice(Grains& grains, const GrainLattice& lattice, double density, int material)
{
    check(lattice);
    grains.reserve(grains.size() + static_cast<std::size_t>(lattice.count[0])*lattice.count[1]*lattice.count[2]);
    forEachGrain(lattice, randomNumbers(lattice.seed), [&](const Vec3& x, double diameter)
    {
        grains.add(x, 0.5*diameter, density, material, static_cast<std::int64_t>(grains.size()));
    });
}

void addBox(Walls& walls, int patch, const Vec3& lower, const Vec3& upper)
{
    if (!((upper - lower).minCoeff() > 0.0))
    {
        throw invalidValue("upper corner of a box", upper.transpose(), "above the lower corner along each axis");
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        walls.addPlane(patch, lower, Vec3::Unit(axis));
        walls.addPlane(patch, upper, -Vec3::Unit(axis));
    }
}

ExternalForces gravityForces(const Grains& grains, const Vec3& gravity, double deltaT)
{
    ExternalForces forces;
    forces.force.reserve(grains.size());
    for (const double mass : grains.mass) forces.force.push_back(mass*gravity);
    forces.speedScale = gravity.norm()*deltaT;
    return forces;
}

} // namespace nscd
