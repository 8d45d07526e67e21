// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading files that list grains.
#include "coupling/case/input/positionFiles.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "fileNameList.H"

#include <cmath>
#include <fstream>
#include <sstream>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const char* const listLayout = "a list of positions, ( (x y z) (x y z) ... )";
const char* const rowLayout = "rows of x y z d [material], in m";

void checkHolds(std::size_t number, const fileName& path, const InputPlace& source)
{
    if (number > 0) return;
    fail({source, "names a file that holds no grain", path, "a file with grains; for a case without any, grains {}"});
}

void checkExists(const fileName& path, const InputPlace& source)
{
    if (isFile(path)) return;
    Words beside;
    for (const fileName& file : readDir(path.path(), fileName::FILE)) beside.push_back(file);
    fail({source, "names a file that does not exist, " + path, path.name(), string::null, beside});
}

[[noreturn]] void failAt(const Istream& is, const string& problem, const string& value = string::null)
{
    fail({{is.name(), is.lineNumber(), is.lineNumber(), fileName(is.name()).name()}, problem, value, listLayout});
}

token nextToken(IFstream& is, std::size_t nRead)
{
    token tok(is);
    if (is.eof() || !tok.good()) failAt(is, "is truncated after " + Foam::name(label(nRead)) + " positions");
    return tok;
}

bool isMark(const token& tok, token::punctuationToken mark)
{
    return tok.isPunctuation() && tok.pToken() == mark;
}

/// The rest of a position after its opening bracket.
vector readPosition(IFstream& is, std::size_t nRead)
{
    vector position;
    for (direction k = 0; k < 3; ++k)
    {
        const token tok = nextToken(is, nRead);
        if (!tok.isNumber() || !std::isfinite(tok.number()))
        {
            failAt(is, "holds a position whose coordinate is not a finite number", messageText(tok));
        }
        position[k] = tok.number();
    }
    const token closing = nextToken(is, nRead);
    if (!isMark(closing, token::END_LIST)) failAt(is, "holds a position without three coordinates", messageText(closing));
    return position;
}

/// Skips the FoamFile header and takes the stream's format from it; returns the first token behind it.
token skipHeader(IFstream& is)
{
    token tok = nextToken(is, 0);
    if (!tok.isWord() || tok.wordToken() != "FoamFile") return tok;
    const dictionary header(is);
    is.format(header.lookupOrDefault<word>("format", "ascii"));
    return nextToken(is, 0);
}

std::vector<vector> readBinary(IFstream& is, const token& count)
{
    is.putBack(count);
    const List<vector> positions(is);
    for (const vector& x : positions)
    {
        const bool isFinite = std::isfinite(x.x()) && std::isfinite(x.y()) && std::isfinite(x.z());
        if (!isFinite) failAt(is, "holds a position whose coordinate is not a finite number", messageText(x));
    }
    return std::vector<vector>(positions.begin(), positions.end());
}

TableRow readRow(const std::string& line, const InputPlace& place)
{
    TableRow row;
    row.place = place;
    std::istringstream words(line);
    std::string word;
    scalar numbers[4];
    for (scalar& number : numbers)
    {
        char* end = nullptr;
        if (words >> word) number = std::strtod(word.c_str(), &end);
        if (!end || *end || !std::isfinite(number)) fail({place, "holds a row without four finite numbers", line, rowLayout});
    }
    row.position = vector(numbers[0], numbers[1], numbers[2]);
    row.diameter = numbers[3];
    if (row.diameter <= 0) fail({place, "holds a diameter that is not positive", line, rowLayout});
    if (words >> word) row.material = word;
    if (words >> word) fail({place, "holds a row with more than five columns", line, rowLayout});
    return row;
}

} // namespace


std::vector<vector> readPositionsFile(const fileName& path, const InputPlace& source)
{
    checkExists(path, source);
    IFstream is(path);
    token tok = skipHeader(is);
    if (is.format() == IOstream::BINARY)
    {
        const std::vector<vector> positions = readBinary(is, tok);
        checkHolds(positions.size(), path, source);
        return positions;
    }

    const label stated = tok.isLabel() ? tok.labelToken() : -1;
    if (tok.isLabel()) tok = nextToken(is, 0);
    if (!isMark(tok, token::BEGIN_LIST)) failAt(is, "does not start with (", messageText(tok));

    std::vector<vector> positions;
    for (tok = nextToken(is, 0); !isMark(tok, token::END_LIST); tok = nextToken(is, positions.size()))
    {
        if (!isMark(tok, token::BEGIN_LIST)) failAt(is, "holds something that is no position", messageText(tok));
        positions.push_back(readPosition(is, positions.size()));
    }
    if (stated >= 0 && stated != label(positions.size()))
    {
        failAt(is, "states " + Foam::name(stated) + " positions and holds " + Foam::name(label(positions.size())));
    }
    checkHolds(positions.size(), path, source);
    return positions;
}


std::vector<TableRow> readGrainTable(const fileName& path, const InputPlace& source)
{
    checkExists(path, source);
    std::ifstream file(path);
    std::vector<TableRow> rows;
    std::string line;
    for (label lineNumber = 1; std::getline(file, line); ++lineNumber)
    {
        line = line.substr(0, line.find('#'));
        std::replace(line.begin(), line.end(), ',', ' ');
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        rows.push_back(readRow(line, {path, lineNumber, lineNumber, path.name()}));
    }
    checkHolds(rows.size(), path, source);
    return rows;
}

} // namespace nscdCoupling
} // namespace Foam
