// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading materials and the coefficients of their pairs.
#include "coupling/case/input/materialsReader.H"

#include "dimensionSets.H"

#include <algorithm>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

nscd::ContactPair readPair(const dictionary& dict)
{
    const CheckedDict given(dict);
    nscd::ContactPair pair;
    pair.friction = given.number("friction", atLeast(0));
    pair.restitution = given.number("restitution", between(0, 1), dimless, 0.0);
    pair.rollingFriction = given.number("rollingFriction", atLeast(0), dimless, 0.0);
    pair.spinningFriction = given.number("spinningFriction", atLeast(0), dimless, 0.0);
    pair.cohesion = given.number("cohesion", atLeast(0), dimForce, 0.0);
    pair.cohesionRange = given.number("cohesionRange", atLeast(0), dimLength, 0.0);
    given.finish();
    return pair;
}

void addMaterial(MaterialProperties& materials, const dictionary& parent, const word& name)
{
    const CheckedDict entries(parent);
    const CheckedDict given(entries.sub(name));
    materials.table.add(name);
    materials.density.push_back(given.number("density", above(0), dimDensity, 0.0));
    materials.place.push_back(placeOf(parent, name));
    given.finish();
}

/// Calls set(a, b, keyword) for both spellings of every pair's keyword, as glass-steel and steel-glass.
template<class Set>
void forEachPairName(const nscd::Materials& table, const Set& set)
{
    for (int a = 0; a < table.size(); ++a)
    {
        for (int b = a; b < table.size(); ++b)
        {
            set(a, b, word(table.names()[a] + "-" + table.names()[b]));
            if (a != b) set(a, b, word(table.names()[b] + "-" + table.names()[a]));
        }
    }
}

void setAllPairs(nscd::Materials& table, const nscd::ContactPair& pair)
{
    for (int a = 0; a < table.size(); ++a)
    {
        for (int b = a; b < table.size(); ++b) table.setPair(a, b, pair);
    }
}

void readContacts(const CheckedDict& contacts, MaterialProperties& materials)
{
    if (contacts.found("default")) setAllPairs(materials.table, readPair(contacts.sub("default")));

    std::vector<std::pair<int, int>> named;
    forEachPairName(materials.table, [&](int a, int b, const word& keyword)
    {
        if (!contacts.found(keyword)) return;
        if (std::find(named.begin(), named.end(), std::make_pair(a, b)) != named.end())
        {
            contacts.reject(keyword, "repeats a pair already given in the other order");
        }
        named.emplace_back(a, b);
        materials.table.setPair(a, b, readPair(contacts.sub(keyword)));
    });
    contacts.finish();
}

} // namespace


Words MaterialProperties::grainMaterials() const
{
    Words names;
    for (int i = 0; i < table.size(); ++i)
    {
        if (density[i] > 0) names.push_back(table.names()[i]);
    }
    return names;
}


MaterialProperties readMaterials(const CheckedDict& top)
{
    MaterialProperties materials;
    const dictionary& list = top.sub("materials");
    for (const entry& given : list) addMaterial(materials, list, given.keyword());
    if (materials.table.size() == 0) fail({placeOf(top.dict(), "materials"), "names no material"});

    materials.contactsPlace = top.place("contacts");
    readContacts(CheckedDict(top.sub("contacts")), materials);
    return materials;
}


int readMaterial(const CheckedDict& dict, const word& keyword, const MaterialProperties& materials)
{
    return materials.table.find(dict.choice(keyword, materials.table.names()));
}


int readGrainMaterial(const CheckedDict& dict, const MaterialProperties& materials)
{
    const Words names = materials.grainMaterials();
    const bool isGiven = dict.found("material");
    if (!isGiven && names.size() == 1) return materials.table.find(names[0]);

    const int material = readMaterial(dict, "material", materials);
    if (materials.density[material] > 0) return material;
    fail
    ({
        materials.place[material], "has no density, which grains need", string::null,
        "density 2500; (in kg/m3) in this material"
    });
}


void checkPairs
(
    const MaterialProperties& materials, const std::vector<int>& ofGrains, const std::vector<int>& ofWalls
)
{
    const auto check = [&](int a, int b)
    {
        if (materials.table.isPairSet(a, b)) return;
        const std::string name = materials.table.names()[a] + "-" + materials.table.names()[b];
        fail
        ({
            materials.contactsPlace, "lacks the pair " + name + ", which can meet", string::null,
            name + " { friction 0.3; restitution 0; }, or the same as `default`"
        });
    };
    for (const int a : ofGrains)
    {
        for (const int b : ofGrains) check(a, b);
        for (const int b : ofWalls) check(a, b);
    }
}

} // namespace nscdCoupling
} // namespace Foam
