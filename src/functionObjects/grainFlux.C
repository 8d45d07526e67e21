// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Counting, and going on with the counts of a written time.
#include "functionObjects/grainFlux.H"

#include "functionObjects/functionEntries.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(GrainFlux, 0);
addToRunTimeSelectionTable(functionObject, GrainFlux, dictionary);

namespace
{

word planeProperty(const word& name) { return "plane." + name; }
word exitProperty(const word& name) { return "exit." + name; }

/// Adds what all ranks counted.
void addOfRanks(scalarList& total, scalarList counted)
{
    Pstream::listCombineGather(counted, plusEqOp<scalar>());
    Pstream::listCombineScatter(counted);
    forAll(total, k) total[k] += counted[k];
}

/// The first half are numbers, whole ones with all digits, the others masses.
void writeTotals(Ostream& os, const scalarList& total)
{
    forAll(total, k)
    {
        os << tab;
        if (2*k < total.size()) os << std::int64_t(total[k]);
        else os << total[k];
    }
}

} // namespace


GrainFlux::GrainFlux(const word& name, const Time& runTime, const dictionary& dict)
:
    GrainTable(name, runTime, dict, typeName)
{
    read(dict);
    // What left while a written time was read is of no step.
    if (runTime.timeIndex() == runTime.startTimeIndex()) countExits();
    remember();
}


bool GrainFlux::read(const dictionary& dict)
{
    nscdCoupling::readFunction(dict, [this](const input::CheckedEntries& entries)
    {
        nscdCoupling::requireEveryStep(entries);
        readPlanes(entries);
        readExits(entries);
    });
    if (!planes_.empty()) access().followMoves();
    const bool isRead = GrainTable::read(dict);
    writeHead("Grains through planes and exits since the case began: numbers and masses [kg]", columns());
    return isRead;
}


void GrainFlux::readPlanes(const input::CheckedEntries& entries)
{
    planes_.clear();
    const input::Dictionary planes = entries.subOrEmpty("planes");
    const input::CheckedEntries named(planes);
    for (const input::Entry& entry : planes.entries)
    {
        planes_.push_back({entry.keyword, nscdCoupling::readPlane(named.sub(entry.keyword)), recalled(planeProperty(entry.keyword), 4)});
    }
    named.finish();
}


void GrainFlux::readExits(const input::CheckedEntries& entries)
{
    exits_.clear();
    input::Words names;
    for (const label patch : access().roles().ofRole(nscdCoupling::PatchRole::exit)) names.push_back(mesh_.boundaryMesh()[patch].name());
    for (const word name : entries.choices("exits", names, names))
    {
        exits_.push_back({name, mesh_.boundaryMesh().findPatchID(name), recalled(exitProperty(name), 2)});
    }
}


scalarList GrainFlux::recalled(const word& property, label size) const
{
    scalarList total(size, scalar(0));
    getProperty(property, total);
    Pstream::scatter(total);
    return total;
}


void GrainFlux::countMoves()
{
    for (PlaneFlux& flux : planes_)
    {
        scalarList counted(4, scalar(0));
        for (const nscdCoupling::GrainMove& move : access().moves())
        {
            const int sign = nscdCoupling::crossing(flux.plane, move.from, move.to, access().box());
            if (sign == 0) continue;
            counted[sign > 0 ? 0 : 1] += 1;
            counted[sign > 0 ? 2 : 3] += move.mass;
        }
        addOfRanks(flux.total, counted);
    }
}


void GrainFlux::countExits()
{
    for (ExitFlux& flux : exits_)
    {
        scalarList counted(2, scalar(0));
        for (const nscdCoupling::GrainExit& gone : access().exits())
        {
            if (gone.patch != flux.patch) continue;
            counted[0] += 1;
            counted[1] += gone.mass;
        }
        addOfRanks(flux.total, counted);
    }
}


void GrainFlux::remember()
{
    for (const PlaneFlux& flux : planes_) setProperty(planeProperty(flux.name), flux.total);
    for (const ExitFlux& flux : exits_) setProperty(exitProperty(flux.name), flux.total);
}


bool GrainFlux::execute()
{
    countMoves();
    countExits();
    remember();
    return true;
}


std::vector<std::string> GrainFlux::columns() const
{
    std::vector<std::string> columns;
    for (const PlaneFlux& flux : planes_)
    {
        for (const char* column : {"numberForward", "numberBackward", "massForward", "massBackward"}) columns.push_back(flux.name + "." + column);
    }
    for (const ExitFlux& flux : exits_)
    {
        for (const char* column : {"number", "mass"}) columns.push_back(flux.name + "." + column);
    }
    return columns;
}


bool GrainFlux::write()
{
    if (!hasFile()) return true;
    writeCurrentTime(file());
    for (const PlaneFlux& flux : planes_) writeTotals(file(), flux.total);
    for (const ExitFlux& flux : exits_) writeTotals(file(), flux.total);
    file() << endl;
    return true;
}

} // namespace functionObjects
} // namespace Foam
