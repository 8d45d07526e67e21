// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Poses and velocities of walls over a step.
#include "nscd/contacts/movingWalls.hpp"

#include "nscd/base/invalidValue.hpp"

#include <cmath>

namespace nscd
{

namespace
{

/// Share of the mean diameter that a wall may move before contacts are listed anew: few more candidates, and rarely a list.
constexpr double margin = 0.2;
constexpr double stepsPerList = 2.0;

/// Mean over a step that turns by less than half a turn [rad/s].
Vec3 angularVelocity(const WallPose& now, const WallPose& next, double deltaT)
{
    if (next.linear() == now.linear()) return Vec3::Zero();
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(next.linear()*now.linear().transpose()));
    return turn.angle()/deltaT*turn.axis();
}

} // namespace

void MovingWalls::setTime(double time)
{
    if (!std::isfinite(time)) throw invalidValue("time of the walls", time, "a finite value [s]");
    if (time == time_ && next_.size() == walls_.patches.size()) return;
    time_ = time;
    for (WallPatch& patch : walls_.patches)
    {
        const WallPose before = patch.pose;
        patch.pose = poseAt(patch, time);
        if (patch.pose.matrix() != before.matrix()) haveJumped_ = true;
    }
    next_.resize(walls_.patches.size(), WallPose::Identity());
    surface_.resize(walls_.patches.size());
}

bool MovingWalls::beginStep(double deltaT)
{
    deltaT_ = deltaT;
    for (std::size_t k = 0; k < walls_.patches.size(); ++k)
    {
        const WallPatch& patch = walls_.patches[k];
        if (patch.motion) next_[k] = poseAt(patch, time_ + deltaT);
        if (!patch.surfaceMotion) continue;
        surface_[k] = patch.surfaceMotion(time_ + 0.5*deltaT);
        if (surface_[k].velocity.allFinite() && surface_[k].omega.allFinite() && surface_[k].point.allFinite()) continue;
        throw invalidValue("surface motion of wall " + patch.name + " at time " + std::to_string(time_), "not finite", "finite velocities");
    }
    const bool haveJumped = haveJumped_;
    haveJumped_ = false;
    return haveJumped;
}

void MovingWalls::endStep()
{
    time_ += deltaT_;
    for (std::size_t k = 0; k < walls_.patches.size(); ++k)
    {
        if (walls_.patches[k].motion) walls_.patches[k].pose = next_[k];
    }
}

bool MovingWalls::isAnyMoving() const
{
    for (std::size_t k = 0; k < walls_.patches.size(); ++k)
    {
        const WallPatch& patch = walls_.patches[k];
        if (patch.motion && next_[k].matrix() != patch.pose.matrix()) return true;
        const Twist& drag = surface_[k];
        if (patch.surfaceMotion && !(drag.velocity.isZero(0.0) && drag.omega.isZero(0.0))) return true;
    }
    return false;
}

Vec3 MovingWalls::velocity(int k, const Vec3& point, const Vec3& normal) const
{
    const WallPatch& patch = walls_.patches[k];
    Vec3 v = patch.motion ? Vec3(displacement(patch.pose, next_[k], point)/deltaT_) : Vec3(Vec3::Zero());
    if (!patch.surfaceMotion) return v;
    const Vec3 surface = surface_[k].at(point);
    return v + surface - normal.dot(surface)*normal;
}

Vec3 MovingWalls::spin(int k, int emptyAxis) const
{
    const WallPatch& patch = walls_.patches[k];
    Vec3 omega = patch.motion ? angularVelocity(patch.pose, next_[k], deltaT_) : Vec3(Vec3::Zero());
    if (patch.surfaceMotion) omega += surface_[k].omega;
    return emptyAxis >= 0 ? Vec3(omega[emptyAxis]*Vec3::Unit(emptyAxis)) : omega;
}

std::vector<Vec3> MovingWalls::spins(int emptyAxis) const
{
    std::vector<Vec3> spins;
    for (std::size_t k = 0; k < walls_.patches.size(); ++k) spins.push_back(spin(static_cast<int>(k), emptyAxis));
    return spins;
}

void MovingWalls::setVelocities(ContactList& list, const PeriodicBox& box, int emptyAxis) const
{
    const std::vector<Vec3> omega = !list.laws.areOfSpins() ? std::vector<Vec3>() : spins(emptyAxis);
    for (std::size_t k = 0; k < list.movingSlots.size(); ++k)
    {
        const std::size_t slot = list.movingSlots[k];
        const int grain = list.blocks[slot/blockLanes].a[slot % blockLanes], patch = walls_.regions[list.wall[slot]].patch;
        const double distance = list.radius[grain] + list.gap[slot];
        Vec3 v = Vec3::Zero(), s = Vec3::Zero();
        if (distance < std::numeric_limits<double>::max())
        {
            const Vec3 n = normal(list, slot);
            v = velocity(patch, box.wrap(list.position[grain]) - distance*n, n);
            if (emptyAxis >= 0) v[emptyAxis] = 0.0;
            if (!omega.empty()) s = list.radius[grain]*omega[patch];
            v -= s.cross(n);
        }
        Body& body = list.bodies[list.firstWallBody() + k];
        Eigen::Map<Vec3>(body.v) = v;
        Eigen::Map<Vec3>(body.s) = s;
    }
}

std::vector<WallReach> MovingWalls::reach
(
    const WallSearch& search, const Grains& grains, const std::vector<double>& grainReach, double diameter
) const
{
    std::vector<WallReach> reach;
    if (!walls_.anyMotion()) return reach;
    Eigen::AlignedBox3d grainBox;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const Vec3 around = Vec3::Constant(grains.radius[i] + grainReach[i]);
        grainBox.extend(grains.position[i] - around);
        grainBox.extend(grains.position[i] + around);
    }
    reach.resize(walls_.patches.size());
    for (std::size_t k = 0; k < reach.size(); ++k)
    {
        const WallPatch& patch = walls_.patches[k];
        if (!patch.motion) continue;
        reach[k].poseAtBuild = patch.pose;
        reach[k].box = search.hasPlane(static_cast<int>(k)) ? moved(grainBox, patch.pose.inverse()) : search.extent(static_cast<int>(k));
        reach[k].distance = margin*diameter + stepsPerList*largestDisplacement(patch.pose, next_[k], reach[k].box);
    }
    return reach;
}

bool MovingWalls::areCovered(const ContactList& list) const
{
    for (std::size_t k = 0; k < list.wallReach.size(); ++k)
    {
        const WallReach& reach = list.wallReach[k];
        if (reach.distance > 0.0 && largestDisplacement(reach.poseAtBuild, next_[k], reach.box) > reach.distance) return false;
    }
    return true;
}

} // namespace nscd
