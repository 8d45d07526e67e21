// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Tests of contactStress on meshes in memory, with contacts that are made up: sums by brute force, and contacts and grains on any rank.
#include "functionObjects/contactStress.H"

#include "caseTools.H"
#include "coupling/step/grainHomes.H"
#include "mappingTools.H"
#include "ranksMesh.H"
#include "functionObjects/shownGrains.H"

#include "parallel/mpiExchange.hpp"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::nscdCoupling;
using namespace Foam::nscdCoupling::testing;
using ::nscd::ShownContact;

namespace
{

const labelVector nCells(6, 5, 8);
const std::size_t nGrains = 120;

::nscd::Grains grainsAnywhere()
{
    const std::vector<Vec3> positions = randomPoints(nGrains, Vec3(0.5, 0.5, 0.5), Vec3(5.5, 4.5, 7.5));
    ::nscd::Grains grains;
    for (std::size_t i = 0; i < nGrains; ++i) grains.add(positions[i], 0.2 + 0.001*scalar(i), 2500, 0, std::int64_t(3*i));
    return grains;
}

/// Forces of any direction between grains far from one another, and of every fifth one with a wall below it.
std::vector<ShownContact> contactsAnywhere(const ::nscd::Grains& grains)
{
    const std::vector<Vec3> forces = randomPoints(nGrains, Vec3::Constant(-3), Vec3::Constant(3), 2);
    std::vector<ShownContact> contacts;
    for (std::size_t i = 0; i + 7 < nGrains; ++i)
    {
        ShownContact contact{};
        const bool isWithWall = i % 5 == 0;
        contact.idA = grains.id[i];
        contact.idB = isWithWall ? -2 : grains.id[i + 7];
        contact.centerA = grains.position[i];
        contact.centerB = isWithWall ? Vec3(grains.position[i] - Vec3(0, 0, 0.3)) : grains.position[i + 7];
        contact.point = isWithWall ? contact.centerB : Vec3(0.3*contact.centerA + 0.7*contact.centerB);
        contact.force = forces[i];
        contacts.push_back(contact);
    }
    return contacts;
}

/// What contactStress makes of contacts and grains on a mesh.
struct StressOf : ShownGrains
{
    StressOf
    (
        const fvMesh& fvMesh, const ::nscd::Grains& own, const std::vector<ShownContact>& contacts, const dictionary& dict,
        const GrainsAtHome& atHome = GrainsAtHome(), const ::nscd::Communicator* all = nullptr
    )
    :
        ShownGrains(fvMesh, own, dict, atHome)
    {
        if (all) access.showRanks(*all);
        access.recordContacts(contacts);
        functionObjects::ContactStress("stress", mesh.time(), dictionaryOf("type contactStress;"));
    }

    const tensorField& field() const { return mesh.lookupObject<volTensorField>("contactStress.grains").primitiveField(); }
};

tensor branchTimesForce(const std::vector<ShownContact>& contacts)
{
    tensor sum = Zero;
    for (const ShownContact& contact : contacts) sum += toFoam(contact.centerA - contact.centerB)*toFoam(contact.force);
    return sum;
}

dictionary looseDict(const word& method) { return mappingDict(method, 0, 0.001); }

} // namespace

TEST(ContactStress, hasTheIntegralOfBranchTimesForce)
{
    for (const dictionary& dict : {looseDict("exact"), looseDict("centroid"), mappingDict("exact", 2, 0.5)})
    {
        BoxMesh box(unitCells(nCells));
        const ::nscd::Grains grains = grainsAnywhere();
        const std::vector<ShownContact> contacts = contactsAnywhere(grains);
        const StressOf stress(box.mesh(), grains, contacts, dict);
        const tensor expected = branchTimesForce(contacts), found = gSum(tensorField(box.mesh().V()*stress.field()));
        EXPECT_LT(mag(found - expected), 1e-11*mag(expected)) << mag(found);
        EXPECT_GT(mag(expected), 10);
    }
}

TEST(ContactStress, isSpreadAsTheVolumeOfEachGrain)
{
    BoxMesh box(unitCells(nCells));
    const ::nscd::Grains grains = grainsAnywhere();
    const std::vector<ShownContact> contacts = contactsAnywhere(grains);
    const StressOf stress(box.mesh(), grains, contacts, looseDict("exact"));
    std::vector<tensor> ofGrain(nGrains, tensor::zero);
    for (const ShownContact& c : contacts)
    {
        ofGrain[std::size_t(c.idA/3)] += toFoam(c.centerA - c.point)*toFoam(c.force);
        if (c.idB >= 0) ofGrain[std::size_t(c.idB/3)] += toFoam(c.point - c.centerB)*toFoam(c.force);
    }
    forAll(stress.field(), cell)
    {
        tensor expected = Zero;
        for (std::size_t i = 0; i < nGrains; ++i) expected += shareIn(stress.mapping->weights(), label(i), cell)*ofGrain[i];
        EXPECT_LT(mag(stress.field()[cell] - expected), 1e-11) << cell;
    }
}

TEST(ContactStress, leavesOutGrainsThatAreGone)
{
    BoxMesh box(unitCells(nCells));
    const ::nscd::Grains grains = grainsAnywhere();
    std::vector<ShownContact> contacts = contactsAnywhere(grains);
    for (ShownContact& contact : contacts) contact.idA = 1;   // nobody's
    const StressOf stress(box.mesh(), grains, contacts, looseDict("exact"));
    tensor expected = Zero;
    for (const ShownContact& c : contacts) if (c.idB >= 0) expected += toFoam(c.point - c.centerB)*toFoam(c.force);
    EXPECT_LT(mag(gSum(tensorField(box.mesh().V()*stress.field())) - expected), 1e-11*mag(expected));
}

TEST(contactStressRanks, isThatOfOneRank)
{
    if (!Pstream::parRun()) GTEST_SKIP() << "on several ranks";
    RanksMesh mesh(unitCells(nCells), blocks());
    const ::nscd::Grains all = grainsAnywhere();
    const std::vector<ShownContact> allContacts = contactsAnywhere(all);
    // Grains are dealt out to ranks as cards are, and contacts otherwise: some rank has a contact of two grains of others.
    const std::size_t me = std::size_t(Pstream::myProcNo()), n = std::size_t(Pstream::nProcs());
    ::nscd::Grains own;
    for (std::size_t i = me; i < all.size(); i += n) own.add(all.position[i], all.radius[i], 2500, 0, all.id[i]);
    std::vector<ShownContact> contacts;
    for (std::size_t c = 0; c < allContacts.size(); ++c) if ((c/3) % n == me) contacts.push_back(allContacts[c]);
    const ::nscd::MpiExchange exchange;
    GrainHomes homes(mesh.part(), exchange.tree(), findHomeIn(mesh.part()));
    GrainsAtHome atHome(exchange.tree());
    atHome.update(own, homes.update(own), MappedBodies());
    const StressOf here(mesh.part(), own, contacts, looseDict("exact"), atHome, &exchange.tree().all());

    const SerialSection serial;
    const StressOf whole(mesh.whole(), all, allContacts, looseDict("exact"));
    EXPECT_LT(max(mag(here.field() - mesh.partOf(whole.field()))), 1e-11);
    EXPECT_GT(max(mag(whole.field())), 1);
}
