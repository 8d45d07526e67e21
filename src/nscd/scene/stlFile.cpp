// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading both forms of STL.
#include "nscd/scene/stlFile.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace nscd
{

namespace
{

constexpr std::size_t binaryHeader = 84, binaryTriangle = 50;

std::string readFile(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::invalid_argument("STL file " + path + " cannot be opened");
    std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (file.bad()) throw std::invalid_argument("STL file " + path + " cannot be read");
    return content;
}

/// Words of an ASCII file, lower case or upper, and the line each stands in.
class Words
{
public:
    Words(const std::string& path, const std::string& content) : path_(path), rest_(content.c_str()) {}

    std::string_view next()
    {
        while (isSpace(*rest_)) line_ += *rest_++ == '\n';
        const char* start = rest_;
        while (*rest_ && !isSpace(*rest_)) ++rest_;
        return {start, static_cast<std::size_t>(rest_ - start)};
    }

    /// The rest of the line: a solid's name.
    void skipLine()
    {
        while (*rest_ && *rest_ != '\n') ++rest_;
    }

    void expect(const char* word)
    {
        const std::string_view given = next();
        if (!isWord(given, word)) fail(found(given) + " where '" + word + "' belongs");
    }

    double number()
    {
        const std::string given(next());
        char* end = nullptr;
        const double value = std::strtod(given.c_str(), &end);
        if (given.empty() || *end != '\0') fail(found(given) + " where a coordinate belongs");
        if (!std::isfinite(value)) fail("a coordinate is " + given + ", allowed: a finite number");
        return value;
    }

    static bool isWord(std::string_view given, std::string_view word)
    {
        const auto isSame = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + ('a' - 'A') : a) == b; };
        return given.size() == word.size() && std::equal(given.begin(), given.end(), word.begin(), isSame);
    }

    static std::string found(std::string_view given)
    {
        return given.empty() ? std::string("the file ends") : "'" + std::string(given.substr(0, 40)) + "' stands";
    }

    [[noreturn]] void fail(const std::string& problem) const
    {
        throw std::invalid_argument("STL file " + path_ + ", line " + std::to_string(line_) + ": " + problem);
    }

private:
    static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

    const std::string& path_;
    const char* rest_;
    std::size_t line_ = 1;
};

Triangle readFacet(Words& words)
{
    words.expect("normal");
    for (int k = 0; k < 3; ++k) words.next();
    words.expect("outer");
    words.expect("loop");
    Triangle triangle;
    for (Vec3& vertex : triangle)
    {
        words.expect("vertex");
        for (int k = 0; k < 3; ++k) vertex[k] = words.number();
    }
    words.expect("endloop");
    words.expect("endfacet");
    return triangle;
}

std::vector<Triangle> readAscii(const std::string& path, const std::string& content)
{
    std::vector<Triangle> triangles;
    Words words(path, content);
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
    {
        if (!Words::isWord(word, "solid")) words.fail(Words::found(word) + " where 'solid' belongs");
        words.skipLine();
        for (word = words.next(); Words::isWord(word, "facet"); word = words.next()) triangles.push_back(readFacet(words));
        if (!Words::isWord(word, "endsolid")) words.fail(Words::found(word) + " where 'facet' or 'endsolid' belongs");
        words.skipLine();
    }
    return triangles;
}

std::vector<Triangle> readBinary(const std::string& path, const std::string& content, std::size_t count)
{
    std::vector<Triangle> triangles(count);
    for (std::size_t t = 0; t < count; ++t)
    {
        float values[12];  // normal, then the vertices
        std::memcpy(values, content.data() + binaryHeader + t*binaryTriangle, sizeof(values));
        for (int k = 0; k < 9; ++k)
        {
            if (!std::isfinite(values[3 + k]))
            {
                throw std::invalid_argument
                (
                    "STL file " + path + ", triangle " + std::to_string(t + 1) + " of " + std::to_string(count)
                  + ": a coordinate is not a finite number"
                );
            }
            triangles[t][k/3][k % 3] = values[3 + k];
        }
    }
    return triangles;
}

/// Number of triangles that the header of a binary file states.
std::size_t statedTriangles(const std::string& content)
{
    std::uint32_t count = 0;
    if (content.size() >= binaryHeader) std::memcpy(&count, content.data() + 80, sizeof(count));
    return count;
}

/// Some binary files begin with `solid` too: what their size says comes first.
std::vector<Triangle> readEither(const std::string& path, const std::string& content)
{
    const std::size_t count = statedTriangles(content);
    if (content.size() >= binaryHeader && content.size() == binaryHeader + count*binaryTriangle) return readBinary(path, content, count);
    const bool isText = content.find('\0') == std::string::npos;
    if (isText && Words::isWord(Words(path, content).next(), "solid")) return readAscii(path, content);
    if (content.size() < binaryHeader) throw std::invalid_argument("STL file " + path + " is neither an ASCII nor a binary STL file");
    const std::size_t whole = (content.size() - binaryHeader)/binaryTriangle;
    throw std::invalid_argument
    (
        "STL file " + path + " states " + std::to_string(count) + " triangles and holds " + std::to_string(whole)
      + (whole < count ? ": truncated" : ": no binary STL file, or not only one")
    );
}

} // namespace

std::vector<Triangle> readStl(const std::string& path, double scale)
{
    if (!(scale > 0.0) || !std::isfinite(scale)) throw std::invalid_argument("scale of STL file " + path + " must be finite and > 0");
    std::vector<Triangle> triangles = readEither(path, readFile(path));
    if (triangles.empty()) throw std::invalid_argument("STL file " + path + " holds no triangle");
    for (Triangle& triangle : triangles)
    {
        for (Vec3& vertex : triangle) vertex *= scale;
    }
    return triangles;
}

} // namespace nscd
