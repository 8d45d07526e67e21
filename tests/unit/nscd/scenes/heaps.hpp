// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Heaps of many grains for tests: a shaken lattice that falls into a box and comes to rest there.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <random>

namespace scenes
{

/// Grains on a jittered lattice in an open box; radii between smallest*radius and radius.
inline Scene heap(int dimensions, int perSide, int layers, double radius, double smallest, double friction)
{
    Scene scene(dimensions, friction, 0.0);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double spacing = 2.3*radius, shake = 0.1*radius;
    const int depth = dimensions == 3 ? perSide : 1;
    for (int k = 0; k < layers; ++k)
    for (int j = 0; j < depth; ++j)
    for (int i = 0; i < perSide; ++i)
    {
        Vec3 x = spacing*Vec3(i + 0.5, j + 0.5, k + 0.5) + shake*Vec3(unit(random), unit(random), unit(random));
        if (dimensions == 2) x[1] = 0.0;
        scene.addGrain(x, radius*(smallest + (1 - smallest)*0.5*(1 + unit(random))));
    }
    const double width = spacing*perSide;
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    scene.addPlane(Vec3::Zero(), Vec3::UnitX());
    scene.addPlane(Vec3(width, 0, 0), -Vec3::UnitX());
    if (dimensions == 3)
    {
        scene.addPlane(Vec3::Zero(), Vec3::UnitY());
        scene.addPlane(Vec3(0, width, 0), -Vec3::UnitY());
    }
    return scene;
}

/// A lattice with periodic sides, so many spheres a side and layer, of 2.5 mm.
inline Scene looseBed(int perSide, int layers, double restitution = 0.0)
{
    constexpr double fine = 1.25e-3, spacing = 2.2*fine, shake = 0.09*fine;   // it falls by a tenth of its height
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    Scene scene(3, 0.3, restitution);
    scene.box.length = Vec3(perSide*spacing, perSide*spacing, 0);
    scene.addPlane(Vec3::Zero(), Vec3::UnitZ());
    for (int k = 0; k < layers; ++k)
    for (int j = 0; j < perSide; ++j)
    for (int i = 0; i < perSide; ++i)
    {
        scene.addGrain(spacing*Vec3(i + 0.5, j + 0.5, k + 0.5) + shake*Vec3(unit(random), unit(random), unit(random)), fine);
    }
    return scene;
}

/// One step in a viscous medium of so much drag [1/s]: nothing else stops a grain that rolls, or spins on its contact.
inline nscd::StepReport stepDamped(nscd::GrainDynamics& dynamics, const Vec3& g, double deltaT, double rate = 30.0)
{
    nscd::ExternalForces forces = weight(dynamics.grains(), g, deltaT);
    const double kappa = dynamics.grains().shape.inertiaFactor();
    for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
    {
        const double mass = dynamics.grains().mass[i], r = dynamics.grains().radius[i];
        forces.implicitDrag.push_back(rate*mass);
        forces.torque.push_back(-rate*kappa*mass*r*r*dynamics.grains().omega[i]);
    }
    dynamics.beginStep(deltaT);
    return dynamics.advance(forces);
}

} // namespace scenes
