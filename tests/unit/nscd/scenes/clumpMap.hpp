// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A judge of contact solutions of clumps that shares no code with the solvers: geometry, laws and balances from what is written.
#pragma once

#include "unit/nscd/scenes/clumpScenes.hpp"
#include "unit/nscd/scenes/naturalMap.hpp"

#include <algorithm>
#include <map>

namespace scenes
{

struct ClumpMap
{
    double rms = 0.0;         ///< natural map over contacts that carry an impulse, or should [m/s]
    double max = 0.0;         ///< [m/s]
    double imbalance = 0.0;   ///< largest |m dv - dt f - sum r|, and the same of L over the radius, over all clumps that are awake [N s]
    double asleep = 0.0;      ///< the same over those that sleep, which lie still to the bit, each in its m g dt: sleep lets forces be off [-]
    double overlap = 0.0;     ///< deepest at the start of the step [m]
    int loaded = 0;
};

/// Positions and orientations before a step, velocities after it, impulses in between. Every pair of balls and planes that could touch is
/// judged, whatever the library listed; velocities at contacts are those of the members as written, v - R omega x n.
class ClumpJudge
{
public:
    ClumpJudge(const Scene& scene, double friction, double deadBand, double deltaT)
    :
        scene_(scene), friction_(friction), deadBand_(deadBand), deltaT_(deltaT)
    {}

    ClumpMap operator()(const nscd::Grains& before, const nscd::GrainDynamics& dynamics) { return (*this)(before, dynamics.grains(), dynamics.contacts()); }

    /// Of scenes in which grains have their places for identities.
    ClumpMap operator()(const nscd::Grains& before, const nscd::Grains& after, const std::vector<nscd::LoadedContact>& contacts)
    {
        clumpOf_ = nscd::clumpOfGrains(before);
        clumpOf_.resize(before.size(), -1);
        impulses_.clear();
        for (const nscd::LoadedContact& c : contacts)
        {
            const int a = static_cast<int>(c.idA), b = static_cast<int>(c.idB);
            const bool isSwapped = b >= 0 && b < a;
            impulses_[isSwapped ? std::pair(b, a) : std::pair(a, b)] = isSwapped ? Vec3(-c.impulse) : c.impulse;
        }
        result_ = ClumpMap();
        sum2_ = 0.0;
        linear_.assign(before.clumps.size(), Vec3::Zero());
        angular_ = linear_;
        farthest_ = 2.5*largestRadius(before) + 2.0*deltaT_*(largest(before.velocity) + largest(after.velocity));
        const int grains = static_cast<int>(before.size());
        for (int i = 0; i < grains; ++i)
        {
            for (int j = i + 1; j < grains; ++j) judgePair(before, after, i, j);
            for (std::size_t w = 0; w < scene_.walls.regions.size(); ++w) judgePlane(before, after, i, static_cast<int>(w));
        }
        for (std::size_t c = 0; c < before.clumps.size(); ++c) judgeBalance(before.clumps, after.clumps, c);
        result_.rms = result_.loaded > 0 ? std::sqrt(sum2_/result_.loaded) : 0.0;
        return result_;
    }

private:
    void judgePair(const nscd::Grains& x, const nscd::Grains& v, int i, int j)
    {
        if (clumpOf_[i] >= 0 && clumpOf_[i] == clumpOf_[j]) return;
        const Vec3 dx = scene_.box.nearestImage(x.position[i] - x.position[j]);
        if (dx.squaredNorm() > farthest_*farthest_) return;
        const double radii = x.radius[i] + x.radius[j];
        const Vec3 before = x.velocity[i] - x.velocity[j], after = v.velocity[i] - v.velocity[j];
        if (!mayMeet(dx.norm() - radii, before, after, x.radius[i])) return;
        const bool areSingle = clumpOf_[i] < 0 && clumpOf_[j] < 0;
        const Vec3 n = areSingle ? normalOfSingle(dx, before, radii) : dx.normalized();
        const Vec3 u = after - (x.radius[i]*v.omega[i] + x.radius[j]*v.omega[j]).cross(n);
        const Vec3 r = judge(n, n.dot(dx) - radii, u, mobility(x, i, -n) + mobility(x, j, n), {i, j});
        account(x, i, -n, r);
        account(x, j, n, -r);
    }

