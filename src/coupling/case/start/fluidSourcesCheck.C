// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking through them.
#include "coupling/case/start/fluidSourcesCheck.H"
#include "coupling/case/input/inputError.H"

#include "volFields.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// They correct U after the pressure, without drag and without its flux.
bool drivesMeanFlow(const word& type)
{
    static const wordList types{"meanVelocityForce", "patchMeanVelocityForce", "directionalPressureGradientExplicitSource"};
    return types.found(type);
}

wordList fieldsWithSources(const fvMesh& mesh, const word& fluidFraction)
{
    DynamicList<word> names{"U", fluidFraction};
    const wordList turbulent{"k", "epsilon", "omega", "nuTilda", "v2", "f", "kt", "kl", "ReThetat", "gammaInt"};
    for (const word& name : turbulent) if (mesh.foundObject<volScalarField>(name)) names.append(name);
    if (mesh.foundObject<volSymmTensorField>("R")) names.append("R");
    return wordList(names);
}

void checkFluidSource(const fv::option& option, const IOdictionary& dict, const wordList& fields)
{
    const Place place = placeOf(dict, option.name());
    if (drivesMeanFlow(option.type()))
    {
        fail({place, "would correct the velocity without the drag of the grains", option.type(), "`meanFlow` in constant/grainProperties"});
    }
    const auto isOn = [&](const word& field) { return option.applyToField(field) != -1; };
    if (std::none_of(fields.begin(), fields.end(), isOn))
    {
        fail({place, "acts on no field that is solved here", option.type(), "an option for one of " + input::joined(toWords(fields))});
    }
}

} // namespace


void checkFluidSources(const fv::options& options, const word& fluidFraction)
{
    const PtrList<fv::option>& list = options;
    if (list.empty()) return;
    const wordList fields(fieldsWithSources(list[0].mesh(), fluidFraction));
    for (const fv::option& option : list) checkFluidSource(option, options, fields);
}

} // namespace nscdCoupling
} // namespace Foam
