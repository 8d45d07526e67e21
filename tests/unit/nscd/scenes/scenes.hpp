// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Small dry scenes for tests: gravity as the only force, one material for grains and one for walls.
#pragma once

#include "nscd/tools/sceneParts.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace scenes
{

using nscd::Vec3;

constexpr double gravity = 9.81;

/// Settings tight enough for analytic cases: residual 1e-10 g dt.
inline nscd::ContactSettings tight()
{
    nscd::ContactSettings settings;
    settings.tolerance = 1e-10;
    settings.displacementTolerance = 1e-10;
    settings.maxSweeps = 1000000;
    return settings;
}

/// What a scene is made of before it runs.
struct Scene
{
    nscd::Grains grains;
    nscd::Materials materials;
    nscd::Walls walls;
    nscd::PeriodicBox box;
    Vec3 g = Vec3(0, 0, -gravity);

    Scene(int dimensions, double friction, double restitution)
    {
        grains.shape.dimensions = dimensions;
        materials.add("grain");
        materials.add("wall");
        for (int a = 0; a < 2; ++a)
        {
            for (int b = 0; b < 2; ++b) materials.setPair(a, b, {friction, restitution});
        }
    }

    void addGrain(const Vec3& x, double radius, double density = 2500.0)
    {
        grains.add(x, radius, density, 0, static_cast<std::int64_t>(grains.size()));
    }

    void addPlane(const Vec3& point, const Vec3& normal)
    {
        walls.addPlane(walls.addPatch("wall" + std::to_string(walls.patches.size()), 1), point, normal);
    }

    /// A floor at z = 0, and four walls around a square of this width.
    void addOpenBox(double width)
    {
        addPlane(Vec3::Zero(), Vec3::UnitZ());
        for (int axis = 0; axis < 2; ++axis)
        {
            addPlane(Vec3::Zero(), Vec3::Unit(axis));
            addPlane(width*Vec3::Unit(axis), -Vec3::Unit(axis));
        }
    }

    /// Spheres at random places between the origin and `upper`, in the order of the radii, none nearer to another or a side than 1 % of its radius.
    void scatter(const std::vector<double>& radii, const Vec3& upper, std::mt19937& random)
    {
        std::uniform_real_distribution<double> unit(0, 1);
        while (grains.size() < radii.size())
        {
            const double r = radii[grains.size()], room = 1.01*r;
            Vec3 x;
            for (int axis = 0; axis < 3; ++axis) x[axis] = room + (upper[axis] - 2*room)*unit(random);
            bool isFree = true;
            for (std::size_t i = 0; i < grains.size() && isFree; ++i) isFree = (x - grains.position[i]).norm() > 1.01*(r + grains.radius[i]);
            if (isFree) addGrain(x, r);
        }
    }

    nscd::GrainDynamics build(const nscd::ContactSettings& settings = tight()) const
    {
        return nscd::GrainDynamics(grains, materials, walls, box, settings);
    }
};

/// Gravity as f_e.
inline nscd::ExternalForces weight(const nscd::Grains& grains, const Vec3& g, double deltaT) { return nscd::gravityForces(grains, g, deltaT); }

inline nscd::StepReport step(nscd::GrainDynamics& dynamics, const Vec3& g, double deltaT)
{
    dynamics.beginStep(deltaT);
    return dynamics.advance(weight(dynamics.grains(), g, deltaT));
}

} // namespace scenes
