// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// A box mesh, whole on every rank and decomposed by OpenFOAM.

#include "ranksMesh.H"

#include "labelIOList.H"

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace Foam
{
namespace nscdCoupling
{
namespace testing
{

Decomposition slices()
{
    return {labelVector(Pstream::nProcs(), 1, 1), {}};
}


Decomposition blocks()
{
    labelVector parts(1, 1, 1);
    label left = Pstream::nProcs();
    for (direction axis = 0; axis < 3 && left % 2 == 0; ++axis, left /= 2) parts[axis] = 2;
    parts[1] *= left;
    return {parts, {}};
}


Decomposition scattered()
{
    const unsigned n = Pstream::nProcs();
    return {labelVector(1, 1, 1), [n](const label cell) { return label((unsigned(cell)*2654435761u >> 16) % n); }};
}


RanksMesh::RanksMesh(const BoxMeshSettings& settings, const Decomposition& decomposition)
{
    {
        const SerialSection serial;
        whole_.reset(new BoxMesh(settings));
    }
    casePath_ = whole_->casePath();
    addressing_.setSize(Pstream::nProcs());
    if (Pstream::parRun())
    {
        if (Pstream::master())
        {
            const SerialSection serial;
            decompose(decomposition);
        }
        Pstream::scatter(casePath_);
        readPart();
    }
    else
    {
        addressing_[0] = identity(whole().nCells());
    }
    rankOf_.setSize(whole_->mesh().nCells());
    forAll(addressing_, rank)
    {
        for (const label cell : addressing_[rank]) rankOf_[cell] = rank;
    }
}


RanksMesh::~RanksMesh()
{
    part_.reset();
    time_.reset();
    label allAreDone = 1;
    reduce(allAreDone, sumOp<label>());
    const SerialSection serial;
    whole_.reset();
}


void RanksMesh::decompose(const Decomposition& decomposition)
{
    whole().setInstance("constant");
    whole().write();
    std::ostringstream dict;
    dict << "numberOfSubdomains " << UPstream::nProcs(UPstream::worldComm) << "; ";
    if (decomposition.rankOf)
    {
        std::ofstream file(casePath_/"constant/cellDecomposition");
        file << "FoamFile { version 2.0; format ascii; class labelList; object cellDecomposition; }\n";
        file << whole().nCells() << "\n(";
        for (label cell = 0; cell < whole().nCells(); ++cell) file << '\n' << decomposition.rankOf(cell);
        file << "\n)\n";
        dict << "method manual; manualCoeffs { dataFile \"cellDecomposition\"; }";
    }
    else
    {
        const labelVector& n = decomposition.parts;
        dict << "method simple; simpleCoeffs { n (" << n[0] << ' ' << n[1] << ' ' << n[2] << "); delta 0.001; }";
    }
    whole_->writeFile("system/decomposeParDict", dict.str());
    whole_->writeFile
    (
        "system/controlDict",
        "startTime 0; endTime 1; deltaT 1; writeInterval 1000000; writePrecision 17; runTimeModifiable false;"
    );
    const std::string command = "decomposePar -case " + casePath_ + " > " + casePath_ + "/log.decomposePar 2>&1 < /dev/null";
    if (std::system(command.c_str()) != 0)
    {
        std::system(("tail -n 30 " + casePath_ + "/log.decomposePar >&2").c_str());
        FatalErrorInFunction << "decomposePar failed" << exit(FatalError);
    }
}


void RanksMesh::readPart()
{
    const label rank = Pstream::myProcNo();
    time_.reset
    (
        new Time
        (
            "controlDict", casePath_.path(), casePath_.name()/("processor" + Foam::name(rank)), "system", "constant", false, false
        )
    );
    part_.reset(new fvMesh(IOobject(fvMesh::defaultRegion, time_->timeName(), *time_, IOobject::MUST_READ)));
    addressing_[rank] = labelIOList
    (
        IOobject
        (
            "cellProcAddressing", part_->facesInstance(), polyMesh::meshSubDir, *part_, IOobject::MUST_READ, IOobject::NO_WRITE
        )
    );
    Pstream::gatherList(addressing_);
    Pstream::scatterList(addressing_);
}

} // End namespace testing
} // End namespace nscdCoupling
} // End namespace Foam
