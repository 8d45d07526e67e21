// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Moments of contact forces on grains, and the field that follows from them.
#include "functionObjects/contactStress.H"

#include "functionObjects/cellFields.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(ContactStress, 0);
addToRunTimeSelectionTable(functionObject, ContactStress, dictionary);

namespace
{

const word fieldName = "contactStress.grains";

/// arm force^T, row by row [N m].
nscdCoupling::TensorForGrain momentOf(std::int64_t id, const ::nscd::Vec3& arm, const ::nscd::Vec3& force)
{
    nscdCoupling::TensorForGrain moment{id, {}};
    for (int a = 0; a < 3; ++a)
    {
        for (int b = 0; b < 3; ++b) moment.value[std::size_t(3*a + b)] = arm[a]*force[b];
    }
    return moment;
}

/// Each contact's part of both of its grains, or of the one at a wall.
std::vector<nscdCoupling::TensorForGrain> momentsOf(const std::vector<::nscd::ShownContact>& contacts)
{
    std::vector<nscdCoupling::TensorForGrain> moments;
    for (const ::nscd::ShownContact& contact : contacts)
    {
        moments.push_back(momentOf(contact.idA, contact.centerA - contact.point, contact.force));
        if (!contact.isWithWall()) moments.push_back(momentOf(contact.idB, contact.centerB - contact.point, -contact.force));
    }
    return moments;
}

} // namespace


ContactStress::ContactStress(const word& name, const Time& runTime, const dictionary& dict)
:
    GrainObject(name, runTime, dict)
{
    read(dict);
    requireFluid(dict);
    followContactsToExecute(dict);
    execute();
}


bool ContactStress::execute()
{
    const std::vector<scalarField> sums = access().perVolume(access().sumsOfOwned(momentsOf(access().contacts())));
    volTensorField& stress = registered<tensor>(mesh_, fieldName, dimPressure);
    forAll(stress, cell) stress[cell] = valueOf<tensor>(sums, 0, cell);
    stress.correctBoundaryConditions();
    return true;
}


bool ContactStress::write() { return !isWriteDue() || writeObject(fieldName); }

} // namespace functionObjects
} // namespace Foam
