// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Conservative smoothing of cell fields over a length, by explicit stages of diffusion.
#include "coupling/mapping/diffusionSmoother.H"

#include "coupling/mapping/mesh/cellShape.H"

#include "cyclicAMIFvPatch.H"
#include "syncTools.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>

namespace Foam
{
namespace nscdCoupling
{
namespace
{

// Index of the Gegenbauer polynomials: in 3D the kernel is (1 - r^2/a^2)^(index - 2). With 3/2 (Legendre's is 1/2) it is negative inside.
constexpr label gegenbauer = 4;

// Largest w |z|. At 2 what alternates from cell to cell would stay.
constexpr scalar mostDamped = 1.5;

// Grains reach no cells beyond a patch between halves of a mesh that slide past each other, and neither does what they are smoothed to.
bool passes(const fvPatch& patch)
{
    return patch.coupled() && !isA<cyclicAMIFvPatch>(patch);
}

wordList borderTypes(const fvMesh& mesh)
{
    wordList types(mesh.boundary().size(), zeroGradientFvPatchScalarField::typeName);
    forAll(types, patchI)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchI];
        if (polyPatch::constraintType(patch.type())) types[patchI] = patch.type();
    }
    return types;
}

label leastStages(const scalar largestRate)
{
    // s (s + 2 index) >= (2 index + 1) rate/mostDamped
    const scalar stages = std::sqrt(gegenbauer*gegenbauer + (2*gegenbauer + 1)*largestRate/mostDamped) - gegenbauer;
    return max(label(1), label(std::ceil(stages)));
}

} // namespace

scalar SmoothingLengths::between(const scalar across) const
{
    // Cells of just that width are not thin, whatever round-off makes of it.
    constexpr scalar roundOff = 1e-6;
    if (width == 0 || across >= (1 - roundOff)*thinCell) return length;
    return std::sqrt(max(scalar(0), sqr(width) - 8*std::log(2.0)/12*sqr(across)));
}

DiffusionSmoother::DiffusionSmoother(const fvMesh& mesh, const SmoothingLengths& lengths)
:
    mesh_(mesh)
{
    if (lengths.length == 0 && lengths.width == 0) return;
    const surfaceScalarField areas(areasOfFaces(lengths));
    setAreas(areas);
    largestLength_ = std::sqrt(gMax(areas_)*16*std::log(2.0));
    if (largestLength_ == 0) return;
    setConductances(areas);
    stages_ = leastStages(largestRate());
    listReached(boolList(mesh.nCells(), true));
}

// D T of each face; of one between ranks or cyclic ones from both of its cells.
surfaceScalarField DiffusionSmoother::areasOfFaces(const SmoothingLengths& lengths) const
{
    const surfaceScalarField across(acrossCells(mesh_));
    surfaceScalarField areas("smoothingArea", sqr(across));
    const auto set = [&](scalarField& of, const scalarField& width)
    {
        forAll(of, k) of[k] = sqr(lengths.between(width[k]))/(16*std::log(2.0));
    };
    set(areas.primitiveFieldRef(), across.primitiveField());
    forAll(areas.boundaryField(), patchI) set(areas.boundaryFieldRef()[patchI], across.boundaryField()[patchI]);
    return areas;
}

void DiffusionSmoother::setAreas(const surfaceScalarField& areas)
{
    areas_.setSize(mesh_.nCells());
    scalarField faces(mesh_.nCells(), Zero);
    areas_ = 0;
    const auto add = [&](label cell, scalar area) { areas_[cell] += area; faces[cell] += 1; };
    forAll(areas, faceI)
    {
        add(mesh_.owner()[faceI], areas[faceI]);
        add(mesh_.neighbour()[faceI], areas[faceI]);
    }
    forAll(mesh_.boundary(), patchI)
    {
        if (!passes(mesh_.boundary()[patchI])) continue;
        const labelUList& faceCells = mesh_.boundary()[patchI].faceCells();
        forAll(faceCells, k) add(faceCells[k], areas.boundaryField()[patchI][k]);
    }
    areas_ /= max(faces, scalar(1));
}

void DiffusionSmoother::setConductances(const surfaceScalarField& areas)
{
    conductance_.reset(new surfaceScalarField("conductance", areas*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()));
    forAll(mesh_.boundary(), patchI)
    {
        const bool isPassing = passes(mesh_.boundary()[patchI]);
        if (!isPassing) conductance_().boundaryFieldRef()[patchI] = 0;
        hasCoupled_ = hasCoupled_ || isPassing;
    }
    reduce(hasCoupled_, orOp<bool>());
}

