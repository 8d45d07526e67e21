// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading functions of time.
#include "functionReader.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <type_traits>

namespace nscdGrains
{

namespace
{

const char* const forms = "a value, table ((time value) ...), or { type sine; frequency 1; amplitude 1; scale 2; level 0; }";

/// What a vector must not have in scenes of discs.
enum class Refused { nothing, outOfPlane, inPlane };

/// Reads the values of one keyword from its tokens.
template<class Value>
class FunctionReader
{
public:
    using Function = std::function<Value(double)>;

    FunctionReader(const CheckedEntries& given, const std::string& keyword, Refused refused = Refused::nothing)
    :
        given_(given),
        keyword_(keyword),
        refused_(refused)
    {}

    Function read() const
    {
        if (given_.found(keyword_) && given_.isDictionary(keyword_)) return readDictionary();
        const std::vector<Token>& tokens = given_.tokens(keyword_, forms);
        const bool isNamed = tokens[0].kind == Token::Kind::word && std::isalpha(static_cast<unsigned char>(tokens[0].text[0]));
        if (!isNamed) return constant(readValue(0, tokens.size()));
        if (tokens[0].text == "constant") return constant(readValue(1, tokens.size()));
        if (tokens[0].text == "table") return readTable(1);
        fail({given_.place(keyword_), "is no function of time", tokens[0].text, forms, {"constant", "table"}});
    }

private:
    static constexpr std::size_t length = std::is_same_v<Value, double> ? 1 : 5;   // of a value in tokens

    static Function constant(const Value& value) { return [value](double) { return value; }; }

    Function readDictionary() const
    {
        const CheckedEntries dict(given_.sub(keyword_));
        const std::string type = dict.choice("type", {"constant", "table", "sine"});
        Function function;
        if (type == "constant") function = constant(readFrom(dict, "value"));
        else if (type == "table") function = FunctionReader(dict, "values", refused_).readTable(0);
        else function = readSine(dict);
        dict.finish();
        return function;
    }

    Value readFrom(const CheckedEntries& dict, const std::string& keyword) const
    {
        return FunctionReader(dict, keyword, refused_).readValue(0, dict.tokens(keyword, forms).size());
    }

    Function readSine(const CheckedEntries& dict) const
    {
        const double frequency = dict.number("frequency", atLeast(0)), amplitude = dict.number("amplitude", anyNumber());
        const double start = dict.number("t0", anyNumber(), 0.0);
        const Value scale = amplitude*readFrom(dict, "scale"), level = readFrom(dict, "level");
        return [=](double time) { return Value(level + std::sin(2.0*M_PI*frequency*(time - start))*scale); };
    }

    Value readValue(std::size_t first, std::size_t last) const
    {
        const std::vector<Token>& tokens = given_.tokens(keyword_, forms);
        if (last < first + length || last > first + length) given_.reject(keyword_, "is not a single value", forms);
        Value value;
        if constexpr (length == 1) value = given_.toNumber(keyword_, tokens[first], anyNumber());
        else value = checked(given_.toVec(keyword_, tokens, first));
        return value;
    }

    Vec3 checked(const Vec3& value) const
    {
        if (refused_ == Refused::outOfPlane && value.z() != 0.0) given_.reject(keyword_, "leaves the plane of discs", "vectors (x y 0)");
        if (refused_ == Refused::inPlane && value.head<2>().norm() > 0.0) given_.reject(keyword_, "turns out of the plane of discs", "vectors (0 0 z)");
        return value;
    }

    /// ((time value) (time value) ...) from a token on.
    Function readTable(std::size_t first) const
    {
        const std::vector<Token>& tokens = given_.tokens(keyword_, forms);
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
    Refused refused_;
};

} // namespace

nscd::ScalarOfTime readScalarFunction(const CheckedEntries& given, const std::string& keyword)
{
    return FunctionReader<double>(given, keyword).read();
}

nscd::VectorOfTime readVectorFunction(const CheckedEntries& given, const std::string& keyword, bool isPlanar)
{
    return FunctionReader<Vec3>(given, keyword, isPlanar ? Refused::outOfPlane : Refused::nothing).read();
}

nscd::VectorOfTime readSpinFunction(const CheckedEntries& given, const std::string& keyword, bool isPlanar)
{
    return FunctionReader<Vec3>(given, keyword, isPlanar ? Refused::inPlane : Refused::nothing).read();
}

} // namespace nscdGrains
