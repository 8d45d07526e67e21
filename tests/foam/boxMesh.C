// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Points, faces and patches of the box, and the scratch case folder that OpenFOAM's readers need.

#include "boxMesh.H"

#include "OSspecific.H"
#include "error.H"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace Foam
{
namespace nscdCoupling
{
namespace testing
{

namespace
{

const wordList sideNames({"left", "right", "bottom", "top", "front", "back"});

//- Faces as fvMesh wants them: internal ones by owner then neighbour, then side after side.
struct Faces
{
    std::vector<face> corners;
    std::vector<label> owner, neighbour;
    label sideStart[6], sideSize[6];
};


class Lattice
{
public:

    explicit Lattice(const BoxMeshSettings& settings) : settings_(settings), n_(settings.cells) {}

    pointField points() const;
    Faces faces() const;

private:

    label cell(const labelVector& c) const { return c[0] + n_[0]*(c[1] + n_[1]*c[2]); }
    label vertex(const labelVector& v) const { return v[0] + (n_[0] + 1)*(v[1] + (n_[1] + 1)*v[2]); }

    //- The face of cell c normal to the axis, on its lower side; the normal points up the axis.
    face lowerFace(labelVector c, label axis) const;

    void addInternal(Faces& faces) const;
    void addSide(Faces& faces, label side) const;

    const BoxMeshSettings& settings_;
    const labelVector n_;
};


pointField Lattice::points() const
{
    pointField points((n_[0] + 1)*(n_[1] + 1)*(n_[2] + 1));
    const vector size = settings_.max - settings_.min;
    labelVector v;
    for (v[2] = 0; v[2] <= n_[2]; ++v[2])
    for (v[1] = 0; v[1] <= n_[1]; ++v[1])
    for (v[0] = 0; v[0] <= n_[0]; ++v[0])
    {
        point p = settings_.min;
        for (direction d = 0; d < 3; ++d) p[d] += size[d]*v[d]/n_[d];
        points[vertex(v)] = settings_.movePoint ? settings_.movePoint(p) : p;
    }
    return points;
}


face Lattice::lowerFace(labelVector c, label axis) const
{
    const label b = (axis + 1) % 3, d = (axis + 2) % 3;
    face f(4);
    f[0] = vertex(c);
    ++c[b];
    f[1] = vertex(c);
    ++c[d];
    f[2] = vertex(c);
    --c[b];
    f[3] = vertex(c);
    return f;
}


void Lattice::addInternal(Faces& faces) const
{
    labelVector c;
    for (c[2] = 0; c[2] < n_[2]; ++c[2])
    for (c[1] = 0; c[1] < n_[1]; ++c[1])
    for (c[0] = 0; c[0] < n_[0]; ++c[0])
    for (label axis = 0; axis < 3; ++axis)
    {
        labelVector next = c;
        if (++next[axis] == n_[axis]) continue;
        faces.corners.push_back(lowerFace(next, axis));
        faces.owner.push_back(cell(c));
        faces.neighbour.push_back(cell(next));
    }
}


// Opposite sides list their faces in the same order, and each face begins at the same corner: a cyclic pair matches.
void Lattice::addSide(Faces& faces, const label side) const
{
    const label axis = side/2, b = (axis + 1) % 3, d = (axis + 2) % 3;
    const bool upper = side % 2;
    faces.sideStart[side] = label(faces.corners.size());
    faces.sideSize[side] = n_[b]*n_[d];

    labelVector c = labelVector::zero;
    for (c[d] = 0; c[d] < n_[d]; ++c[d])
    for (c[b] = 0; c[b] < n_[b]; ++c[b])
    {
        c[axis] = upper ? n_[axis] - 1 : 0;
        faces.owner.push_back(cell(c));
        c[axis] = upper ? n_[axis] : 0;
        const face f = lowerFace(c, axis);
        faces.corners.push_back(upper ? f : f.reverseFace());
    }
}


Faces Lattice::faces() const
{
    Faces faces;
    addInternal(faces);
    for (label side = 0; side < 6; ++side) addSide(faces, side);
    return faces;
}


template<class To, class From>
To copyOf(const From& from)
{
    To to(label(from.size()));
    std::copy(from.begin(), from.end(), to.begin());
    return to;
}


void addPatches(fvMesh& mesh, const Faces& faces, const wordList& types)
{
    PtrList<polyPatch> patches(6);
    for (label side = 0; side < 6; ++side)
    {
        dictionary dict;
        dict.add("type", types[side]);
        dict.add("nFaces", faces.sideSize[side]);
        dict.add("startFace", faces.sideStart[side]);
        if (types[side] == "cyclic") dict.add("neighbourPatch", sideNames[side ^ 1]);
        patches.set(side, polyPatch::New(sideNames[side], dict, side, mesh.boundaryMesh()));
    }
    mesh.addFvPatches(patches);
}


fileName makeScratchFolder()
{
    const char* tmp = std::getenv("TMPDIR");
    std::string path = std::string(tmp ? tmp : "/tmp") + "/nscdDEMFoamTest.XXXXXX";
    if (!::mkdtemp(&path[0])) throw std::runtime_error("cannot make the folder " + path);
    return fileName(path);
}


dictionary controlDict(const BoxMeshSettings& settings)
{
    dictionary dict;
    dict.add("startTime", 0);
    dict.add("endTime", 1e10);
    dict.add("deltaT", settings.deltaT);
    dict.add("writeControl", "timeStep");
    dict.add("writeInterval", 1000000);
    dict.add("writePrecision", 17);
    dict.add("timePrecision", 12);
    dict.add("runTimeModifiable", false);
    dict.merge(settings.control);
    return dict;
}


std::unique_ptr<fvMesh> makeMesh(const Time& time, const BoxMeshSettings& settings)
{
    const Lattice lattice(settings);
    const Faces faces = lattice.faces();

    // READ_IF_PRESENT, for with NO_READ fvSchemes and fvSolution would not be read either; no mesh file is there.
    std::unique_ptr<fvMesh> mesh
    (
        new fvMesh
        (
            IOobject
            (
                fvMesh::defaultRegion, time.timeName(), time, IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
            ),
            lattice.points(),
            copyOf<faceList>(faces.corners),
            copyOf<labelList>(faces.owner),
            copyOf<labelList>(faces.neighbour)
        )
    );
    addPatches(*mesh, faces, settings.patchTypes);
    return mesh;
}

} // End anonymous namespace


BoxMesh::BoxMesh(const BoxMeshSettings& settings)
:
    casePath_(makeScratchFolder())
{
    writeFile("system/fvSchemes", settings.schemes);
    writeFile("system/fvSolution", settings.solution);
    time_.reset(new Time(controlDict(settings), casePath_.path(), casePath_.name(), "system", "constant", false));
    mesh_ = makeMesh(*time_, settings);
}


BoxMesh::~BoxMesh()
{
    mesh_.reset();
    time_.reset();
    rmDir(casePath_);
}


void BoxMesh::writeFile(const fileName& path, const std::string& contents) const
{
    const fileName full = casePath_/path;
    mkDir(full.path());
    // decomposePar takes those for fields that say so.
    const bool isField = contents.find("internalField") != std::string::npos;
    const auto has = [&](const char* dimensions) { return contents.find(dimensions) != std::string::npos; };
    const bool isVector = has("dimensions [0 1 -1 0 0 0 0]") || has("dimensions [0 1 -2 0 0 0 0]");
    std::ofstream(full)
        << "FoamFile { version 2.0; format ascii; class " << (!isField ? "dictionary" : isVector ? "volVectorField" : "volScalarField")
        << "; object " << full.name() << "; }\n"
        << contents << '\n';
}


std::string errorMessage(const std::function<void()>& action)
{
    try
    {
        action();
    }
    catch (const Foam::error& raised)
    {
        return raised.message();
    }
    return std::string();
}

} // End namespace testing
} // End namespace nscdCoupling
} // End namespace Foam