// Bound of the eigenvalues of D T V^-1 L: twice the largest diagonal.
scalar DiffusionSmoother::largestRate() const
{
    scalarField sums(mesh_.nCells(), Zero);
    const scalarField& inner = conductance_().primitiveField();
    forAll(inner, faceI)
    {
        sums[mesh_.owner()[faceI]] += inner[faceI];
        sums[mesh_.neighbour()[faceI]] += inner[faceI];
    }
    forAll(mesh_.boundary(), patchI)
    {
        const labelUList& faceCells = mesh_.boundary()[patchI].faceCells();
        const scalarField& conductance = conductance_().boundaryField()[patchI];
        forAll(conductance, k) sums[faceCells[k]] += conductance[k];
    }
    return 2*gMax(scalarField(sums/mesh_.V()));
}

// Cells next to those reached are reached too.
void DiffusionSmoother::addLayer(boolList& isReached) const
{
    const boolList before(isReached);
    for (label faceI = 0; faceI < mesh_.nInternalFaces(); ++faceI)
    {
        const label own = mesh_.faceOwner()[faceI];
        const label other = mesh_.faceNeighbour()[faceI];
        if (before[own]) isReached[other] = true;
        if (before[other]) isReached[own] = true;
    }
    if (!hasCoupled_) return;
    boolList behind;
    syncTools::swapBoundaryCellList(mesh_, before, behind);
    forAll(behind, k)
    {
        if (behind[k]) isReached[mesh_.faceOwner()[mesh_.nInternalFaces() + k]] = true;
    }
}

void DiffusionSmoother::listReached(const boolList& isReached)
{
    DynamicList<label> cells, faces;
    forAll(isReached, cellI)
    {
        if (isReached[cellI] && areas_[cellI] > 0) cells.append(cellI);
    }
    const scalarField& conductance = conductance_().primitiveField();
    for (label faceI = 0; faceI < mesh_.nInternalFaces(); ++faceI)
    {
        if (conductance[faceI] > 0 && isReached[mesh_.faceOwner()[faceI]] && isReached[mesh_.faceNeighbour()[faceI]]) faces.append(faceI);
    }
    cells_.transfer(cells);
    faces_.transfer(faces);
}

void DiffusionSmoother::restrictTo(const scalarField& used)
{
    if (!isOn()) return;
    boolList isReached(mesh_.nCells());
    forAll(isReached, cellI) isReached[cellI] = used[cellI] > 0;
    for (label stage = 0; stage < stages_; ++stage) addLayer(isReached);
    listReached(isReached);
}

template<class Type>
void DiffusionSmoother::setNetInflow(const GeometricField<Type, fvPatchField, volMesh>& cells, Field<Type>& inflow) const
{
    inflow = Zero;
    const scalarField& inner = conductance_().primitiveField();
    for (const label faceI : faces_)
    {
        const label own = mesh_.owner()[faceI];
        const label other = mesh_.neighbour()[faceI];
        const Type flux = inner[faceI]*(cells[own] - cells[other]);
        inflow[own] -= flux;
        inflow[other] += flux;
    }
    forAll(mesh_.boundary(), patchI)
    {
        if (!passes(mesh_.boundary()[patchI])) continue;
        const labelUList& faceCells = mesh_.boundary()[patchI].faceCells();
        const scalarField& conductance = conductance_().boundaryField()[patchI];
        const Field<Type> behind(cells.boundaryField()[patchI].patchNeighbourField());
        forAll(faceCells, k) inflow[faceCells[k]] += conductance[k]*(behind[k] - cells[faceCells[k]]);
    }
}

template<class Type>
void DiffusionSmoother::smoothField(Field<Type>& cells) const
{
    if (!isOn()) return;
    const IOobject header("smoothed", mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::NO_WRITE, false);
    GeometricField<Type, fvPatchField, volMesh> values(header, mesh_, dimensioned<Type>("zero", dimless, Zero), borderTypes(mesh_));
    Field<Type>& newest = values.primitiveFieldRef();
    newest = cells;
    Field<Type> inflow(cells.size());
    const scalarField& volumes = mesh_.V();
    const scalar share = scalar(2*gegenbauer + 1)/(stages_*(stages_ + 2*gegenbauer));
    for (label stage = 1; stage <= stages_; ++stage)
    {
        if (hasCoupled_) values.correctBoundaryConditions();
        const scalar momentum = scalar(stage - 1)/(stage + 2*gegenbauer - 1);
        setNetInflow(values, inflow);
        for (const label cellI : cells_)
        {
            const Type value = newest[cellI];
            newest[cellI] += momentum*(value - cells[cellI]) + ((1 + momentum)*share/volumes[cellI])*inflow[cellI];
            cells[cellI] = value;
        }
    }
    cells = newest;
}

template void DiffusionSmoother::smoothField(scalarField&) const;
template void DiffusionSmoother::smoothField(vectorField&) const;

} // namespace nscdCoupling
} // namespace Foam
