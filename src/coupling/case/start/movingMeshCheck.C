// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking at constant/dynamicMeshDict, and at the mesh after it moved.
#include "coupling/case/start/movingMeshCheck.H"

#include "coupling/base/rotatingZonesFile.H"
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/inputError.H"
#include "coupling/case/walls/patchRoles.H"

#include "IOdictionary.H"
#include "Time.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const word keyword = "dynamicFvMesh";
const word still = "staticFvMesh";

IOdictionary dynamicMeshDict(const Time& time)
{
    return IOdictionary(IOobject("dynamicMeshDict", time.constant(), time, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false));
}

/// OpenFOAM's mesh that moves now and then keeps the flux of its last motion meanwhile, and walls would have that velocity.
void refuseUpdatesNowAndThen(const dictionary& dict)
{
    const word control = "updateControl", interval = "updateInterval";
    const bool isInSteps = dict.getOrDefault<word>(control, "timeStep") == "timeStep";
    if (!isInSteps) fail({placeOf(dict, control), "moves the mesh now and then", dict.get<word>(control), "none, for a mesh that moves in every step"});
    const scalar steps = dict.getOrDefault<scalar>(interval, 1);
    if (steps > 1) fail({placeOf(dict, interval), "moves the mesh now and then", Foam::name(steps), "1, for a mesh that moves in every step"});
}

} // namespace


bool movesMesh(const Time& time)
{
    const IOdictionary dict(dynamicMeshDict(time));
    if (dict.empty()) return false;
    if (!dict.found(keyword)) fail({placeOf(dict, keyword), "is missing, in a file that moves the mesh", "", still + ", dynamicMotionSolverFvMesh, ..."});
    return dict.get<word>(keyword) != still;
}


void checkMovingMesh(const GrainProperties& properties, const polyMesh& mesh)
{
    const IOdictionary dict(dynamicMeshDict(mesh.time()));
    const auto refuse = [&](const string& problem, const string& allowed)
    {
        fail({placeOf(dict, keyword), "moves the mesh, " + problem, dict.get<word>(keyword), still + ", or " + allowed});
    };
    refuseUpdatesNowAndThen(dict);
    if (properties.heat) refuse("on which temperatures are not followed", "no `heat`");
    if (properties.holdsMeanFlow) refuse("on which a mean flow is not held", "no `meanFlow`");
    if (properties.time.mayCycle()) refuse("whose walls are known at the ends of the fluid's steps alone", "`subCycles 1` and no `maxGrainImpacts`");
    if (hasRotatingZones(mesh)) refuse("beside a rotating frame", "no constant/MRFProperties");
}


void checkMovedMesh(const polyMesh& mesh, const nscd::PeriodicBox& box)
{
    if (mesh.topoChanging())
    {
        FatalErrorInFunction << "the mesh has changed its cells at time " << mesh.time().timeName()
            << ": nscdDEMFoam follows meshes whose points move, and no others" << exit(FatalError);
    }
    if (!box.any()) return;
    const nscd::Vec3 change = periodicBox(mesh).length - box.length;
    if (change.cwiseAbs().maxCoeff() <= 1e-6*mesh.bounds().mag()) return;
    FatalErrorInFunction << "the mesh has changed its periods by " << toFoam(change) << " m at time " << mesh.time().timeName() << exit(FatalError);
}

} // namespace nscdCoupling
} // namespace Foam
