// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The usual motions of walls.
#include "nscd/scene/wallMotion.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace nscd
{

namespace
{

constexpr double piece = 0.01;       // [s]
constexpr int maxHalvings = 40;      // of a piece, down to round-off of times of seconds
constexpr double accuracy = 1e-13;   // of a piece, relative to what it would be without changes of sign
constexpr long maxValues = 20000000; // of a function over a piece, a second of work: enough for oscillations of 2e4 Hz

double size(double x) { return std::abs(x); }
double size(const Vec3& x) { return x.norm(); }

/// Simpson's rule over a step of a function known at its ends and in its middle.
template<class Value>
Value simpson(double step, const Value& a, const Value& middle, const Value& b) { return step/6.0*(a + 4.0*middle + b); }

template<class Value, class Function>
Value integrate
(
    const Function& f, double from, double step, const Value& a, const Value& middle, const Value& b, double tolerance, int halvings, long& valuesLeft
)
{
    if ((valuesLeft -= 2) < 0) throw invalidValue("integral of a function of time", "not found", "a function that oscillates at most 2e4 times a second");
    const Value left = f(from + 0.25*step), right = f(from + 0.75*step);
    const Value coarse = simpson(step, a, middle, b);
    const Value halves[2] = {simpson(0.5*step, a, left, middle), simpson(0.5*step, middle, right, b)};
    const Value fine = halves[0] + halves[1];
    // Relative to the part too: no part can be better than its round-off.
    const double scale = std::abs(step)*(size(a) + size(left) + size(middle) + size(right) + size(b));
    // Not for what is no number either, which halves for ever.
    if (halvings == 0 || !(size(Value(fine - coarse)) > std::max(tolerance, accuracy*scale))) return fine;
    return integrate<Value>(f, from, 0.5*step, a, left, middle, tolerance, halvings - 1, valuesLeft)
         + integrate<Value>(f, from + 0.5*step, 0.5*step, middle, right, b, tolerance, halvings - 1, valuesLeft);
}

template<class Value, class Function>
Value integrate(const Function& f, double from, double to)
{
    const double step = to - from;
    const Value a = f(from), middle = f(from + 0.5*step), b = f(to);
    long valuesLeft = maxValues;
    return integrate<Value>(f, from, step, a, middle, b, accuracy*std::abs(step)*(size(a) + size(middle) + size(b)), maxHalvings, valuesLeft);
}

/// The integral at the ends of the pieces passed so far is kept.
template<class Value, class Function>
Function runningIntegral(Function f, Value zero)
{
    auto known = std::make_shared<std::vector<Value>>(1, zero);
    return [f, known](double time)
    {
        if (!(time > 0.0)) return integrate<Value>(f, 0.0, time);
        const std::size_t pieces = static_cast<std::size_t>(time/piece);
        while (known->size() <= pieces)
        {
            const double from = piece*(known->size() - 1);
            known->push_back(known->back() + integrate<Value>(f, from, from + piece));
        }
        return Value((*known)[pieces] + integrate<Value>(f, piece*pieces, time));
    };
}

} // namespace

WallMotion translation(const Vec3& velocity)
{
    return translationBy([velocity](double time) { return Vec3(time*velocity); });
}

WallMotion translationBy(VectorOfTime displacement)
{
    return [displacement](double time)
    {
        WallPose pose = WallPose::Identity();
        pose.translation() = displacement(time);
        return pose;
    };
}

WallMotion rotation(const Vec3& point, const Vec3& axis, double omega)
{
    return rotationBy(point, axis, [omega](double time) { return omega*time; });
}

WallMotion rotationBy(const Vec3& point, const Vec3& axis, ScalarOfTime angle)
{
    if (!(axis.norm() > 0.0)) throw invalidValue("axis of a wall's rotation", axis.transpose(), "a vector that is not zero");
    return [point, unit = Vec3(axis.normalized()), angle](double time)
    {
        WallPose pose = WallPose::Identity();
        pose.linear() = Eigen::AngleAxisd(angle(time), unit).toRotationMatrix();
        pose.translation() = point - pose.linear()*point;
        return pose;
    };
}

ScalarOfTime integralOf(ScalarOfTime speed) { return runningIntegral<double>(std::move(speed), 0.0); }

VectorOfTime integralOf(VectorOfTime velocity) { return runningIntegral<Vec3>(std::move(velocity), Vec3::Zero()); }

WallMotion oscillation(const Vec3& amplitude, double frequency, double phase)
{
    if (!(frequency >= 0.0)) throw invalidValue("frequency of a wall's oscillation", frequency, ">= 0 Hz");
    return translationBy([=](double time) { return Vec3(std::sin(2.0*M_PI*frequency*time + phase)*amplitude); });
}

SurfaceMotion belt(const Vec3& velocity)
{
    return [velocity](double) { return Twist{velocity, Vec3::Zero(), Vec3::Zero()}; };
}

SurfaceMotion turningSurface(const Vec3& point, const Vec3& omega)
{
    return [point, omega](double) { return Twist{Vec3::Zero(), omega, point}; };
}

Vec3 displacement(const WallPose& now, const WallPose& next, const Vec3& x)
{
    const Vec3 material = now.linear().transpose()*(x - now.translation());
    return next*material - x;
}

double largestDisplacement(const WallPose& now, const WallPose& next, const Eigen::AlignedBox3d& box)
{
    if (box.isEmpty()) return 0.0;
    double largest2 = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
        const Vec3 x = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        largest2 = std::max(largest2, (next*x - now*x).squaredNorm());
    }
    return std::sqrt(largest2);
}

} // namespace nscd
