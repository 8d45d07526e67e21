// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// From loaded contacts to arrays.
#include "nscd/tools/contactFiles.hpp"

#include "nscd/base/vtkPolyData.hpp"

#include <algorithm>
#include <tuple>

namespace nscd
{

namespace
{

/// Round-off of a solve that ends on the edge of Coulomb's cone, with room.
constexpr double edgeOfCone = 1e-6;

ContactState stateOf(const LoadedContact& contact)
{
    const Vec3 r = contact.impulse - contact.attraction;
    const double normal = r.dot(contact.normal);
    if (normal <= 0.0) return ContactState::open;
    const double tangential = (r - normal*contact.normal).norm();
    return tangential >= (1.0 - edgeOfCone)*contact.friction*normal ? ContactState::slip : ContactState::stick;
}

ShownContact shown(const Grains& grains, const LoadedContact& contact, double deltaT)
{
    const Vec3& center = grains.position[contact.a];
    const double surface = grains.radius[contact.a];
    const bool isWithWall = contact.b < 0;
    const Vec3 centerB = center - (surface + contact.gap + contact.radiusB)*contact.normal;
    const Vec3 point = isWithWall ? centerB : Vec3(center - (surface + 0.5*contact.gap)*contact.normal);
    return
    {
        contact.idA, contact.idB, center, centerB, point, contact.normal, contact.gap, contact.impulse, contact.impulse/deltaT, stateOf(contact)
    };
}

/// Seen from the other grain.
void turnRound(ShownContact& contact)
{
    std::swap(contact.idA, contact.idB);
    std::swap(contact.centerA, contact.centerB);
    contact.normal = -contact.normal;
    contact.impulse = -contact.impulse;
    contact.force = -contact.force;
}

template<class Value>
auto valuesOf(const std::vector<ShownContact>& contacts, const Value& value)
{
    std::vector<std::decay_t<decltype(value(contacts.front()))>> values;
    values.reserve(contacts.size());
    for (const ShownContact& contact : contacts) values.push_back(value(contact));
    return values;
}

/// What points and lines show alike.
struct ContactArrays
{
    explicit ContactArrays(const std::vector<ShownContact>& contacts)
    :
        force(valuesOf(contacts, [](const ShownContact& c) { return c.force; })),
        tangentialForce(valuesOf(contacts, [](const ShownContact& c) { return Vec3(c.force - c.force.dot(c.normal)*c.normal); })),
        impulse(valuesOf(contacts, [](const ShownContact& c) { return c.impulse; })),
        normalForce(valuesOf(contacts, [](const ShownContact& c) { return c.force.dot(c.normal); })),
        normalImpulse(valuesOf(contacts, [](const ShownContact& c) { return c.impulse.dot(c.normal); })),
        gap(valuesOf(contacts, [](const ShownContact& c) { return c.gap; })),
        state(valuesOf(contacts, [](const ShownContact& c) { return static_cast<int>(c.state); })),
        kind(valuesOf(contacts, [](const ShownContact& c) { return c.isWithWall() ? 1 : 0; })),
        idA(valuesOf(contacts, [](const ShownContact& c) { return c.idA; })),
        idB(valuesOf(contacts, [](const ShownContact& c) { return c.idB; }))
    {}

    void addTo(VtkPolyData& data) const
    {
        data.add("normalForce", normalForce);
        data.add("tangentialForce", tangentialForce);
        data.add("force", force);
        data.add("normalImpulse", normalImpulse);
        data.add("impulse", impulse);
        data.add("gap", gap);
        data.add("state", state);
        data.add("kind", kind);
        data.add("idA", idA);
        data.add("idB", idB);
    }

    std::vector<Vec3> force, tangentialForce, impulse;
    std::vector<double> normalForce, normalImpulse, gap;
    std::vector<int> state, kind;
    std::vector<std::int64_t> idA, idB;
};

auto keyOf(const ShownContact& c) { return std::make_tuple(c.idA, c.idB, c.normal[0], c.normal[1], c.normal[2]); }

} // namespace

std::vector<ShownContact> shownContacts(const Grains& grains, const std::vector<LoadedContact>& contacts, double deltaT)
{
    std::vector<ShownContact> result;
    result.reserve(contacts.size());
    for (const LoadedContact& contact : contacts)
    {
        result.push_back(shown(grains, contact, deltaT));
        if (contact.idB >= 0 && contact.idB < contact.idA) turnRound(result.back());
    }
    return result;
}

void sortByIdentity(std::vector<ShownContact>& contacts)
{
    std::sort(contacts.begin(), contacts.end(), [](const ShownContact& a, const ShownContact& b) { return keyOf(a) < keyOf(b); });
}

void writeContactPoints(const std::string& path, double time, const std::vector<ShownContact>& contacts)
{
    const ContactArrays arrays(contacts);
    const std::vector<Vec3> points = valuesOf(contacts, [](const ShownContact& c) { return c.point; });
    const std::vector<Vec3> normals = valuesOf(contacts, [](const ShownContact& c) { return c.normal; });
    VtkPolyData data = VtkPolyData::ofVertices(points);
    data.open("PointData Scalars=\"normalForce\" Vectors=\"force\"");
    arrays.addTo(data);
    data.add("normal", normals);
    data.close("PointData");
    data.write(path, time);
}

void writeForceChains(const std::string& path, double time, const std::vector<ShownContact>& contacts)
{
    const ContactArrays arrays(contacts);
    std::vector<Vec3> ends;
    for (const ShownContact& contact : contacts) ends.insert(ends.end(), {contact.centerA, contact.centerB});
    const std::vector<double> magnitude = valuesOf(contacts, [](const ShownContact& c) { return c.force.norm(); });
    VtkPolyData data = VtkPolyData::ofLines(ends);
    data.open("CellData Scalars=\"forceMagnitude\" Vectors=\"force\"");
    arrays.addTo(data);
    data.add("forceMagnitude", magnitude);
    data.close("CellData");
    data.write(path, time);
}

} // namespace nscd
