// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Mass, mass center and inertia of clumps.
#include "nscd/scene/clumpShape.hpp"

#include "nscd/base/invalidValue.hpp"
#include "nscd/scene/grains.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace nscd
{

namespace
{

constexpr double roundOff = 1e-9;

void checkMembers(const std::vector<Ball>& members)
{
    if (members.empty()) throw invalidValue("number of members of a clump", 0, "at least 1");
    for (const Ball& member : members)
    {
        if (!member.center.allFinite()) throw invalidValue("center of a clump's member", "not finite", "finite coordinates [m]");
        if (!(member.radius > 0.0) || !std::isfinite(member.radius)) throw invalidValue("radius of a clump's member", member.radius, "a finite value > 0 m");
    }
}

bool haveOverlap(const std::vector<Ball>& members)
{
    for (std::size_t i = 0; i < members.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            const double radii = members[i].radius + members[j].radius;
            if ((members[i].center - members[j].center).norm() < radii*(1.0 - 1e-12)) return true;
        }
    }
    return false;
}

/// The axis along which all members lie at the same place; that of the scene where it has one.
int flatAxis(const std::vector<Ball>& discs, const GrainShape& shape)
{
    for (int axis = 2; axis >= 0; --axis)
    {
        if (shape.emptyAxis >= 0 && axis != shape.emptyAxis) continue;
        bool isFlat = true;
        for (const Ball& disc : discs) isFlat = isFlat && std::abs(disc.center[axis] - discs[0].center[axis]) <= roundOff*disc.radius;
        if (isFlat) return axis;
    }
    throw invalidValue("plane of a clump's members", "none", "one normal to a coordinate axis, to the empty one where the scene has one");
}

/// Members that do not overlap: kappa m R^2 about their own centers, with the axes of Steiner's theorem.
VolumeMoments separateMoments(const std::vector<Ball>& members, const GrainShape& shape)
{
    VolumeMoments sum;
    for (const Ball& member : members)
    {
        const double volume = shape.volume(member.radius);
        sum.volume += volume;
        sum.first += volume*member.center;
        sum.second += volume*(member.center*member.center.transpose() + 0.2*member.radius*member.radius*Eigen::Matrix3d::Identity());
    }
    return sum;
}

/// Of discs: the number J of the turn in their plane as a multiple of the identity, which has no gyroscopic force.
ClumpShape discShape(std::vector<Ball> members, double density, const GrainShape& shape)
{
    const int axis = flatAxis(members, shape);
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    const Vec3 origin = members[0].center;
    std::vector<Ball> inPlane;
    for (const Ball& disc : members)
    {
        const Vec3 c = disc.center - origin;
        inPlane.push_back({Vec3(c[x], c[y], 0.0), disc.radius});
    }
    const VolumeMoments moments = unionOfDiscs(inPlane);
    const Vec3 center = moments.first/moments.volume;
    const double polar = moments.second.trace() - moments.volume*center.squaredNorm();
    ClumpShape clump;
    clump.massCenter = origin;
    clump.massCenter[x] += center[0];
    clump.massCenter[y] += center[1];
    clump.mass = density*shape.thickness*moments.volume;
    clump.inertia = density*shape.thickness*polar*Eigen::Matrix3d::Identity();
    clump.members = std::move(members);
    return clump;
}

ClumpShape ballShape(std::vector<Ball> members, double density, const GrainShape& shape)
{
    const Vec3 origin = members[0].center;
    for (Ball& member : members) member.center -= origin;
    const VolumeMoments moments = haveOverlap(members) ? unionOfBalls(members) : separateMoments(members, shape);
    const Vec3 center = moments.first/moments.volume;
    const Eigen::Matrix3d second = moments.second - moments.volume*center*center.transpose();
    ClumpShape clump;
    clump.massCenter = origin + center;
    clump.mass = density*moments.volume;
    clump.inertia = density*(second.trace()*Eigen::Matrix3d::Identity() - second);
    for (Ball& member : members) member.center += origin;
    clump.members = std::move(members);
    return clump;
}

void checkInertia(const Eigen::Matrix3d& inertia, const GrainShape& shape)
{
    const double size = inertia.cwiseAbs().maxCoeff();
    if (!inertia.allFinite() || (inertia - inertia.transpose()).cwiseAbs().maxCoeff() > roundOff*size)
    {
        throw invalidValue("inertia of a clump", "not symmetric or not finite", "a symmetric tensor [kg m2]");
    }
    const Vec3 principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
    if (!(principal[0] > 0.0)) throw invalidValue("smallest principal moment of inertia of a clump", principal[0], "> 0 kg m2");
    if (principal[2] > (principal[0] + principal[1])*(1.0 + roundOff))
    {
        throw invalidValue("largest principal moment of inertia of a clump", principal[2], "at most the sum of the others");
    }
    if (shape.dimensions == 2 && principal[2] > principal[0]*(1.0 + roundOff))
    {
        throw invalidValue("inertia of a clump of discs", "not isotropic", "J times the identity, J of the turn in the plane");
    }
}

/// Discs, and spheres in a plane.
void checkFlat(const std::vector<Ball>& members, const GrainShape& shape)
{
    if (shape.dimensions == 2 || shape.emptyAxis >= 0) flatAxis(members, shape);
}

ClumpShape centered(ClumpShape clump)
{
    for (Ball& member : clump.members) member.center -= clump.massCenter;
    return clump;
}

} // namespace

ClumpShape makeClumpShape(std::vector<Ball> members, double density, const GrainShape& shape)
{
    checkMembers(members);
    checkFlat(members, shape);
    if (!(density > 0.0) || !std::isfinite(density)) throw invalidValue("density of a clump", density, "a finite value > 0 kg/m3");
    return centered(shape.dimensions == 2 ? discShape(std::move(members), density, shape) : ballShape(std::move(members), density, shape));
}

ClumpShape makeClumpShape
(
    std::vector<Ball> members, double mass, const Vec3& massCenter, const Eigen::Matrix3d& inertia, const GrainShape& shape
)
{
    checkMembers(members);
    checkFlat(members, shape);
    if (!(mass > 0.0) || !std::isfinite(mass)) throw invalidValue("mass of a clump", mass, "a finite value > 0 kg");
    if (!massCenter.allFinite()) throw invalidValue("mass center of a clump", "not finite", "finite coordinates [m]");
    checkInertia(inertia, shape);
    return centered({std::move(members), mass, inertia, massCenter});
}

} // namespace nscd
