// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The grains: rigid spheres (3D) or discs (2D), one plain array per property.
#pragma once

#include "nscd/base/vec3.hpp"
#include "nscd/scene/clumps.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace nscd
{

/// Shape of all grains of a scene, which fixes mass and inertia J = kappa m R^2.
struct GrainShape
{
    /// 3: spheres, kappa = 2/5. 2: discs (cylinders of length `thickness`), kappa = 1/2.
    int dimensions = 3;
    /// Length of a disc along the empty direction [m]; not used for spheres.
    double thickness = 1.0;
    /// 0, 1 or 2: the axis that nothing moves along, for discs, or spheres with their centers in a plane; walls then get no velocity and no
    /// normal along it, to the last bit (else round-off of triangulated walls grows), and walls that face along it are not felt.
    /// -1: space, or a plane whose walls are exact without that.
    int emptyAxis = -1;

    double inertiaFactor() const { return dimensions == 2 ? 0.5 : 0.4; }
    double volume(double radius) const;
};

/// Grains in the order their owner gave them; that order never changes during a run.
/// Units: SI. Owned grains come first; ghosts of other ranks follow from index nOwned on.
struct Grains
{
    GrainShape shape;
    std::size_t nOwned = 0;

    std::vector<Vec3> position;
    std::vector<Vec3> velocity;
    std::vector<Vec3> omega;              ///< angular velocity, world frame [rad/s]
    std::vector<Quaternion> orientation;
    std::vector<double> radius;
    std::vector<double> mass;
    std::vector<int> material;            ///< index into Materials
    std::vector<std::int64_t> id;         ///< unique over all ranks and the whole run
    std::vector<std::uint8_t> isFixed;    ///< 1: held or driven, infinite mass: moves with its velocity and omega as given

    /// Rigid assemblies of some of the grains; whoever reorders or removes grains keeps their indices right.
    Clumps clumps;

    std::size_t size() const { return position.size(); }
    double volume(std::size_t i) const { return shape.volume(radius[i]); }

    /// Appends one owned grain at rest.
    /// Errors: std::invalid_argument for a radius or density that is not finite and positive, or a position that is not finite
    void add(const Vec3& position, double radius, double density, int material, std::int64_t id);

    /// Appends the grains of another, all of them owned then; clumps stay as they are.
    void append(const Grains& more);

    /// Makes room for so many grains, or gives back what is not used.
    void reserve(std::size_t number);
    void shrinkToFit();

    /// Calls visit(name, array) for each array with an entry per grain, as a pointer to the member: the one list of them, which
    /// copying, removing, sending and storing of grains follow. The names stand in checkpoint files, in this order.
    template<class Visit>
    static constexpr void forEachMember(const Visit& visit);

    /// Calls change(values) for each of these arrays.
    template<class Change>
    void forEachArray(const Change& change)
    {
        forEachMember([&](const char*, auto array) { change(this->*array); });
    }
};

template<class Visit>
constexpr void Grains::forEachMember(const Visit& visit)
{
    visit("position", &Grains::position);
    visit("velocity", &Grains::velocity);
    visit("omega", &Grains::omega);
    visit("orientation", &Grains::orientation);
    visit("radius", &Grains::radius);
    visit("mass", &Grains::mass);
    visit("material", &Grains::material);
    visit("id", &Grains::id);
    visit("isFixed", &Grains::isFixed);
}

/// Sum of all owned grains' volume [m3].
double totalVolume(const Grains& grains);

/// The rigid body that each grain is a part of, -1: it is one itself; empty where all are.
std::vector<int> bodyOfGrains(const Grains& grains);

/// Where the body of each grain is: its own center, or the mass center of its clump, by which clumps are shared out among ranks [m].
std::vector<Vec3> placesOfBodies(const Grains& grains);

/// Of all bodies that move, the largest mass [kg] and the largest inverse of one [1/kg]; zeros when none does.
std::array<double, 2> massExtremes(const Grains& grains);

/// Center of mass of the owned grains [m]; zero when there are none.
Vec3 massCenter(const Grains& grains);

/// Sum of m v^2/2 + kappa m R^2 omega^2/2 over the owned grains, of clumps as wholes [J].
double kineticEnergy(const Grains& grains);

} // namespace nscd
