// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Mass, momentum and momentum flux of the grains by cells, and the fields that follow from them.
#include "functionObjects/grainFields.H"

#include "functionObjects/cellFields.H"

#include "addToRunTimeSelectionTable.H"

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

/// Cells with less than this part of the largest bulk density count as without grains. Where smoothing of the void fraction ends it leaves
/// round-off.
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

} // namespace


GrainFields::GrainFields(const word& name, const Time& runTime, const dictionary& dict)
:
    GrainObject(name, runTime, dict)
{
    read(dict);
    requireFluid(dict);
    execute();
}


bool GrainFields::execute()
{
    const std::vector<scalarField> sums = access().perVolume(amountsOf(access().grains()));
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
        temperature[cell] = hasGrains ? max(tr(fluctuations), scalar(0))/(access().grains().shape.dimensions*density) : 0;
    }
    bulkDensity.correctBoundaryConditions();
    velocity.correctBoundaryConditions();
    temperature.correctBoundaryConditions();
    stress.correctBoundaryConditions();
    return true;
}


bool GrainFields::write()
{
    if (!isWriteDue()) return true;
    for (const word& field : {bulkDensityName, velocityName, temperatureName, stressName}) writeObject(field);
    return true;
}

} // namespace functionObjects
} // namespace Foam
