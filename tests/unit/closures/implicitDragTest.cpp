// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Drag over one step: the split of gamma, and falling grains against their exact transients.
#include "closures/implicitDrag.hpp"

#include "accuracy/expectNear.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace
{

using closures::DragState;
using closures::DragStep;
using closures::DragWeighting;
using Eigen::Vector3d;

const double pi = std::acos(-1.0);

/// A sphere that falls from rest in still fluid.
struct Fall
{
    double d, rhoP, rho, mu;
    closures::DragLaw law;

    double volume() const { return pi*d*d*d/6; }
    double mass() const { return rhoP*volume(); }
    double weight() const { return (rhoP - rho)*volume()*9.81; }
    DragState state(double slip) const { return {closures::sphereSize(d), slip, 1, rho, mu}; }
    double acceleration(double v) const { return (weight() - law(state(std::abs(v)))*v)/mass(); }
    double stokesTime() const { return mass()/(3*pi*mu*d); }

    double terminal() const
    {
        double low = 0, high = 100;
        for (int i = 0; i < 100; ++i) (acceleration((low + high)/2) > 0 ? low : high) = (low + high)/2;
        return low;
    }
};

Fall fallOf(const char* name, const char* law)
{
    const closures::DragLaw f = closures::findDragLaw(law).law;
    if (name == std::string("C01")) return {1e-4, 3000, 10, 1e-4, f};
    if (name == std::string("C03")) return {2e-3, 2500, 997, 1.00199e-3, f};
    return {2e-4, 2650, 1000, 1e-3, f};
}

/// Speed at time t by a fourth-order method with tiny steps.
double exactSpeed(const Fall& fall, double t)
{
    const int n = 20000;
    const double h = t/n;
    double v = 0;
    for (int i = 0; i < n; ++i)
    {
        const double a = fall.acceleration(v), b = fall.acceleration(v + h/2*a);
        const double c = fall.acceleration(v + h/2*b), d = fall.acceleration(v + h*c);
        v += h/6*(a + 2*b + 2*c + d);
    }
    return v;
}

/// Speeds after each of n steps of length dt, gamma at mid-slip or at the start of the step.
std::vector<double> speeds(const Fall& fall, double dt, int n, DragWeighting weighting, bool atMidSlip)
{
    const DragStep step = {Vector3d::Zero(), {0, -fall.weight(), 0}, fall.mass(), dt};
    std::vector<double> result;
    Vector3d v = Vector3d::Zero();
    for (int i = 0; i < n; ++i)
    {
        const DragState state = fall.state(v.norm());
        const double gamma =
            atMidSlip ? closures::gammaAtMidSlip(fall.law, state, step, v, weighting) : fall.law(state);
        v = closures::velocityAfter(step, v, gamma, weighting);
        result.push_back(-v.y());
    }
    return result;
}

double speedAt(const Fall& fall, double t, double dt, DragWeighting weighting, bool atMidSlip)
{
    return speeds(fall, dt, int(std::lround(t/dt)), weighting, atMidSlip).back();
}

const struct { const char* fall; const char* law; double t, speed; } transients[] =
{
    {"C01", "SchillerNaumann", 0.005, 0.041853}, {"C01", "SchillerNaumann", 0.010, 0.071654},
    {"C01", "SchillerNaumann", 0.020, 0.106809}, {"C01", "SchillerNaumann", 0.050, 0.134424},
    {"C01", "DallaValle", 0.005, 0.041645}, {"C01", "DallaValle", 0.010, 0.070648},
    {"C01", "DallaValle", 0.020, 0.103434}, {"C01", "DallaValle", 0.050, 0.126663},
    {"C03", "DallaValle", 0.005, 0.029075}, {"C03", "DallaValle", 0.020, 0.105371},
    {"C03", "DallaValle", 0.050, 0.192245}, {"C03", "DallaValle", 0.055, 0.199809},
    {"C05", "DallaValle", 0.005, 0.017703}, {"C05", "DallaValle", 0.010, 0.021812}
};

} // namespace

