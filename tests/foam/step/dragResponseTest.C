// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The response of grains to the fluid: free and held ones against closed forms.
#include "coupling/step/dragResponse.H"
#include "stepTools.H"

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// A suspension with its drag linearized and the velocities that free grains get.
struct FreeGrains
{
    RandomSuspension random;
    const ::nscd::Grains& grains = random.grains;
    std::vector<Vec3> force;
    LinearDrag drag;
    ::nscd::ExternalForces external;
    ::nscd::Prediction prediction;

    scalar deltaT;

    explicit FreeGrains(scalar step = 5e-3) : deltaT(step)
    {
        const GrainForces forces(forcesOf(""), spheresInFluid);
        force = forces.explicitForces(random.inputs(), {});
        drag = forces.linearize(random.inputs(), {force, random.lastContactForce, deltaT});
        external = forces.external(random.inputs(), force, drag);
        external.speedScale = 0.3;
        prediction = freePrediction(grains, external, deltaT);
    }

    GrainResponse response(const Mobility& mobility, bool feelsPressure = true) const
    {
        return contactAwareResponse(random.inputs(), drag, prediction, std::vector<Mobility>(size(), mobility), feelsPressure, deltaT);
    }
    std::size_t size() const { return grains.size(); }
};

} // namespace

TEST(DragResponse, freeGrainsAreSolvedForInClosedForm)
{
    const FreeGrains free;
    for (std::size_t i = 0; i < free.size(); ++i)
    {
        const Vec3 v0 = free.grains.velocity[i], v1 = free.prediction.velocity[i], u = free.random.at.velocity[i];
        EXPECT_EQ(free.prediction.contactForce[i], Vec3(Vec3::Zero()));
        if (free.grains.isFixed[i])
        {
            EXPECT_EQ(v1, v0);
            continue;
        }
        const Vec3 given = free.deltaT*(free.force[i] + free.drag.implicit[i]*(u - v1) + free.drag.remainder[i]*(u - v0));
        EXPECT_LT((free.grains.mass[i]*(v1 - v0) - given).norm(), 1e-13*given.norm());
    }
}

TEST(DragResponse, isWhatFreeGrainsDoWithAnotherFluid)
{
    // v* is linear, and exact for free grains: predict them with another velocity and pressure gradient, and compare.
    const FreeGrains free;
    FreeGrains other;
    RandomNumbers random(9);
    other.random.at.velocity = random.vecs(free.size());
    other.random.at.pressureGradient = random.vecs(free.size());
    const GrainForces forces(forcesOf(""), spheresInFluid);
    other.external = forces.external(other.random.inputs(), forces.explicitForces(other.random.inputs(), {}), free.drag);
    other.prediction = freePrediction(other.grains, other.external, other.deltaT);

    const GrainResponse response = free.response({1, false});
    EXPECT_FALSE(response.isZero);
    for (std::size_t i = 0; i < free.size(); ++i)
    {
        const Vec3 v = respondedVelocity(response, i, other.random.at.velocity[i], other.random.at.pressureGradient[i]);
        EXPECT_LT((v - other.prediction.velocity[i]).norm(), 1e-13) << i;
    }
}

TEST(DragResponse, heldGrainsAnswerNothing)
{
    const FreeGrains grains;
    const GrainResponse response = grains.response({0, true});
    EXPECT_TRUE(response.isZero);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        EXPECT_EQ(response.slip[i], 0);
        EXPECT_EQ(response.mobility[i], 0);
        EXPECT_EQ(response.intercept[i], grains.prediction.velocity[i]);
    }
}

TEST(DragResponse, leavesThePressureOutWhereGrainsDoNotFeelIt)
{
    const FreeGrains grains;
    const GrainResponse response = grains.response({1, false}, false);
    for (std::size_t i = 0; i < grains.size(); ++i) EXPECT_EQ(response.mobility[i], 0);
    const GrainResponse lagged = laggedResponse(grains.grains);
    EXPECT_TRUE(lagged.isZero);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        EXPECT_EQ(respondedVelocity(lagged, i, Vec3(1, 2, 3), Vec3(4, 5, 6)), grains.grains.velocity[i]);
    }
}

