// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A judge of contact solutions that shares no code with the solvers: the natural-map residual of all pairs and planes of a scene.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace scenes
{

struct NaturalMap
{
    double rms = 0.0;  ///< over contacts that carry an impulse, or should [m/s]
    double norm = 0.0; ///< root of the sum of squares over the same contacts [m/s]
    double max = 0.0;  ///< over all pairs [m/s]
    int loaded = 0;
    double overlap = 0.0;    ///< deepest at the start [m]
};

/// How far one contact is from its laws [m/s].
struct MapDefect
{
    double normal;
    double all;
};

/// Natural map of Signorini's and Coulomb's laws: r against its own projection after a step of -u.
/// Shapes: r: impulse [N s]; wn, wt: mobility along n and across it [1/kg]
inline MapDefect mapDefect(const Vec3& n, double bias, const Vec3& u, double wn, double wt, const Vec3& r, double friction)
{
    const double rn = r.dot(n);
    const Vec3 rt = r - rn*n;
    const double normalDefect = wn*std::abs(rn - std::max(0.0, rn - (u.dot(n) + bias)/wn));
    Vec3 q = rt - (u - u.dot(n)*n)/wt;
    const double limit = friction*std::max(0.0, rn);
    if (q.norm() > limit) q *= limit/q.norm();
    return {normalDefect, std::hypot(normalDefect, wt*(rt - q).norm())};
}

/// What the judge sees: positions before the step, velocities after it, and the impulses in between.
class Judge
{
public:
    Judge(const Scene& scene, double friction, double deadBand, double deltaT)
    :
        scene_(scene), friction_(friction), deadBand_(deadBand), deltaT_(deltaT)
    {}

    NaturalMap operator()(const nscd::Grains& before, const nscd::GrainDynamics& after)
    {
        return operator()(before, after.grains(), after.contacts());
    }

    /// Contacts by the grains' identities, which are their indices here.
    NaturalMap operator()(const nscd::Grains& before, const nscd::Grains& after, const std::vector<nscd::LoadedContact>& contacts)
    {
        impulses_.clear();
        attracting_.clear();
        for (const nscd::LoadedContact& c : contacts)
        {
            const int a = static_cast<int>(c.idA), b = static_cast<int>(c.idB);
            const bool isSwapped = b >= 0 && b < a;
            const std::pair<int, int> key = isSwapped ? std::pair(b, a) : std::pair(a, b);
            // What cohesion pulls is a known force; the laws hold for the rest.
            const Vec3 r = c.impulse - c.attraction;
            impulses_[key] = isSwapped ? Vec3(-r) : r;
            if (c.attraction != Vec3::Zero()) attracting_.insert(key);
        }
        sum2_ = 0.0;
        result_ = NaturalMap();
        for (int i = 0; i < static_cast<int>(before.size()); ++i)
        {
            for (int j = i + 1; j < static_cast<int>(before.size()); ++j) judgePair(before, after, i, j);
            for (std::size_t w = 0; w < scene_.walls.regions.size(); ++w) judgePlane(before, after, i, static_cast<int>(w));
        }
        result_.norm = std::sqrt(sum2_);
        result_.rms = result_.loaded > 0 ? std::sqrt(sum2_/result_.loaded) : 0.0;
        return result_;
    }

private:
    void judgePair(const nscd::Grains& x, const nscd::Grains& v, int i, int j)
    {
        const Vec3 dx = scene_.box.nearestImage(x.position[i] - x.position[j]);
        const double gap = dx.norm() - x.radius[i] - x.radius[j];
        const Vec3 n = dx.normalized();
        const Vec3 u = v.velocity[i] - v.velocity[j] - (x.radius[i]*v.omega[i] + x.radius[j]*v.omega[j]).cross(n);
        const double kappa = x.shape.inertiaFactor();
        const double wn = mobility(x, i) + mobility(x, j);
        judge(n, gap, u, wn, wn*(1.0 + 1.0/kappa), {i, j});
    }

    void judgePlane(const nscd::Grains& x, const nscd::Grains& v, int i, int region)
    {
        const nscd::WallRegion& wall = scene_.walls.regions[region];
        const double gap = wall.normal.dot(x.position[i] - wall.point) - x.radius[i];
        const Vec3 u = v.velocity[i] - x.radius[i]*v.omega[i].cross(wall.normal);
        const double wn = mobility(x, i);
        judge(wall.normal, gap, u, wn, wn*(1.0 + 1.0/x.shape.inertiaFactor()), {i, -1 - region});
    }

    double mobility(const nscd::Grains& x, int i) const { return x.isFixed[i] ? 0.0 : 1.0/x.mass[i]; }

    void judge(const Vec3& n, double gap, const Vec3& u, double wn, double wt, std::pair<int, int> key)
    {
        if (!(wn > 0.0)) return;
        const auto found = impulses_.find(key);
        const Vec3 r = found == impulses_.end() ? Vec3(Vec3::Zero()) : found->second;
        // What attracts beyond the dead band here is a bond, drawn back to the band (scenes have no range of cohesion).
        const double target = attracting_.count(key) > 0 ? deadBand_ : 0.0;
        const double bias = gap > deadBand_ ? (gap - target)/deltaT_ : 0.0;
        const MapDefect defect = mapDefect(n, bias, u, wn, wt, r, friction_);
        result_.max = std::max(result_.max, defect.all);
        result_.overlap = std::max(result_.overlap, -gap);
        if (found == impulses_.end() && !(defect.normal > 0.0)) return;
        ++result_.loaded;
        sum2_ += defect.all*defect.all;
    }

    const Scene& scene_;
    double friction_;
    double deadBand_;
    double deltaT_;
    std::map<std::pair<int, int>, Vec3> impulses_;
    std::set<std::pair<int, int>> attracting_;
    NaturalMap result_;
    double sum2_ = 0.0;
};

} // namespace scenes
