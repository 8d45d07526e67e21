// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The symmetric table of contact pairs.
#include "nscd/scene/materials.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

void checkNotNegative(const char* name, double value)
{
    if (!(value >= 0.0) || !std::isfinite(value)) throw invalidValue(name, value, "a finite value >= 0");
}

void checkFilm(const ContactPair& pair)
{
    checkNotNegative("roughness", pair.roughness);
    checkNotNegative("lubrication range", pair.lubricationRange);
    checkNotNegative("lubrication viscosity", pair.lubricationViscosity);
    if (pair.roughness > 0.0 && !(pair.lubricationRange > 0.0)) throw invalidValue("lubrication range", pair.lubricationRange, "more than 0 where there is a roughness");
}

bool isFilmWithoutViscosity(const ContactPair& pair) { return pair.roughness > 0.0 && pair.lubricationViscosity == 0.0; }

} // namespace

int Materials::add(const std::string& name)
{
    if (find(name) >= 0) throw invalidValue("material", name, "a name not used before");

    const int oldSize = size();
    const int newSize = oldSize + 1;
    std::vector<ContactPair> pairs(newSize*newSize);
    std::vector<char> isSet(newSize*newSize, 0);
    for (int a = 0; a < oldSize; ++a)
    {
        for (int b = 0; b < oldSize; ++b)
        {
            pairs[a*newSize + b] = pairs_[a*oldSize + b];
            isSet[a*newSize + b] = isSet_[a*oldSize + b];
        }
    }
    names_.push_back(name);
    pairs_ = std::move(pairs);
    isSet_ = std::move(isSet);
    return oldSize;
}

void Materials::setPair(int a, int b, const ContactPair& pair)
{
    if (a < 0 || a >= size()) throw invalidValue("material index", a, "an index of a material added before");
    if (b < 0 || b >= size()) throw invalidValue("material index", b, "an index of a material added before");
    checkNotNegative("friction", pair.friction);
    checkNotNegative("rolling friction", pair.rollingFriction);
    checkNotNegative("spinning friction", pair.spinningFriction);
    checkNotNegative("cohesion", pair.cohesion);
    checkNotNegative("cohesion range", pair.cohesionRange);
    checkFilm(pair);
    if (!(pair.restitution >= 0.0 && pair.restitution <= 1.0))
    {
        throw invalidValue("restitution", pair.restitution, "0 to 1");
    }
    for (int index : {a*size() + b, b*size() + a})
    {
        pairs_[index] = pair;
        isSet_[index] = 1;
    }
}

int Materials::find(const std::string& name) const
{
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
}

bool Materials::anyFriction() const
{
    return std::any_of(pairs_.begin(), pairs_.end(), [](const ContactPair& p) { return p.friction > 0.0; });
}

double Materials::largestFriction() const
{
    double largest = 0.0;
    for (const ContactPair& p : pairs_) largest = std::max(largest, p.friction);
    return largest;
}

bool Materials::anyRestitution() const
{
    return std::any_of(pairs_.begin(), pairs_.end(), [](const ContactPair& p) { return p.restitution > 0.0; });
}

bool Materials::anyRolling() const
{
    const auto resists = [](const ContactPair& p) { return p.rollingFriction > 0.0 || p.spinningFriction > 0.0; };
    return std::any_of(pairs_.begin(), pairs_.end(), resists);
}

bool Materials::anyCohesion() const
{
    return std::any_of(pairs_.begin(), pairs_.end(), [](const ContactPair& p) { return p.cohesion > 0.0; });
}

bool Materials::anyRoughness() const
{
    return std::any_of(pairs_.begin(), pairs_.end(), [](const ContactPair& p) { return p.roughness > 0.0; });
}

bool Materials::lacksFilmViscosity() const { return std::any_of(pairs_.begin(), pairs_.end(), isFilmWithoutViscosity); }

void Materials::setFilmViscosity(double viscosity)
{
    checkNotNegative("lubrication viscosity", viscosity);
    for (ContactPair& pair : pairs_)
    {
        if (isFilmWithoutViscosity(pair)) pair.lubricationViscosity = viscosity;
    }
}

double Materials::lubricationRange() const
{
    double largest = 0.0;
    for (const ContactPair& p : pairs_) largest = p.roughness > 0.0 ? std::max(largest, p.lubricationRange) : largest;
    return largest;
}

double Materials::cohesionRange() const
{
    double largest = 0.0;
    for (const ContactPair& p : pairs_) largest = p.cohesion > 0.0 ? std::max(largest, p.cohesionRange) : largest;
    return largest;
}

} // namespace nscd
