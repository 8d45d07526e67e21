// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The same operation on every quantity.
#include "coupling/step/grainMemory.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/walls/grainExits.H"

#include <stdexcept>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// The values of one type that a state carries, by name.
std::map<word, std::vector<scalar>>& valuesOf(GrainExtras& extras, scalar) { return extras.scalars; }
std::map<word, std::vector<Vec3>>& valuesOf(GrainExtras& extras, const Vec3&) { return extras.vectors; }
const std::map<word, std::vector<scalar>>& valuesOf(const GrainExtras& extras, scalar) { return extras.scalars; }
const std::map<word, std::vector<Vec3>>& valuesOf(const GrainExtras& extras, const Vec3&) { return extras.vectors; }

scalar shown(scalar value) { return value; }
vector shown(const Vec3& value) { return toFoam(value); }

template<class Type>
void sayStart(const Remembered<Type>& quantity, Ostream& os)
{
    os << "  lagrangian/grains/" << quantity.name << " was not written: all grains start with ";
    if (!quantity.startText.empty()) os << quantity.startText.c_str() << nl;
    else os << shown(quantity.start) << ' ' << quantity.unit.c_str() << nl;
}

template<class Type>
void list(const Remembered<Type>& quantity, wordList& required, wordList& optional)
{
    if (quantity.onRestart == OnRestart::required) required.append(quantity.name);
    if (quantity.onRestart == OnRestart::optional) optional.append(quantity.name);
}

} // namespace

bool GrainMemory::isKnown(const word& name) const
{
    bool isKnown = false;
    forEach([&](const auto& quantity) { isKnown = isKnown || quantity.declared.name == name; });
    return isKnown;
}

template<class Type>
std::vector<Type>& GrainMemory::declare(std::list<Quantity<Type>>& quantities, const Remembered<Type>& declared)
{
    if (isKnown(declared.name)) throw std::invalid_argument("grains remember '" + declared.name + "' already");
    if (!declared.isWritten && declared.onRestart != OnRestart::forgotten)
    {
        throw std::invalid_argument("'" + declared.name + "' is to be read on restart, and is not written");
    }
    quantities.push_back({declared, {}});
    return quantities.back().values;
}

std::vector<scalar>& GrainMemory::add(const Remembered<scalar>& quantity) { return declare(scalars_, quantity); }

std::vector<Vec3>& GrainMemory::add(const Remembered<Vec3>& quantity) { return declare(vectors_, quantity); }

void GrainMemory::expect(RestartExpectation& expected) const
{
    for (const auto& quantity : scalars_) list(quantity.declared, expected.scalars, expected.optionalScalars);
    for (const auto& quantity : vectors_) list(quantity.declared, expected.vectors, expected.optionalVectors);
}

void GrainMemory::start(std::size_t grains)
{
    forEach([grains](auto& quantity) { quantity.values.assign(grains, quantity.declared.start); });
}

void GrainMemory::recall(const GrainExtras& read, Ostream& os)
{
    forEach([&](auto& quantity)
    {
        const auto& known = valuesOf(read, quantity.declared.start);
        const auto found = known.find(quantity.declared.name);
        if (found != known.end()) quantity.values = found->second;
        else if (quantity.declared.onRestart == OnRestart::optional) sayStart(quantity.declared, os);
    });
}

void GrainMemory::enter(std::size_t grains)
{
    forEach([grains](auto& quantity) { quantity.values.resize(quantity.values.size() + grains, quantity.declared.start); });
}

void GrainMemory::erase(const std::vector<std::size_t>& indices)
{
    forEach([&indices](auto& quantity) { eraseAt(quantity.values, indices); });
}

void GrainMemory::copyTo(GrainState& state) const
{
    forEach([&state](const auto& quantity)
    {
        GrainExtras& extras = quantity.declared.isWritten ? state.extras : state.unwritten;
        valuesOf(extras, quantity.declared.start)[quantity.declared.name] = quantity.values;
    });
}

void GrainMemory::takeFrom(const GrainState& state)
{
    forEach([&state](auto& quantity)
    {
        const GrainExtras& extras = quantity.declared.isWritten ? state.extras : state.unwritten;
        quantity.values = valuesOf(extras, quantity.declared.start).at(quantity.declared.name);
    });
}

} // namespace nscdCoupling
} // namespace Foam
