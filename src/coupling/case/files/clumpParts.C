// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Taking clumps apart, and putting them together.
#include "coupling/case/files/clumpParts.H"

#include "coupling/base/vectorConversion.H"

#include "Time.H"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace Foam
{
namespace nscdCoupling
{

namespace part
{
    const wordList scalars{"members", "orientationW", "mass"};
    const wordList vectors{"position", "U", "omega", "orientation", "angularMomentum", "inertiaX", "inertiaY", "inertiaZ"};
}

namespace
{

using nscd::Quaternion;
using nscd::Vec3;

/// A mass that is off by more is that of another density.
constexpr scalar roundOff = 1e-9;

GrainExtras emptyParts(std::size_t grains)
{
    GrainExtras parts;
    parts.scalars[part::clump].assign(grains, -1);
    parts.vectors[part::memberCenter].assign(grains, Vec3::Zero());
    for (const word& name : part::scalars) parts.scalars[name].assign(grains, 0);
    for (const word& name : part::vectors) parts.vectors[name].assign(grains, Vec3::Zero());
    return parts;
}

void takeApart(const nscd::Clumps& clumps, std::size_t c, GrainExtras& parts)
{
    const std::size_t first = clumps.firstMember[c];
    const nscd::ClumpShape& shape = clumps.shapeOf(c);
    const Quaternion& q = clumps.orientation[c];
    parts.scalars["members"][first] = scalar(shape.members.size());
    parts.scalars["orientationW"][first] = q.w();
    parts.scalars["mass"][first] = shape.mass;
    parts.vectors["position"][first] = clumps.position[c];
    parts.vectors["U"][first] = clumps.velocity[c];
    parts.vectors["omega"][first] = nscd::angularVelocity(clumps, c);
    parts.vectors["orientation"][first] = q.vec();
    parts.vectors["angularMomentum"][first] = clumps.angularMomentum[c];
    // Its two halves differ by round-off.
    parts.vectors["inertiaX"][first] = shape.inertia.row(0);
    parts.vectors["inertiaY"][first] = shape.inertia.row(1);
    parts.vectors["inertiaZ"][first] = shape.inertia.row(2);
}

/// Grains in the order that has the members of each clump in a row, in the place of its first one.
class MemberOrder
{
public:
    MemberOrder(const GrainState& state, const polyMesh& mesh)
    :
        state_(state),
        clump_(state.clumpParts.scalars.at(part::clump))
    {
        for (std::size_t i = 0; i < clump_.size(); ++i)
        {
            if (clump_[i] >= 0) members_[std::int64_t(clump_[i])].push_back(i);
        }
        for (std::size_t i = 0; i < clump_.size(); ++i) add(i);
        if (order_.size() == clump_.size()) return;
        for (const auto& clump : members_) refuseClump(mesh, label(clump.first), "whose members are not there, or not in a row");
    }

    const std::vector<std::size_t>& order() const { return order_; }

private:
    void add(std::size_t i)
    {
        if (clump_[i] < 0) order_.push_back(i);
        if (!isFirstMember(state_, i)) return;
        const auto clump = members_.find(state_.grains.id[i]);
        std::vector<std::size_t>& own = clump->second;
        std::sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) { return state_.grains.id[a] < state_.grains.id[b]; });
        order_.insert(order_.end(), own.begin(), own.end());
        members_.erase(clump);
    }

    const GrainState& state_;
    const std::vector<scalar>& clump_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> members_;   // of clumps that have no place yet
    std::vector<std::size_t> order_;
};

template<class Values>
void sortBy(const std::vector<std::size_t>& order, Values& values)
{
    Values sorted;
    sorted.reserve(values.size());
    for (const std::size_t i : order) sorted.push_back(values[i]);
    values = std::move(sorted);
}

void sortBy(const std::vector<std::size_t>& order, GrainState& state)
{
    if (std::is_sorted(order.begin(), order.end())) return;
    state.grains.forEachArray([&](auto& values) { sortBy(order, values); });
    for (GrainExtras* extras : {&state.extras, &state.unwritten, &state.clumpParts})
    {
        for (auto& entry : extras->scalars) sortBy(order, entry.second);
        for (auto& entry : extras->vectors) sortBy(order, entry.second);
    }
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
void shareMass(nscd::Grains& grains, std::size_t first, std::size_t number, scalar mass)
{
    double volume = 0;
    for (std::size_t i = first; i < first + number; ++i) volume += grains.volume(i);
    const double density = mass/volume;
    for (std::size_t i = first; i < first + number; ++i) grains.mass[i] = density*grains.volume(i);
}

/// Members from a first one on, all of them there.
std::size_t numberOfMembers(const GrainState& state, std::size_t first, const polyMesh& mesh)
{
    const std::vector<scalar>& clump = state.clumpParts.scalars.at(part::clump);
    const label id = label(state.grains.id[first]);
    std::size_t end = first;
    while (end < clump.size() && clump[end] == clump[first]) ++end;
    if (scalar(end - first) != state.clumpParts.scalars.at("members")[first]) refuseClump(mesh, id, "whose members are not there, or not in a row");
    for (std::size_t i = first; i < end; ++i)
    {
        if (state.grains.material[i] != state.grains.material[first]) refuseClump(mesh, id, "of several materials");
    }
    return end - first;
}

nscd::ClumpShape writtenShape(const GrainState& state, std::size_t first, std::size_t number, const input::MaterialTable& materials)
{
    const GrainExtras& parts = state.clumpParts;
    const nscd::Grains& grains = state.grains;
    std::vector<nscd::Ball> balls;
    for (std::size_t i = first; i < first + number; ++i) balls.push_back({parts.vectors.at(part::memberCenter)[i], grains.radius[i]});
    Eigen::Matrix3d inertia;
    const char* const rows[] = {"inertiaX", "inertiaY", "inertiaZ"};
    for (int k = 0; k < 3; ++k) inertia.row(k) = parts.vectors.at(rows[k])[first].transpose();
    return shapeOf(balls, parts.scalars.at("mass")[first], inertia, materials.density[grains.material[first]], grains.shape);
}

void join(GrainState& state, std::size_t first, const polyMesh& mesh, const input::MaterialTable& materials)
{
    const GrainExtras& parts = state.clumpParts;
    nscd::Clumps& clumps = state.grains.clumps;
    const std::size_t number = numberOfMembers(state, first, mesh);
    try
    {
        clumps.shape.push_back(addShape(clumps.shapes, writtenShape(state, first, number, materials)));
    }
    catch (const std::invalid_argument& error)
    {
        refuseClump(mesh, label(state.grains.id[first]), string("that is damaged: ") + error.what());
    }
    clumps.firstMember.push_back(int(first));
    clumps.position.push_back(parts.vectors.at("position")[first]);
    const Vec3& axis = parts.vectors.at("orientation")[first];
    clumps.orientation.push_back(Quaternion(parts.scalars.at("orientationW")[first], axis[0], axis[1], axis[2]));
    clumps.velocity.push_back(parts.vectors.at("U")[first]);
    clumps.angularMomentum.push_back(parts.vectors.at("angularMomentum")[first]);
    shareMass(state.grains, first, number, clumps.shapeOf(clumps.size() - 1).mass);
}

/// Mass, inertia, and center and radius of each member.
scalarList numbersOf(const nscd::ClumpShape& shape)
{
    DynamicList<scalar> numbers;
    numbers.append(shape.mass);
    for (int k = 0; k < 9; ++k) numbers.append(shape.inertia.data()[k]);
    for (const nscd::Ball& ball : shape.members)
    {
        for (int k = 0; k < 3; ++k) numbers.append(ball.center[k]);
        numbers.append(ball.radius);
    }
    return scalarList(numbers);
}

nscd::ClumpShape shapeFrom(const scalarList& numbers)
{
    nscd::ClumpShape shape;
    shape.mass = numbers[0];
    std::copy_n(&numbers[1], 9, shape.inertia.data());
    for (label k = 10; k < numbers.size(); k += 4) shape.members.push_back({Vec3(numbers[k], numbers[k + 1], numbers[k + 2]), numbers[k + 3]});
    return shape;
}

/// The shapes of all ranks, in the order of these.
void shareShapes(nscd::Clumps& clumps)
{
    if (!Pstream::parRun()) return;
    List<List<scalarList>> ofRanks(Pstream::nProcs());
    for (const nscd::ClumpShape& shape : clumps.shapes) ofRanks[Pstream::myProcNo()].append(numbersOf(shape));
    Pstream::gatherList(ofRanks);
    Pstream::scatterList(ofRanks);
    const std::vector<nscd::ClumpShape> own = std::move(clumps.shapes);
    clumps.shapes.clear();
    for (const List<scalarList>& shapes : ofRanks)
    {
        for (const scalarList& numbers : shapes) addShape(clumps.shapes, shapeFrom(numbers));
    }
    for (int& shape : clumps.shape) shape = addShape(clumps.shapes, own[shape]);
}

} // namespace


void refuseClump(const polyMesh& mesh, label id, const string& what)
{
    const fileName file = mesh.time().timePath()/"lagrangian/clumps/origId";
    fail({placeInFile(file, "origId"), "names a clump " + what, Foam::name(id), "the identity of its first member, which the others follow"});
}


GrainExtras clumpParts(const nscd::Grains& grains)
{
    GrainExtras parts = emptyParts(grains.size());
    for (std::size_t c = 0; c < grains.clumps.size(); ++c)
    {
        const std::vector<nscd::Ball>& members = grains.clumps.shapeOf(c).members;
        const std::size_t first = grains.clumps.firstMember[c];
        for (std::size_t k = 0; k < members.size(); ++k)
        {
            parts.scalars[part::clump][first + k] = scalar(grains.id[first]);
            parts.vectors[part::memberCenter][first + k] = members[k].center;
        }
        takeApart(grains.clumps, c, parts);
    }
    return parts;
}


bool isFirstMember(const GrainState& state, std::size_t grain)
{
    return state.clumpParts.scalars.at(part::clump)[grain] == scalar(state.grains.id[grain]);
}


void joinClumpParts(GrainState& state, const polyMesh& mesh, const input::MaterialTable& materials)
{
    sortBy(MemberOrder(state, mesh).order(), state);
    state.grains.clumps = nscd::Clumps();
    for (std::size_t i = 0; i < state.grains.size(); ++i)
    {
        if (isFirstMember(state, i)) join(state, i, mesh, materials);
    }
    shareShapes(state.grains.clumps);
    state.clumpParts = GrainExtras();
}

} // namespace nscdCoupling
} // namespace Foam
