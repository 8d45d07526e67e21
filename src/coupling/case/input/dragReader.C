// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The law by its name, and the table of a user's own.
#include "coupling/case/input/dragReader.H"

#include "input/dictionary/checkedEntries.hpp"
#include "input/lists/textRows.hpp"

#include <stdexcept>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

input::Words lawWords()
{
    input::Words words = {"none", "table"};
    for (const closures::DragLawRow& row : closures::dragLaws())
    {
        words.push_back(row.name);
        if (row.alias[0]) words.push_back(row.alias);
    }
    return words;
}

closures::DragTable readTable(const std::string& path, const input::Place& place)
{
    std::vector<closures::DragTableRow> rows;
    for (const input::NumberRow& row : input::readNumberTable(path, {"Re", "alpha", "Cd"}, place))
    {
        rows.push_back({row.values[0], row.values[1], row.values[2]});
    }
    try
    {
        return closures::DragTable(rows);
    }
    catch (const std::invalid_argument& error)
    {
        throw input::InputError({place, "names a file that is no table of drag coefficients: " + std::string(error.what()), path,
            "rows of Re alpha Cd, every alpha with every Re"});
    }
}

} // namespace


DragSettings readDrag(const input::CheckedEntries& forces, const input::Surroundings& around)
{
    const input::Dictionary dict = forces.subOrEmpty("drag");
    const input::CheckedEntries given(dict);
    DragSettings settings;
    settings.law = given.choice("law", lawWords(), settings.law);
    if (settings.law == "table") settings.table = readTable(around.pathOfGrains(given.text("table")), given.place("table"));
    settings.weight = given.choice("weight", {"exponential", "backwardEuler"}, settings.weight);
    settings.isPolydisperse = given.flag("polydisperse", settings.isPolydisperse);
    settings.polydispersePlace = given.place("polydisperse");
    settings.correctsOwnWake = given.flag("ownWakeCorrection", settings.correctsOwnWake);
    given.finish();
    return settings;
}

} // namespace nscdCoupling
} // namespace Foam
