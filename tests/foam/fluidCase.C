// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Writing the small case's dictionaries, and stepping it.

#include "fluidCase.H"

#include "fvcFlux.H"

#include <sstream>

namespace Foam
{
namespace nscdCoupling
{
namespace testing
{

namespace
{

const char* const sides[] = {"left", "right", "bottom", "top", "front", "back"};

std::string fieldFile
(
    const FluidCaseSettings& settings, const std::string& dimensions, const std::string& internal,
    const std::map<label, std::string>& borders, const std::string& wall
)
{
    std::ostringstream os;
    os << "dimensions " << dimensions << ";\ninternalField " << internal << ";\nboundaryField\n{\n";
    for (label side = 0; side < 6; ++side)
    {
        const word type = settings.box.patchTypes[side];
        const bool isPlain = type == "wall" || type == "patch";
        const auto given = borders.find(side);
        os << sides[side] << " { "
            << (given != borders.end() ? given->second : isPlain ? wall : "type " + type + ";") << " }\n";
    }
    os << "}\n";
    return os.str();
}

std::string schemes(const FluidCaseSettings& settings)
{
    return
        "ddtSchemes { default " + settings.ddt + "; } gradSchemes { default " + settings.gradient + "; }"
        "divSchemes { default Gauss linear; div(phi,U) " + settings.convection + "; }"
        "laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default " + settings.interpolation + "; }"
        "snGradSchemes { default corrected; }";
}

std::string solution(const FluidCaseSettings& settings)
{
    std::ostringstream os;
    os << "solvers { \"p_rgh.*\" { solver PCG; preconditioner DIC; tolerance " << settings.tolerance
        << "; relTol 0; maxIter 5000; }"
        << "\"(U|k|epsilon).*\" { solver PBiCGStab; preconditioner DILU; tolerance " << settings.tolerance << "; relTol 0; } }"
        << "PIMPLE { " << settings.pimple << " }";
    return os.str();
}

BoxMeshSettings withNumerics(const FluidCaseSettings& settings)
{
    BoxMeshSettings box = settings.box;
    box.schemes = schemes(settings);
    box.solution = solution(settings);
    return box;
}

template<class Type, class Function>
scalar l2Difference(const GeometricField<Type, fvPatchField, volMesh>& field, const Function& exact)
{
    const fvMesh& mesh = field.mesh();
    scalar sum = 0;
    forAll(field, celli) sum += mesh.V()[celli]*magSqr(field[celli] - exact(mesh.C()[celli]));
    return std::sqrt(sum/Foam::sum(mesh.V()).value());
}

template<class Type, class Function>
void setAll(GeometricField<Type, fvPatchField, volMesh>& field, const Function& f)
{
    const fvMesh& mesh = field.mesh();
    forAll(field, celli) field[celli] = f(mesh.C()[celli]);
    forAll(field.boundaryField(), patchi)
    {
        auto& patch = field.boundaryFieldRef()[patchi];
        if (!patch.fixesValue()) continue;
        forAll(patch, facei) patch[facei] = f(mesh.boundary()[patchi].Cf()[facei]);
    }
    field.correctBoundaryConditions();
}

} // End anonymous namespace


FluidCaseSettings::FluidCaseSettings()
{
    box.deltaT = 1e-2;
}


void FluidCaseSettings::setCells(const label nx, const label ny, const label nz)
{
    box.cells = labelVector(nx, ny, nz);
}


void FluidCaseSettings::setSize(const scalar x, const scalar y, const scalar z)
{
    box.max = point(x, y, z);
}


FluidCaseSettings planeCase(const label nx, const label ny, const scalar sizeX, const scalar sizeY)
{
    FluidCaseSettings settings;
    settings.setCells(nx, ny, 1);
    settings.setSize(sizeX, sizeY, sizeX/nx);
    settings.box.patchTypes = {"wall", "wall", "wall", "wall", "empty", "empty"};
    return settings;
}


FluidCaseSettings tubeCase(const label n, const scalar length)
{
    FluidCaseSettings settings;
    settings.setCells(n, 1, 1);
    settings.setSize(length, 0.1*length, 0.1*length);
    settings.box.patchTypes =
        {"patch", "patch", "symmetryPlane", "symmetryPlane", "symmetryPlane", "symmetryPlane"};
    return settings;
}


FluidCase::FluidCase(const FluidCaseSettings& settings)
:
    box_(withNumerics(settings)),
    sources_((writeCase(settings), box_.mesh()))
{
    messageStream::level = 0;
    sources_.hasGrains = true;
}


void FluidCase::writeCase(const FluidCaseSettings& settings) const
{
    std::ostringstream transport, gravity;
    gravity.precision(17);
    transport << "transportModel Newtonian; nu " << settings.nu << "; rho " << settings.rho << ";";
    gravity << "dimensions [0 1 -2 0 0 0 0]; value (" << settings.gravity.x() << ' ' << settings.gravity.y() << ' '
        << settings.gravity.z() << ");";
    box_.writeFile("constant/transportProperties", transport.str());
    box_.writeFile("constant/turbulenceProperties", settings.turbulence);
    box_.writeFile("constant/g", gravity.str());
    box_.writeFile
    (
        "0/U", fieldFile(settings, "[0 1 -1 0 0 0 0]", settings.U0, settings.borderU, "type noSlip;")
    );
    box_.writeFile
    (
        "0/p_rgh",
        fieldFile(settings, "[1 -1 -2 0 0 0 0]", settings.pRgh0, settings.borderP, "type zeroGradient;")
    );
}


FluidSolver& FluidCase::fluid()
{
    if (!fluid_)
    {
        sources_.correctBoundaryConditions();
        fluid_.reset(new FluidSolver(box_.mesh(), sources_, meanFlow_));
    }
    return *fluid_;
}


void FluidCase::setMeanFlow(const vector& target)
{
    meanFlow_.set("target", target);
}


void FluidCase::setVelocity(const VectorFunction& u)
{
    fluid();
    auto& U = mesh().lookupObjectRef<volVectorField>("U");
    setCells(U, u);
    mesh().lookupObjectRef<surfaceScalarField>("phi") = fvc::flux(sources_.fluidFraction*U);
}


void FluidCase::step(const std::function<void()>& change)
{
    fluid();
    ++time();
    sources_.beginStep();
    if (change) change();
    sources_.correctBoundaryConditions();
    fluid().solve();
}


void FluidCase::steps(const label n, const std::function<void()>& change)
{
    for (label i = 0; i < n; ++i) step(change);
}


void setCells(volScalarField& field, const PointFunction& f)
{
    setAll(field, f);
}


void setCells(volVectorField& field, const VectorFunction& f)
{
    setAll(field, f);
}


scalar l2Error(const volScalarField& field, const PointFunction& exact)
{
    return l2Difference(field, exact);
}


scalar l2Error(const volVectorField& field, const VectorFunction& exact)
{
    return l2Difference(field, exact);
}

} // End namespace testing
} // End namespace nscdCoupling
} // End namespace Foam
