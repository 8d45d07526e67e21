// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Complaints about a user's input, told through OpenFOAM's FatalIOError.
#include "coupling/case/input/inputError.H"

#include "nscd/base/nearestWord.hpp"

#include "IFstream.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

string joined(const Words& words)
{
    string text;
    for (const std::string& w : words) text += (text.empty() ? "" : ", ") + w;
    return text;
}

/// Path of a sub-dictionary below its file, with a trailing dot; empty at the top.
string pathBelowFile(const dictionary& dict)
{
    const string top = dict.topDict().name();
    const string name = dict.name();
    return name.size() > top.size() + 1 ? string(name.substr(top.size() + 1)) + "." : string();
}

} // namespace


void fail(const InputError& error)
{
    const InputPlace& place = error.place;
    Ostream& os = FatalIOError
    (
        FUNCTION_NAME, __FILE__, __LINE__, place.file, place.firstLine, place.lastLine
    );
    os << "keyword: " << place.keyword.c_str() << " " << error.problem.c_str();
    if (!error.value.empty()) os << nl << "value:   " << error.value.c_str();
    if (!error.allowed.empty()) os << nl << "allowed: " << error.allowed.c_str();
    if (!error.words.empty()) os << nl << "allowed: " << joined(error.words).c_str();
    const std::string nearest = ::nscd::nearestWord(error.value, error.words);
    if (!nearest.empty()) os << nl << "nearest: " << nearest.c_str();
    FatalIOError.exit();
    std::abort();
}


InputPlace placeOf(const dictionary& dict)
{
    const string path = pathBelowFile(dict);
    const string keyword = path.empty() ? string("(file)") : string(path.substr(0, path.size() - 1));
    return {dict.topDict().name(), dict.startLineNumber(), dict.endLineNumber(), keyword};
}


InputPlace placeOf(const dictionary& dict, const word& keyword)
{
    InputPlace place = placeOf(dict);
    place.keyword = pathBelowFile(dict) + keyword;
    const entry* found = dict.findEntry(keyword, keyType::LITERAL);
    if (found && found->startLineNumber() >= 0)
    {
        place.firstLine = found->startLineNumber();
        place.lastLine = found->endLineNumber();
    }
    return place;
}


InputPlace placeInFile(const fileName& file, const string& keyword)
{
    InputPlace place;
    place.file = file;
    place.keyword = keyword;
    return place;
}


InputPlace placeInDictionaryFile(const fileName& file, const word& keyword)
{
    IFstream is(file);
    if (!is.good()) return placeInFile(file, keyword);
    const dictionary dict(file, dictionary::null, is);
    return placeOf(dict, keyword);
}


string valueText(const dictionary& dict, const word& keyword)
{
    const entry* found = dict.findEntry(keyword, keyType::LITERAL);
    if (!found || found->isDict()) return string::null;
    string text;
    for (const token& tok : found->stream()) text += (text.empty() ? "" : " ") + messageText(tok);
    return text;
}


Words toWords(const UList<word>& names)
{
    return Words(names.begin(), names.end());
}

} // namespace nscdCoupling
} // namespace Foam
