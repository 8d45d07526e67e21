// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The functions of time, and the names of fields.
#include "coupling/case/input/fieldReader.H"

#include "input/scene/functionReader.hpp"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

const char* const parts = "acceleration (0 0 1); [m/s2], forceDensity (0 0 1); [N/m3], fields (myField);";

/// A name, or a list of names in brackets.
input::Words readNames(const input::CheckedEntries& given)
{
    const char* const form = "names of volVectorFields, as (myField)";
    input::Words names;
    for (const input::Token& token : given.tokens("fields", form))
    {
        const bool isBracket = token.isMark('(') || token.isMark(')');
        if (!isBracket && token.kind != input::Token::Kind::word) given.reject("fields", "is no list of names", form);
        if (!isBracket) names.push_back(token.text);
    }
    if (names.empty()) given.reject("fields", "names none", form);
    return names;
}

} // namespace


FieldSettings readField(const input::CheckedEntries& forces, const input::Surroundings& around)
{
    FieldSettings settings;
    if (!forces.found("field")) return settings;
    const input::CheckedEntries given(forces.sub("field"));
    if (given.found("acceleration")) settings.acceleration = input::readVectorFunction(given, "acceleration", around.shape.emptyAxis);
    if (given.found("forceDensity")) settings.forceDensity = input::readVectorFunction(given, "forceDensity", around.shape.emptyAxis);
    if (given.found("fields")) settings.fields = readNames(given);
    settings.fieldsPlace = given.place("fields");
    given.finish();
    if (!settings.acceleration && !settings.forceDensity && settings.fields.empty()) forces.reject("field", "says nothing", parts);
    if (!settings.fields.empty() && !around.hasFluid) given.reject("fields", "is sampled with the fluid, and none is solved", "acceleration and forceDensity; or fluid solved");
    return settings;
}

} // namespace nscdCoupling
} // namespace Foam
