// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking through text that OpenFOAM is going to read.
#include "input/dictionary/openFoamText.hpp"

#include "input/dictionary/tokenizer.hpp"
#include "input/dictionary/withoutTraps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace input
{

namespace
{

const char* const largestOfAll = "a number up to 1e308";
const char* const digits = "0123456789";
const char* const lettersOfNumbers = "0123456789+-.eE";

/// A number beyond all that a computer holds.
bool overflows(const std::string& word)
{
    return word.find_first_not_of(lettersOfNumbers) == std::string::npos && std::isinf(std::strtod(word.c_str(), nullptr));
}

bool overflows(const Token& token) { return token.kind == Token::Kind::word && overflows(token.text); }

/// Whether an e stands within a number of three digits behind it or more, as in 1e999.
bool isLargeExponent(const std::string& text, std::size_t e)
{
    const std::size_t sign = e + 1 < text.size() && (text[e + 1] == '+' || text[e + 1] == '-');
    const std::size_t first = e + 1 + sign, end = std::min(text.size(), text.find_first_not_of(digits, first));
    return e > 0 && std::strchr("0123456789.", text[e - 1]) && end >= first + 3;
}

/// Whether a comment begins in the line before a place.
bool isInComment(const std::string& text, std::size_t at)
{
    const std::size_t comment = text.rfind("//", at);
    return comment != std::string::npos && text.find('\n', comment) > at;
}

/// The word around a place, made of what numbers are made of.
std::string numberAround(const std::string& text, std::size_t at)
{
    const std::size_t before = text.find_last_not_of(lettersOfNumbers, at), first = before == std::string::npos ? 0 : before + 1;
    return text.substr(first, text.find_first_not_of(lettersOfNumbers, at) - first);
}

int lineOf(const std::string& text, std::size_t at)
{
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

void checkBraces(const std::string& text, const std::string& file)
{
    int depth = 0;
    for (std::size_t at = text.find_first_of("{}"); at != std::string::npos; at = text.find_first_of("{}", at + 1))
    {
        depth += text[at] == '{' ? 1 : -1;
        if (depth > maxDepth) throw InputError(nestedTooDeep({file, lineOf(text, at)}));
    }
}

/// Directives after which one keyword may be meant to stand twice.
bool mayRepeat(const Token& token) { return token.text.compare(0, 3, "#if") == 0 || token.text == "#inputMode"; }

/// Walks from keyword to keyword. What it does not understand it leaves to OpenFOAM.
class Walk
{
public:
    Walk(const std::vector<Token>& tokens, const std::string& file, Repeats repeats)
    :
        tokens_(tokens),
        file_(file),
        mayRepeat_(repeats == Repeats::allowed || std::any_of(tokens.begin(), tokens.end(), mayRepeat))
    {}

    void through(Dictionary& dict, int depth)
    {
        if (depth > maxDepth) throw InputError(nestedTooDeep(dict.place));
        while (at_ < tokens_.size() && !tokens_[at_].isMark('}')) entry(dict, depth);
        ++at_;
    }

private:
    void entry(Dictionary& dict, int depth)
    {
        const Token& key = tokens_[at_++];
        if (key.isMark(';') || key.text[0] == '$') return;
        if (key.text[0] == '#') skipArgument();
        else if (key.kind == Token::Kind::mark) at_ = tokens_.size();
        else keyword(dict, key, depth);
    }

    void keyword(Dictionary& dict, const Token& key, int depth)
    {
        const Place place = {file_, key.line, dict.pathOf(key.text)};
        const Entry* first = dict.find(key.text);
        if (first && !mayRepeat_) throw InputError(repeated(place, first->line));
        dict.entries.push_back({key.text, key.line, {}, nullptr});
        const bool isDictionary = at_ < tokens_.size() && tokens_[at_].isMark('{');
        if (!isDictionary) return skipValue(place);
        ++at_;
        Dictionary inner{place, {}};
        through(inner, depth + 1);
    }

    /// Of a directive, as #include "file" or #remove (a b).
    void skipArgument()
    {
        const bool isList = at_ < tokens_.size() && tokens_[at_].isMark('(');
        while (isList && at_ < tokens_.size() && !tokens_[at_].isMark(')')) ++at_;
        ++at_;
    }

    /// To behind the semicolon that ends a value, or to the brace that ends its dictionary.
    void skipValue(const Place& place)
    {
        int depth = 0;
        for (; at_ < tokens_.size() && depth >= 0; ++at_)
        {
            const Token& token = tokens_[at_];
            if (overflows(token)) throw InputError({place, "is not a finite number", token.text, largestOfAll});
            if (token.isMark(';') && depth == 0) break;
            if (depth == 0 && beginsDictionary()) throw InputError({place, "has no semicolon before {", "", "keyword value;"});
            depth += token.isMark('(') + token.isMark('{') - token.isMark(')') - token.isMark('}');
        }
        if (depth < 0) --at_;
        else ++at_;
    }

    /// Whether the next thing is a dictionary behind its keyword, not one of OpenFOAM's 3{0} or #eval{ ... }. OpenFOAM warns, and goes on with
    /// dictionaries that end elsewhere.
    bool beginsDictionary() const
    {
        const Token& before = tokens_[at_ - 1];
        return tokens_[at_].isMark('{') && before.kind == Token::Kind::word && !std::strchr("#$", before.text[0]);
    }

    const std::vector<Token>& tokens_;
    const std::string& file_;
    const bool mayRepeat_;
    std::size_t at_ = 0;
};

} // namespace

void checkOpenFoamText(const std::string& text, const std::string& file, Repeats repeats)
{
    const WithoutTraps traps;
    const std::vector<Token> tokens = tokensOf(text, file, Dialect::openFoam);
    Dictionary top{{file}, {}};
    Walk walk(tokens, file, repeats);
    walk.through(top, 0);
}

void checkFieldText(const std::string& text, const std::string& file)
{
    checkBraces(text, file);
    const WithoutTraps traps;
    for (std::size_t e = text.find_first_of("eE"); e != std::string::npos; e = text.find_first_of("eE", e + 1))
    {
        if (!isLargeExponent(text, e) || isInComment(text, e)) continue;
        const std::string word = numberAround(text, e);
        if (!overflows(word)) continue;
        throw InputError({{file, lineOf(text, e)}, "holds a number that no computer holds", word, largestOfAll});
    }
}

} // namespace input
