// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing and reading clumps.
#include "coupling/case/files/clumpFiles.H"

#include "coupling/base/vectorConversion.H"
#include "nscd/scene/clumpForm.hpp"

#include "Time.H"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using nscd::Quaternion;
using nscd::Vec3;

/// A mass that is off by more is that of another density.
constexpr scalar roundOff = 1e-9;

template<class Value, class Of>
List<Value> ofClumps(const nscd::Clumps& clumps, const Of& of)
{
    List<Value> values(label(clumps.size()));
    forAll(values, c) values[c] = of(std::size_t(c));
    return values;
}

/// The files of one time: a row for each clump.
struct WrittenClumps
{
    labelList id, members;
    vectorField position, velocity, axisPart, angularMomentum, inertiaX, inertiaY, inertiaZ;
    scalarField w, mass;

    explicit WrittenClumps(const CloudReader& cloud)
    :
        id(cloud.labels("origId")),
        members(cloud.labels("members")),
        position(cloud.vectors("position")),
        velocity(cloud.vectors("U")),
        axisPart(cloud.vectors("orientation")),
        angularMomentum(cloud.vectors("angularMomentum")),
        inertiaX(cloud.vectors("inertiaX")),
        inertiaY(cloud.vectors("inertiaY")),
        inertiaZ(cloud.vectors("inertiaZ")),
        w(cloud.scalars("orientationW")),
        mass(cloud.scalars("mass"))
    {}

    Eigen::Matrix3d inertia(label c) const
    {
        Eigen::Matrix3d tensor;
        tensor << toVec3(inertiaX[c]).transpose(), toVec3(inertiaY[c]).transpose(), toVec3(inertiaZ[c]).transpose();
        return tensor;
    }
};

/// Of the members that were written, which clump they are of and where in it.
struct Membership
{
    labelList clump;
    vectorField center;
};

[[noreturn]] void refuseMembers(const polyMesh& mesh, label id, const string& what)
{
    const fileName file = mesh.time().timePath()/"lagrangian/clumps/origId";
    fail({placeInFile(file, "origId"), "names a clump " + what, Foam::name(id), "the identity of its first member, which the others follow"});
}

using PlaceOfGrain = std::unordered_map<std::int64_t, std::size_t>;

PlaceOfGrain placesOf(const nscd::Grains& grains)
{
    PlaceOfGrain places;
    for (std::size_t i = 0; i < grains.size(); ++i) places.emplace(grains.id[i], i);
    return places;
}

/// The grains of a clump from its first one on.
std::vector<std::size_t> membersOf
(
    const polyMesh& mesh, label id, label number, const PlaceOfGrain& places, const nscd::Grains& grains, const Membership& members
)
{
    const auto place = places.find(id);
    const std::size_t first = place == places.end() ? grains.size() : place->second;
    std::vector<std::size_t> found;
    for (std::size_t i = first; i < grains.size() && members.clump[label(i)] == id; ++i) found.push_back(i);
    if (found.empty() || label(found.size()) != number) refuseMembers(mesh, id, "whose members are not there, or not in a row");
    for (const std::size_t i : found)
    {
        if (grains.material[i] != grains.material[first]) refuseMembers(mesh, id, "of several materials");
    }
    return found;
}

bool isSame(const nscd::ClumpShape& a, const nscd::ClumpShape& b)
{
    const auto areSame = [](const nscd::Ball& x, const nscd::Ball& y) { return x.center == y.center && x.radius == y.radius; };
    return a.mass == b.mass && a.inertia == b.inertia && std::equal(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(), areSame);
}

int addShape(std::vector<nscd::ClumpShape>& shapes, const nscd::ClumpShape& shape)
{
    const auto known = std::find_if(shapes.begin(), shapes.end(), [&](const nscd::ClumpShape& each) { return isSame(each, shape); });
    if (known != shapes.end()) return int(known - shapes.begin());
    shapes.push_back(shape);
    return int(shapes.size()) - 1;
}

/// Mass and inertia as written, or as a density makes them that has changed since.
nscd::ClumpShape shapeOf(const std::vector<nscd::Ball>& balls, scalar mass, const Eigen::Matrix3d& inertia, scalar density, const nscd::GrainShape& shape)
{
    const scalar present = nscd::makeClumpShape(balls, density, shape).mass;
    const scalar factor = std::abs(present/mass - 1) > roundOff ? present/mass : 1;
    return nscd::makeClumpShape(balls, factor*mass, Vec3::Zero(), factor*inertia, shape);
}

/// Members share the clump's mass by their volumes, as addClump() has it, to the bit.
void shareMass(nscd::Grains& grains, const std::vector<std::size_t>& members, scalar mass)
{
    double volume = 0;
    for (const std::size_t i : members) volume += grains.volume(i);
    const double density = mass/volume;
    for (const std::size_t i : members) grains.mass[i] = density*grains.volume(i);
}

