// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Strict reading of dictionaries: declared keywords, checked values, messages that say what would have been right.
#pragma once

#include "input/dictionary/quantity.hpp"

#include "nscd/base/vec3.hpp"

#include <array>

namespace input
{

using nscd::Vec3;

/// As (0 0 1), in few digits.
std::string describe(const Vec3& vector);

/// One dictionary being read. Every function that takes a keyword declares it; finish() refuses all keywords not declared.
/// Functions with a default value take it where the keyword is missing; those without refuse that.
/// Units:  SI; dimensions may stand before a value, `density [1 -3 0 0 0 0 0] 2500;`, and must then be right
/// Errors: InputError with file, line, path of the keyword, value, and what is allowed
class CheckedEntries
{
public:
    explicit CheckedEntries(const Dictionary& dict) : dict_(dict) {}

    bool found(const std::string& keyword) const;
    /// Likewise, of a keyword without which others would be complained about: refuses the one that may be it, misspelt.
    bool foundAsSpelt(const std::string& keyword) const;
    /// Refuses entries that may be one of these keywords, misspelt: for dictionaries that hold entries of others as well.
    void refuseMisspelt(const Words& keywords) const;
    /// Refuses a dictionary without the keyword; names the one that may be it, misspelt.
    void require(const std::string& keyword, const std::string& allowed) const;
    Place place(const std::string& keyword) const { return dict_.placeOf(keyword); }
    const Dictionary& dict() const { return dict_; }

    double number(const std::string& keyword, const Range& range) const;
    double number(const std::string& keyword, const Range& range, double defaultValue) const;
    long integer(const std::string& keyword, long lower) const;
    long integer(const std::string& keyword, long lower, long defaultValue) const;
    bool flag(const std::string& keyword, bool defaultValue) const;
    /// (x y z)
    Vec3 vec(const std::string& keyword, const Unit& unit) const;
    Vec3 vec(const std::string& keyword, const Unit& unit, const Vec3& defaultValue) const;
    /// (x y z) (x y z): two of them.
    std::array<Vec3, 2> twoVecs(const std::string& keyword, const Unit& unit) const;
    /// ((x y z) (x y z) ...)
    std::vector<Vec3> vecList(const std::string& keyword, const Unit& unit) const;
    /// (a b): two numbers.
    std::array<double, 2> pair(const std::string& keyword, const Unit& unit) const;
    /// (i j ...), or 2 (i j): whole numbers, at least one.
    std::vector<long> integers(const std::string& keyword, long lower) const;
    /// One of the words allowed.
    std::string choice(const std::string& keyword, const Words& allowed) const;
    std::string choice(const std::string& keyword, const Words& allowed, const std::string& defaultValue) const;
    /// (word word ...), each one of those allowed.
    Words choices(const std::string& keyword, const Words& allowed, const Words& defaultValue) const;
    /// A word or a quoted string.
    std::string text(const std::string& keyword) const;
    std::string text(const std::string& keyword, const std::string& defaultValue) const;

    bool isDictionary(const std::string& keyword) const;
    /// A value as it is written, for values of more than one form; at least one token.
    const std::vector<Token>& tokens(const std::string& keyword, const std::string& allowed) const;
    double toNumber(const std::string& keyword, const Token& token, const Range& range) const;
    /// (x y z) from a token on.
    Vec3 toVec(const std::string& keyword, const std::vector<Token>& tokens, std::size_t first) const;

    const Dictionary& sub(const std::string& keyword) const;
    /// An empty one where it is missing.
    Dictionary subOrEmpty(const std::string& keyword) const;

    [[noreturn]] void reject
    (
        const std::string& keyword, const std::string& problem, const std::string& allowed = "", const Words& words = {}
    ) const;

    void finish() const;

private:
    /// The entry that may be a keyword, misspelt; empty where there is none.
    std::string misspelt(const std::string& keyword) const;
    /// Tokens of a value behind its dimensions.
    std::vector<Token> quantity(const std::string& keyword, const Unit& unit) const;
    long toInteger(const std::string& keyword, double number, long lower) const;

    const Dictionary& dict_;
    mutable Words declared_;
};

} // namespace input
