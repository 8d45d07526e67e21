// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Walls that move, over a step: where they are, where they will be, and the velocity that each contact with them sees.
#pragma once

#include "nscd/contacts/contactList.hpp"

#include <limits>

namespace nscd
{

/// Geometry is at the poses of a step's start until endStep(), as grains are. A contact with a moving wall joins the grain to a body
/// of no mobility that has the wall's velocity at the contact: displacement of the wall's material point there over the step, over dt.
/// So the gap at the end of the step is the one that the contact law closes, for any angle per step up to the curvature of
/// the point's path. Scenes without such walls pay nothing.
class MovingWalls
{
public:
    explicit MovingWalls(Walls& walls) : walls_(walls) {}

    double time() const { return time_; }
    /// Moves the walls to where they are at a time [s].
    void setTime(double time);

    /// Looks where the walls will be at the end of a step. Returns whether setTime() moved any since the last step.
    bool beginStep(double deltaT);
    /// Moves the walls there.
    void endStep();
    /// Whether any wall moves in the step begun, or drags grains along.
    bool isAnyMoving() const;

    /// Sets the velocities of the list's bodies at walls, none along `emptyAxis` if that is not -1. For laws within the sweeps such a body is
    /// as large as the grain and turns with the wall, in 2D about the empty axis alone; its surface has the wall's velocity.
    void setVelocities(ContactList& list, const PeriodicBox& box, int emptyAxis) const;

    /// Where a patch that moves will be at the end of the step begun.
    const WallPose& next(int patch) const { return next_[patch]; }

    /// How far each patch may go before a list made now is stale: this step and another, and a margin.
    std::vector<WallReach> reach
    (
        const WallSearch& search, const Grains& grains, const std::vector<double>& grainReach, double diameter
    ) const;
    /// Whether all patches stay within that in this step.
    bool areCovered(const ContactList& list) const;

private:
    Vec3 velocity(int patch, const Vec3& point, const Vec3& normal) const;
    Vec3 spin(int patch, int emptyAxis) const;
    std::vector<Vec3> spins(int emptyAxis) const;   ///< per patch

    Walls& walls_;
    double time_ = 0.0;
    double deltaT_ = 0.0;
    bool haveJumped_ = false;
    std::vector<WallPose> next_;    ///< per patch
    std::vector<Twist> surface_;    ///< per patch, in the middle of the step
};

} // namespace nscd
