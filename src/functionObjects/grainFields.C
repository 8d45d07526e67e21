// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Mass, momentum and momentum flux of the grains by cells, and the fields that follow from them.
#include "functionObjects/grainFields.H"

#include "functionObjects/functionEntries.H"

#include "addToRunTimeSelectionTable.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(GrainFields, 0);
addToRunTimeSelectionTable(functionObject, GrainFields, dictionary);

namespace
{

const word bulkDensityName = "bulkDensity.grains", velocityName = "U.grains";
const word temperatureName = "T.grains", stressName = "kineticStress.grains";

/// Cells with less than this part of the largest bulk density count as without grains. Smoothing of the void fraction leaves some
/// of every grain in every cell, and of less than this it leaves round-off.
constexpr scalar leastPart = 1e-12;

/// Where in the sums over a cell what begins, by its components.
constexpr std::size_t mass = 0, momentum = 1, momentumFlux = 4, nSums = 10;

/// m, m v and m v v of each owned grain.
std::vector<std::vector<scalar>> amountsOf(const ::nscd::Grains& grains)
{
    std::vector<std::vector<scalar>> amounts(nSums, std::vector<scalar>(grains.nOwned));
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const ::nscd::Vec3& v = grains.velocity[i];
        const scalar m = grains.mass[i];
        amounts[mass][i] = m;
        std::size_t flux = momentumFlux;
        for (int a = 0; a < 3; ++a)
        {
            amounts[momentum + a][i] = m*v[a];
            for (int b = a; b < 3; ++b) amounts[flux++][i] = m*v[a]*v[b];
        }
    }
    return amounts;
}

/// The field of a name in the mesh's registry, which owns it; made where there is none.
template<class Type>
GeometricField<Type, fvPatchField, volMesh>& registered(const fvMesh& mesh, const word& name, const dimensionSet& dimensions)
{
    using VolField = GeometricField<Type, fvPatchField, volMesh>;
    if (!mesh.foundObject<VolField>(name))
    {
        const dimensioned<Type> zero("zero", dimensions, Zero);
        const word border = zeroGradientFvPatchField<Type>::typeName;
        regIOobject::store(new VolField(IOobject(name, mesh.time().timeName(), mesh), mesh, zero, border));
    }
    return mesh.lookupObjectRef<VolField>(name);
}

/// Components of a cell, one after another from `first`.
template<class Type>
Type valueOf(const std::vector<scalarField>& sums, std::size_t first, label cell)
{
    Type value;
    for (direction k = 0; k < pTraits<Type>::nComponents; ++k) setComponent(value, k) = sums[first + k][cell];
    return value;
}

} // namespace


GrainFields::GrainFields(const word& name, const Time& runTime, const dictionary& dict)
:
    fvMeshFunctionObject(name, runTime, dict),
    access_(nscdCoupling::GrainAccess::of(mesh_, nscdCoupling::placeOf(dict)))
{
    read(dict);
    if (!access_.isMapped())
    {
        nscdCoupling::fail({nscdCoupling::placeOf(dict), "needs a fluid", "fluid none", "a run with a fluid: fields are made as its void fraction is"});
    }
    execute();
}


bool GrainFields::read(const dictionary& dict)
{
    nscdCoupling::readFunction(dict, [](const input::CheckedEntries&) {});
    hasWriteControl_ = dict.found("writeControl") || dict.found("outputControl");
    return fvMeshFunctionObject::read(dict);
}


bool GrainFields::execute()
{
    const std::vector<scalarField> sums = access_.perVolume(amountsOf(access_.grains()));
    volScalarField& bulkDensity = registered<scalar>(mesh_, bulkDensityName, dimDensity);
    volVectorField& velocity = registered<vector>(mesh_, velocityName, dimVelocity);
    volScalarField& temperature = registered<scalar>(mesh_, temperatureName, sqr(dimVelocity));
    volSymmTensorField& stress = registered<symmTensor>(mesh_, stressName, dimPressure);
    const scalar least = leastPart*gMax(sums[mass]);
    forAll(sums[mass], cell)
    {
        const scalar density = sums[mass][cell];
        const bool hasGrains = density > least;
        const vector u = hasGrains ? valueOf<vector>(sums, momentum, cell)/density : vector(Zero);
        const symmTensor fluctuations = valueOf<symmTensor>(sums, momentumFlux, cell) - density*sqr(u);
        bulkDensity[cell] = hasGrains ? density : 0;
        velocity[cell] = u;
        stress[cell] = hasGrains ? fluctuations : symmTensor(Zero);
        // Not below zero but for round-off.
        temperature[cell] = hasGrains ? max(tr(fluctuations), scalar(0))/(access_.grains().shape.dimensions*density) : 0;
    }
    bulkDensity.correctBoundaryConditions();
    velocity.correctBoundaryConditions();
    temperature.correctBoundaryConditions();
    stress.correctBoundaryConditions();
    return true;
}


bool GrainFields::write()
{
    if (!hasWriteControl_ && !time_.writeTime()) return true;
    for (const word& field : {bulkDensityName, velocityName, temperatureName, stressName}) writeObject(field);
    return true;
}

} // namespace functionObjects
} // namespace Foam
