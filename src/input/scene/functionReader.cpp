// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading functions of time.
#include "input/scene/functionReader.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <type_traits>

namespace input
{

namespace
{

const char* const forms = "a value, table ((time value) ...), or { type sine; frequency 1; amplitude 1; scale 2; level 0; }";
const Words ownTypes = {"constant", "table", "sine"};

bool isName(const Token& token) { return token.kind == Token::Kind::word && std::isalpha(static_cast<unsigned char>(token.text[0])); }

bool isOneOf(const std::string& word, const Words& words) { return std::find(words.begin(), words.end(), word) != words.end(); }

/// As (x y 0), or (0 0 z) for what stands on the plane of the grains.
std::string vectorForm(int emptyAxis, bool isInPlane)
{
    std::string form = "(";
    for (int k = 0; k < 3; ++k) form += std::string(k ? " " : "") + ((k == emptyAxis) == isInPlane ? '0' : "xyz"[k]);
    return "vectors " + form + ")";
}

/// Reads the values of one keyword from its tokens, and checks them.
template<class Value>
class FunctionReader
{
public:
    using Function = std::function<Value(double)>;
    using Check = std::function<void(const CheckedEntries&, const std::string&, const Value&)>;

    FunctionReader(const CheckedEntries& given, const std::string& keyword, const Check& check)
    :
        given_(given),
        keyword_(keyword),
        more_(given.dict().functions.get()),
        check_(check)
    {}

    Function read() const
    {
        given_.require(keyword_, forms);
        // Functions of OpenFOAM may keep their numbers beside themselves.
        if (more_ && given_.dict().find(keyword_ + "Coeffs")) given_.found(keyword_ + "Coeffs");
        const Function own = given_.isDictionary(keyword_) ? readDictionary() : readTokens();
        const Function function = own ? own : readMore();
        const Value start = function(0.0);
        if (!isFinite(start)) given_.reject(keyword_, "is not finite at time 0", forms);
        check_(given_, keyword_, start);
        return function;
    }

private:
    static constexpr bool isScalar = std::is_same_v<Value, double>;
    static constexpr std::size_t length = isScalar ? 1 : 5;   // of a value in tokens

    static Function constant(const Value& value) { return [value](double) { return value; }; }

    static bool isFinite(const Value& value)
    {
        if constexpr (isScalar) return std::isfinite(value);
        else return value.allFinite();
    }

    Function readMore() const
    {
        if constexpr (isScalar) return more_->scalar(keyword_);
        else return more_->vector(keyword_);
    }

    /// What the program makes itself where it can, once it has been found right.
    Function checked(const Function& own) const { return more_ ? Function() : own; }

    Function readTokens() const
    {
        const std::vector<Token>& tokens = given_.tokens(keyword_, forms);
        if (!isName(tokens[0])) return checked(constant(readConstant()));
        const std::string& type = tokens[0].text;
        if (type == "constant") return checked(constant(readValue(1, tokens.size())));
        if (type == "table") return checked(readTable(1));
        const Words types = more_ ? more_->types() : Words{"constant", "table"};
        if (!isOneOf(type, types)) throw InputError({given_.place(keyword_), "is no function of time", type, forms, types});
        return {};
    }

    Function readDictionary() const
    {
        const CheckedEntries dict(given_.sub(keyword_));
        dict.require("type", forms);
        const std::string type = dict.choice("type", more_ ? more_->types() : ownTypes);
        if (!isOneOf(type, ownTypes)) return {};
        Function function;
        if (type == "constant") function = constant(of(dict, "value").readConstant());
        else if (type == "table") function = readTableDictionary(dict);
        else function = readSine(dict);
        dict.finish();
        return function;
    }

    Function readTableDictionary(const CheckedEntries& dict) const
    {
        const Function table = of(dict, "values").readTable(0);
        const bool isBounded = more_ && dict.found("outOfBounds"), isSmooth = more_ && dict.found("interpolationScheme");
        return isBounded || isSmooth ? Function() : table;
    }

    FunctionReader of(const CheckedEntries& dict, const std::string& keyword) const { return FunctionReader(dict, keyword, check_); }

    Value readConstant() const { return readValue(0, given_.tokens(keyword_, forms).size()); }

