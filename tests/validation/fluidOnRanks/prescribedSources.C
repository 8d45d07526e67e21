// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// A case of the averaged fluid with the grains' sources given by formulas, on one rank or several: constant/prescribedSources.

#include "coupling/fluid/fluidSolver.H"
#include "coupling/fluid/rankPatches.H"

#include "IOdictionary.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::nscdCoupling;

namespace
{

/// Grains in a box that moves, with edges half a millimeter wide; every source is its value times the weight.
class PrescribedGrains
{
public:

    explicit PrescribedGrains(const dictionary& dict)
    :
        dict_(dict),
        lower_(dict.get<point>("lower")),
        upper_(dict.get<point>("upper")),
        velocity_(dict.getOrDefault<vector>("velocity", Zero)),
        ripple_(dict.getOrDefault<scalar>("ripple", 0)),
        wave_(dict.getOrDefault<vector>("wave", Zero))
    {}

    /// Writes alpha too: to be called between beginStep() and the solve.
    void write(GrainSources& sources) const
    {
        const scalarField w(weights(sources.fluidFraction.mesh()));
        sources.fluidFraction.primitiveFieldRef() = 1 - value("solids")*w;
        sources.drag.primitiveFieldRef() = value("drag")*w;
        sources.acceleration.primitiveFieldRef() = w*vectorOf("acceleration");
        sources.pressure.primitiveFieldRef() = value("pressure")*w;
        sources.carried.primitiveFieldRef() = w*vectorOf("carried");
        sources.slip.primitiveFieldRef() = value("slip")*w;
        sources.mobility.primitiveFieldRef() = value("mobility")*w;
        sources.correctBoundaryConditions();
    }

private:

    scalar value(const word& name) const { return dict_.getOrDefault<scalar>(name, 0); }
    vector vectorOf(const word& name) const { return dict_.getOrDefault<vector>(name, Zero); }

    scalarField weights(const fvMesh& mesh) const
    {
        const vectorField& C = mesh.C().primitiveField();
        scalarField w(C.size());
        forAll(w, i) w[i] = weight(C[i] - mesh.time().value()*velocity_);
        return w;
    }

    /// Continuous, so that cell centers which differ by round-off from one way of cutting the mesh to another matter not.
    scalar weight(const point& x) const
    {
        scalar w = 1 - ripple_*(0.5 + 0.5*std::sin(wave_.x()*x.x())*std::sin(wave_.y()*x.y()));
        for (direction d = 0; d < 2; ++d)
        {
            const scalar inside = min(x[d] - lower_[d], upper_[d] - x[d])/5e-4;
            w *= min(scalar(1), max(scalar(0), 0.5 + inside));
        }
        return w;
    }

    const dictionary& dict_;
    const point lower_, upper_;
    const vector velocity_;
    const scalar ripple_;
    const vector wave_;
};

void disturb(volScalarField& pRgh, const scalar amplitude)
{
    const vectorField& C = pRgh.mesh().C().primitiveField();
    forAll(pRgh, i) pRgh[i] += amplitude*std::sin(777*C[i].x())*std::cos(555*C[i].y());
    fillRankPatches(pRgh);
}

void print(const char* name, const vector& v)
{
    Info<< "figure " << name << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << nl;
}

void printFigures(const FluidSolver& fluid, const scalar fastest)
{
    const FluidMomentum momentum = fluid.momentum();
    print("momentum", momentum.inside);
    print("convected", momentum.convected);
    print("pressureForce", momentum.pressureForce);
    print("viscousForce", momentum.viscousForce);
    print("meanFlowGradient", fluid.meanFlowGradient());
    print("courant", vector(fluid.courantNumber().mean, fluid.courantNumber().max, 0));
    Info<< "limit continuity " << fluid.continuityError().largest << nl
        << "limit fastest " << fastest << endl;
}

} // End anonymous namespace

int main(int argc, char* argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    fvMesh mesh(IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));
    const IOdictionary dict(IOobject("prescribedSources", runTime.constant(), runTime, IOobject::MUST_READ));
    Sout.precision(17);

    const PrescribedGrains grains(dict);
    GrainSources sources(mesh);
    sources.hasGrains = true;
    sources.hasResponse = dict.get<bool>("responds");
    grains.write(sources);
    FluidSolver fluid(mesh, sources, dict.subOrEmptyDict("meanFlow"));
    disturb(const_cast<volScalarField&>(fluid.pRgh()), dict.getOrDefault<scalar>("disturbed", 0));

    scalar fastest = 0;
    while (runTime.run())
    {
        ++runTime;
        sources.beginStep();
        grains.write(sources);
        fluid.solve();
        fastest = max(fastest, gMax(mag(fluid.U().primitiveField())()));
        runTime.write();
    }
    printFigures(fluid, fastest);
    return 0;
}
