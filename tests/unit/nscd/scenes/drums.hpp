// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A rotating drum of facets with discs or spheres in it.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

namespace scenes
{

/// The mantle of a drum around the y axis, `facets` strips of two triangles each.
inline std::vector<nscd::Triangle> mantle(double radius, double length, int facets)
{
    std::vector<nscd::Triangle> triangles;
    const auto rim = [&](int k, double y) { return Vec3(radius*std::cos(2*M_PI*k/facets), y, radius*std::sin(2*M_PI*k/facets)); };
    for (int k = 0; k < facets; ++k)
    {
        const Vec3 a = rim(k, -0.5*length), b = rim(k + 1, -0.5*length), c = rim(k + 1, 0.5*length), d = rim(k, 0.5*length);
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    return triangles;
}

/// A drum of 50 mm that turns by omega [rad/s], its lower half filled with discs of `radius`.
inline Scene drum(double omega, double radius, int facets)
{
    constexpr double drumRadius = 0.05;
    Scene scene(2, 0.5, 0.0);
    scene.grains.shape.thickness = 0.01;
    scene.grains.shape.emptyAxis = 1;
    const int patch = scene.walls.addPatch("drum", 1);
    scene.walls.addTriangles(patch, mantle(drumRadius, 0.04, facets));
    scene.walls.setMotion(patch, nscd::rotation(Vec3::Zero(), Vec3::UnitY(), omega));
    const double spacing = 2.05*radius;
    for (int k = -40; k < 0; ++k)
    {
        for (int i = -40; i <= 40; ++i)
        {
            const Vec3 x((i + 0.5*(k & 1))*spacing, 0, (k + 0.5)*spacing);
            if (x.norm() < drumRadius - 1.05*radius) scene.addGrain(x, radius*(0.9 + 0.1*((i + 7*k) & 1)));
        }
    }
    return scene;
}

} // namespace scenes