    void judgePlane(const nscd::Grains& x, const nscd::Grains& v, int i, int region)
    {
        const nscd::WallRegion& wall = scene_.walls.regions[region];
        const double gap = wall.normal.dot(x.position[i] - wall.point) - x.radius[i];
        if (!mayMeet(gap, x.velocity[i], v.velocity[i], x.radius[i])) return;
        const Vec3 u = v.velocity[i] - x.radius[i]*v.omega[i].cross(wall.normal);
        account(x, i, -wall.normal, judge(wall.normal, gap, u, mobility(x, i, -wall.normal), {i, -1 - region}));
    }

    /// Whether the relative velocities before and after the step may close a gap in it: a contact carries its impulse
    /// across the whole way.
    bool mayMeet(double gap, const Vec3& before, const Vec3& after, double radius) const
    {
        return gap <= 0.5*radius + deltaT_*(before.norm() + after.norm());
    }

    /// Normal of a pair of single grains. Those that move by more than a quarter of their radii's sum in the
    /// free motion (u, which weight leaves as it was) have the normal with which they meet in it, or are nearest.
    Vec3 normalOfSingle(const Vec3& dx, const Vec3& u, double radii) const
    {
        const double speed2 = u.squaredNorm(), approach = -dx.dot(u), distance2 = dx.squaredNorm();
        const bool isFast = deltaT_*std::sqrt(speed2) > 0.25*radii && approach > 0.0 && distance2 > std::pow(1.001*radii, 2);
        if (!isFast) return dx.normalized();
        const double root = std::sqrt(std::max(0.0, approach*approach - speed2*(distance2 - radii*radii)));
        return (dx + std::min(deltaT_, (approach - root)/speed2)*u).normalized();
    }

    Vec3 arm(const nscd::Grains& x, int i, const Vec3& toContact) const
    {
        const int c = clumpOf_[i];
        const Vec3 center = x.clumps.orientation[c]*x.clumps.shapeOf(c).members[i - x.clumps.firstMember[c]].center;
        return center + x.radius[i]*toContact;
    }

    /// Velocity of the contact point by unit impulses there, column by column.
    Eigen::Matrix3d mobility(const nscd::Grains& x, int i, const Vec3& toContact) const
    {
        Eigen::Matrix3d w;
        for (int k = 0; k < 3; ++k)
        {
            const Vec3 p = Vec3::Unit(k);
            if (clumpOf_[i] < 0)
            {
                const Vec3 point = x.radius[i]*toContact;
                const double inertia = x.shape.inertiaFactor()*x.mass[i]*x.radius[i]*x.radius[i];
                w.col(k) = p/x.mass[i] + (point.cross(p)/inertia).cross(point);
                continue;
            }
            const Vec3 a = arm(x, i, toContact);
            const Eigen::Matrix3d turn = x.clumps.orientation[clumpOf_[i]].toRotationMatrix();
            const nscd::ClumpShape& shape = x.clumps.shapeOf(clumpOf_[i]);
            const Vec3 omega = turn*Vec3(shape.inertia.ldlt().solve(turn.transpose()*a.cross(p)));
            w.col(k) = p/shape.mass + omega.cross(a);
        }
        return w;
    }

    void account(const nscd::Grains& x, int i, const Vec3& toContact, const Vec3& r)
    {
        if (clumpOf_[i] < 0) return;
        linear_[clumpOf_[i]] += r;
        angular_[clumpOf_[i]] += arm(x, i, toContact).cross(r);
    }

