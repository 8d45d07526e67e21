// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading files of rows.
#include "input/lists/textRows.hpp"

#include "input/dictionary/quantity.hpp"
#include "input/dictionary/textFile.hpp"
#include "input/dictionary/withoutTraps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace input
{

namespace
{

const char* const separators = " \t\r,";

std::string layoutOf(const Words& columns)
{
    std::string layout = "rows of";
    for (const std::string& column : columns) layout += " " + column;
    return layout + ", numbers up to 1e30";
}

NumberRow numberRow(const std::string& line, const Words& columns, const Place& place)
{
    NumberRow row;
    row.place = place;
    const char* at = line.c_str();
    for (double number = 0; takeColumn(at, number);) row.values.push_back(number);
    skipSeparators(at);
    if (*at || row.values.size() != columns.size())
    {
        throw InputError({place, textOf("holds a row without ", columns.size(), " finite numbers"), line, layoutOf(columns)});
    }
    return row;
}

} // namespace

void checkIsText(const std::string& text, const std::string& path)
{
    const std::size_t zero = text.find('\0');
    if (zero == std::string::npos) return;
    const int line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n'));
    throw InputError({{path, line, std::filesystem::path(path).filename()}, "holds a character that is no text", "", "a text file"});
}

bool takeNumber(const char*& at, double& number)
{
    const std::size_t length = std::strspn(at, "0123456789+-.eE");
    char* end = nullptr;
    number = std::strtod(at, &end);
    if (length == 0 || end != at + length || !(std::abs(number) <= largestNumber)) return false;
    at = end;
    return true;
}

bool takeColumn(const char*& at, double& number)
{
    skipSeparators(at);
    return takeNumber(at, number) && (*at == '\0' || std::strchr(separators, *at));
}

void skipSeparators(const char*& at)
{
    at += std::strspn(at, separators);
}

void forEachRow
(
    const std::string& path, const Place& source, const std::function<void(const std::string& line, const Place& place)>& read
)
{
    const WithoutTraps traps;
    const std::string text = readText(path, source);
    checkIsText(text, path);
    const std::string name = std::filesystem::path(path).filename();
    std::string line;
    int lineNumber = 1;
    for (std::size_t begin = 0; begin < text.size(); ++lineNumber)
    {
        const std::size_t end = std::min(text.size(), text.find('\n', begin));
        line.assign(text, begin, end - begin);
        line.resize(std::min(line.size(), line.find('#')));
        begin = end + 1;
        if (line.find_first_not_of(separators) != std::string::npos) read(line, {path, lineNumber, name});
    }
}

std::vector<NumberRow> readNumberTable(const std::string& path, const Words& columns, const Place& source)
{
    std::vector<NumberRow> rows;
    forEachRow(path, source, [&](const std::string& line, const Place& place) { rows.push_back(numberRow(line, columns, place)); });
    if (rows.empty()) throw InputError({source, "names a file without rows", path, layoutOf(columns)});
    return rows;
}

} // namespace input
