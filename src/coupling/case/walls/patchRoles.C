// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Boundary patches as grains see them.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/patchRegion.H"
#include "coupling/case/walls/patchRoles.H"
#include "coupling/case/walls/zoneRegion.H"
#include "coupling/mapping/mesh/nearestBorder.H"

#include "SubField.H"
#include "Time.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

Place boundaryPlace(const polyMesh& mesh, const polyPatch& patch)
{
    return placeInFile(mesh.boundaryMesh().objectPath(), patch.name());
}

bool isWallByType(const polyPatch& patch)
{
    return isA<wallPolyPatch>(patch) || isA<symmetryPolyPatch>(patch) || isA<symmetryPlanePolyPatch>(patch);
}

/// Not all coupled patches are constraints to OpenFOAM: cyclicPeriodicAMI is none.
bool mayTakeRule(const polyPatch& patch)
{
    return isWallByType(patch) || !(polyPatch::constraintType(patch.type()) || isA<coupledPolyPatch>(patch));
}

void refuseUnknownKinds(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const bool isParallel = isA<processorPolyPatch>(patch);
        const bool isKnown = mayTakeRule(patch) || isA<emptyPolyPatch>(patch) || patch.type() == cyclicPolyPatch::typeName
            || patch.type() == cyclicAMIPolyPatch::typeName;
        if (isKnown || (isParallel && Pstream::parRun())) continue;
        fail
        ({
            boundaryPlace(mesh, patch),
            isParallel ? "belongs to a part of a decomposed case: run the whole with -parallel" : "is of a type that grains do not know",
            patch.type(), "wall, symmetry, symmetryPlane, patch, cyclic, cyclicAMI, empty"
        });
    }
}

/// Halves that slide past each other touch: a grain that goes from one into the other stays where it is, and is not turned.
void refuseHalvesApart(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* half = isA<cyclicAMIPolyPatch>(patch);
        if (!half) continue;
        const auto transform = half->transform();
        if (transform != coupledPolyPatch::ROTATIONAL && transform != coupledPolyPatch::TRANSLATIONAL) continue;
        fail
        ({
            boundaryPlace(mesh, patch), "lies apart from its partner, and grains do not go from one to the other",
            coupledPolyPatch::transformTypeNames[transform],
            "`transform noOrdering` of halves that touch; periodic sides are of type cyclic, with faces alike and a translation along x, y or z"
        });
    }
}

/// Patches that a rule fits.
labelList patchesOf(const PatchRule& rule, const polyMesh& mesh)
{
    labelList fitting;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (rule.patch.match(patch.name())) fitting.append(patch.index());
    }
    if (fitting.empty())
    {
        fail
        ({
            rule.place, "names no patch of the mesh", rule.patch, string::null, toWords(mesh.boundaryMesh().names())
        });
    }
    return fitting;
}

void applyRule(const PatchRule& rule, const polyMesh& mesh, PatchRoles& roles)
{
    for (const label patchi : patchesOf(rule, mesh))
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        if (!mayTakeRule(patch))
        {
            // An expression such as ".*" may well sweep over patches that need no rule.
            if (rule.patch.isPattern()) continue;
            fail({rule.place, "names a patch of type " + patch.type() + ", whose role is fixed by its type"});
        }
        roles.role[patchi] = rule.isExit ? PatchRole::exit : PatchRole::wall;
        roles.material[patchi] = rule.material;
        roles.surfaceMotion[patchi] = rule.surfaceMotion;
        roles.torquePoint[patchi] = rule.torquePoint;
    }
}

/// Faces of each patch on all ranks; those between ranks count where they are.
labelList patchSizes(const polyMesh& mesh)
{
    labelList sizes;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const bool isOfAll = !isA<processorPolyPatch>(patch);
        sizes.append(isOfAll ? returnReduce(patch.size(), sumOp<label>()) : patch.size());
    }
    return sizes;
}

PatchRole roleByType(const polyPatch& patch, bool isVoid, bool hasGrains)
{
    if (isA<processorPolyPatch>(patch) || isBetweenHalves(patch)) return PatchRole::unused;
    if (isA<emptyPolyPatch>(patch)) return PatchRole::empty;
    if (isA<cyclicPolyPatch>(patch)) return PatchRole::periodic;
    if (isWallByType(patch)) return PatchRole::wall;
    return isVoid || hasGrains ? PatchRole::unused : PatchRole::exit;
}

void checkComplete(const GrainProperties& properties, const polyMesh& mesh, const labelList& sizes, const PatchRoles& roles)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const label patchi = patch.index();
        if (sizes[patchi] == 0 || !properties.hasAnySource() || isA<processorPolyPatch>(patch) || isBetweenHalves(patch)) continue;
        if (roles.role[patchi] == PatchRole::unused)
        {
            fail
            ({
                properties.patchesPlace, "does not say what the patch " + patch.name() + " is to the grains", string::null,
                patch.name() + " { type wall; } or " + patch.name() + " { type exit; }"
            });
        }
        if (roles.role[patchi] == PatchRole::wall && roles.material[patchi] < 0)
        {
            fail
            ({
                properties.patchesPlace, "gives no material to the wall " + patch.name(), string::null,
                "wallMaterial ...; for all walls, or " + patch.name() + " { type wall; material ...; }: "
              + input::joined(properties.materials.table.names())
            });
        }
    }
}

/// The faces of a cyclic patch on all ranks, those between ranks among them.
struct CyclicFaces
{
    vector sumOfCenters = Zero;
    scalar number = 0;
    scalar turned = 0;       ///< ranks that see a rotation

