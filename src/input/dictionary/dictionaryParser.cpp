// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Putting tokens together to entries.
#include "input/dictionary/tokenizer.hpp"

namespace input
{

namespace
{

class Parser
{
public:
    Parser(std::vector<Token> tokens, const std::string& file) : tokens_(std::move(tokens)), file_(file) {}

    Dictionary top()
    {
        Dictionary dict{{file_}, {}};
        while (at_ < tokens_.size()) addEntry(dict, 0);
        return dict;
    }

private:
    Token take() { return tokens_[at_++]; }

    Dictionary nested(const Place& place, int depth)
    {
        if (depth > maxDepth) throw InputError(nestedTooDeep(place));
        Dictionary dict{place, {}};
        while (true)
        {
            if (at_ == tokens_.size()) throw InputError({place, "begins a dictionary that does not end", "", "a closing }"});
            if (tokens_[at_].isMark('}')) break;
            addEntry(dict, depth);
        }
        ++at_;
        return dict;
    }

    void addEntry(Dictionary& dict, int depth)
    {
        const Token key = take();
        if (key.isMark(';')) return;
        if (key.kind == Token::Kind::mark) throw InputError({{file_, key.line}, "has no keyword here", key.text, "keyword value; or keyword { ... }"});
        if (key.isNumber()) throw InputError({{file_, key.line}, "has a number where a keyword belongs", key.text, "keyword value; or keyword { ... }"});
        const Place place = {file_, key.line, dict.pathOf(key.text)};
        if (const Entry* first = dict.find(key.text)) throw InputError(repeated(place, first->line));

        Entry entry{key.text, key.line, {}, nullptr, key.kind == Token::Kind::quoted};
        if (at_ < tokens_.size() && tokens_[at_].isMark('{'))
        {
            ++at_;
            entry.dict = std::make_shared<Dictionary>(nested(place, depth + 1));
        }
        else
        {
            entry.value = takeValue(place);
        }
        const bool isHeader = key.text == "FoamFile" && dict.place.keyword.empty();
        if (!isHeader) dict.entries.push_back(std::move(entry));
    }

    std::vector<Token> takeValue(const Place& place)
    {
        std::vector<Token> value;
        while (at_ < tokens_.size() && !tokens_[at_].isMark(';'))
        {
            const Token token = take();
            if (token.isMark('{') || token.isMark('}')) throw InputError({place, "has no semicolon before " + token.text, "", "keyword value;"});
            value.push_back(token);
        }
        if (at_ == tokens_.size()) throw InputError({place, "has no semicolon", "", "keyword value;"});
        ++at_;
        return value;
    }

    std::vector<Token> tokens_;
    const std::string& file_;
    std::size_t at_ = 0;
};

} // namespace

Dictionary parseDictionary(const std::string& text, const std::string& file)
{
    return Parser(tokensOf(text, file, Dialect::plain), file).top();
}

} // namespace input
