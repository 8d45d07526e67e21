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

namespace input
{

namespace
{

/// Digits and signs that make a number beyond all that a computer holds.
bool overflows(const Token& token)
{
    const bool mayBeNumber = token.kind == Token::Kind::word && token.text.find_first_not_of("0123456789+-.eE") == std::string::npos;
    return mayBeNumber && std::isinf(std::strtod(token.text.c_str(), nullptr));
}

/// Directives after which one keyword may be meant to stand twice.
bool mayRepeat(const Token& token) { return token.text.compare(0, 3, "#if") == 0 || token.text == "#inputMode"; }

/// Walks from keyword to keyword. What it does not understand it leaves to OpenFOAM.
class Walk
{
public:
    Walk(const std::vector<Token>& tokens, const std::string& file)
    :
        tokens_(tokens),
        file_(file),
        mayRepeat_(std::any_of(tokens.begin(), tokens.end(), mayRepeat))
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
            if (overflows(token)) throw InputError({place, "is not a finite number", token.text, "a number up to 1e308"});
            if (token.isMark(';') && depth == 0) break;
            depth += token.isMark('(') + token.isMark('{') - token.isMark(')') - token.isMark('}');
        }
        if (depth < 0) --at_;
        else ++at_;
    }

    const std::vector<Token>& tokens_;
    const std::string& file_;
    const bool mayRepeat_;
    std::size_t at_ = 0;
};

} // namespace

void checkOpenFoamText(const std::string& text, const std::string& file)
{
    const WithoutTraps traps;
    const std::vector<Token> tokens = tokensOf(text, file, Dialect::openFoam);
    Dictionary top{{file}, {}};
    Walk walk(tokens, file);
    walk.through(top, 0);
}

} // namespace input
