// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Cutting text into tokens, and tokens into entries.
#include "sceneDictionary.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace nscdGrains
{

namespace
{

constexpr int maxDepth = 50;

class Tokenizer
{
public:
    Tokenizer(const std::string& text, const std::string& file) : text_(text), file_(file) {}

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

    /// To behind the next `end`.
    void skipTo(const char* end, const char* what)
    {
        const std::size_t found = text_.find(end, at_ + 1 + (end[0] == '*'));
        if (found == std::string::npos) fail({{file_, line_, ""}, std::string("begins a ") + what + " that does not end", "", end});
        advance(found + std::strlen(end));
    }

    void skipBlanks()
    {
        while (at_ < text_.size())
        {
            if (std::isspace(static_cast<unsigned char>(text_[at_]))) advance(at_ + 1);
            else if (startsWith("//")) advance(std::min(text_.size(), text_.find('\n', at_)));
            else if (startsWith("/*")) skipTo("*/", "comment");
            else return;
        }
    }

    Token next()
    {
        const std::size_t begin = at_;
        const int line = line_;
        if (std::strchr("()[]{};", text_[at_]))
        {
            advance(at_ + 1);
            return {Token::Kind::mark, text_.substr(begin, 1), line};
        }
        if (text_[at_] == '"')
        {
            skipTo("\"", "string");
            return {Token::Kind::quoted, text_.substr(begin + 1, at_ - begin - 2), line};
        }
        refuseOthers();
        while (at_ < text_.size() && !endsWord()) ++at_;
        return {Token::Kind::word, text_.substr(begin, at_ - begin), line};
    }

    bool endsWord() const
    {
        const char c = text_[at_];
        return std::isspace(static_cast<unsigned char>(c)) || std::strchr("()[]{};\"", c) || startsWith("//") || startsWith("/*");
    }

    void refuseOthers() const
    {
        const char c = text_[at_];
        const char* const allowed = "plain values: macros ($) and directives (#) are OpenFOAM's alone";
        if (c == '$' || c == '#') fail({{file_, line_, ""}, std::string("holds ") + c, "", allowed});
        if (static_cast<unsigned char>(c) < ' ') fail({{file_, line_, ""}, "holds a character that is no text", "", "a text file"});
    }

    const std::string& text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1;
};

class Parser
{
public:
    Parser(std::vector<Token> tokens, const std::string& file) : tokens_(std::move(tokens)), file_(file) {}

    Dictionary top()
    {
        Dictionary dict;
        dict.place = {file_, 0, ""};
        while (at_ < tokens_.size()) addEntry(dict, 0);
        return dict;
    }

private:
    Token take() { return tokens_[at_++]; }

    Dictionary nested(const Place& place, int depth)
    {
        if (depth > maxDepth) fail({place, "is nested too deep", "", "at most " + std::to_string(maxDepth) + " levels"});
        Dictionary dict;
        dict.place = place;
        while (true)
        {
            if (at_ == tokens_.size()) fail({place, "begins a dictionary that does not end", "", "a closing }"});
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
        const Place place = {file_, key.line, dict.pathOf(key.text)};
        if (key.kind == Token::Kind::mark) fail({{file_, key.line, ""}, "has no keyword here", key.text, "keyword value; or keyword { ... }"});
        if (const Entry* first = dict.find(key.text)) fail({place, "is given twice, first in line " + std::to_string(first->line), "", "once"});

        Entry entry{key.text, key.line, {}, nullptr};
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
            if (token.isMark('{') || token.isMark('}')) fail({place, "has no semicolon before " + token.text, "", "keyword value;"});
            value.push_back(token);
        }
        if (at_ == tokens_.size()) fail({place, "has no semicolon", "", "keyword value;"});
        ++at_;
        return value;
    }

    std::vector<Token> tokens_;
    std::string file_;
    std::size_t at_ = 0;
};

} // namespace

const Entry* Dictionary::find(const std::string& keyword) const
{
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.keyword == keyword; });
    return found == entries.end() ? nullptr : &*found;
}

std::string Dictionary::pathOf(const std::string& keyword) const
{
    return place.keyword.empty() ? keyword : place.keyword + "." + keyword;
}

void checkIsFile(const std::string& path, const Place& place)
{
    namespace fs = std::filesystem;
    std::error_code error;
    if (fs::is_regular_file(path, error)) return;
    Words beside;
    const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    {
        if (entry.is_regular_file(error)) beside.push_back(entry.path().filename());
    }
    std::sort(beside.begin(), beside.end());
    fail({place, "names a file that does not exist, " + path, fs::path(path).filename(), "a file that can be read", beside});
}

std::string readText(const std::string& path, const Place& place)
{
    checkIsFile(path, place);
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::string text(file ? static_cast<std::size_t>(file.tellg()) : 0, ' ');
    file.seekg(0);
    file.read(&text[0], static_cast<std::streamsize>(text.size()));
    if (!file) fail({place, "names a file that cannot be read, " + path, "", ""});
    return text;
}

Dictionary parseDictionary(const std::string& text, const std::string& file)
{
    return Parser(Tokenizer(text, file).all(), file).top();
}

} // namespace nscdGrains
