// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Random shots of grains at closed surfaces, and a wavy sheet: which side they end on.
#pragma once

#include "unit/nscd/scenes/scenes.hpp"

#include <algorithm>
#include <ctime>
#include <numeric>
#include <random>
#include <vector>

namespace scenes
{

/// Height of a sheet [m], of amplitude 1 cm and waves of 16 and 18 cm.
inline double waveHeight(const Vec3& x) { return 0.01*std::sin(40*x[0])*std::cos(35*x[1]); }

/// A square sheet of 2 n n triangles, 0.3 m wide, about the origin.
inline std::vector<nscd::Triangle> wavySheet(int n)
{
    constexpr double width = 0.3;
    const auto at = [n](int i, int j)
    {
        Vec3 x(width*(static_cast<double>(i)/n - 0.5), width*(static_cast<double>(j)/n - 0.5), 0.0);
        x[2] = waveHeight(x);
        return x;
    };
    std::vector<nscd::Triangle> triangles;
    for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    return triangles;
}

/// A closed surface around the origin: an octahedron divided `times` times, on a sphere of radius 0.1 m; normals inwards.
inline std::vector<nscd::Triangle> ball(int times)
{
    std::vector<nscd::Triangle> triangles;
    for (int octant = 0; octant < 8; ++octant)
    {
        const Vec3 x = (octant & 1 ? -1 : 1)*Vec3::UnitX(), y = (octant & 2 ? -1 : 1)*Vec3::UnitY(), z = (octant & 4 ? -1 : 1)*Vec3::UnitZ();
        const bool isInwards = x.cross(y).dot(z) < 0.0;
        triangles.push_back(isInwards ? nscd::Triangle{x, y, z} : nscd::Triangle{x, z, y});
    }
    for (int k = 0; k < times; ++k)
    {
        std::vector<nscd::Triangle> finer;
        for (const nscd::Triangle& t : triangles)
        {
            const Vec3 a = (t[0] + t[1]).normalized(), b = (t[1] + t[2]).normalized(), c = (t[2] + t[0]).normalized();
            for (const nscd::Triangle& part : {nscd::Triangle{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}}) finer.push_back(part);
        }
        triangles = finer;
    }
    for (nscd::Triangle& t : triangles) for (Vec3& x : t) x *= 0.1;
    return triangles;
}

/// 144 spheres of 5 mm at 100 m/s, above a sheet of 7200 triangles.
inline Scene volleyAtSheet()
{
    Scene scene(3, 0.3, 0.5);
    scene.walls.addTriangles(scene.walls.addPatch("sheet", 1), wavySheet(60));
    for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
    {
        scene.addGrain(Vec3(0.012*(i - 5.5), 0.012*(j - 5.5), 0.05), 0.0025);
        scene.grains.velocity.back() = Vec3(0, 0, -100);
    }
    return scene;
}

enum class Surface { octahedron, coarseBall, fineBall, oneSidedBall, polygonBox, movingBall, turningBall };

inline std::vector<Surface> allSurfaces()
{
    return
    {
        Surface::octahedron, Surface::coarseBall, Surface::fineBall, Surface::oneSidedBall, Surface::polygonBox, Surface::movingBall, Surface::turningBall
    };
}

/// A box of six rectangles that are seen from inside.
inline void addPolygonBox(nscd::Walls& walls, int patch, double half)
{
    for (int axis = 0; axis < 3; ++axis)
    for (double side : {-1.0, 1.0})
    {
        const Vec3 n = -side*Vec3::Unit(axis), p = half*Vec3::Unit((axis + 1) % 3), q = -side*half*Vec3::Unit((axis + 2) % 3), middle = -half*n;
        walls.addPolygon(patch, {middle - p - q, middle + p - q, middle + p + q, middle - p + q});
    }
}

/// Closed walls about the origin, 5 cm or more away from it.
inline Scene closedWalls(Surface surface, double friction, double restitution)
{
    Scene scene(3, friction, restitution);
    nscd::Walls& walls = scene.walls;
    const int patch = walls.addPatch("walls", 1);
    if (surface == Surface::polygonBox) addPolygonBox(walls, patch, 0.08);
    else
    {
        const auto sides = surface == Surface::oneSidedBall ? nscd::WallSides::one : nscd::WallSides::both;
        walls.addTriangles(patch, ball(surface == Surface::octahedron ? 0 : surface == Surface::coarseBall ? 1 : 4), sides);
    }
    if (surface == Surface::movingBall) walls.setMotion(patch, nscd::translation(Vec3(2, -1, 3)));
    if (surface == Surface::turningBall) walls.setMotion(patch, nscd::rotation(Vec3(0.01, 0, 0), Vec3(1, 2, 3), 50));
    return scene;
}

/// What came of shots.
struct Tally
{
    int shots = 0;
    int passed = 0;              ///< grains on the other side of the walls, at the end of their shot
    int stopped = 0;             ///< stops on the way
    int unconverged = 0;         ///< steps
    double energyGain = 0.0;     ///< largest of a step at walls at rest, beyond what its shock's residual may have; share of the start's
    std::vector<double> seconds; ///< of processor time in the steps of each shot

