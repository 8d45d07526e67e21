// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Placing clumps, and what they weigh.
#include "nscd/scene/clumps.hpp"

#include "nscd/base/invalidValue.hpp"
#include "nscd/base/periodicBox.hpp"
#include "nscd/scene/grains.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Members may be off by this share of the clump's extent: coordinates far from the origin are rounded.
constexpr double placementTolerance = 1e-6;

double volumeOf(const std::vector<Ball>& members, const GrainShape& shape)
{
    double sum = 0.0;
    for (const Ball& member : members) sum += shape.volume(member.radius);
    return sum;
}

double extent(const ClumpShape& shape)
{
    double largest = 0.0;
    for (const Ball& member : shape.members) largest = std::max(largest, member.center.norm() + member.radius);
    return largest;
}

std::string nameOf(std::size_t clump) { return "clump " + std::to_string(clump); }

void checkMotion(const Clumps& clumps, std::size_t c)
{
    const bool isFinite = clumps.position[c].allFinite() && clumps.velocity[c].allFinite() && clumps.angularMomentum[c].allFinite();
    if (!isFinite) throw invalidValue("position, velocity or spin of " + nameOf(c), "not finite", "finite components");
    const double size = clumps.orientation[c].norm();
    if (!(std::abs(size - 1.0) < 1e-9)) throw invalidValue("length of the orientation of " + nameOf(c), size, "1 (a unit quaternion)");
}

void checkMembers(const Grains& grains, std::size_t c, const PeriodicBox& box)
{
    const Clumps& clumps = grains.clumps;
    const ClumpShape& shape = clumps.shapeOf(c);
    for (std::size_t k = 0; k < shape.members.size(); ++k)
    {
        const std::size_t grain = clumps.firstMember[c] + k;
        const Vec3 offset = clumps.orientation[c]*shape.members[k].center;
        const Vec3 miss = box.nearestImage(grains.position[grain] - clumps.position[c] - offset);
        const bool isInPlace = miss.norm() <= placementTolerance*extent(shape) && grains.radius[grain] == shape.members[k].radius;
        const std::string member = "member " + std::to_string(grains.id[grain]) + " of " + nameOf(c);
        if (!isInPlace) throw invalidValue("place or radius of " + member, "not the shape's", "what placeMembers() makes of it");
        if (grains.isFixed[grain]) throw invalidValue(member, "held", "members that move (single grains may be held)");
    }
}

} // namespace

std::size_t addClump(Grains& grains, const ClumpPlacement& placement, const PeriodicBox& box)
{
    Clumps& clumps = grains.clumps;
    if (placement.shape < 0 || placement.shape >= static_cast<int>(clumps.shapes.size()))
    {
        throw invalidValue("shape of a clump", placement.shape, "an index below " + std::to_string(clumps.shapes.size()));
    }
    const double size = placement.orientation.norm();
    const bool isFinite = placement.position.allFinite() && placement.velocity.allFinite() && placement.omega.allFinite();
    if (!isFinite || !(size > 0.0) || !std::isfinite(size))
    {
        throw invalidValue("position, orientation, velocity or spin of " + nameOf(clumps.size()), "not finite", "finite numbers");
    }
    const ClumpShape& shape = clumps.shapes[placement.shape];
    clumps.shape.push_back(placement.shape);
    clumps.firstMember.push_back(static_cast<int>(grains.size()));
    clumps.position.push_back(box.wrap(placement.position));
    clumps.orientation.push_back(placement.orientation.normalized());
    clumps.velocity.push_back(placement.velocity);
    clumps.angularMomentum.push_back(Vec3::Zero());
    const std::size_t c = clumps.size() - 1;
    clumps.angularMomentum[c] = worldInertia(clumps, c)*placement.omega;

    const double density = shape.mass/volumeOf(shape.members, grains.shape);
    for (std::size_t k = 0; k < shape.members.size(); ++k)
    {
        grains.add(placement.position, shape.members[k].radius, density, placement.material, placement.firstId + static_cast<std::int64_t>(k));
    }
    placeMembers(grains, c, box);
    return c;
}

void placeMembers(Grains& grains, std::size_t clump, const PeriodicBox& box)
{
    const Clumps& clumps = grains.clumps;
    const ClumpShape& shape = clumps.shapeOf(clump);
    const Vec3 omega = angularVelocity(clumps, clump);
    for (std::size_t k = 0; k < shape.members.size(); ++k)
    {
        const std::size_t grain = clumps.firstMember[clump] + k;
        const Vec3 arm = clumps.orientation[clump]*shape.members[k].center;
        grains.position[grain] = box.wrap(clumps.position[clump] + arm);
        grains.velocity[grain] = clumps.velocity[clump] + omega.cross(arm);
        grains.omega[grain] = omega;
        grains.orientation[grain] = clumps.orientation[clump];
    }
}

Eigen::Matrix3d worldInertia(const Clumps& clumps, std::size_t clump)
{
    const Eigen::Matrix3d r = clumps.orientation[clump].toRotationMatrix();
    return r*clumps.shapeOf(clump).inertia*r.transpose();
}

Vec3 angularVelocity(const Clumps& clumps, std::size_t clump)
{
    const Quaternion& q = clumps.orientation[clump];
    return q*Vec3(clumps.shapeOf(clump).inertia.inverse()*(q.conjugate()*clumps.angularMomentum[clump]));
}

double kineticEnergy(const Clumps& clumps, std::size_t clump)
{
    const double linear = clumps.shapeOf(clump).mass*clumps.velocity[clump].squaredNorm();
    return 0.5*(linear + clumps.angularMomentum[clump].dot(angularVelocity(clumps, clump)));
}

std::vector<int> clumpOfGrains(const Grains& grains)
{
    const Clumps& clumps = grains.clumps;
    std::vector<int> clumpOf(clumps.empty() ? 0 : grains.size(), -1);
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        const std::size_t first = clumps.firstMember[c], number = clumps.shapeOf(c).members.size();
        for (std::size_t grain = first; grain < first + number; ++grain) clumpOf[grain] = static_cast<int>(c);
    }
    return clumpOf;
}

void checkClumps(const Grains& grains, const PeriodicBox& box)
{
    const Clumps& clumps = grains.clumps;
    std::vector<char> isTaken(grains.size(), 0);
    for (std::size_t c = 0; c < clumps.size(); ++c)
    {
        const bool hasShape = clumps.shape[c] >= 0 && clumps.shape[c] < static_cast<int>(clumps.shapes.size());
        const std::size_t number = hasShape ? clumps.shapeOf(c).members.size() : 0;
        const int first = clumps.firstMember[c];
        if (!hasShape || first < 0 || first + number > grains.size())
        {
            throw invalidValue("first member of " + nameOf(c), first, "the index of a grain with all members of a shape behind it");
        }
        for (std::size_t grain = first; grain < first + number; ++grain)
        {
            if (isTaken[grain]) throw invalidValue("grain " + std::to_string(grains.id[grain]), "a member of two clumps", "one clump");
            isTaken[grain] = 1;
        }
        checkMotion(clumps, c);
        checkMembers(grains, c, box);
        for (int axis = 0; axis < 3; ++axis)
        {
            const double size = 2.0*extent(clumps.shapeOf(c));
            if (!box.isPeriodic(axis) || box.length[axis] > 2.0*size) continue;
            throw invalidValue("period", box.length[axis], "more than twice the extent of " + nameOf(c) + ", " + std::to_string(size) + " m");
        }
    }
}

} // namespace nscd