void addClump
(
    const polyMesh& mesh, const WrittenClumps& written, label c, const PlaceOfGrain& places, const Membership& members,
    const input::MaterialTable& materials, nscd::Grains& grains
)
{
    const std::vector<std::size_t> own = membersOf(mesh, written.id[c], written.members[c], places, grains, members);
    std::vector<nscd::Ball> balls;
    for (const std::size_t i : own) balls.push_back({toVec3(members.center[label(i)]), grains.radius[i]});
    nscd::Clumps& clumps = grains.clumps;
    try
    {
        const scalar density = materials.density[grains.material[own[0]]];
        clumps.shape.push_back(addShape(clumps.shapes, shapeOf(balls, written.mass[c], written.inertia(c), density, grains.shape)));
    }
    catch (const std::invalid_argument& error)
    {
        refuseMembers(mesh, written.id[c], string("that is damaged: ") + error.what());
    }
    clumps.firstMember.push_back(int(own[0]));
    clumps.position.push_back(toVec3(written.position[c]));
    const vector& axis = written.axisPart[c];
    clumps.orientation.push_back(Quaternion(written.w[c], axis.x(), axis.y(), axis.z()));
    clumps.velocity.push_back(toVec3(written.velocity[c]));
    clumps.angularMomentum.push_back(toVec3(written.angularMomentum[c]));
    shareMass(grains, own, clumps.shapeOf(clumps.size() - 1).mass);
}

void checkOneRank(const polyMesh& mesh)
{
    if (!Pstream::parRun()) return;
    fail({placeInFile(mesh.time().timePath()/"lagrangian/clumps", "origId"), "holds clumps, which several ranks do not know", "", "one rank"});
}

} // namespace


void writeMembership(const CloudWriter& grainCloud, const nscd::Grains& grains)
{
    if (grains.clumps.empty()) return;
    labelList clump(label(grains.size()), -1);
    List<vector> center(label(grains.size()), vector(Zero));
    for (std::size_t c = 0; c < grains.clumps.size(); ++c)
    {
        const std::vector<nscd::Ball>& members = grains.clumps.shapeOf(c).members;
        const std::size_t first = grains.clumps.firstMember[c];
        for (std::size_t k = 0; k < members.size(); ++k)
        {
            clump[label(first + k)] = label(grains.id[first]);
            center[label(first + k)] = toFoam(members[k].center);
        }
    }
    grainCloud.write("clump", clump);
    grainCloud.write("memberCenter", center);
}


void writeClumps(const polyMesh& mesh, const nscd::Grains& grains, const labelUList& cells)
{
    const nscd::Clumps& clumps = grains.clumps;
    if (clumps.empty()) return;
    const auto vectors = [&](const auto& of) { return ofClumps<vector>(clumps, [&](std::size_t c) { return toFoam(of(c)); }); };
    const auto points = vectors([&](std::size_t c) { return grains.position[clumps.firstMember[c]]; });
    const auto cellsOfClumps = ofClumps<label>(clumps, [&](std::size_t c) { return cells[clumps.firstMember[c]]; });
    const auto ids = ofClumps<label>(clumps, [&](std::size_t c) { return label(grains.id[clumps.firstMember[c]]); });
    const auto inertia = [&](std::size_t c) { return clumps.shapeOf(c).inertia; };
    const CloudWriter cloud(mesh, "clumps", points, cellsOfClumps, ids);
    cloud.write("members", ofClumps<label>(clumps, [&](std::size_t c) { return label(clumps.shapeOf(c).members.size()); }));
    cloud.write("position", vectors([&](std::size_t c) { return clumps.position[c]; }));
    cloud.write("U", vectors([&](std::size_t c) { return clumps.velocity[c]; }));
    cloud.write("omega", vectors([&](std::size_t c) { return nscd::angularVelocity(clumps, c); }));
    cloud.write("orientation", vectors([&](std::size_t c) { return Vec3(clumps.orientation[c].vec()); }));
    cloud.write("orientationW", ofClumps<scalar>(clumps, [&](std::size_t c) { return clumps.orientation[c].w(); }));
    cloud.write("angularMomentum", vectors([&](std::size_t c) { return clumps.angularMomentum[c]; }));
    cloud.write("mass", ofClumps<scalar>(clumps, [&](std::size_t c) { return clumps.shapeOf(c).mass; }));
    // Its two halves differ by round-off.
    cloud.write("inertiaX", vectors([&](std::size_t c) { return Vec3(inertia(c).row(0)); }));
    cloud.write("inertiaY", vectors([&](std::size_t c) { return Vec3(inertia(c).row(1)); }));
    cloud.write("inertiaZ", vectors([&](std::size_t c) { return Vec3(inertia(c).row(2)); }));
}


void readClumps(const polyMesh& mesh, const input::MaterialTable& materials, nscd::Grains& grains)
{
    const CloudReader grainCloud(mesh, "grains");
    grainCloud.labels("origId");   // how many there are
    if (!grainCloud.found("clump")) return;
    checkOneRank(mesh);
    const Membership members{grainCloud.labels("clump"), grainCloud.vectors("memberCenter")};
    const WrittenClumps written(CloudReader(mesh, "clumps"));
    const PlaceOfGrain places = placesOf(grains);
    forAll(written.id, c) addClump(mesh, written, c, places, members, materials, grains);
}

} // namespace nscdCoupling
} // namespace Foam
