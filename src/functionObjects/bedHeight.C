// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Heights of all ranks' grains, on the first rank.
#include "functionObjects/bedHeight.H"

#include "functionObjects/functionEntries.H"

#include "addToRunTimeSelectionTable.H"

#include <algorithm>

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(BedHeight, 0);
addToRunTimeSelectionTable(functionObject, BedHeight, dictionary);

namespace
{

constexpr scalar usualShare = 0.95;

/// Height [m] and mass [kg] of a grain.
using HeightAndMass = Tuple2<scalar, scalar>;

/// Those of all ranks' grains, on the master.
List<HeightAndMass> gatherHeights(const ::nscd::Grains& grains, const nscdCoupling::Plane& floor)
{
    const ::nscd::Vec3 up = floor.normal.normalized();
    List<List<HeightAndMass>> ofRanks(Pstream::nProcs());
    List<HeightAndMass>& here = ofRanks[Pstream::myProcNo()];
    here.setSize(label(grains.nOwned));
    forAll(here, i) here[i] = HeightAndMass(up.dot(grains.position[i] - floor.point), grains.mass[i]);
    Pstream::gatherList(ofRanks);
    List<HeightAndMass> all;
    for (const List<HeightAndMass>& part : ofRanks) all.append(part);
    return all;
}

scalar massOf(const List<HeightAndMass>& grains)
{
    scalar mass = 0;
    for (const HeightAndMass& grain : grains) mass += grain.second();
    return mass;
}

scalar twiceMean(const List<HeightAndMass>& grains)
{
    scalar sum = 0;
    for (const HeightAndMass& grain : grains) sum += grain.first()*grain.second();
    return grains.empty() ? 0 : 2*sum/massOf(grains);
}

scalar heightOfShare(List<HeightAndMass> grains, scalar share)
{
    std::sort(grains.begin(), grains.end());
    const scalar wanted = share*massOf(grains);
    scalar below = 0;
    for (const HeightAndMass& grain : grains)
    {
        below += grain.second();
        if (below >= wanted) return grain.first();
    }
    // Where round-off leaves the sum below a share of 1.
    return grains.empty() ? 0 : grains.last().first();
}

} // namespace


BedHeight::BedHeight(const word& name, const Time& runTime, const dictionary& dict)
:
    GrainTable(name, runTime, dict, typeName)
{
    read(dict);
    writeHead("Heights of grains above the floor [m]", {"twiceMean", "share"});
}


bool BedHeight::read(const dictionary& dict)
{
    nscdCoupling::readFunction(dict, [this](const input::CheckedEntries& entries)
    {
        floor_ = nscdCoupling::readPlane(entries.sub("floor"));
        share_ = entries.number("share", input::between(0, 1), usualShare);
    });
    return GrainTable::read(dict);
}


bool BedHeight::write()
{
    const List<HeightAndMass> grains = gatherHeights(access().grains(), floor_);
    if (!hasFile()) return true;
    writeCurrentTime(file());
    file() << tab << twiceMean(grains) << tab << heightOfShare(grains, share_) << endl;
    return true;
}

} // namespace functionObjects
} // namespace Foam