    void add(const coupledPolyPatch& patch)
    {
        sumOfCenters += sum(patch.faceCentres());
        number += patch.size();
        turned += !patch.parallel();
    }
    vector center() const { return sumOfCenters/number; }
};

/// By patch; patches that are not cyclic have none.
std::vector<CyclicFaces> cyclicFaces(const polyMesh& mesh)
{
    std::vector<CyclicFaces> faces(mesh.boundaryMesh().nNonProcessor());
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(patch);
        const auto* cut = isA<processorCyclicPolyPatch>(patch);
        if (cyclic) faces[patch.index()].add(*cyclic);
        if (cut) faces[cut->referPatchID()].add(*cut);
    }
    for (CyclicFaces& of : faces)
    {
        reduce(of.sumOfCenters, sumOp<vector>());
        reduce(of.number, sumOp<scalar>());
        reduce(of.turned, sumOp<scalar>());
    }
    return faces;
}

/// Axis along which a cyclic patch is shifted from its partner.
int periodicAxis(const polyMesh& mesh, const cyclicPolyPatch& patch, const CyclicFaces& own, const CyclicFaces& partner)
{
    const Place place = boundaryPlace(mesh, patch);
    const string allowed = "a translation along x, y or z between two sides of the mesh";
    if (own.turned > 0 || partner.turned > 0) fail({place, "is a rotational cyclic patch", patch.type(), allowed});

    const vector shift = own.center() - partner.center();
    int axis = 0;
    for (int k = 1; k < 3; ++k)
    {
        if (mag(shift[k]) > mag(shift[axis])) axis = k;
    }
    const scalar length = mag(shift[axis]);
    vector rest = shift;
    rest[axis] = 0;
    if (mag(rest) > 1e-6*length) fail({place, "is shifted from its partner aslant", Foam::name(mag(rest)), allowed});
    if (mag(length - mesh.bounds().span()[axis]) > 1e-6*length)
    {
        fail({place, "does not bound the mesh on the side of its partner", Foam::name(length), allowed});
    }
    return axis;
}

} // namespace


labelList PatchRoles::ofRole(PatchRole wanted) const
{
    labelList found;
    for (std::size_t i = 0; i < role.size(); ++i)
    {
        if (role[i] == wanted) found.append(label(i));
    }
    return found;
}


PatchRoles assignPatchRoles(const GrainProperties& properties, const polyMesh& mesh)
{
    refuseUnknownKinds(mesh);
    refuseHalvesApart(mesh);
    const labelList sizes = patchSizes(mesh);
    PatchRoles roles;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        roles.role.push_back(roleByType(patch, sizes[patch.index()] == 0, properties.hasAnySource()));
        roles.material.push_back(properties.wallMaterial);
    }
    roles.surfaceMotion.resize(roles.role.size());
    roles.torquePoint.resize(roles.role.size(), vector(Zero));
    // Exact names win over expressions, whatever their order, as everywhere in OpenFOAM.
    for (const bool isPattern : {true, false})
    {
        for (const PatchRule& rule : properties.patchRules)
        {
            if (rule.patch.isPattern() == isPattern) applyRule(rule, mesh, roles);
        }
    }
    checkComplete(properties, mesh, sizes, roles);
    return roles;
}


int emptyAxis(const polyMesh& mesh)
{
    if (mesh.nGeometricD() == 3) return -1;
    if (mesh.nGeometricD() < 2)
    {
        fail({placeInFile(mesh.boundaryMesh().objectPath(), "boundary"), "leaves the mesh fewer than two dimensions"});
    }
    for (int k = 0; k < 3; ++k)
    {
        if (mesh.geometricD()[k] < 0) return k;
    }
    return -1;
}


nscd::GrainShape grainShape(const polyMesh& mesh)
{
    const int axis = emptyAxis(mesh);
    nscd::GrainShape shape;
    shape.dimensions = axis < 0 ? 3 : 2;
    if (axis >= 0) shape.thickness = mesh.bounds().span()[axis];
    shape.emptyAxis = axis;
    return shape;
}


void checkShape(const GrainProperties& properties, const polyMesh& mesh)
{
    if (properties.shape != "disc" || emptyAxis(mesh) >= 0) return;
    fail({properties.shapePlace, "is for 2D meshes, and this mesh is 3D", properties.shape, "sphere"});
}


nscd::PeriodicBox periodicBox(const polyMesh& mesh)
{
    const std::vector<CyclicFaces> faces = cyclicFaces(mesh);
    nscd::PeriodicBox box;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(patch);
        if (!cyclic || faces[patch.index()].number == 0) continue;
        const int axis = periodicAxis(mesh, *cyclic, faces[patch.index()], faces[cyclic->neighbPatchID()]);
        box.lower[axis] = mesh.bounds().min()[axis];
        box.length[axis] = mesh.bounds().span()[axis];
    }
    return box;
}


GrainSpace grainSpace(const GrainProperties& properties, const polyMesh& mesh)
{
    GrainSpace space;
    space.shape = chosenShape(grainShape(mesh), properties.shape);
    space.emptyAxis = space.shape.emptyAxis;
    return space;
}


input::Surroundings surroundingsIn(const polyMesh& mesh)
{
    input::Surroundings around = foamSurroundings(mesh.time().globalPath());
    around.shape = grainShape(mesh);
    if (around.shape.emptyAxis >= 0) around.midPlane = mesh.bounds().centre()[around.shape.emptyAxis];
    around.box = periodicBox(mesh);
    around.entryRegions = {{"patch", patchRegions(mesh)}, {"cellZone", zoneRegions(mesh)}};
    return around;
}

} // namespace nscdCoupling
} // namespace Foam
