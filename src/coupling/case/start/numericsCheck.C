// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Asking for every field, scheme and solver once.
#include "coupling/case/input/earlierTimes.H"
#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/inputError.H"
#include "coupling/case/start/numericsCheck.H"

#include "input/dictionary/checkedEntries.hpp"

#include "convectionScheme.H"
#include "ddtScheme.H"
#include "dimensionSets.H"
#include "divScheme.H"
#include "fixedValueFvPatchFields.H"
#include "gradScheme.H"
#include "laplacianScheme.H"
#include "lduMatrix.H"
#include "IFstream.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "surfaceFields.H"
#include "volFields.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// First line of a file that starts with a word; for field files, which may be binary behind that line.
Place placeOfLine(const fileName& file, const string& start)
{
    Place place = placeInFile(file, start);
    IFstream is(file);
    string line;
    for (label lineNumber = 1; is.getLine(line).good(); ++lineNumber)
    {
        if (line.compare(std::min(line.size(), line.find_first_not_of(" \t")), start.size(), start) != 0) continue;
        place.line = lineNumber;
        break;
    }
    return place;
}

template<class Values>
void checkSizes(const fileName& file, const string& where, const Values& values)
{
    for (const auto& value : values)
    {
        if (cmptMax(cmptMag(value)) <= input::largestNumber) continue;
        fail({placeOfLine(file, where), "holds a number that is too large", messageText(value), messageText("numbers up to ", input::largestNumber)});
    }
}

