// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking through them.
#include "coupling/case/start/rotatingZonesCheck.H"

#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/inputError.H"

#include "input/dictionary/checkedEntries.hpp"

#include "PstreamReduceOps.H"
#include "wordRes.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const char* const excluded = "nonRotatingPatches";

/// Names of the patches that the mesh has before it is cut.
Words patchNames(const polyBoundaryMesh& patches)
{
    Words names;
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi) names.push_back(patches[patchi].name());
    return names;
}

void checkEntries(const dictionary& zone, const Words& cellZones)
{
    const input::Dictionary translated = fromFoam(zone);
    const input::CheckedEntries entries(translated);
    entries.flag("active", true);
    entries.found(excluded);
    if (cellZones.empty()) entries.reject("cellZone", "is needed, and the mesh has no cell zone", "a cell zone: topoSet makes one");
    entries.choice("cellZone", cellZones);
    entries.vec("origin", input::unit::length);
    if (entries.vec("axis", input::unit::one).isZero(0)) entries.reject("axis", "has no direction", "a vector other than (0 0 0)");
    entries.require("omega", "a speed of rotation [rad/s], constant or any Function1");
    entries.finish();
}

void checkExcluded(const dictionary& zone, const polyBoundaryMesh& patches)
{
    for (const wordRe& name : zone.getOrDefault<wordRes>(excluded, wordRes()))
    {
        if (patches.patchSet(wordRes(1, name)).empty()) fail({placeOf(zone, excluded), "names no patch", name, "", patchNames(patches)});
    }
}

/// Whether any face of a patch, on any rank, belongs to a cell of the zone.
bool isInZone(const polyPatch& patch, const cellZone& zone)
{
    bool isIn = false;
    for (const label cell : patch.faceCells()) isIn = isIn || zone.whichCell(cell) >= 0;
    return returnReduce(isIn, orOp<bool>());
}

/// Patches to which the zone gives the velocity of its frame.
labelList turnedBy(const dictionary& zone, const fvMesh& mesh)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const labelHashSet still(patches.patchSet(zone.getOrDefault<wordRes>(excluded, wordRes())));
    const cellZone& cells = mesh.cellZones()[zone.get<word>("cellZone")];
    DynamicList<label> turned;
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        const polyPatch& patch = patches[patchi];
        const bool mayTurn = !patch.coupled() && !still.found(patchi) && patch.type() != "empty";
        // On all ranks alike: the sum over ranks is inside.
        if (mayTurn && isInZone(patch, cells)) turned.append(patchi);
    }
    return labelList(turned);
}

void tellZone(const word& name, const dictionary& zone, const fvMesh& mesh, const PatchRoles& roles, Ostream& os)
{
    os << "rotating zone " << name << ": the fluid's equations are those of its frame; grains stay in the frame at rest and feel the fluid's"
        << " absolute velocity" << nl;
    for (const label patchi : turnedBy(zone, mesh))
    {
        const word& patch = mesh.boundaryMesh()[patchi].name();
        const bool standsStill = roles.role[std::size_t(patchi)] == PatchRole::wall && !roles.surfaceMotion[std::size_t(patchi)];
        os << "  patch " << patch << " turns with it for the fluid";
        if (standsStill) os << "; to the grains it stands still, unless `patches { " << patch << " { type wall; surfaceRotation { ... } } }` says otherwise";
        os << nl;
    }
}

} // namespace


void checkRotatingZones(const fvMesh& mesh, const PatchRoles& roles, Ostream& os)
{
    const IOobject file("MRFProperties", mesh.time().constant(), mesh, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false);
    const IOdictionary zones(file);
    for (const entry& zone : zones)
    {
        if (!zone.isDict()) continue;
        toldByFoam([&] { checkEntries(zone.dict(), toWords(mesh.cellZones().names())); });
        checkExcluded(zone.dict(), mesh.boundaryMesh());
        if (zone.dict().getOrDefault("active", true)) tellZone(zone.keyword(), zone.dict(), mesh, roles, os);
    }
}

} // namespace nscdCoupling
} // namespace Foam
