// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Checking labels, sizes and bounds.
#include "coupling/case/start/meshCheck.H"

#include "coupling/case/input/inputError.H"
#include "coupling/case/start/movingMeshCheck.H"

#include "input/dictionary/quantity.hpp"
#include "input/dictionary/withoutTraps.hpp"

#include "dynamicFvMesh.H"
#include "labelIOList.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

[[noreturn]] void refuse(const polyMesh& mesh, const word& file, const string& problem, const string& value)
{
    const fileName folder = mesh.time().path()/mesh.facesInstance()/polyMesh::meshSubDir;
    fail({placeInFile(folder/file, file), problem, value, "the files of one mesh, whole"});
}

void checkPoints(const polyMesh& mesh)
{
    for (const point& x : mesh.points())
    {
        if (cmptMax(cmptMag(x)) <= input::largestNumber) continue;
        refuse(mesh, "points", "holds a point too far away", messageText(x));
    }
}

void checkFaces(const polyMesh& mesh)
{
    forAll(mesh.faces(), facei)
    {
        const face& f = mesh.faces()[facei];
        if (f.size() < 3) refuse(mesh, "faces", messageText("holds face ", facei, ", which has too few points"), messageText(f.size()));
        for (const label pointi : f)
        {
            if (pointi >= 0 && pointi < mesh.nPoints()) continue;
            refuse(mesh, "faces", messageText("holds face ", facei, " of a point that is not there"), messageText(pointi));
        }
    }
}

/// Counts the faces of each cell, of those that one file names.
void countFaces(const polyMesh& mesh, const labelUList& cells, const word& file, labelList& count)
{
    for (const label celli : cells)
    {
        if (celli < 0 || celli >= count.size()) refuse(mesh, file, "names a cell that is not there", messageText(celli));
        ++count[celli];
    }
}

void checkCells(const polyMesh& mesh)
{
    if (mesh.faceOwner().size() != mesh.nFaces())
    {
        refuse(mesh, "owner", messageText("does not fit the ", mesh.nFaces(), " faces"), messageText(mesh.faceOwner().size()));
    }
    constexpr label fewestFaces = 4;   // of a tetrahedron
    labelList count(mesh.nCells(), label(0));
    countFaces(mesh, mesh.faceOwner(), "owner", count);
    countFaces(mesh, mesh.faceNeighbour(), "neighbour", count);
    forAll(count, celli)
    {
        if (count[celli] >= fewestFaces) continue;
        refuse(mesh, "owner", messageText("leaves cell ", celli, " too few faces"), messageText(count[celli]));
    }
}

void checkPatches(const polyMesh& mesh)
{
    label next = mesh.nInternalFaces();
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.start() != next)
        {
            refuse(mesh, "boundary", "begins patch " + patch.name() + messageText(" elsewhere than at face ", next), messageText(patch.start()));
        }
        next += patch.size();
    }
    if (next != mesh.nFaces()) refuse(mesh, "boundary", messageText("does not end at the last of ", mesh.nFaces(), " faces"), messageText(next));
}

fileName meshFolder(const Time& time) { return time.path()/time.findInstance(polyMesh::meshSubDir, "faces")/polyMesh::meshSubDir; }

/// OpenFOAM takes a mesh without owners for one without cells.
void checkFilesAreThere(const Time& time)
{
    for (const word name : {"owner", "neighbour"})
    {
        IOobject file(name, time.findInstance(polyMesh::meshSubDir, "faces"), polyMesh::meshSubDir, time, IOobject::MUST_READ, IOobject::NO_WRITE, false);
        if (file.typeHeaderOk<labelIOList>(true)) continue;
        const fileName path = meshFolder(time)/name;
        fail({placeInFile(path, name), "is missing or has no header", "", "the files of one mesh, whole"});
    }
}

/// With the solver of its motion; OpenFOAM's errors tell what constant/dynamicMeshDict lacks.
autoPtr<fvMesh> movingMesh(const IOobject& region) { return autoPtr<fvMesh>(dynamicFvMesh::New(region).ptr()); }

void checkMeshFiles(const polyMesh& mesh)
{
    checkPoints(mesh);
    checkFaces(mesh);
    checkCells(mesh);
    checkPatches(mesh);
}

} // namespace


autoPtr<fvMesh> readMesh(const Time& time)
{
    // Cells without volume and points without end raise floating-point exceptions before anybody can look at them.
    const input::WithoutTraps traps;
    checkFilesAreThere(time);
    const IOobject region(fvMesh::defaultRegion, time.timeName(), time, IOobject::MUST_READ);
    const bool moves = movesMesh(time);
    auto mesh = toldWithFile(meshFolder(time), time.path(), [&] { return moves ? movingMesh(region) : autoPtr<fvMesh>::New(region); });
    checkMeshFiles(*mesh);
    return mesh;
}

} // namespace nscdCoupling
} // namespace Foam
