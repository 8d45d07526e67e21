// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What every front end must accept and refuse alike: a text that is right, ways to make it wrong, and what must be said of them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace frontEnds
{

/// The keywords of scenes that nscdGrains and nscdDEMFoam share, a line each.
inline std::string rightText()
{
    return
        "materials { glass { density 2500; } steel {} }\n"
        "contacts  { default { friction 0.3; restitution 0.2; } }\n"
        "grains    { type lattice; box (0 0 0) (0.06 0.06 0.08); count (5 5 5); diameter 0.01; spread 0.2; jitter 0.5; }\n"
        "wallMaterial steel;\n"
        "walls     { tray { type box; box (0 0 0) (0.06 0.06 0.2); } }\n"
        "planes    { }\n"
        "solver    { type NLGS; }\n"
        "driven    { }\n"
        "maxInitialOverlap 0.01;\n";
}

/// What the text is read in: spheres in the box (0 0 0) (0.06 0.06 0.2), discs in its plane z = 0, or spheres with y periodic.
enum class Space { spheres, discs, periodicY };

/// What a front end said; no text: nothing.
struct Complaint
{
    std::string file;
    int line = 0;         ///< 0 or less: none
    std::string text;
};

/// Does all that is done with a text before the first step; `grains.txt` beside it holds `file`.
using FrontEnd = std::function<Complaint(const std::string& text, Space space, const std::string& file)>;

/// The text with the first `from` replaced.
inline std::string changed(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A text that is wrong in one place.
struct Wrong
{
    std::string name;
    std::string from;                    ///< in the right text
    std::string to;
    int line;                            ///< 0: the text as a whole
    std::vector<std::string> mentions;   ///< what must be said
    Space space = Space::spheres;
};

inline void PrintTo(const Wrong& wrong, std::ostream* os) { *os << wrong.name; }

inline void expectMentions(const Complaint& said, const std::vector<std::string>& mentions)
{
    for (const std::string& words : mentions) EXPECT_NE(said.text.find(words), std::string::npos) << said.text;
}

inline void expectRefused(const Wrong& wrong, const FrontEnd& frontEnd, const std::string& fileName)
{
    const std::string text = changed(rightText(), wrong.from, wrong.to);
    const Complaint said = frontEnd(text, wrong.space, "");
    ASSERT_FALSE(said.text.empty()) << "was accepted:\n" << text;
    EXPECT_EQ(said.file.substr(said.file.rfind('/') + 1), fileName) << said.text;
    EXPECT_EQ(std::max(0, said.line), wrong.line) << said.text;
    expectMentions(said, wrong.mentions);
}

/// A file of grains that is wrong in one line.
struct WrongFile
{
    std::string name;
    bool isTable;                        ///< or a list of positions
    std::string contents;
    int line;                            ///< of the file; 0: the text that names it is complained about, in its line 3
    std::vector<std::string> mentions;
};

inline void PrintTo(const WrongFile& wrong, std::ostream* os) { *os << wrong.name; }

inline std::string textWithFile(bool isTable)
{
    const std::string source = isTable ? "type table; file grains.txt; }\n" : "type positionsFile; file grains.txt; diameter 0.01; }\n";
    const std::string text = rightText();
    const std::size_t begin = text.find("type lattice"), end = text.find('\n', begin) + 1;
    return std::string(text).replace(begin, end - begin, source);
}

inline void expectRefused(const WrongFile& wrong, const FrontEnd& frontEnd, const std::string& fileName)
{
    const Complaint said = frontEnd(textWithFile(wrong.isTable), Space::spheres, wrong.contents);
    ASSERT_FALSE(said.text.empty()) << "was accepted:\n" << wrong.contents;
    EXPECT_EQ(said.file.substr(said.file.rfind('/') + 1), wrong.line > 0 ? "grains.txt" : fileName) << said.text;
    EXPECT_EQ(said.line, wrong.line > 0 ? wrong.line : 3) << said.text;
    expectMentions(said, wrong.mentions);
}

} // namespace frontEnds
