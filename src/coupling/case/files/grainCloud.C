// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing and reading the state of the grains.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/files/cloudFiles.H"
#include "coupling/case/files/clumpFiles.H"
#include "coupling/case/files/grainCloud.H"
#include "coupling/case/files/processorFolders.H"
#include "coupling/case/files/processorNames.H"
#include "coupling/case/files/restartFiles.H"
#include "coupling/case/files/runState.H"
#include "nscd/contacts/contactLaw.hpp"

#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "HashSet.H"
#include "cloud.H"

#include <algorithm>
#include <unordered_map>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using IndexOfId = std::unordered_map<std::int64_t, std::size_t>;

template<class To, class From, class Convert>
List<To> converted(const std::vector<From>& from, const Convert& convert)
{
    List<To> to(static_cast<label>(from.size()));
    std::transform(from.begin(), from.end(), to.begin(), convert);
    return to;
}

List<vector> vectorsOf(const std::vector<nscd::Vec3>& values) { return converted<vector>(values, toFoam); }

label toLabel(std::int64_t id)
{
    if (id > labelMax || id < labelMin)
    {
        FatalErrorInFunction
            << "The grain id " << id << " does not fit into a label of this build of OpenFOAM, which ends at " << labelMax
            << "; build OpenFOAM with 64 bit labels." << exit(FatalError);
    }
    return static_cast<label>(id);
}

IndexOfId indexById(const nscd::Grains& grains)
{
    IndexOfId index;
    for (std::size_t i = 0; i < grains.size(); ++i) index.emplace(grains.id[i], i);
    return index;
}

void writeGrains(const polyMesh& mesh, const GrainState& state, const labelUList& cells)
{
    const nscd::Grains& grains = state.grains;
    const GrainExtras& extras = state.extras;
    const CloudWriter cloud(mesh, "grains", vectorsOf(grains.position), cells, converted<label>(grains.id, toLabel));
    cloud.write("position", vectorsOf(grains.position));
    cloud.write("d", converted<scalar>(grains.radius, [](double radius) { return 2*radius; }));
    cloud.write("U", vectorsOf(grains.velocity));
    cloud.write("omega", vectorsOf(grains.omega));
    using nscd::Quaternion;
    const auto axisPart = [](const Quaternion& q) { return vector(q.x(), q.y(), q.z()); };
    cloud.write("orientation", converted<vector>(grains.orientation, axisPart));
    cloud.write("orientationW", converted<scalar>(grains.orientation, [](const Quaternion& q) { return q.w(); }));
    cloud.write("material", converted<label>(grains.material, [](int index) { return label(index); }));
    cloud.write("isFixed", converted<label>(grains.isFixed, [](std::uint8_t fixed) { return label(fixed); }));
    for (const auto& extra : extras.scalars) cloud.write(extra.first, converted<scalar>(extra.second, [](scalar x) { return x; }));
    for (const auto& extra : extras.vectors) cloud.write(extra.first, vectorsOf(extra.second));
    writeMembership(cloud, state);
}

void writeContacts
(
    const polyMesh& mesh, const std::vector<nscd::StoredImpulse>& contacts, const nscd::Grains& grains,
    const nscd::Materials& materials, const labelUList& cells
)
{
    using nscd::StoredImpulse;
    const IndexOfId index = indexById(grains);
    const auto grainOf = [&](const StoredImpulse& c) { return index.at(c.idA); };
    const auto idA = converted<label>(contacts, [](const StoredImpulse& c) { return toLabel(c.idA); });
    const auto idB = converted<label>(contacts, [](const StoredImpulse& c) { return toLabel(c.idB); });
    const auto positions = converted<vector>(contacts, [&](const StoredImpulse& c) { return toFoam(grains.position[grainOf(c)]); });
    const auto cellsOfContacts = converted<label>(contacts, [&](const StoredImpulse& c) { return cells[grainOf(c)]; });

    const CloudWriter cloud(mesh, "contacts", positions, cellsOfContacts, identity(idA.size()));
    cloud.write("idA", idA);
    cloud.write("idB", idB);
    cloud.write("impulse", converted<vector>(contacts, [](const StoredImpulse& c) { return toFoam(c.impulse); }));
    std::size_t place = 0;
    for (const nscd::ContactLawRow& law : nscd::contactLaws())
    {
        if (!law.impulseName) continue;
        const std::size_t own = place++;
        if (law.isUsed(materials)) cloud.write(law.impulseName, converted<vector>(contacts, [own](const StoredImpulse& c) { return toFoam(c.ofLaws[own]); }));
    }
}

