// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Comparing processor folders with one another and with the case.
#include "coupling/case/files/processorFolders.H"
#include "coupling/case/files/processorNames.H"
#include "coupling/case/input/inputError.H"

#include "HashSet.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "PtrList.H"
#include "SubField.H"
#include "Time.H"
#include "entry.H"
#include "processorCyclicPolyPatch.H"

#include <map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const char* const cutAnew = "parts of one mesh, one for each rank: decomposePar -force (it removes what the folders hold)";

dictionary readHeader(IFstream& is)
{
    const token keyword(is);
    return dictionary(is);
}

/// Number of cells of a mesh as the header of its file `owner` notes it; -1 without a note.
label notedCells(const fileName& polyMeshFolder)
{
    IFstream is(polyMeshFolder/"owner");
    if (!is.good()) return -1;
    const string note = readHeader(is).getOrDefault<string>("note", "");
    const std::string name = "nCells:";
    const std::size_t at = note.find(name);
    return at == std::string::npos ? -1 : label(std::atol(note.c_str() + at + name.size()));
}

void checkNumber(const argList& args, const fileName& wholeCase)
{
    const bool isMissing = !isDir(args.path());
    if (returnReduce(isMissing, orOp<bool>()))
    {
        const string names = processorsWhere(isMissing);
        fail({placeInFile(wholeCase, "processor folders"), "are missing for some of the ranks of mpirun", names, cutAnew});
    }
    // redistributePar leaves folders without cells behind.
    const word next = "processor" + Foam::name(Pstream::nProcs());
    bool isLeftOut = Pstream::master() && isDir(wholeCase/next) && notedCells(wholeCase/next/"constant/polyMesh") != 0;
    if (!returnReduce(isLeftOut, orOp<bool>())) return;
    fail
    ({
        placeInFile(wholeCase/next, "processor folders"), "are more than the ranks of mpirun", next + " and "
            + Foam::name(Pstream::nProcs()) + " ranks", cutAnew
    });
}

/// Faces that this rank's part of the mesh shares with other parts, by their rank.
std::map<label, label> sharedFaces(const fileName& processorFolder)
{
    std::map<label, label> faces;
    IFstream is(processorFolder/"constant/polyMesh/boundary");
    if (!is.good()) return faces;
    readHeader(is);
    const PtrList<entry> patches(is);
    for (const entry& patch : patches)
    {
        const dictionary& dict = patch.dict();
        if (dict.found("neighbProcNo")) faces[dict.get<label>("neighbProcNo")] += dict.get<label>("nFaces");
    }
    return faces;
}

void checkSharedFaces(const argList& args, const fileName& wholeCase)
{
    const std::map<label, label> mine = sharedFaces(args.path());
    labelListList triples(Pstream::nProcs());
    for (const auto& shared : mine)
    {
        if (shared.second > 0) triples[Pstream::myProcNo()].append(labelList({Pstream::myProcNo(), shared.first, shared.second}));
    }
    Pstream::gatherList(triples);
    string first;
    if (Pstream::master())
    {
        std::map<std::pair<label, label>, label> all;
        for (const labelList& rank : triples)
        {
            for (label k = 0; k < rank.size(); k += 3) all[{rank[k], rank[k + 1]}] = rank[k + 2];
        }
        for (const auto& shared : all)
        {
            const auto back = all.find({shared.first.second, shared.first.first});
            if (back != all.end() && back->second == shared.second) continue;
            first = messageText("processor", shared.first.first, " shares ", shared.second, " faces with processor", shared.first.second,
                ", which shares ", back == all.end() ? 0 : back->second, " with it");
            break;
        }
    }
    Pstream::scatter(first);
    if (!first.empty()) fail({placeInFile(wholeCase, "processor folders"), "are of different decompositions", first, cutAnew});
}

/// Whether the faces that two parts share lie in the same places; those of cyclic patches lie a period apart.
bool isMetByNeighbor(const polyPatch& patch)
{
    if (!isA<processorPolyPatch>(patch) || isA<processorCyclicPolyPatch>(patch)) return true;
    const auto& shared = refCast<const processorPolyPatch>(patch);
    if (shared.neighbFaceCentres().size() != shared.size()) return false;
    constexpr scalar tolerance = 1e-2;   // of a face's length: far more than written digits lose, far less than another face is away
    forAll(shared, face)
    {
        const scalar length = std::sqrt(mag(shared.faceAreas()[face]));
        if (mag(shared.faceCentres()[face] - shared.neighbFaceCentres()[face]) > tolerance*length) return false;
    }
    return true;
}

void checkOrigin(const polyMesh& mesh)
{
    const fileName folder = mesh.facesInstance()/polyMesh::meshSubDir;
    // Meshing on several ranks removes the addressing: the case's mesh is then the one that was meshed from.
    const bool isCut = isFile(mesh.time().path()/folder/"cellProcAddressing");
    if (!returnReduce(isCut, andOp<bool>())) return;
    const label found = returnReduce(mesh.nCells(), sumOp<label>());
    label whole = Pstream::master() ? notedCells(mesh.time().globalPath()/folder) : -1;
    Pstream::scatter(whole);
    if (whole < 0 || whole == found) return;
    fail
    ({
        placeInFile(mesh.time().globalPath()/folder, "processor folders"), "were cut from another mesh than this one",
        Foam::name(found) + " cells in all", Foam::name(whole) + " cells: decomposePar -force (it removes what the folders hold)"
    });
}

wordList fieldFiles(const fileName& folder)
{
    wordList names;
    for (const fileName& file : readDir(folder, fileName::FILE)) names.append(file.name());
    return names;
}

} // namespace


void checkProcessorFolders(const argList& args)
{
    if (!Pstream::parRun()) return;
    const fileName wholeCase = args.rootPath()/args.globalCaseName();
    checkNumber(args, wholeCase);
    checkSharedFaces(args, wholeCase);
}


void checkMeshParts(const polyMesh& mesh)
{
    if (!Pstream::parRun()) return;
    bool isMet = true;
    for (const polyPatch& patch : mesh.boundaryMesh()) isMet = isMet && isMetByNeighbor(patch);
    if (!returnReduce(isMet, andOp<bool>()))
    {
        const string names = processorsWhere(!isMet) + " have faces that are elsewhere on the processor they share them with";
        fail({placeInFile(mesh.time().globalPath(), "processor folders"), "are of different decompositions", names, cutAnew});
    }
    checkOrigin(mesh);
}


void checkFieldsOfAll(const Time& time)
{
    if (!Pstream::parRun()) return;
    const wordHashSet mine(fieldFiles(time.timePath()));
    wordList all = mine.sortedToc();
    Pstream::combineGather(all, ListOps::uniqueEqOp<word>());
    Pstream::combineScatter(all);
    for (const word& name : all)
    {
        const bool isMissing = !mine.found(name);
        if (!returnReduce(isMissing, orOp<bool>())) continue;
        const string names = processorsWhere(isMissing);
        fail
        ({
            placeInFile(time.globalPath()/"processor*"/time.timeName()/name, name), "is missing on some processors", names,
            "the files of one written time on all; or remove the directory " + time.timeName()
                + " of all processors, and the run continues from the time before it"
        });
    }
}

} // namespace nscdCoupling
} // namespace Foam
