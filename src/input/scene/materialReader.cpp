// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading materials.
#include "input/scene/materialReader.hpp"

namespace input
{

namespace
{

/// The film of fluid between two surfaces; where the fluid is solved, its viscosity is the fluid's, unless it is given.
void readFilm(const CheckedEntries& given, bool hasFluid, nscd::ContactPair& pair)
{
    const Range anyViscosity = atLeast(0, unit::dynamicViscosity);
    pair.roughness = given.number("roughness", atLeast(0, unit::length), 0.0);
    if (pair.roughness > 0.0)
    {
        pair.lubricationRange = given.number("lubricationRange", above(0, unit::length));
        pair.lubricationViscosity = hasFluid
            ? given.number("lubricationViscosity", anyViscosity, 0.0) : given.number("lubricationViscosity", above(0, unit::dynamicViscosity));
        return;
    }
    pair.lubricationRange = given.number("lubricationRange", atLeast(0, unit::length), 0.0);
    pair.lubricationViscosity = given.number("lubricationViscosity", anyViscosity, 0.0);
    if (pair.lubricationRange > 0.0) given.require("roughness", "the thickness of the film that is left where surfaces touch, as 1e-6 [m]; 0: no film");
}

nscd::ContactPair readPair(const Dictionary& dict, bool hasFluid)
{
    const CheckedEntries given(dict);
    nscd::ContactPair pair;
    pair.friction = given.number("friction", atLeast(0));
    pair.restitution = given.number("restitution", between(0, 1), 0.0);
    pair.rollingFriction = given.number("rollingFriction", atLeast(0), 0.0);
    pair.spinningFriction = given.number("spinningFriction", atLeast(0), 0.0);
    pair.cohesion = given.number("cohesion", atLeast(0, unit::force), 0.0);
    pair.cohesionRange = given.number("cohesionRange", atLeast(0, unit::length), 0.0);
    readFilm(given, hasFluid, pair);
    given.finish();
    return pair;
}

void addMaterial(MaterialTable& materials, const CheckedEntries& list, const std::string& name)
{
    const CheckedEntries given(list.sub(name));
    materials.table.add(name);
    materials.density.push_back(given.number("density", above(0, unit::density), 0.0));
    materials.place.push_back(list.place(name));
    given.finish();
}

void setAllPairs(nscd::Materials& table, const nscd::ContactPair& pair)
{
    for (int a = 0; a < table.size(); ++a)
    {
        for (int b = a; b < table.size(); ++b) table.setPair(a, b, pair);
    }
}

std::string nameOfPair(const nscd::Materials& table, int a, int b) { return table.names()[a] + "-" + table.names()[b]; }

/// Sets the pair a-b, under either spelling of its name.
void readNamedPair(const CheckedEntries& contacts, bool hasFluid, nscd::Materials& table, int a, int b)
{
    const std::string name = nameOfPair(table, a, b), swapped = nameOfPair(table, b, a);
    const bool isNamed = contacts.found(name);
    const bool isSwapped = contacts.found(swapped);
    if (isNamed && isSwapped && a != b) contacts.reject(swapped, "repeats a pair already given in the other order");
    if (isNamed || isSwapped) table.setPair(a, b, readPair(contacts.sub(isNamed ? name : swapped), hasFluid));
}

int readMaterial(const CheckedEntries& dict, const std::string& keyword, const MaterialTable& materials)
{
    return materials.table.find(dict.choice(keyword, materials.table.names()));
}

} // namespace

Words MaterialTable::grainMaterials() const
{
    Words names;
    for (int i = 0; i < table.size(); ++i)
    {
        if (density[i] > 0) names.push_back(table.names()[i]);
    }
    return names;
}

MaterialTable readMaterials(const CheckedEntries& top, bool hasFluid)
{
    MaterialTable materials;
    const CheckedEntries list(top.sub("materials"));
    for (const Entry& given : list.dict().entries) addMaterial(materials, list, given.keyword);
    if (materials.table.size() == 0) throw InputError({top.place("materials"), "names no material", "", "materials { glass { density 2500; } }"});

    materials.contactsPlace = top.place("contacts");
    const CheckedEntries contacts(top.sub("contacts"));
    if (contacts.found("default")) setAllPairs(materials.table, readPair(contacts.sub("default"), hasFluid));
    for (int a = 0; a < materials.table.size(); ++a)
    {
        for (int b = a; b < materials.table.size(); ++b) readNamedPair(contacts, hasFluid, materials.table, a, b);
    }
    contacts.finish();
    return materials;
}

int readWallMaterial(const CheckedEntries& top, const MaterialTable& materials)
{
    if (top.foundAsSpelt("wallMaterial")) return readMaterial(top, "wallMaterial", materials);
    return materials.table.size() == 1 ? 0 : -1;
}

int readMaterialOfWall(const CheckedEntries& wall, const Scene& scene)
{
    if (!wall.found("material") && scene.wallMaterial >= 0) return scene.wallMaterial;
    wall.require("material", "material ...; here, or wallMaterial ...; for all walls: " + joined(scene.materials.table.names()));
    return readMaterial(wall, "material", scene.materials);
}

int readMaterialOfGrains(const CheckedEntries& source, const MaterialTable& materials)
{
    const Words names = materials.grainMaterials();
    if (!source.found("material") && names.size() == 1) return materials.table.find(names[0]);
    const int material = readMaterial(source, "material", materials);
    if (materials.density[material] > 0) return material;
    throw InputError({materials.place[material], "has no density, which grains need", "", "density 2500; (in kg/m3) in this material"});
}

void checkPairs(const MaterialTable& materials, const std::vector<int>& ofGrains, const nscd::Walls& walls)
{
    std::vector<int> others = ofGrains;
    for (const nscd::WallPatch& patch : walls.patches) others.push_back(patch.material);
    for (const int a : ofGrains)
    {
        for (const int b : others)
        {
            if (materials.table.isPairSet(a, b)) continue;
            const std::string name = nameOfPair(materials.table, a, b);
            const std::string allowed = name + " { friction 0.3; restitution 0; }, or the same as `default`";
            throw InputError({materials.contactsPlace, "lacks the pair " + name + ", which can meet", "", allowed});
        }
    }
}

} // namespace input
