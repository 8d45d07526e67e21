// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding the probed grains on the ranks that own them.
#include "functionObjects/grainProbes.H"

#include "functionObjects/functionEntries.H"

#include "addToRunTimeSelectionTable.H"

#include <algorithm>

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(GrainProbes, 0);
addToRunTimeSelectionTable(functionObject, GrainProbes, dictionary);

namespace
{

constexpr label nColumns = 7;
const char* const columnsOfGrain[nColumns] = {"present", "x", "y", "z", "ux", "uy", "uz"};

} // namespace


GrainProbes::GrainProbes(const word& name, const Time& runTime, const dictionary& dict)
:
    GrainTable(name, runTime, dict, typeName)
{
    read(dict);
}


bool GrainProbes::read(const dictionary& dict)
{
    nscdCoupling::readFunction(dict, [this](const input::CheckedEntries& entries) { ids_ = entries.integers("ids", 0); });
    const bool isRead = GrainTable::read(dict);
    writeHead("Grains by their ids: position [m], velocity [m/s]", columns());
    return isRead;
}


std::vector<std::string> GrainProbes::columns() const
{
    std::vector<std::string> columns;
    for (const long id : ids_)
    {
        for (const char* column : columnsOfGrain) columns.push_back(std::to_string(id) + "." + column);
    }
    return columns;
}


scalarList GrainProbes::values() const
{
    scalarList values(nColumns*label(ids_.size()), scalar(0));
    const ::nscd::Grains& grains = access().grains();
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const auto probe = std::find(ids_.begin(), ids_.end(), grains.id[i]);
        if (probe == ids_.end()) continue;
        const label first = nColumns*label(probe - ids_.begin());
        values[first] = 1;
        for (int k = 0; k < 3; ++k)
        {
            values[first + 1 + k] = grains.position[i][k];
            values[first + 4 + k] = grains.velocity[i][k];
        }
    }
    Pstream::listCombineGather(values, plusEqOp<scalar>());
    return values;
}


bool GrainProbes::write()
{
    const scalarList row = values();
    if (!hasFile()) return true;
    writeCurrentTime(file());
    for (const scalar value : row) file() << tab << value;
    file() << endl;
    return true;
}

} // namespace functionObjects
} // namespace Foam