template<class Field>
Field checkField(const fvMesh& mesh, const word& name, const dimensionSet& dimensions, const string& unit)
{
    const IOobject file(name, mesh.time().timeName(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    if (!isFile(file.objectPath()))
    {
        fail({placeInFile(file.objectPath(), name), "is missing", "", "a field in " + unit + adviceOnEarlierTime(mesh.time())});
    }
    const Field field = toldWithFile(file.objectPath(), file.path(), [&] { return Field(file, mesh); });
    checkSizes(field.objectPath(), "internalField", field.primitiveField());
    for (const auto& patch : field.boundaryField()) checkSizes(field.objectPath(), patch.patch().name(), patch);
    if (field.dimensions() == dimensions) return field;
    fail
    ({
        placeOfLine(field.objectPath(), "dimensions"), "are wrong for " + name, messageText(field.dimensions()),
        messageText(dimensions, ": ", name, " is in ", unit.c_str())
    });
}

/// A quantity of turbulence models, where this case has it.
void checkTransported(const fvMesh& mesh, const word& name, const dimensionSet& dimensions, const string& unit, const input::Range& range)
{
    IOobject file(name, mesh.time().timeName(), mesh, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    if (!file.typeHeaderOk<volScalarField>(true)) return;
    const volScalarField field = checkField<volScalarField>(mesh, name, dimensions, unit);
    const scalar least = gMin(field.primitiveField());
    // OpenFOAM raises negative ones to round-off, which makes an eddy viscosity without end, and divides by zero.
    if (!range.contains(least)) fail({placeOfLine(field.objectPath(), "internalField"), "is out of range", messageText(least), range.describe()});
}

/// Files that turbulenceProperties does not ask for may be left from another run.
bool isTurbulent(const Time& time)
{
    const IOobject file("turbulenceProperties", time.constant(), time, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    return IOdictionary(file).getOrDefault<word>("simulationType", "laminar") != "laminar";
}

void checkTimeScheme(const fvMesh& mesh, const word& name)
{
    const word scheme(mesh.ddtScheme(name));
    if (scheme == "steadyState" || scheme == "localEuler")
    {
        fail
        ({
            placeInDictionaryFile(mesh.fvSchemes::objectPath(), "ddtSchemes"), "has no time step for " + name, scheme,
            "a scheme in time, as Euler or backward"
        });
    }
    fv::ddtScheme<vector>::New(mesh, mesh.ddtScheme(name));
}

/// The quantities that the turbulence model of this run transports, among those that OpenFOAM's models know.
wordList turbulenceFields(const fvMesh& mesh)
{
    wordList names;
    for (const word name : {"k", "epsilon", "omega", "nuTilda", "R"})
    {
        if (mesh.objectRegistry::found(name)) names.append(name);
    }
    return names;
}

void checkSchemes(const fvMesh& mesh, const surfaceScalarField& phi, bool isAveraged)
{
    checkTimeScheme(mesh, isAveraged ? "ddt(alpha.fluid,U)" : "ddt(U)");
    fv::convectionScheme<vector>::New(mesh, phi, mesh.divScheme("div(phi,U)"));
    fv::divScheme<tensor>::New(mesh, mesh.divScheme("div((nuEff*dev2(T(grad(U)))))"));
    for (const word& name : turbulenceFields(mesh)) mesh.divScheme("div(phi," + name + ")");
    fv::gradScheme<vector>::New(mesh, mesh.gradScheme("grad(U)"));
    if (!isAveraged) fv::gradScheme<scalar>::New(mesh, mesh.gradScheme("grad(p_rgh)"));
    fv::laplacianScheme<vector, scalar>::New(mesh, mesh.laplacianScheme("laplacian(nuEff,U)"));
    fv::laplacianScheme<scalar, scalar>::New(mesh, mesh.laplacianScheme("laplacian(rAU,p_rgh)"));
}

/// OpenFOAM's residuals are 1 at most: beyond that it iterates as often as minIter says, and without that not at all.
/// A smoother with a fixed number of sweeps (nSweeps below 0) does not look at them.
void checkTolerances(const dictionary& dict)
{
    const input::Dictionary entries = valuesFromFoam(dict);
    const input::CheckedEntries given(entries);
    toldByFoam([&]
    {
        input::Range range = input::atLeast(0);
        if (given.integer("minIter", 0, 0) == 0 && dict.getOrDefault<label>("nSweeps", 1) > 0) range.upper = 1;
        for (const char* keyword : {"tolerance", "relTol"}) given.number(keyword, range, 0);
    });
}

template<class Table>
void checkSolver(const fvMesh& mesh, const word& field, const Table& known)
{
    const dictionary& dict = mesh.solverDict(field);
    const word type = dict.get<word>("solver");
    if (!known.found(type)) fail({placeOf(dict, "solver"), "is unknown, or not for this equation", type, string::null, toWords(known.sortedToc())});
    checkTolerances(dict);
}

/// What fvSolution must have, and what it may.
void checkSolution(const fvMesh& mesh)
{
    const input::Dictionary entries = valuesFromFoam(mesh.solutionDict());
    const input::CheckedEntries given(entries);
    toldByFoam([&]
    {
        given.sub("solvers");
        given.refuseMisspelt({"PIMPLE"});
        given.subOrEmpty("PIMPLE");
    });
}

/// OpenFOAM takes any whole number; without a pressure correction nothing is solved.
void checkPimple(const fvMesh& mesh)
{
    const input::Dictionary entries = valuesFromFoam(mesh.solutionDict().subOrEmptyDict("PIMPLE"));
    const input::CheckedEntries given(entries);
    toldByFoam([&]
    {
        given.refuseMisspelt
        ({
            "nOuterCorrectors", "nCorrectors", "nNonOrthogonalCorrectors", "momentumPredictor", "pRefCell", "pRefPoint", "pRefValue",
            "residualControl", "turbOnFinalIterOnly"
        });
        given.integer("nOuterCorrectors", 1, 1);
        given.integer("nCorrectors", 1, 1);
        given.integer("nNonOrthogonalCorrectors", 0, 0);
    });
}

/// In the last iterations the solvers called are those with "Final" behind the field's name.
void checkSolvers(const fvMesh& mesh)
{
    const dictionary& pimple = mesh.solutionDict().subOrEmptyDict("PIMPLE");
    const label outer = pimple.getOrDefault<label>("nOuterCorrectors", 1);
    const label inner =
        pimple.getOrDefault<label>("nCorrectors", 1)*(1 + pimple.getOrDefault<label>("nNonOrthogonalCorrectors", 0));

    const auto& symmetric = *lduMatrix::solver::symMatrixConstructorTablePtr_;
    checkSolver(mesh, "p_rghFinal", symmetric);
    if (outer*inner > 1) checkSolver(mesh, "p_rgh", symmetric);

    wordList transported = turbulenceFields(mesh);
    if (pimple.getOrDefault("momentumPredictor", true)) transported.append("U");
    for (const word& name : transported)
    {
        checkSolver(mesh, name + "Final", *lduMatrix::solver::asymMatrixConstructorTablePtr_);
        if (outer > 1) checkSolver(mesh, name, *lduMatrix::solver::asymMatrixConstructorTablePtr_);
    }
}

} // namespace


void checkFieldDimensions(const fvMesh& mesh)
{
    checkField<volVectorField>(mesh, "U", dimVelocity, "m/s");
    checkField<volScalarField>(mesh, "p_rgh", dimPressure, "Pa");
    if (!isTurbulent(mesh.time())) return;
    checkTransported(mesh, "k", dimVelocity*dimVelocity, "m2/s2", input::atLeast(0));
    checkTransported(mesh, "epsilon", dimVelocity*dimVelocity/dimTime, "m2/s3", input::above(0));
    checkTransported(mesh, "omega", dimless/dimTime, "1/s", input::above(0));
    checkTransported(mesh, "nut", dimViscosity, "m2/s", input::atLeast(0));
}


void checkTemperature(const fvMesh& mesh)
{
    const volScalarField field = checkField<volScalarField>(mesh, "T", dimTemperature, "K");
    const auto check = [&](const scalarField& values, const string& where)
    {
        const scalar least = gMin(values);
        if (!(least > 0)) fail({placeOfLine(field.objectPath(), where), "is out of range", messageText(least), input::above(0).describe()});
    };
    check(field.primitiveField(), "internalField");
    for (const fvPatchScalarField& patch : field.boundaryField()) if (isA<fixedValueFvPatchScalarField>(patch)) check(patch, patch.patch().name());
}


void checkHeatNumerics(const surfaceScalarField& phi)
{
    const fvMesh& mesh = phi.mesh();
    fv::convectionScheme<scalar>::New(mesh, phi, mesh.divScheme("div(phi,T)"));
    fv::laplacianScheme<scalar, scalar>::New(mesh, mesh.laplacianScheme("laplacian(diffusivity,T)"));
    checkSolver(mesh, "T", *lduMatrix::solver::asymMatrixConstructorTablePtr_);
}


void checkTransportProperties(const Time& time)
{
    const IOobject file("transportProperties", time.constant(), time, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    checkText(file);
    const IOdictionary dict(file);
    const input::Dictionary entries = valuesFromFoam(dict);
    const input::CheckedEntries given(entries);
    toldByFoam([&]
    {
        given.number("rho", input::above(0, input::unit::density));
        if (given.found("nu")) given.number("nu", input::above(0, input::unit::viscosity));
    });
}


void checkNumerics(const surfaceScalarField& phi, bool isAveraged)
{
    checkSolution(phi.mesh());
    checkPimple(phi.mesh());
    checkSchemes(phi.mesh(), phi, isAveraged);
    checkSolvers(phi.mesh());
}

} // namespace nscdCoupling
} // namespace Foam
