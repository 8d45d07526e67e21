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

constexpr scalar deltaT = 5e-3;

/// A suspension with its drag linearized and the velocities that free grains get.
struct FreeGrains
{
    RandomSuspension random;
    const ::nscd::Grains& grains = random.grains;
    std::vector<Vec3> force;
    LinearDrag drag;
    ::nscd::ExternalForces external;
    ::nscd::Prediction prediction;

    explicit FreeGrains(const std::string& settings = "")
    {
        const GrainForces forces(forcesOf(settings), spheresInFluid);
        force = forces.explicitForces(random.inputs(), {});
        drag = forces.linearize(random.inputs(), {force, random.lastContactForce, deltaT});
        external = forces.external(random.inputs(), force, drag);
        external.speedScale = 0.3;
        prediction = freePrediction(grains, external, deltaT);
    }

    GrainResponse response(const std::vector<scalar>& mobility, bool feelsPressure = true) const
    {
        return contactAwareResponse(grains, drag, random.at, prediction, mobility, feelsPressure, deltaT);
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
        const Vec3 given = deltaT*(free.force[i] + free.drag.implicit[i]*(u - v1) + free.drag.remainder[i]*(u - v0));
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
    other.prediction = freePrediction(other.grains, other.external, deltaT);

    const GrainResponse response = free.response(std::vector<scalar>(free.size(), 1.0));
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
    const GrainResponse response = grains.response(std::vector<scalar>(grains.size(), 0.0));
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
    const GrainResponse response = grains.response(std::vector<scalar>(grains.size(), 1.0), false);
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
    const TrialPush push = makeTrialPush(grains.grains, grains.force, grains.drag, grains.random.at, grains.external, deltaT);
    EXPECT_EQ(push.speed, 0.1*0.3);
    const ::nscd::Prediction pushed = freePrediction(grains.grains, push.external, deltaT);
    for (std::size_t i = 0; i + 1 < grains.size(); ++i)
    {
        const Vec3 change = pushed.velocity[i] - grains.prediction.velocity[i];
        EXPECT_LT((change - push.speed*push.direction[i]).norm(), 1e-12) << i;
        const scalar gamma = grains.drag.implicit[i] + grains.drag.remainder[i];
        EXPECT_GT(push.direction[i].dot(gamma*(grains.random.at.velocity[i] - grains.grains.velocity[i]) - grains.force[i]), 0);
    }
    EXPECT_EQ(followedShare(push, grains.force, grains.prediction, pushed), std::vector<scalar>(grains.size(), 1.0));
}

TEST(DragResponse, theShareFollowedIsBoundedByWhatContactsBear)
{
    TrialPush push;
    push.direction.assign(6, Vec3::UnitX());
    push.speed = 0.01;
    const std::vector<Vec3> force(6, Vec3(0, 2, 0));
    ::nscd::Prediction before, after;
    before.velocity.assign(6, Vec3(1, 1, 1));
    before.contactForce = {{0, 0, 0}, {0, 0, 0}, {0, -2, 0}, {0, -0.5, 0}, {0, -0.5, 0}, {0, -3, 0}};
    after = before;
    after.contactForce[1] = Vec3(1, 0, 0);
    // Free; met by a contact; held whole; half followed; more than followed; borne by others' weight on it.
    const std::vector<scalar> followed = {5, 0.25, 1, 0.5, 3, 1};
    for (std::size_t i = 0; i < 6; ++i) after.velocity[i].x() += followed[i]*push.speed;
    const std::vector<scalar> share = followedShare(push, force, before, after), expected = {1, 0.25, 0, 0.5, 0.75, 0};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(share[i], expected[i], 1e-13) << i;
    push.speed = 0;
    EXPECT_EQ(followedShare(push, force, before, after), std::vector<scalar>(6, 1.0)) << "no push, as without any force";
}
