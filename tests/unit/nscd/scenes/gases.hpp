// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains that fly about in a closed box, and whether any got into others, listed or not.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <random>

namespace scenes
{

/// 1200 grains in a closed box of `width`, with up to 0.8 radii a step along each axis, so that lists are long. One in four is 20 times as heavy and throws
/// others about, by more than lists allow for.
inline Scene heavyAndLightGas(double width, double radius, double deltaT)
{
    Scene scene(3, 0.3, 0.9);
    scene.addOpenBox(width);
    scene.addPlane(width*Vec3::UnitZ(), -Vec3::UnitZ());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    scene.scatter(std::vector<double>(1200, radius), Vec3::Constant(width), random);
    for (Vec3& v : scene.grains.velocity) v = 0.8*radius/deltaT*Vec3(unit(random), unit(random), unit(random));
    for (std::size_t i = 0; i < scene.grains.size(); i += 4) scene.grains.mass[i] *= 20.0;
    return scene;
}

/// Between any two centers, by brute force.
inline double smallestDistance(const std::vector<Vec3>& x)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j) smallest = std::min(smallest, (x[i] - x[j]).squaredNorm());
    }
    return std::sqrt(smallest);
}

} // namespace scenes
