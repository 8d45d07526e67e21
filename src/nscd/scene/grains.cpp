// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Adding grains, and sums over them.
#include "nscd/scene/grains.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

double GrainShape::volume(double radius) const
{
    const double pi = 3.14159265358979323846;
    return dimensions == 2 ? pi*radius*radius*thickness : 4.0/3.0*pi*radius*radius*radius;
}

void Grains::add(const Vec3& x, double r, double density, int materialIndex, std::int64_t identity)
{
    if (!x.allFinite()) throw invalidValue("position of grain " + std::to_string(identity), "not finite", "finite coordinates [m]");
    if (!(r > 0.0) || !std::isfinite(r)) throw invalidValue("radius", r, "a finite value > 0 m");
    if (!(density > 0.0) || !std::isfinite(density)) throw invalidValue("density", density, "a finite value > 0 kg/m3");

    position.push_back(x);
    velocity.push_back(Vec3::Zero());
    omega.push_back(Vec3::Zero());
    orientation.push_back(Quaternion::Identity());
    radius.push_back(r);
    mass.push_back(density*shape.volume(r));
    material.push_back(materialIndex);
    id.push_back(identity);
    isFixed.push_back(0);
    nOwned = size();
}

void Grains::append(const Grains& more)
{
    const auto addTo = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    forEachMember([&](const char*, auto array) { addTo(this->*array, more.*array); });
    nOwned = size();
}

void Grains::reserve(std::size_t number)
{
    forEachArray([number](auto& values) { values.reserve(number); });
}

void Grains::shrinkToFit()
{
    forEachArray([](auto& values) { values.shrink_to_fit(); });
}

double totalVolume(const Grains& grains)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < grains.nOwned; ++i) sum += grains.volume(i);
    return sum;
}

std::vector<int> bodyOfGrains(const Grains& grains) { return clumpOfGrains(grains); }

std::vector<Vec3> placesOfBodies(const Grains& grains)
{
    std::vector<Vec3> places = grains.position;
    const std::vector<int> clumpOf = clumpOfGrains(grains);
    for (std::size_t i = 0; i < clumpOf.size(); ++i)
    {
        if (clumpOf[i] >= 0) places[i] = grains.clumps.position[clumpOf[i]];
    }
    return places;
}

std::array<double, 2> massExtremes(const Grains& grains)
{
    std::array<double, 2> extremes = {0.0, 0.0};
    const auto take = [&](double mass) { extremes = {std::max(extremes[0], mass), std::max(extremes[1], 1.0/mass)}; };
    const std::vector<int> bodyOf = bodyOfGrains(grains);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (!grains.isFixed[i] && (bodyOf.empty() || bodyOf[i] < 0)) take(grains.mass[i]);
    }
    for (std::size_t c = 0; c < grains.clumps.size(); ++c) take(grains.clumps.shapeOf(c).mass);
    return extremes;
}

Vec3 massCenter(const Grains& grains)
{
    Vec3 moment = Vec3::Zero();
    double mass = 0.0;
    const std::vector<int> bodyOf = bodyOfGrains(grains);
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (!bodyOf.empty() && bodyOf[i] >= 0) continue;
        moment += grains.mass[i]*grains.position[i];
        mass += grains.mass[i];
    }
    for (std::size_t c = 0; c < grains.clumps.size(); ++c)
    {
        moment += grains.clumps.shapeOf(c).mass*grains.clumps.position[c];
        mass += grains.clumps.shapeOf(c).mass;
    }
    return mass > 0.0 ? Vec3(moment/mass) : Vec3::Zero();
}

double kineticEnergy(const Grains& grains)
{
    const double kappa = grains.shape.inertiaFactor();
    double sum = 0.0;
    const std::vector<int> bodyOf = bodyOfGrains(grains);
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        if (!bodyOf.empty() && bodyOf[i] >= 0) continue;
        const double spin2 = kappa*grains.radius[i]*grains.radius[i]*grains.omega[i].squaredNorm();
        sum += 0.5*grains.mass[i]*(grains.velocity[i].squaredNorm() + spin2);
    }
    for (std::size_t c = 0; c < grains.clumps.size(); ++c) sum += kineticEnergy(grains.clumps, c);
    return sum;
}

} // namespace nscd
