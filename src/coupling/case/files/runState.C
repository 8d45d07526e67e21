// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing and reading uniform/grainState.
#include "coupling/case/files/runState.H"
#include "coupling/case/files/restartFiles.H"
#include "coupling/case/files/writtenFiles.H"
#include "coupling/case/input/foamDictionary.H"

#include "input/dictionary/checkedEntries.hpp"

#include "IOdictionary.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "Time.H"

#include <fstream>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// While it lives, numbers are written with all their digits.
class FullPrecision
{
public:
    FullPrecision() : before_(IOstream::defaultPrecision(17)) {}
    ~FullPrecision() { IOstream::defaultPrecision(before_); }

private:
    unsigned before_;
};

IOobject stateFile(const polyMesh& mesh, IOobject::readOption read)
{
    return IOobject("grainState", mesh.time().timeName(), "uniform", mesh, read, IOobject::NO_WRITE, false);
}

void waitForAll()
{
    bool isHere = true;
    reduce(isHere, andOp<bool>());
}

} // namespace


void beginRunState(const Time& time)
{
    const fileName folder = time.timePath()/"uniform";
    // decomposePar makes links to the folder of the whole case.
    if (!isDir(folder, false)) rm(folder);
    mkDir(folder);
    std::ofstream mark(folder/"grainState");
    mark << "this time was not written to its end" << std::endl;
    if (!mark.good()) refuseUnwritten(folder/"grainState");
    waitForAll();
}


/// Without the count that OpenFOAM writes before a list: a user may take names out.
void addNames(dictionary& dict, const word& keyword, const fileNameList& names)
{
    OStringStream text;
    text << keyword << " (";
    for (const fileName& name : names) text << ' ' << string(name);
    text << " );";
    dict.merge(dictionary(IStringStream(text.str())()));
}


void writeRunState(const polyMesh& mesh, const RunState& state)
{
    const fileName folder = mesh.time().timePath();
    checkWritten(folder);
    waitForAll();
    const FullPrecision precision;
    IOdictionary dict(stateFile(mesh, IOobject::NO_READ));
    dict.add("grains", state.nGrains);
    dict.add("contacts", state.nContacts);
    dict.add("materials", state.materials);
    addNames(dict, "files", restartFiles(mesh.time()));
    dictionary numbers;
    for (const auto& number : state.numbers) numbers.add(number.first, number.second);
    dict.add("numbers", numbers);
    dict.writeObject(IOstream::ASCII, IOstream::currentVersion, IOstream::UNCOMPRESSED, true);
    checkWritten(folder/"uniform");
}


void writeExactTime(const Time& time)
{
    const FullPrecision precision;
    IOdictionary dict
    (
        IOobject("time", time.timeName(), "uniform", time, IOobject::MUST_READ, IOobject::NO_WRITE, false)
    );
    dict.set("deltaT", time.timeToUserTime(time.deltaTValue()));
    dict.set("deltaT0", time.timeToUserTime(time.deltaT0Value()));
    dict.writeObject(IOstream::ASCII, IOstream::currentVersion, IOstream::UNCOMPRESSED, true);
}


bool hasRunState(const polyMesh& mesh)
{
    IOobject file = stateFile(mesh, IOobject::READ_IF_PRESENT);
    // OpenFOAM goes on to look for it in the folder of the whole case.
    const bool isThere = isFile(mesh.time().timePath()/"uniform"/file.name());
    bool isWritten = file.typeHeaderOk<IOdictionary>(true) && isThere;
    Pstream::scatter(isWritten);
    return isWritten;
}


RunState readRunState(const polyMesh& mesh)
{
    const IOobject file = stateFile(mesh, IOobject::MUST_READ);
    if (!hasRunState(mesh)) fail({placeInFile(file.objectPath(), "grainState"), "is missing or has no header"});
    const IOdictionary dict(file);
    const input::Dictionary entries = fromFoam(dict);
    const input::CheckedEntries given(entries);
    RunState state;
    state.place = placeOf(dict);
    toldByFoam([&]
    {
        state.nGrains = label(given.integer("grains", 0));
        state.nContacts = label(given.integer("contacts", 0));
        for (const char* list : {"materials", "files"}) given.found(list);
        const input::CheckedEntries numbers(given.sub("numbers"));
        for (const input::Entry& number : numbers.dict().entries) state.numbers[number.keyword] = numbers.number(number.keyword, input::anyNumber());
        given.finish();
    });
    state.materials = dict.get<wordList>("materials");
    dict.readIfPresent("files", state.files);
    return state;
}

} // namespace nscdCoupling
} // namespace Foam
