// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Translating dictionaries.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/inputError.H"

#include "input/dictionary/openFoamText.hpp"

#include "Function1.H"
#include "IFstream.H"
#include "IOdictionary.H"
#include "ITstream.H"
#include "dimensionSet.H"
#include "primitiveEntry.H"

#include <cmath>
#include <cstring>
#include <iterator>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using input::Token;

/// The Function1 of a dictionary.
class FoamFunctions : public input::Functions
{
public:
    explicit FoamFunctions(const dictionary& dict) : dict_(dict) {}

    const dictionary& dict() const { return dict_; }

    Words types() const override { return toWords(Function1<Foam::scalar>::dictionaryConstructorTablePtr_->sortedToc()); }

    nscd::ScalarOfTime scalar(const std::string& keyword) const override
    {
        return [function = read<Foam::scalar>(keyword)](double time) { return function->value(time); };
    }

    nscd::VectorOfTime vector(const std::string& keyword) const override
    {
        return [function = read<Foam::vector>(keyword)](double time) { return toVec3(function->value(time)); };
    }

private:
    template<class Type>
    std::shared_ptr<const Function1<Type>> read(const std::string& keyword) const
    {
        const std::shared_ptr<const Function1<Type>> function(Function1<Type>::New(keyword, dict_).release());
        if (const auto* value = isA<primitiveEntry>(*dict_.findEntry(keyword, keyType::LITERAL)))
        {
            // Of `sine;` with its numbers in a dictionary of their own, later versions than v1912 only look at the word.
            const label read = max(label(1), value->size() - value->nRemainingTokens());
            if (read < value->size())
            {
                throw input::InputError({placeOf(dict_, keyword), "goes on after its function of time", messageText((*value)[read])});
            }
        }
        return function;
    }

    const dictionary& dict_;
};

Token mark(char c, int line) { return {Token::Kind::mark, std::string(1, c), line}; }

Token translated(const token& tok)
{
    const int line = int(tok.lineNumber());
    if (tok.isPunctuation() && std::strchr("()[]{};", char(tok.pToken()))) return mark(char(tok.pToken()), line);
    if (tok.isNumber() && std::isfinite(tok.number())) return {Token::Kind::number, messageText(tok), line, tok.number()};
    if (tok.isWord()) return {Token::Kind::word, tok.wordToken(), line};
    if (tok.isStringType()) return {Token::Kind::quoted, tok.stringToken(), line};
    return {Token::Kind::word, messageText(tok), line};
}

/// A list that OpenFOAM has read already, as List<label> 2(0 1): its tokens but the name of its type.
void addList(std::vector<Token>& tokens, const token& list)
{
    OStringStream os;
    os.precision(17);
    list.compoundToken().write(os);
    for (const token& tok : ITstream::parse(os.str()))
    {
        tokens.push_back(translated(tok));
        tokens.back().line = int(list.lineNumber());
    }
}

/// Position of the bracket that closes dimensions in symbols, as [kg/m^3], which a token opens; -1 where it opens something else.
label endOfSymbols(const tokenList& value, label opening)
{
    const bool isOpening = value[opening].isPunctuation() && value[opening].pToken() == token::BEGIN_SQR;
    if (!isOpening || opening + 1 >= value.size() || !value[opening + 1].isWord()) return -1;
    for (label i = opening + 1; i < value.size(); ++i)
    {
        const bool endsWithIt = value[i].isWord() && value[i].wordToken().back() == ']';
        if (endsWithIt || (value[i].isPunctuation() && value[i].pToken() == token::END_SQR)) return i;
    }
    return -1;
}

/// Exponents between brackets. Returns the factor to SI.
scalar addDimensions(std::vector<Token>& tokens, const tokenList& value, label opening, label closing)
{
    ITstream is("dimensions", SubList<token>(value, closing - opening + 1, opening));
    dimensionSet dimensions(dimless);
    scalar factor = 1;
    dimensions.read(is, factor);
    const int line = int(value[opening].lineNumber());
    tokens.push_back(mark('[', line));
    for (int k = 0; k < dimensionSet::nDimensions; ++k)
    {
        const scalar exponent = dimensions[dimensionSet::dimensionType(k)];
        tokens.push_back({Token::Kind::number, messageText(exponent), line, exponent});
    }
    tokens.push_back(mark(']', line));
    return factor;
}

std::vector<Token> translated(const tokenList& value)
{
    std::vector<Token> tokens;
    scalar factor = 1;
    for (label i = 0; i < value.size(); ++i)
    {
        const label closing = endOfSymbols(value, i);
        if (closing >= 0)
        {
            factor = addDimensions(tokens, value, i, closing);
            i = closing;
        }
        else if (value[i].isCompound()) addList(tokens, value[i]);
        else
        {
            tokens.push_back(translated(value[i]));
            tokens.back().number *= factor;
        }
    }
    return tokens;
}

input::Dictionary translated(const dictionary& dict, const Place& place, bool isDeep)
{
    input::Dictionary result{place, {}, std::make_shared<FoamFunctions>(dict)};
    for (const entry& given : dict)
    {
        const Place placeOfEntry = placeOf(dict, given.keyword());
        result.entries.push_back({given.keyword(), placeOfEntry.line, {}, nullptr, given.keyword().isPattern()});
        if (!given.isDict()) result.entries.back().value = translated(given.stream());
        else if (isDeep) result.entries.back().dict = std::make_shared<input::Dictionary>(translated(given.dict(), placeOfEntry, true));
        else result.entries.back().dict = std::make_shared<input::Dictionary>(input::Dictionary{placeOfEntry, {}});
    }
    return result;
}

/// A file as a whole has no line.
Place placeOfWhole(const dictionary& dict)
{
    Place place = placeOf(dict);
    if (place.keyword.empty()) place.line = 0;
    return place;
}

} // namespace


input::Dictionary fromFoam(const dictionary& dict)
{
    return translated(dict, placeOfWhole(dict), true);
}


const dictionary& foamDictionary(const input::Dictionary& translated)
{
    return dynamic_cast<const FoamFunctions&>(*translated.functions).dict();
}


input::Dictionary valuesFromFoam(const dictionary& dict)
{
    return translated(dict, placeOfWhole(dict), false);
}


void checkText(const IOobject& file)
{
    const fileName path = file.globalFilePath(IOdictionary::typeName);
    if (path.empty()) return;
    IFstream is(path);
    const std::string text{std::istreambuf_iterator<char>(is.stdStream()), {}};
    toldByFoam([&] { input::checkOpenFoamText(text, path); });
}

} // namespace nscdCoupling
} // namespace Foam
