// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cutting text into tokens.
#include "input/dictionary/tokenizer.hpp"

#include "input/dictionary/withoutTraps.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace input
{

namespace
{

bool isBlank(char c) { return std::isspace(static_cast<unsigned char>(c)); }

class Tokenizer
{
public:
    Tokenizer(const std::string& text, const std::string& file, Dialect dialect)
    :
        text_(text),
        file_(file),
        isPlain_(dialect == Dialect::plain)
    {}

    std::vector<Token> all()
    {
        std::vector<Token> tokens;
        for (skipBlanks(); at_ < text_.size(); skipBlanks()) tokens.push_back(next());
        return tokens;
    }

private:
    bool startsWith(const char* start) const { return text_.compare(at_, std::strlen(start), start) == 0; }

    void advance(std::size_t to)
    {
        line_ += static_cast<int>(std::count(text_.begin() + at_, text_.begin() + to, '\n'));
        at_ = to;
    }

    /// To behind the next `end`, which may begin `ahead` characters from here.
    void skipTo(const char* end, std::size_t ahead, const char* what)
    {
        std::size_t found = text_.find(end, at_ + ahead);
        while (!isPlain_ && found != std::string::npos && end[0] == '"' && text_[found - 1] == '\\') found = text_.find(end, found + 1);
        if (found == std::string::npos) refuse(std::string("begins a ") + what + " that does not end", end);
        advance(found + std::strlen(end));
    }

    void skipBlanks()
    {
        while (at_ < text_.size())
        {
            if (isBlank(text_[at_])) advance(at_ + 1);
            else if (startsWith("//")) advance(std::min(text_.size(), text_.find('\n', at_)));
            else if (startsWith("/*")) skipTo("*/", 2, "comment");
            else return;
        }
    }

    Token next()
    {
        const std::size_t begin = at_;
        const int line = line_;
        if (std::strchr("()[]{};", text_[at_]) && text_[at_] != '\0')
        {
            advance(at_ + 1);
            return {Token::Kind::mark, text_.substr(begin, 1), line};
        }
        if (text_[at_] == '"')
        {
            skipTo("\"", 1, "string");
            return {Token::Kind::quoted, text_.substr(begin + 1, at_ - begin - 2), line};
        }
        if (isPlain_) refuseOthers();
        else if (startsWith("#{")) return through("#}", "verbatim text");
        else if (startsWith("${")) return through("}", "macro");
        return word(line);
    }

    Token through(const char* end, const char* what)
    {
        const std::size_t begin = at_;
        const int line = line_;
        skipTo(end, 2, what);
        return {Token::Kind::quoted, text_.substr(begin, at_ - begin), line};
    }

    Token word(int line)
    {
        const std::size_t begin = at_;
        int depth = 0;
        do depth += depthOf(text_[at_++]); while (at_ < text_.size() && !endsWord(depth));
        Token token = {Token::Kind::word, text_.substr(begin, at_ - begin), line};
        if (readNumber(token.text, token.number)) token.kind = Token::Kind::number;
        return token;
    }

    static int depthOf(char c) { return (c == '(') - (c == ')'); }

    bool endsWord(int depth) const
    {
        const char c = text_[at_];
        if (isBlank(c) || std::strchr("[]{};\"", c) || startsWith("//") || startsWith("/*")) return true;
        return isPlain_ ? depthOf(c) != 0 : c == ')' && depth == 0;
    }

    void refuseOthers() const
    {
        const char c = text_[at_];
        if (c == '$' || c == '#') refuse(std::string("holds ") + c, "plain values: macros ($) and directives (#) are OpenFOAM's alone");
        if (static_cast<unsigned char>(c) < ' ') refuse("holds a character that is no text", "a text file");
    }

    [[noreturn]] void refuse(const std::string& problem, const std::string& allowed) const
    {
        throw InputError({{file_, line_, ""}, problem, "", allowed});
    }

    const std::string& text_;
    const std::string& file_;
    bool isPlain_;
    std::size_t at_ = 0;
    int line_ = 1;
};

} // namespace

Mistake nestedTooDeep(const Place& place)
{
    return {place, "is nested too deep", "", "at most " + std::to_string(maxDepth) + " levels"};
}

std::vector<Token> tokensOf(const std::string& text, const std::string& file, Dialect dialect)
{
    const WithoutTraps traps;
    return Tokenizer(text, file, dialect).all();
}

} // namespace input
