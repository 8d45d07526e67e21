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

#include <cstdlib>
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

/// Where a header stands.
std::string beginOf(std::istream& file)
{
    constexpr std::size_t longestHeader = 2000;
    std::string text(longestHeader, '\0');
    file.read(&text[0], longestHeader);
    text.resize(std::size_t(file.gcount()));
    return text;
}

/// The text of a file; empty where there is none, or where its header says that it is binary.
std::string textOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string text = beginOf(file);
    const std::size_t format = text.find("format");
    const std::size_t word = format == std::string::npos ? format : text.find_first_not_of(" \t", format + std::strlen("format"));
    if (word != std::string::npos && text.compare(word, 6, "binary") == 0) return "";
    text.append(std::istreambuf_iterator<char>(file), {});
    return text;
}

/// OpenFOAM makes a whole number of the version in a header, and stops with a signal where none holds it.
void checkVersion(const std::string& path)
{
    constexpr double latest = 100;
    std::ifstream file(path, std::ios::binary);
    const std::string begin = beginOf(file), keyword = "version";
    const std::size_t header = begin.find('{', std::min(begin.find("FoamFile"), begin.size()));
    const std::size_t at = begin.find(keyword, std::min(header, begin.size()));
    if (at == std::string::npos || at > begin.find('}', header)) return;
    const double version = std::strtod(begin.c_str() + at + keyword.size(), nullptr);
    if (version >= 0 && version <= latest) return;
    fail({placeInFile(path, "FoamFile." + keyword), "is out of range", messageText(version), "2.0"});
}

void checkDictionary(const std::string& path)
{
    checkVersion(path);
    toldByFoam([&] { input::checkOpenFoamText(textOf(path), path, input::Repeats::allowed); });
}

void checkFieldText(const std::string& path)
{
    checkVersion(path);
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