    Vec3 judge(const Vec3& n, double gap, const Vec3& u, const Eigen::Matrix3d& w, std::pair<int, int> key)
    {
        const auto found = impulses_.find(key);
        const Vec3 r = found == impulses_.end() ? Vec3(Vec3::Zero()) : found->second;
        const double bias = gap > deadBand_ ? gap/deltaT_ : 0.0;
        const double wn = n.dot(w*n), wt = 0.5*(w.trace() - wn);
        const MapDefect defect = mapDefect(n, bias, u, wn, wt, r, friction_);
        result_.max = std::max(result_.max, defect.all);
        result_.overlap = std::max(result_.overlap, -gap);
        if (found == impulses_.end() && !(defect.normal > 0.0)) return r;
        ++result_.loaded;
        sum2_ += defect.all*defect.all;
        return r;
    }

    void judgeBalance(const nscd::Clumps& before, const nscd::Clumps& after, std::size_t c)
    {
        const double mass = before.shapeOf(c).mass;
        const Vec3 linear = mass*(after.velocity[c] - before.velocity[c]) - deltaT_*mass*scene_.g - linear_[c];
        const Vec3 angular = after.angularMomentum[c] - before.angularMomentum[c] - angular_[c];
        const double off = std::max(linear.norm(), angular.norm()/memberRadius);
        const bool isAsleep = after.velocity[c] == Vec3::Zero() && after.angularMomentum[c] == Vec3::Zero();
        if (isAsleep) result_.asleep = std::max(result_.asleep, off/(mass*scene_.g.norm()*deltaT_));
        else result_.imbalance = std::max(result_.imbalance, off);
    }

    static double largestRadius(const nscd::Grains& x)
    {
        return x.radius.empty() ? 0.0 : *std::max_element(x.radius.begin(), x.radius.end());
    }

    static double largest(const std::vector<Vec3>& vectors)
    {
        double squared = 0.0;
        for (const Vec3& v : vectors) squared = std::max(squared, v.squaredNorm());
        return std::sqrt(squared);
    }

    const Scene& scene_;
    double friction_;
    double deadBand_;
    double deltaT_;
    double farthest_ = 0.0;   ///< that centers may be apart and meet [m]
    std::vector<int> clumpOf_;
    std::map<std::pair<int, int>, Vec3> impulses_;
    std::vector<Vec3> linear_, angular_;
    ClumpMap result_;
    double sum2_ = 0.0;
};

/// Clumps of three kinds, and spheres between them, above each other in a box of `side` cells.
inline Scene clumpHeap(int clumps, int side, double friction)
{
    Scene scene(3, friction, 0.0);
    const double cell = 5.0*memberRadius, width = side*cell;
    const int shapes[] = {addShape(scene, pebble()), addShape(scene, dumbbell(1.5)), addShape(scene, tetrapod())};
    std::uint32_t state = 1;
    const auto random = [&] { return (state = 1664525u*state + 1013904223u)/4294967296.0 - 0.5; };
    for (int k = 0; k < clumps; ++k)
    {
        const Vec3 cellMiddle = cell*(Vec3(k % side, k/side % side, k/(side*side)) + Vec3::Constant(0.5));
        addClump(scene, shapes[k % 3], cellMiddle, Quaternion(1.0, 2*random(), 2*random(), 2*random()));
        const bool isInside = k % side < side - 1 && k/side % side < side - 1;
        if (k % 4 == 0 && isInside) scene.addGrain(cellMiddle + Vec3::Constant(0.5*cell), 0.8*memberRadius);
    }
    for (int axis = 0; axis < 3; ++axis) scene.addPlane(Vec3::Zero(), Vec3::Unit(axis));
    for (int axis = 0; axis < 2; ++axis) scene.addPlane(Vec3::Constant(width), -Vec3::Unit(axis));
    return scene;
}

} // namespace scenes
