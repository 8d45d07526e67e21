// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// From mistakes to OpenFOAM's FatalIOError.
#include "coupling/case/input/inputError.H"

#include "coupling/base/openFoamVersions.H"

#include "IFstream.H"

namespace Foam
{
namespace nscdCoupling
{

void fail(const input::Mistake& mistake)
{
    const Place& place = mistake.place;
    const label line = place.line > 0 ? place.line : -1;
    FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, place.file, line, line) << input::describe(mistake).c_str();
    FatalIOError.exit();
    std::abort();
}


Place placeOf(const dictionary& dict)
{
    return {dict.topDict().name(), int(max(label(0), dict.startLineNumber())), dottedName(dict)};
}


Place placeOf(const dictionary& dict, const word& keyword)
{
    Place place = placeOf(dict);
    const entry* found = dict.findEntry(keyword, keyType::LITERAL);
    if (found && found->startLineNumber() > 0) place.line = int(found->startLineNumber());
    place.keyword += (place.keyword.empty() ? "" : ".") + keyword;
    return place;
}


Place placeInDictionaryFile(const fileName& file, const word& keyword)
{
    IFstream is(file);
    if (!is.good()) return placeInFile(file, keyword);
    const dictionary dict(file, dictionary::null, is);
    return placeOf(dict, keyword);
}

} // namespace nscdCoupling
} // namespace Foam
