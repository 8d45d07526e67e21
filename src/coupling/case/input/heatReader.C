// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The fluid's and each material's part of `heat`.
#include "coupling/case/input/heatReader.H"

#include "closures/nusseltLaws.hpp"
#include "input/dictionary/checkedEntries.hpp"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using input::CheckedEntries;

input::Words lawWords()
{
    input::Words words;
    for (const closures::NusseltLawRow& row : closures::nusseltLaws()) words.push_back(row.name);
    return words;
}

FluidHeat readFluid(const CheckedEntries& heat)
{
    const CheckedEntries given(heat.sub("fluid"));
    FluidHeat fluid;
    fluid.heatCapacity = given.number("heatCapacity", input::above(0, input::unit::heatCapacity));
    fluid.conductivity = given.number("conductivity", input::above(0, input::unit::conductivity));
    fluid.expansion = given.number("expansion", input::anyNumber(input::unit::perTemperature), fluid.expansion);
    if (fluid.expansion != 0) fluid.reference = given.number("reference", input::above(0, input::unit::temperature));
    fluid.turbulentPrandtl = given.number("turbulentPrandtl", input::above(0), fluid.turbulentPrandtl);
    given.finish();
    return fluid;
}

GrainHeatProperties readMaterial(const CheckedEntries& list, const std::string& name)
{
    const CheckedEntries given(list.sub(name));
    GrainHeatProperties material;
    material.isGiven = true;
    material.heatCapacity = given.number("heatCapacity", input::above(0, input::unit::heatCapacity));
    material.temperature = given.number("temperature", input::above(0, input::unit::temperature));
    material.conductivity = given.number("conductivity", input::above(0, input::unit::conductivity), 0.0);
    material.youngModulus = given.number("youngModulus", input::above(0, input::unit::pressure), 0.0);
    material.poissonRatio = given.number("poissonRatio", input::between(-1, 0.5), material.poissonRatio);
    material.isHeld = given.flag("held", false);
    given.finish();
    return material;
}

std::vector<GrainHeatProperties> readMaterials(const CheckedEntries& heat, const input::MaterialTable& known)
{
    const CheckedEntries list(heat.sub("materials"));
    const GrainHeatProperties byDefault = list.found("default") ? readMaterial(list, "default") : GrainHeatProperties();
    std::vector<GrainHeatProperties> materials;
    for (const std::string& name : known.table.names())
    {
        materials.push_back(list.found(name) ? readMaterial(list, name) : byDefault);
    }
    list.finish();
    for (const std::string& name : known.grainMaterials())
    {
        if (materials[std::size_t(known.table.find(name))].isGiven) continue;
        const std::string allowed = name + " { heatCapacity 840; temperature 293; }, or the same as `default`";
        throw input::InputError({heat.place("materials"), "lacks the material " + name + " of grains", "", allowed});
    }
    return materials;
}

/// Of `contacts on`.
void checkContacts(const CheckedEntries& heat, const HeatSettings& settings, const input::MaterialTable& known)
{
    for (const std::string& name : known.grainMaterials())
    {
        const GrainHeatProperties& material = settings.materials[std::size_t(known.table.find(name))];
        if (material.conductivity > 0 && material.youngModulus > 0) continue;
        heat.reject("contacts", "needs conductivity and youngModulus of the material " + name, "both; or off");
    }
}

void refuse(const CheckedEntries& top, const std::string& why, const std::string& allowed)
{
    throw input::InputError({top.place("heat"), why, "", allowed});
}

} // namespace


HeatSettings readHeat(const CheckedEntries& top, const input::Scene& scene, bool solvesFluid, bool hasFeedback)
{
    if (!solvesFluid) refuse(top, "needs a fluid that is solved", "fluid solved; or no `heat`");
    if (!hasFeedback) refuse(top, "is shared by grains and fluid, and this fluid does not feel the grains", "feedback on; or no `heat`");
    const CheckedEntries given(top.sub("heat"));
    HeatSettings settings;
    settings.place = top.place("heat");
    settings.law = given.choice("law", lawWords());
    settings.fluid = readFluid(given);
    settings.materials = readMaterials(given, scene.materials);
    settings.hasContacts = given.flag("contacts", settings.hasContacts);
    if (settings.hasContacts) checkContacts(given, settings, scene.materials);
    given.finish();
    return settings;
}

} // namespace nscdCoupling
} // namespace Foam
