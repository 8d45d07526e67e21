// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Gathering the contacts of all ranks, and writing them by the first.
#include "functionObjects/contactForces.H"

#include "coupling/case/files/writtenFiles.H"
#include "coupling/case/input/inputError.H"

#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"

#include <stdexcept>

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(ContactForces, 0);
addToRunTimeSelectionTable(functionObject, ContactForces, dictionary);

namespace
{

using ::nscd::ShownContact;
using ::nscd::Vec3;

/// Numbers of a contact in a message: two identities, which are below 2^53, six vectors, gap and state.
constexpr label nNumbers = 22;

void pack(const ShownContact& contact, DynamicList<scalar>& numbers)
{
    numbers.append(scalar(contact.idA));
    numbers.append(scalar(contact.idB));
    for (const Vec3& v : {contact.centerA, contact.centerB, contact.point, contact.normal, contact.impulse, contact.force})
    {
        for (int k = 0; k < 3; ++k) numbers.append(v[k]);
    }
    numbers.append(contact.gap);
    numbers.append(scalar(int(contact.state)));
}

ShownContact unpacked(const scalar* n)
{
    return
    {
        std::int64_t(n[0]), std::int64_t(n[1]), Vec3(n + 2), Vec3(n + 5), Vec3(n + 8), Vec3(n + 11), n[20], Vec3(n + 14), Vec3(n + 17),
        ::nscd::ContactState(int(n[21]))
    };
}

/// Those of all ranks, on the master.
std::vector<ShownContact> gathered(const std::vector<ShownContact>& here)
{
    if (!Pstream::parRun()) return here;
    DynamicList<scalar> numbers(nNumbers*label(here.size()));
    for (const ShownContact& contact : here) pack(contact, numbers);
    List<List<scalar>> ofRanks(Pstream::nProcs());
    ofRanks[Pstream::myProcNo()] = numbers;
    Pstream::gatherList(ofRanks);
    std::vector<ShownContact> all;
    if (!Pstream::master()) return all;
    for (const List<scalar>& part : ofRanks)
    {
        for (label k = 0; k < part.size(); k += nNumbers) all.push_back(unpacked(part.cdata() + k));
    }
    return all;
}

} // namespace


ContactForces::ContactForces(const word& name, const Time& runTime, const dictionary& dict)
:
    GrainObject(name, runTime, dict),
    folder_(time_.globalPath()/"postProcessing"/name),
    contacts_(folder_/"contacts.pvd"),
    forceChains_(folder_/"forceChains.pvd")
{
    read(dict);
    followContactsToWrite(dict);
    if (!Pstream::master()) return;
    for (::nscd::VtkSeries* series : {&contacts_, &forceChains_})
    {
        try { series->readUpTo(time_.value()); }
        // OpenFOAM would go on without the function object after a FatalError here.
        catch (const std::runtime_error& error) { nscdCoupling::fail({nscdCoupling::placeOf(dict), error.what()}); }
    }
}


void ContactForces::writeFiles(const std::vector<ShownContact>& contacts)
{
    const std::string time = time_.timeName();
    mkDir(folder_/time);
    ::nscd::writeContactPoints(folder_/time/"contacts.vtp", time_.value(), contacts);
    ::nscd::writeForceChains(folder_/time/"forceChains.vtp", time_.value(), contacts);
    contacts_.add(time_.value(), time + "/contacts.vtp");
    forceChains_.add(time_.value(), time + "/forceChains.vtp");
}


bool ContactForces::write()
{
    if (!isWriteDue()) return true;
    std::vector<ShownContact> contacts = gathered(access().contacts());
    if (!Pstream::master()) return true;
    ::nscd::sortByIdentity(contacts);
    try { writeFiles(contacts); }
    catch (const std::runtime_error& error) { nscdCoupling::refuseUnwritten(folder_, error.what()); }
    return true;
}

} // namespace functionObjects
} // namespace Foam