/// Index into the present materials of each material at the time of writing.
std::vector<int> materialMap(const RunState& state, const nscd::Materials& present)
{
    std::vector<int> map;
    for (const word& name : state.materials)
    {
        map.push_back(present.find(name));
        if (map.back() < 0)
        {
            fail
            ({
                state.place, "was written with a material that grainProperties no longer has", name, string::null,
                present.names()
            });
        }
    }
    return map;
}

int presentMaterial(label written, const std::vector<int>& map, const input::MaterialTable& materials, const RunState& state)
{
    if (written < 0 || written >= label(map.size()))
    {
        fail({state.place, "does not name the material of a grain", Foam::name(written), "materials in the order written"});
    }
    const int material = map[written];
    if (materials.density[material] <= 0) fail({materials.place[material], "has no density, and grains are made of it"});
    return material;
}

void checkGrain(const polyMesh& mesh, label id, scalar diameter, const vector& position)
{
    if (diameter > 0 && diameter < VGREAT && mag(position) < VGREAT) return;
    fail
    ({
        placeInFile(mesh.time().timePath()/"lagrangian/grains", "d, position"), "are damaged: grain " + Foam::name(id),
        Foam::name(diameter), "finite positions and positive diameters"
    });
}

void checkOrientation(const polyMesh& mesh, label id, scalar w, const vector& axis)
{
    if (isUnitQuaternion(w, axis)) return;
    fail
    ({
        placeInFile(mesh.time().timePath()/"lagrangian/grains", "orientationW, orientation"), "are damaged: grain " + Foam::name(id),
        messageText(w, ", ", axis), "a quaternion of length 1"
    });
}

/// Of the grains of this rank: those of others it does not see.
void checkIds(const polyMesh& mesh, const labelUList& ids)
{
    labelHashSet seen;
    for (const label id : ids)
    {
        if (seen.insert(id)) continue;
        const fileName file = mesh.time().timePath()/"lagrangian/grains/origId";
        fail({placeInFile(file, "origId"), "names two grains alike", Foam::name(id), "an id for each grain"});
    }
}

nscd::Grains readGrains
(
    const polyMesh& mesh, const RunState& state, const input::MaterialTable& materials, const nscd::GrainShape& shape
)
{
    const CloudReader cloud(mesh, "grains");
    const labelList id = cloud.labels("origId");
    cloud.checkTotal("origId", state.nGrains);
    checkIds(mesh, id);
    const vectorField position = cloud.vectors("position");
    const scalarField diameter = cloud.scalars("d");
    const vectorField velocity = cloud.vectors("U");
    const vectorField omega = cloud.vectors("omega");
    const vectorField axisPart = cloud.vectors("orientation");
    const scalarField w = cloud.scalars("orientationW");
    const labelList material = cloud.labels("material");
    const labelList fixed = cloud.labels("isFixed");

    const std::vector<int> map = materialMap(state, materials.table);
    nscd::Grains grains;
    grains.shape = shape;
    forAll(id, i)
    {
        checkGrain(mesh, id[i], diameter[i], position[i]);
        checkOrientation(mesh, id[i], w[i], axisPart[i]);
        const int m = presentMaterial(material[i], map, materials, state);
        grains.add(toVec3(position[i]), 0.5*diameter[i], materials.density[m], m, id[i]);
        grains.velocity.back() = toVec3(velocity[i]);
        grains.omega.back() = toVec3(omega[i]);
        grains.orientation.back() = nscd::Quaternion(w[i], axisPart[i].x(), axisPart[i].y(), axisPart[i].z());
        grains.isFixed.back() = fixed[i] != 0;
    }
    return grains;
}

std::vector<nscd::Vec3> toVec3s(const vectorField& values)
{
    std::vector<nscd::Vec3> result;
    for (const vector& value : values) result.push_back(toVec3(value));
    return result;
}

/// Names of fields to read: those needed, and of the optional ones those that were written. Collective.
wordList withThoseFound(const CloudReader& cloud, wordList names, const wordList& optional)
{
    for (const word& name : optional)
    {
        if (cloud.found(name)) names.append(name);
    }
    return names;
}

GrainExtras readExtras(const polyMesh& mesh, const RestartExpectation& expected)
{
    const CloudReader cloud(mesh, "grains");
    cloud.labels("origId");
    GrainExtras extras;
    for (const word& name : withThoseFound(cloud, expected.scalars, expected.optionalScalars))
    {
        const scalarField values = cloud.scalars(name);
        extras.scalars[name].assign(values.begin(), values.end());
    }
    for (const word& name : withThoseFound(cloud, expected.vectors, expected.optionalVectors))
    {
        extras.vectors[name] = toVec3s(cloud.vectors(name));
    }
    return extras;
}

