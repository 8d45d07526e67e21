// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of force fields on the grains: means of functions over a step, fields where the grains are, what is refused.
#include "fluidCase.H"
#include "mappingTools.H"
#include "stepTools.H"

#include "coupling/step/forceField.H"

#include <cmath>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;

namespace
{

/// Grains of several sizes in a box of 4 x 4 x 4 m, with a field a = (x, 2 y, 3 z) of some unit.
struct GrainsInField
{
    BoxMesh box;
    ::nscd::Grains grains;
    GrainMapping mapping;

    static BoxMeshSettings settings()
    {
        BoxMeshSettings settings;
        settings.cells = labelVector(4, 4, 4);
        settings.max = point(4, 4, 4);
        return settings;
    }

    GrainsInField() : box(settings()), mapping(box.mesh(), mappingDict("centroid"), 0.4)
    {
        for (int k = 0; k < 4; ++k) grains.add(Vec3(0.5 + k, 3.5 - k, 1.5), 0.1*(k + 1), 2500, 0, k);
        mapping.update(grains, ::nscd::PeriodicBox());
    }

    void addField(const word& name, const dimensionSet& dimensions)
    {
        const IOobject file(name, box.time().timeName(), box.mesh(), IOobject::NO_READ, IOobject::NO_WRITE);
        volVectorField* field = new volVectorField(file, box.mesh(), dimensionedVector(name, dimensions, Zero));
        forAll(*field, i) (*field)[i] = cmptMultiply(vector(1, 2, 3), box.mesh().C()[i]);
        regIOobject::store(field);
    }

    std::vector<Vec3> forces(const std::string& text, scalar begin = 0, scalar end = 1)
    {
        settings_ = forcesOf("field { " + text + " }").field;
        return ForceField(settings_, box.mesh()).onGrains(grains, begin, end, &mapping, &atHome_);
    }

private:
    FieldSettings settings_;
    GrainsAtHome atHome_;
};

} // namespace

TEST(ForceField, isTheMeanOfItsFunctionsOverTheStep)
{
    GrainsInField all;
    const std::string functions = "acceleration table ((0 (0 0 0)) (1 (0 0 8))); forceDensity { type sine; frequency 1; amplitude 3; scale (1 0 0); level (0 5 0); }";
    const std::vector<Vec3> force = all.forces(functions, 0.25, 0.75);
    for (std::size_t i = 0; i < force.size(); ++i)
    {
        const Vec3 expected = all.grains.mass[i]*Vec3(0, 0, 4) + all.grains.volume(i)*Vec3(0, 5, 0);
        EXPECT_LT((force[i] - expected).norm(), 1e-10*expected.norm()) << i;
    }
    // A ramp that ends within the step: the mean of 6 to 8 over half of it, and 8 after.
    EXPECT_NEAR(all.forces("acceleration table ((0 (0 0 0)) (1 (0 0 8)));", 0.75, 1.25)[0].z()/all.grains.mass[0], 7.5, 1e-9);
}

TEST(ForceField, isWhatItsFieldsAreWhereTheGrainIs)
{
    GrainsInField all;
    all.addField("push", dimAcceleration);
    all.addField("magnetic", dimForce/dimVolume);
    const std::vector<Vec3> push = all.forces("fields push;"), both = all.forces("fields (push magnetic); acceleration (1 0 0);");
    for (std::size_t i = 0; i < push.size(); ++i)
    {
        const Vec3 here = all.grains.position[i].cwiseProduct(Vec3(1, 2, 3));
        EXPECT_LT((push[i] - all.grains.mass[i]*here).norm(), 1e-12*push[i].norm()) << i;
        const Vec3 expected = all.grains.mass[i]*(here + Vec3(1, 0, 0)) + all.grains.volume(i)*here;
        EXPECT_LT((both[i] - expected).norm(), 1e-12*expected.norm()) << i;
    }
}

/// On, it is one force more, and the only one without weight and fluid.
TEST(ForceField, isARowThatIsOffUnlessNamed)
{
    RandomSuspension grains;
    grains.at.applied = RandomNumbers(5).vecs(grains.size());
    const ForceConditions dry{false, true, true};
    const GrainForces without(forcesOf(""), dry), with(forcesOf("field { acceleration (1 0 0); }"), dry);
    EXPECT_FALSE(forcesOf("").isOn("field"));
    const std::vector<Vec3> weight = without.explicitForces(grains.inputs(), {}), all = with.explicitForces(grains.inputs(), {});
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_LT((all[i] - weight[i] - grains.at.applied[i]).norm(), 1e-15) << i;
    EXPECT_EQ(with.readsAtStart(), reads::nothing);
}

TEST(ForceField, refusesWhatIsNoField)
{
    GrainsInField all;
    all.addField("speed", dimVelocity);
    const auto says = [&](const std::string& text, const std::vector<std::string>& pieces)
    {
        return holds(complaint([&] { all.forces(text); }), pieces);
    };
    EXPECT_TRUE(says("fields (speed);", {"forces.field.fields", "of other dimensions: speed", "[0 1 -2 0 0 0 0]", "file: constant/grainProperties"}));
    EXPECT_TRUE(says("fields (nowhere);", {"forces.field.fields", "names a field that is not there", "nowhere", "file: constant/grainProperties"}));
    EXPECT_TRUE(says("fields ();", {"forces.field.fields", "names none"}));
    EXPECT_TRUE(says("fields (2);", {"forces.field.fields", "is no list of names"}));
    EXPECT_TRUE(says("", {"forces.field", "says nothing", "acceleration"}));
    EXPECT_TRUE(says("aceleration (0 0 1);", {"aceleration", "nearest: acceleration"}));
    EXPECT_TRUE(says("acceleration wind;", {"forces.field.acceleration", "is no function of time"}));
}
