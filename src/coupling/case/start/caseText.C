// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading files once more, as text.
#include "coupling/case/start/caseText.H"

#include "coupling/case/input/inputError.H"
#include "coupling/case/start/controlEdits.H"
#include "coupling/case/start/initialChecks.H"

#include "input/dictionary/openFoamText.hpp"

#include "polyMesh.H"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// The text of a file; empty where there is none, or where its header says that it is binary.
std::string textOf(const std::string& path)
{
    constexpr std::size_t longestHeader = 2000;
    std::ifstream file(path, std::ios::binary);
    std::string text(longestHeader, '\0');
    file.read(&text[0], longestHeader);
    text.resize(std::size_t(file.gcount()));
    const std::size_t format = text.find("format");
    const std::size_t word = format == std::string::npos ? format : text.find_first_not_of(" \t", format + std::strlen("format"));
    if (word != std::string::npos && text.compare(word, 6, "binary") == 0) return "";
    text.append(std::istreambuf_iterator<char>(file), {});
    return text;
}

void checkDictionary(const std::string& path)
{
    toldByFoam([&] { input::checkOpenFoamText(textOf(path), path, input::Repeats::allowed); });
}

void checkFieldText(const std::string& path)
{
    toldByFoam([&] { input::checkFieldText(textOf(path), path); });
}

void checkFolder(const std::string& folder)
{
    namespace fs = std::filesystem;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
    {
        if (entry.is_regular_file(error)) checkFieldText(entry.path());
    }
}

} // namespace


void checkControlText(const argList& args)
{
    const fileName file = args.rootPath()/args.globalCaseName()/"system"/"controlDict";
    checkDictionary(file);
    const dictionary control = readIfWhole(file);
    if (!control.empty()) checkTimeControls(control);
}


void checkStartText(const Time& time)
{
    const fileName system = time.globalPath()/time.system(), constant = time.globalPath()/time.constant();
    for (const fileName& file : {system/"fvSchemes", system/"fvSolution", constant/"turbulenceProperties"}) checkDictionary(file);
    const fileName mesh = time.path()/time.constant()/polyMesh::meshSubDir;
    for (const fileName& file : {mesh/"points", mesh/"boundary"}) checkFieldText(file);
    checkFolder(time.timePath());
}

} // namespace nscdCoupling
} // namespace Foam
