// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading files of grains.
#include "input/lists/grainFiles.hpp"

#include "input/dictionary/quantity.hpp"
#include "input/dictionary/textFile.hpp"
#include "input/dictionary/withoutTraps.hpp"
#include "input/lists/textRows.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace input
{

namespace
{

const char* const listLayout = "a list of positions, ( (x y z) (x y z) ... ), numbers up to 1e30";
const char* const rowLayout = "rows of x y z d [material], in m, numbers up to 1e30";

void checkHolds(std::size_t number, const std::string& path, const Place& source)
{
    if (number == 0) throw InputError({source, "names a file that holds no grain", path, "a file with grains"});
}

/// Moves through a text that ends with a zero, counting lines; numbers are read in place.
class Scanner
{
public:
    Scanner(const std::string& text, const std::string& path) : at_(text.c_str()), end_(at_ + text.size()), path_(path) {}

    /// Beyond blanks and comments.
    void skipBlanks()
    {
        while (true)
        {
            if (*at_ == '\n') ++line_;
            if (std::strchr(" \t\r\n", *at_) && at_ < end_) ++at_;
            else if (std::strncmp(at_, "//", 2) == 0) at_ += std::strcspn(at_, "\n");
            else if (std::strncmp(at_, "/*", 2) == 0) skipBehind("*/");
            else return;
        }
    }

    bool isAtEnd() const { return at_ == end_; }
    bool startsWith(const char* word) const { return std::strncmp(at_, word, std::strlen(word)) == 0; }

    /// Takes a mark if it is the next thing.
    bool take(char mark)
    {
        skipBlanks();
        if (isAtEnd() || *at_ != mark) return false;
        ++at_;
        return true;
    }

    double number(const char* problem)
    {
        skipBlanks();
        double value = 0.0;
        if (!takeNumber(at_, value)) failUnexpected(problem);
        return value;
    }

    std::string skipBehind(const char* mark)
    {
        const char* found = std::strstr(at_, mark);
        if (!found) failHere("is cut short");
        const std::string skipped(at_, found);
        for (const char c : skipped) line_ += c == '\n';
        at_ = found + std::strlen(mark);
        return skipped;
    }

    [[noreturn]] void failHere(const std::string& problem) const
    {
        const std::string name = std::filesystem::path(path_).filename();
        const std::string word(at_, std::min<std::size_t>(std::strcspn(at_, " \t\r\n()"), 40));
        throw InputError({{path_, line_, name}, problem, word, listLayout});
    }

    /// Something else was to come here.
    [[noreturn]] void failUnexpected(const std::string& problem) const { failHere(isAtEnd() ? "is cut short" : problem); }

private:
    const char* at_;
    const char* end_;
    const std::string& path_;
    int line_ = 1;
};

void skipHeader(Scanner& scanner)
{
    scanner.skipBlanks();
    if (!scanner.startsWith("FoamFile")) return;
    const std::string header = scanner.skipBehind("}");
    if (header.find("binary") != std::string::npos) scanner.failHere("is in binary format, which OpenFOAM alone reads");
}

TableRow readRow(const char* at, const std::string& line, const Place& place)
{
    TableRow row{};
    double numbers[4];
    for (double& number : numbers)
    {
        if (!takeColumn(at, number)) throw InputError({place, "holds a row without four finite numbers", line, rowLayout});
    }
    row.position = nscd::Vec3(numbers[0], numbers[1], numbers[2]);
    row.diameter = numbers[3];
    if (!(row.diameter >= smallestPositive)) throw InputError({place, "holds a diameter that is not positive", line, rowLayout});
    skipSeparators(at);
    row.material.assign(at, std::strcspn(at, " \t\r,"));
    at += row.material.size();
    skipSeparators(at);
    if (*at) throw InputError({place, "holds a row with more than five columns", line, rowLayout});
    row.line = place.line;
    return row;
}

} // namespace

std::vector<nscd::Vec3> readPositionsFile(const std::string& path, const Place& source)
{
    return parsePositions(readText(path, source), path, source);
}

std::vector<nscd::Vec3> parsePositions(const std::string& text, const std::string& path, const Place& source)
{
    const WithoutTraps traps;
    checkIsText(text, path);
    Scanner scanner(text, path);
    skipHeader(scanner);
    double stated = -1.0;
    if (!scanner.take('('))
    {
        stated = scanner.number("does not begin with a list");
        if (!scanner.take('(')) scanner.failUnexpected("does not begin with a list");
    }
    std::vector<nscd::Vec3> positions;
    while (!scanner.take(')'))
    {
        if (!scanner.take('(')) scanner.failUnexpected("holds something that is no position");
        nscd::Vec3 x;
        for (int k = 0; k < 3; ++k) x[k] = scanner.number("holds a position whose coordinate is not a finite number");
        if (!scanner.take(')')) scanner.failUnexpected("holds a position without three coordinates");
        positions.push_back(x);
    }
    scanner.skipBlanks();
    if (!scanner.isAtEnd()) scanner.failHere("goes on after its list");
    if (stated >= 0.0 && stated != static_cast<double>(positions.size()))
    {
        scanner.failHere(textOf("states ", stated, " positions and holds ", positions.size()));
    }
    checkHolds(positions.size(), path, source);
    return positions;
}

std::vector<TableRow> readGrainTable(const std::string& path, const Place& source)
{
    std::vector<TableRow> rows;
    forEachRow(path, source, [&](const std::string& line, const Place& place) { rows.push_back(readRow(line.c_str(), line, place)); });
    checkHolds(rows.size(), path, source);
    return rows;
}

} // namespace input