TEST(ImplicitDrag, exponentialWeightIsAccurateForAllSteps)
{
    for (double exponent = -15; exponent <= 5; exponent += 0.01)
    {
        const double k = std::pow(10, exponent);
        const long double K = k;
        // Long double leaves 19 digits, of which the closed form loses those of 1/k.
        const long double expected = K < 1e-3L ? K/2 + K*K/12 - K*K*K*K/720 : K/(-std::expm1(-K)) - 1;
        EXPECT_NEAR(double(closures::exponential(k)/expected), 1, 1e-14) << k;
    }
    EXPECT_EQ(closures::exponential(0), 0);
}

TEST(ImplicitDrag, splitGivesBackTheLinearSolution)
{
    const double mass = 2e-6, force = 3e-5, u = 0.4, v0 = -0.2;
    for (double k : {1e-6, 0.01, 0.1, 1.0, 30.0, 1e4})
    {
        const double dt = 1e-3, gamma = k*mass/dt;
        const double exact = u + force/gamma + (v0 - u - force/gamma)*std::exp(-k);
        const closures::DragSplit split = closures::splitDrag(gamma, mass, dt, closures::exponential);
        const double implicitForm =
            (mass*v0 + dt*(force + gamma*u - split.remainder*v0))/(mass + dt*split.implicit);
        EXPECT_NEAR(implicitForm, exact, 1e-13*std::max(1.0, 1/k*force*dt/mass)) << k;
        EXPECT_NEAR(split.implicit + split.remainder, gamma, 1e-15*gamma);
        EXPECT_GE(split.implicit, 0);
        EXPECT_GE(split.remainder, 0);

        const DragStep step = {{u, 0, 0}, {force, 0, 0}, mass, dt};
        EXPECT_NEAR(closures::velocityAfter(step, {v0, 0, 0}, gamma, closures::exponential).x(), implicitForm, 1e-13);
    }
}

TEST(ImplicitDrag, backwardEulerHasNoRemainder)
{
    const closures::DragSplit split = closures::splitDrag(7.0, 0.3, 0.01, closures::backwardEuler);
    EXPECT_NEAR(split.implicit, 7.0, 1e-14);
    EXPECT_NEAR(split.remainder, 0.0, 1e-14);
}

TEST(ImplicitDrag, slipIsMeasuredAsAVector)
{
    // u - v0 is 5 long, and a huge mass keeps it so.
    const DragState state = {closures::sphereSize(1e-3), 0, 1, 1000, 1e-3};
    const DragStep step = {{3, 0, 1}, Vector3d::Zero(), 1e9, 1e-3};
    const closures::DragLaw law = closures::findDragLaw("DallaValle").law;
    DragState at5 = state;
    at5.slip = 5;
    EXPECT_NEAR(closures::gammaAtMidSlip(law, state, step, {0, 4, 1}, closures::exponential)/law(at5), 1, 1e-9);
}

TEST(ImplicitDrag, gammaAtMidSlipByHand)
{
    const Fall fall = fallOf("C05", "DallaValle");
    const double u = 0.03, v0 = 0.02, dt = 2e-3;
    const DragStep step = {{u, 0, 0}, {fall.weight(), 0, 0}, fall.mass(), dt};
    const double k = fall.law(fall.state(u - v0))*dt/fall.mass();
    const double v1 = v0 + (dt*fall.weight()/fall.mass() + k*(u - v0))/(1 + k);
    const double expected = fall.law(fall.state(std::abs(u - (v0 + v1)/2)));
    const double got = closures::gammaAtMidSlip(fall.law, fall.state(0), step, {v0, 0, 0}, closures::backwardEuler);
    EXPECT_NEAR(got/expected, 1, 1e-13);
}

