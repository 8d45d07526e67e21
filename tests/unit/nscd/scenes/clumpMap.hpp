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
    double imbalance = 0.0;   ///< largest |m dv - dt f - sum r|, and the same of L over the radius, over all clumps [N s]
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
        const double gap = dx.norm() - x.radius[i] - x.radius[j];
        if (gap > 0.5*x.radius[i]) return;
        const Vec3 n = dx.normalized();
        const Vec3 u = v.velocity[i] - v.velocity[j] - (x.radius[i]*v.omega[i] + x.radius[j]*v.omega[j]).cross(n);
        const Vec3 r = judge(n, gap, u, mobility(x, i, -n) + mobility(x, j, n), {i, j});
        account(x, i, -n, r);
        account(x, j, n, -r);
    }

    void judgePlane(const nscd::Grains& x, const nscd::Grains& v, int i, int region)
    {
        const nscd::WallRegion& wall = scene_.walls.regions[region];
        const double gap = wall.normal.dot(x.position[i] - wall.point) - x.radius[i];
        if (gap > 0.5*x.radius[i]) return;
        const Vec3 u = v.velocity[i] - x.radius[i]*v.omega[i].cross(wall.normal);
        account(x, i, -wall.normal, judge(wall.normal, gap, u, mobility(x, i, -wall.normal), {i, -1 - region}));
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
        result_.imbalance = std::max({result_.imbalance, linear.norm(), angular.norm()/memberRadius});
    }

    const Scene& scene_;
    double friction_;
    double deadBand_;
    double deltaT_;
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