    double median() const
    {
        std::vector<double> sorted = seconds;
        std::nth_element(sorted.begin(), sorted.begin() + sorted.size()/2, sorted.end());
        return sorted[sorted.size()/2];
    }
    double mean() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0)/static_cast<double>(seconds.size()); }
};

/// Whether a place is outside of closed walls: where the ray along a direction meets them an even number of times.
inline bool isOutside(const nscd::Walls& walls, const Vec3& x)
{
    const Vec3 ray = Vec3(0.3217, 0.5131, 0.7963).normalized();
    int crossings = 0;
    for (const nscd::WallRegion& region : walls.regions)
    {
        const nscd::WallPose& pose = walls.patches[region.patch].pose;
        const Vec3 start = pose.inverse()*x, along = pose.linear().transpose()*ray;
        const double speed = region.normal.dot(along), time = -region.normal.dot(start - region.point)/speed;
        crossings += time > 0.0 && nscd::holdsFoot(region, start + time*along);
    }
    return crossings % 2 == 0;
}

/// Shots at one surface by grains of one size, with random places, directions and speeds.
class Volley
{
public:
    /// `grains`: in a row, one behind the other.
    Volley(Surface surface, int grains, std::mt19937& random)
    :
        surface_(surface),
        random_(random),
        radius_(0.0005*std::pow(20.0, share_(random))),
        scene_(closedWalls(surface, share_(random) < 0.5 ? 0.0 : 0.5, 0.5*std::floor(3*share_(random))))
    {
        for (int k = 0; k < grains; ++k) scene_.addGrain(Vec3(0, 0, 3*k*radius_), radius_);
    }

    /// One after the other, three steps each, of up to 200 d.
    void shoot(int shots, Tally& tally)
    {
        auto dynamics = scene_.build(nscd::ContactSettings());
        for (int k = 0; k < shots; ++k)
        {
            dynamics.setGrains(loaded(dynamics.grains()));
            dynamics.setTime(0.0);
            const bool isFromOutside = isOutside(dynamics.walls(), dynamics.grains().position[0]);
            fly(dynamics, tally);
            for (const Vec3& x : dynamics.grains().position) tally.passed += isOutside(dynamics.walls(), x) != isFromOutside;
            ++tally.shots;
        }
    }

private:
    Vec3 vector() { return Vec3(unit_(random_), unit_(random_), unit_(random_)); }

    bool areOfTwoSides() const { return surface_ != Surface::oneSidedBall && surface_ != Surface::polygonBox; }
    bool areMoving() const { return surface_ == Surface::movingBall || surface_ == Surface::turningBall; }

    nscd::Grains loaded(nscd::Grains grains)
    {
        const double speed = 400*radius_/deltaT*std::pow(share_(random_), 2);
        const bool isFromOutside = areOfTwoSides() && share_(random_) < 0.5;
        const Vec3 start = isFromOutside ? Vec3(0.17*vector().normalized()) : Vec3(0.005*vector());
        const Vec3 along = isFromOutside ? Vec3((0.08*vector() - start).normalized()) : vector().normalized();
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            grains.position[i] = start - static_cast<double>(i)*(2.0 + share_(random_))*radius_*along;
            grains.velocity[i] = speed*along;
            grains.omega[i] = 0.3*speed/radius_*vector();
        }
        return grains;
    }

    void fly(nscd::GrainDynamics& dynamics, Tally& tally) const
    {
        const double start = nscd::kineticEnergy(dynamics.grains());
        double before = start;
        const std::clock_t begun = std::clock();
        for (int n = 0; n < 3; ++n)
        {
            const nscd::StepReport report = step(dynamics, Vec3::Zero(), deltaT);
            const double now = nscd::kineticEnergy(dynamics.grains());
            if (!areMoving()) tally.energyGain = std::max(tally.energyGain, (now - before - report.solve.shockResidualWork)/start);
            before = now;
            tally.stopped += static_cast<int>(report.stoppedOnWay);
            tally.unconverged += !report.solve.converged;
        }
        tally.seconds.push_back(static_cast<double>(std::clock() - begun)/CLOCKS_PER_SEC);
    }

    static constexpr double deltaT = 1e-3;
    Surface surface_;
    std::mt19937& random_;
    std::uniform_real_distribution<double> unit_{-1, 1}, share_{0, 1};
    double radius_;
    Scene scene_;
};

/// `grains`: in each shot.
inline void shoot(Surface surface, int shots, int grains, unsigned seed, Tally& tally)
{
    constexpr int volley = 20;
    std::mt19937 random(seed);
    for (int done = 0; done < shots; done += volley) Volley(surface, grains, random).shoot(volley, tally);
}

} // namespace scenes