TEST(ImplicitDrag, tabulatedTransients)
{
    for (const auto& row : transients)
    {
        const Fall fall = fallOf(row.fall, row.law);
        EXPECT_NEAR(exactSpeed(fall, row.t)/row.speed, 1, 3e-5) << row.fall << " " << row.t;
        const double atMid = speedAt(fall, row.t, 1e-3, closures::exponential, true);
        EXPECT_NEAR(atMid/row.speed, 1, 1.5e-3) << row.fall << " " << row.law << " " << row.t;
    }
}

TEST(ImplicitDrag, lethesStepOfFiveMilliseconds)
{
    const Fall fall = fallOf("C03", "DallaValle");
    for (const auto& row : transients)
    {
        if (row.fall != std::string("C03")) continue;
        figures::expectNear("C03 DallaValle, " + figures::text(1e3*row.t) + " ms", "speed in steps of 5 ms [m/s]",
            speedAt(fall, row.t, 5e-3, closures::exponential, true), row.speed, 2e-3*row.speed);
        const double frozen = speedAt(fall, row.t, 5e-3, closures::exponential, false);
        EXPECT_GT(frozen/row.speed, 1.009) << "gamma from the start of the step should be 1 to 1.5 % fast";
    }
}

TEST(ImplicitDrag, backwardEulerIsPercentsOff)
{
    for (const auto& row : transients)
    {
        if (row.t != 0.005 || row.fall == std::string("C03")) continue;
        const double error = speedAt(fallOf(row.fall, row.law), row.t, 1e-3, closures::backwardEuler, false)/row.speed - 1;
        EXPECT_LT(error, -0.02);
        EXPECT_GT(error, -0.04);
    }
}

TEST(ImplicitDrag, secondOrderAtMidSlipAndFirstWithout)
{
    const Fall fall = fallOf("C05", "DallaValle");
    const double exact = exactSpeed(fall, 4e-3);
    const auto error = [&](double dt, bool atMidSlip)
    {
        return std::abs(speedAt(fall, 4e-3, dt, closures::exponential, atMidSlip) - exact);
    };
    EXPECT_NEAR(std::log2(error(1e-4, true)/error(5e-5, true)), 2, 0.15);
    EXPECT_NEAR(std::log2(error(1e-4, false)/error(5e-5, false)), 1, 0.15);
}

TEST(ImplicitDrag, terminalVelocityAtAnyStep)
{
    for (const char* name : {"C01", "C03", "C05"})
    {
        for (const char* law : {"Stokes", "SchillerNaumann", "DallaValle"})
        {
            const Fall fall = fallOf(name, law);
            const double terminal = fall.terminal();
            for (double ratio : {0.01, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4})
            {
                for (DragWeighting weighting : {closures::backwardEuler, closures::exponential})
                {
                    const int n = std::max(30, int(40/ratio));
                    const std::vector<double> v = speeds(fall, ratio*fall.stokesTime(), n, weighting, true);
                    EXPECT_NEAR(v.back()/terminal, 1, 1e-9) << name << " " << law << " " << ratio;
                    for (double speed : v) EXPECT_GT(speed, 0);
                }
            }
        }
    }
}

TEST(ImplicitDrag, linearDragReachesTerminalVelocityInOneLongStep)
{
    const Fall fall = fallOf("C05", "Stokes");
    const std::vector<double> v = speeds(fall, 1e4*fall.stokesTime(), 3, closures::exponential, true);
    for (double speed : v) EXPECT_NEAR(speed/fall.terminal(), 1, 1e-13);
}

TEST(ImplicitDrag, wordsForTheWeighting)
{
    EXPECT_EQ(closures::findDragWeighting("backwardEuler"), closures::backwardEuler);
    EXPECT_EQ(closures::findDragWeighting("exponential"), closures::exponential);
    EXPECT_THROW(closures::findDragWeighting("trapezoidal"), std::invalid_argument);
}