TEST(DragResponse, aFreeGrainFollowsTheTrialPushWhole)
{
    const FreeGrains grains;
    const TrialPush push = makeTrialPush(grains.grains, grains.force, grains.drag, grains.random.at, grains.external, grains.deltaT);
    EXPECT_EQ(push.speed, 0.1*0.3);
    const ::nscd::Prediction pushed = freePrediction(grains.grains, push.external, grains.deltaT);
    for (std::size_t i = 0; i + 1 < grains.size(); ++i)
    {
        const Vec3 change = pushed.velocity[i] - grains.prediction.velocity[i];
        EXPECT_LT((change - push.speed*push.direction[i]).norm(), 1e-12) << i;
        const scalar gamma = grains.drag.implicit[i] + grains.drag.remainder[i];
        EXPECT_GT(push.direction[i].dot(gamma*(grains.random.at.velocity[i] - grains.grains.velocity[i]) - grains.force[i]), 0);
    }
    for (const Mobility& mobility : mobilities(push, grains.prediction, pushed))
    {
        EXPECT_EQ(mobility.share, 1);
        EXPECT_FALSE(mobility.isTouched);
    }
}

TEST(DragResponse, mobilityIsTheShareOfThePushThatATouchedGrainFollows)
{
    TrialPush push;
    push.direction.assign(5, Vec3::UnitX());
    push.speed = 0.01;
    ::nscd::Prediction before, after;
    before.velocity.assign(5, Vec3(1, 1, 1));
    before.contactForce = {{0, 0, 0}, {0, 0, 0}, {0, -2, 0}, {0, -0.5, 0}, {0, -3, 0}};
    after = before;
    after.contactForce[1] = Vec3(1, 0, 0);
    // Free; met by a contact; half followed; more than followed; turned back.
    const std::vector<scalar> followed = {5, 0.25, 0.5, 3, -1}, expected = {1, 0.25, 0.5, 1, 0};
    for (std::size_t i = 0; i < 5; ++i) after.velocity[i].x() += followed[i]*push.speed;
    const std::vector<Mobility> found = mobilities(push, before, after);
    for (std::size_t i = 0; i < 5; ++i)
    {
        EXPECT_NEAR(found[i].share, expected[i], 1e-13) << i;
        EXPECT_EQ(found[i].isTouched, i > 0) << i;
    }
    push.speed = 0;
    for (const Mobility& mobility : mobilities(push, before, after)) EXPECT_EQ(mobility.share, 1) << "no push, as without any force";
}

namespace
{

/// A layer of grains like grain i and the fluid between them, along one direction without a pressure gradient. In the trial the
/// grain followed its push, but its neighbors hold it against all that comes. Speeds of the fluid, one a step, from 1.
/// Equation: m (u1 - u0) + implicit dt (u1 - v*(u1)) + remainder dt u1 = repaidShare debt
std::vector<scalar> speedsAroundHeldGrain(FreeGrains& grains, std::size_t i, label steps)
{
    const scalar implicit = grains.drag.implicit[i]*grains.deltaT, remainder = grains.drag.remainder[i]*grains.deltaT;
    const scalar alpha = grains.random.at.fluidFraction[i], fluid = 1000*alpha/(1 - alpha)*grains.grains.volume(i);
    std::vector<scalar> u = {1};
    scalar debt = 0;
    grains.prediction.velocity[i].setZero();
    for (label step = 0; step < steps; ++step)
    {
        grains.random.at.velocity[i] = u.back()*Vec3::UnitX();
        const GrainResponse response = grains.response({1, true}, false);
        const scalar a = response.intercept[i].x(), s = response.slip[i];
        u.push_back((fluid*u.back() + implicit*a + repaidShare*debt)/(fluid + implicit*(1 - s) + remainder));
        debt -= repaidShare*debt + implicit*(a + s*u.back());
    }
    return u;
}

} // namespace

TEST(DragResponse, fluidComesToRestAmongTouchedGrainsThatDoNotGiveWay)
{
    for (const scalar deltaT : {1.0, 100.0, 1e4})
    {
        FreeGrains grains(deltaT);
        for (std::size_t i = 0; i + 1 < grains.size(); ++i)
        {
            const std::vector<scalar> u = speedsAroundHeldGrain(grains, i, 60);
            EXPECT_LT(*std::max_element(u.begin(), u.end(), [](scalar a, scalar b) { return mag(a) < mag(b); }), 1.5) << deltaT << ' ' << i;
            EXPECT_LT(mag(u.back()), 1e-3) << deltaT << ' ' << i;
        }
    }
}

TEST(DragResponse, onlyTouchedGrainsFollowTheFluidLess)
{
    const FreeGrains grains(100);
    const GrainResponse free = grains.response({1, false}), touched = grains.response({1, true});
    for (std::size_t i = 0; i + 1 < grains.size(); ++i)
    {
        EXPECT_GT(free.slip[i], 0.9);
        EXPECT_NEAR(touched.slip[i], looseSlip, 0.1*looseSlip) << "the fluid's own momentum is small beside such a drag";
        EXPECT_EQ(free.mobility[i], touched.mobility[i]);
    }
}
