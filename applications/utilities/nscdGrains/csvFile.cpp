// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Beginning tables, going on with them, adding rows.
#include "csvFile.hpp"

#include "nscd/base/completeFile.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace nscdGrains
{

namespace
{

/// The rows of an earlier file up to a time, under the same head, in a file that takes its place.
void keepRows(const std::string& path, const std::string& head, double upTo)
{
    std::ifstream old(path);
    if (!old) throw std::runtime_error("cannot read " + path + ", which a run that goes on adds to");
    std::string found, line;
    for (auto lines = std::count(head.begin(), head.end(), '\n'); lines > 0 && std::getline(old, line); --lines) found += line + '\n';
    if (found != head) throw std::runtime_error(path + " has other columns than this run writes; move it away to begin another");
    nscd::CompleteFile kept(path);
    kept.stream() << head;
    // A row without its end is one that a killed run was writing.
    while (std::getline(old, line) && !old.eof() && std::strtod(line.c_str(), nullptr) <= upTo) kept.stream() << line << '\n';
    kept.complete();
}

} // namespace

CsvFile::CsvFile(const std::string& path, const std::string& head, bool goesOn, double keepUpTo)
:
    path_(path)
{
    errno = 0;
    const bool isKept = goesOn && std::filesystem::exists(path);
    if (isKept) keepRows(path, head, keepUpTo);
    file_.open(path, isKept ? std::ios::app : std::ios::trunc);
    if (!isKept) file_ << head << std::flush;
    if (!file_) nscd::failToWrite(path_);
}

void CsvFile::write(const std::string& line)
{
    errno = 0;
    file_ << line << '\n' << std::flush;
    if (!file_) nscd::failToWrite(path_);
}

} // namespace nscdGrains