/// Impulses that laws keep, where they were written.
void readLawImpulses(const CloudReader& cloud, std::vector<nscd::StoredImpulse>& contacts)
{
    std::size_t place = 0;
    for (const nscd::ContactLawRow& law : nscd::contactLaws())
    {
        if (!law.impulseName) continue;
        const std::size_t own = place++;
        if (!cloud.found(law.impulseName)) continue;
        const vectorField values = cloud.vectors(law.impulseName);
        forAll(values, c) contacts[c].ofLaws[own] = toVec3(values[c]);
    }
}

std::vector<nscd::StoredImpulse> readContacts
(
    const polyMesh& mesh, const RunState& state, const nscd::Grains& grains, label nWallRegions
)
{
    const CloudReader cloud(mesh, "contacts");
    const labelList idA = cloud.labels("idA");
    cloud.checkTotal("idA", state.nContacts);
    const labelList idB = cloud.labels("idB");
    const vectorField impulse = cloud.vectors("impulse");

    const IndexOfId index = indexById(grains);
    std::vector<nscd::StoredImpulse> contacts;
    forAll(idA, c)
    {
        contacts.push_back({idA[c], idB[c], toVec3(impulse[c])});
        // Grains of a contact may be another rank's: whoever brings contacts to their grains looks for them.
        const bool isKnownA = Pstream::parRun() || index.count(idA[c]) > 0;
        const bool isKnownB = idB[c] < 0 ? -1 - idB[c] < nWallRegions : Pstream::parRun() || index.count(idB[c]) > 0;
        if (!isKnownA || !isKnownB) refuseContact(mesh, contacts.back());
    }
    readLawImpulses(cloud, contacts);
    return contacts;
}

[[noreturn]] void refuseUnfinished(const Time& time, const fileName& state)
{
    string advice = ", and the run continues from the time before it";
    if (Pstream::parRun()) advice = " of all processors" + advice + " (after redistributePar: run that with -overwrite)";
    fail
    ({
        placeInFile(state, "grainState"), "is missing or incomplete: the directory was not written to its end", string::null,
        "remove the directory " + time.timeName() + advice
    });
}

GrainState withClumpsApart(GrainState state)
{
    state.clumpParts = clumpParts(state.grains);
    state.grains.clumps = nscd::Clumps();
    return state;
}

} // namespace


void writeGrainState
(
    const polyMesh& mesh, const GrainState& state, const nscd::Materials& materials, const labelUList& cells
)
{
    if (!state.grains.clumps.empty()) return writeGrainState(mesh, withClumpsApart(state), materials, cells);
    writeGrains(mesh, state, cells);
    writeClumps(mesh, state, cells);
    writeContacts(mesh, state.contacts, state.grains, materials, cells);
    RunState run;
    run.nGrains = returnReduce(label(state.grains.size()), sumOp<label>());
    run.nContacts = returnReduce(label(state.contacts.size()), sumOp<label>());
    run.materials = wordList(label(materials.names().size()));
    std::copy(materials.names().begin(), materials.names().end(), run.materials.begin());
    run.numbers = state.numbers;
    writeRunState(mesh, run);
}


bool hasGrainState(const polyMesh& mesh)
{
    if (hasRunState(mesh)) return true;
    const Time& time = mesh.time();
    fileName state = time.timePath()/"uniform/grainState";
    const bool isBegun = isFile(state) || isDir(time.timePath()/cloud::prefix/"grains") || isFile(time.timePath()/"balancedGradient");
    if (!returnReduce(isBegun, orOp<bool>()) && !skipsWrittenTime(time)) return false;
    Pstream::scatter(state);
    refuseUnfinished(time, state);
}


void refuseContact(const polyMesh& mesh, const nscd::StoredImpulse& contact)
{
    fail
    ({
        placeInFile(mesh.time().timePath()/"lagrangian/contacts", "idA, idB"), "name a grain or wall that is not there",
        Foam::name(label(contact.idA)) + " and " + Foam::name(label(contact.idB)),
        "ids of lagrangian/grains, and walls as at the time of writing"
    });
}


GrainState readGrainState
(
    const polyMesh& mesh, const input::MaterialTable& materials, const nscd::GrainShape& shape,
    const RestartExpectation& expected
)
{
    checkFieldsOfAll(mesh.time());
    const RunState run = readRunState(mesh);
    checkRestartFiles(mesh.time(), run.files);
    for (const word& name : expected.numbers)
    {
        if (run.numbers.count(name) == 0) fail({run.place, "lacks the number " + name, string::null, "what this version writes"});
    }
    GrainState state;
    state.grains = readGrains(mesh, run, materials, shape);
    readClumpParts(mesh, state);
    state.extras = readExtras(mesh, expected);
    state.contacts = readContacts(mesh, run, state.grains, expected.nWallRegions);
    state.numbers = run.numbers;
    if (areClumpsApart(state) && !Pstream::parRun()) joinClumpParts(state, mesh, materials);
    return state;
}

} // namespace nscdCoupling
} // namespace Foam
