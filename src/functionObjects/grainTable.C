// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The head of a table.
#include "functionObjects/grainTable.H"

#include "coupling/case/input/inputError.H"

namespace Foam
{
namespace functionObjects
{

GrainTable::GrainTable(const word& name, const Time& runTime, const dictionary& dict, const word& type)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, type, dict),
    access_(nscdCoupling::GrainAccess::of(mesh_, nscdCoupling::placeOf(dict)))
{}


bool GrainTable::read(const dictionary& dict)
{
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


void GrainTable::writeHead(const std::string& title, const std::vector<std::string>& columns)
{
    if (!hasFile()) return;
    writeHeader(file(), title);
    writeCommented(file(), "Time");
    for (const std::string& column : columns) writeTabbed(file(), column);
    file() << endl;
}

} // namespace functionObjects
} // namespace Foam