    Function readSine(const CheckedEntries& dict) const
    {
        const Words needed = {"frequency", "amplitude", "scale", "level"};
        for (const std::string& keyword : needed) dict.require(keyword, forms);
        // In OpenFOAM's each number may be a function again.
        const auto isFunction = [&](const std::string& keyword) { return dict.isDictionary(keyword) || isName(dict.tokens(keyword, forms)[0]); };
        const double start = dict.number("t0", anyNumber(), 0.0);
        if (more_ && std::any_of(needed.begin(), needed.end(), isFunction)) return {};
        const double frequency = dict.number("frequency", between(0, highestFrequency)), amplitude = dict.number("amplitude", anyNumber());
        const Value scale = amplitude*of(dict, "scale").readConstant(), level = of(dict, "level").readConstant();
        return checked([=](double time) { return Value(level + std::sin(2.0*M_PI*frequency*(time - start))*scale); });
    }

    Value readValue(std::size_t first, std::size_t last) const
    {
        const std::vector<Token>& tokens = given_.tokens(keyword_, forms);
        if (last != first + length) given_.reject(keyword_, "is not a single value", forms);
        Value value;
        if constexpr (isScalar) value = given_.toNumber(keyword_, tokens[first], anyNumber());
        else value = given_.toVec(keyword_, tokens, first);
        check_(given_, keyword_, value);
        return value;
    }

    /// ((time value) (time value) ...) from a token on, their number before them or not.
    Function readTable(std::size_t first) const
    {
        const std::vector<Token>& tokens = given_.tokens(keyword_, forms);
        if (first + 1 < tokens.size() && tokens[first].isNumber() && tokens[first + 1].isMark('(')) ++first;
        const std::size_t row = length + 3;
        const bool isList = tokens.size() >= first + 2 + row && tokens[first].isMark('(') && tokens.back().isMark(')');
        if (!isList || (tokens.size() - first - 2) % row != 0) given_.reject(keyword_, "is not a table", "rows of time and value, as table ((0 0) (1 2.5))");
        std::vector<double> times;
        std::vector<Value> values;
        for (std::size_t at = first + 1; at + 1 < tokens.size(); at += row)
        {
            if (!tokens[at].isMark('(') || !tokens[at + row - 1].isMark(')')) given_.reject(keyword_, "is not a table", "rows in brackets, as (0 2.5)");
            times.push_back(given_.toNumber(keyword_, tokens[at + 1], anyNumber()));
            values.push_back(readValue(at + 2, at + row - 1));
        }
        if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end())
        {
            given_.reject(keyword_, "has rows out of order", "times that increase from row to row");
        }
        return [times, values](double time) { return interpolated(times, values, time); };
    }

    static Value interpolated(const std::vector<double>& times, const std::vector<Value>& values, double time)
    {
        const std::size_t next = std::upper_bound(times.begin(), times.end(), time) - times.begin();
        if (next == 0) return values.front();
        if (next == times.size()) return values.back();
        const double share = (time - times[next - 1])/(times[next] - times[next - 1]);
        return (1.0 - share)*values[next - 1] + share*values[next];
    }

    const CheckedEntries& given_;
    const std::string keyword_;
    const Functions* more_;
    const Check check_;
};

template<void check(const CheckedEntries&, const std::string&, const Vec3&, int)>
nscd::VectorOfTime readChecked(const CheckedEntries& given, const std::string& keyword, int emptyAxis)
{
    const auto checkValue = [emptyAxis](const CheckedEntries& dict, const std::string& name, const Vec3& value) { check(dict, name, value, emptyAxis); };
    return FunctionReader<Vec3>(given, keyword, checkValue).read();
}

} // namespace

void checkInPlane(const CheckedEntries& given, const std::string& keyword, const Vec3& value, int emptyAxis)
{
    if (emptyAxis < 0 || value[emptyAxis] == 0.0) return;
    given.reject(keyword, "leaves the plane of the grains", vectorForm(emptyAxis, true));
}

void checkNormalToPlane(const CheckedEntries& given, const std::string& keyword, const Vec3& value, int emptyAxis)
{
    if (emptyAxis < 0 || (value - value[emptyAxis]*Vec3::Unit(emptyAxis)).isZero(0.0)) return;
    given.reject(keyword, "turns out of the plane of the grains", vectorForm(emptyAxis, false));
}

nscd::ScalarOfTime readScalarFunction(const CheckedEntries& given, const std::string& keyword)
{
    return FunctionReader<double>(given, keyword, [](const CheckedEntries&, const std::string&, double) {}).read();
}

nscd::VectorOfTime readVectorFunction(const CheckedEntries& given, const std::string& keyword, int emptyAxis)
{
    return readChecked<checkInPlane>(given, keyword, emptyAxis);
}

nscd::VectorOfTime readSpinFunction(const CheckedEntries& given, const std::string& keyword, int emptyAxis)
{
    return readChecked<checkNormalToPlane>(given, keyword, emptyAxis);
}

} // namespace input
