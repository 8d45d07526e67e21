// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The lines about the case.
#include "coupling/case/log/sceneLog.H"

#include "coupling/case/input/heatReader.H"

#include "nscd/base/formattedText.hpp"
#include "nscd/tools/sceneWork.hpp"

#include "Time.H"

namespace Foam
{
namespace nscdCoupling
{

using ::nscd::formatted;

namespace
{

string namesOf(const labelList& patches, const polyMesh& mesh)
{
    string names;
    for (const label patchi : patches) names += (names.empty() ? "" : " ") + mesh.boundaryMesh()[patchi].name();
    return names.empty() ? string("none") : names;
}

string describeGrains(const GrainTotals& grains, const nscd::GrainShape& shape)
{
    if (grains.number == 0) return "none";
    const std::string clumps = grains.clumps == 0 ? "" : formatted(", those of %lld clumps included", static_cast<long long>(grains.clumps));
    return formatted
    (
        "%lld %s%s, diameter %.4g to %.4g m, volume %.6g m3",
        static_cast<long long>(grains.number), shape.dimensions == 2 ? "discs" : shape.emptyAxis < 0 ? "spheres" : "spheres in a plane", clumps.c_str(),
        grains.diameterMin, grains.diameterMax, grains.volume
    );
}

/// As 1000 parcels of 125 grains = 125000 grains of diameter 0.001 to 0.001 m, 0.3 kg
string describeReal(const GrainTotals& grains)
{
    const RealTotals& real = grains.real;
    const std::string range = real.perGrainMin < real.perGrainMax ? formatted("%.9g to ", real.perGrainMin) : "";
    return formatted
    (
        "%lld parcels of %s%.9g grains = %.12g grains of diameter %.4g to %.4g m, %.6g kg",
        static_cast<long long>(grains.number), range.c_str(), real.perGrainMax, real.number, real.diameterMin, real.diameterMax, grains.mass
    );
}

string describeEntry(const nscd::EntrySource& entry, const nscd::GrainShape& shape)
{
    const double inOne = nscd::grainsInParcel(entry.coarseGraining, shape.dimensions);
    return formatted
    (
        "%s, diameter %.4g to %.4g m, by %s%s%s", entry.name.c_str(), entry.sizes.smallest, entry.sizes.largest, entry.isMass ? "mass" : "number",
        entry.takesFluidVelocity ? ", at the fluid's velocity" : "", inOne > 1 ? formatted(", parcels of %.9g grains", inOne).c_str() : ""
    );
}

string describeWalls(const GrainScene& scene, const polyMesh& mesh)
{
    string planes;
    const std::size_t count = scene.roles.ofRole(PatchRole::wall).size();
    for (std::size_t i = count; i < scene.walls.patches.size(); ++i) planes += " " + scene.walls.patches[i].name;
    const string patches = namesOf(scene.roles.ofRole(PatchRole::wall), mesh);
    return formatted("%s%s, %zu flat regions", patches.c_str(), planes.c_str(), scene.walls.regions.size());
}

/// Walls beside the mesh hold grains back and no fluid.
bool areWallsUnseen(const GrainProperties& properties)
{
    return properties.solvesFluid && !properties.walls.patches.empty();
}

string describeFluid(const GrainProperties& properties, const nscd::GrainShape& shape)
{
    if (!properties.solvesFluid) return "none";
    return formatted
    (
        "solved, feedback %s%s; drag %s%s%s; void fraction %s",
        properties.hasFeedback ? "on" : "off", properties.forces.isOn("modelB") ? "; model B" : "", properties.forces.drag.law.c_str(), properties.forces.drag.isPolydisperse ? ", polydisperse" : "",
        correctsOwnWake(properties, shape) ? ", corrected for the own wake of lone grains" : "", properties.voidFraction.method.c_str()
    );
}

string describeSteps(const GrainTimeSettings& time)
{
    const string atLeast = formatted("at least %d of the grains in one of the fluid", int(time.subCycles));
    if (!(time.maxGrainImpacts > 0)) return atLeast;
    const int most = GrainTimeSettings::mostForImpacts;
    return atLeast + formatted(", and at most %.3g impacts of a grain in each, in the mean, as far as %d steps go", time.maxGrainImpacts, most);
}

/// Forces that the fluid's equation has by its factor alpha, and the grains of this case do not; empty: none.
string forcesOfFluidAlone(const GrainProperties& properties)
{
    string names;
    if (!properties.solvesFluid || !properties.hasFeedback || properties.forces.isOn("modelB")) return names;
    for (const char* force : {"pressureGradient", "viscous"})
    {
        if (!properties.forces.isOn(force)) names += (names.empty() ? "" : ", ") + string(force);
    }
    return names;
}

} // namespace


void logScene
(
    Ostream& os, const GrainProperties& properties, const GrainScene& scene, const GrainTotals& grains,
    const polyMesh& mesh, bool isRestart, const stringList& inflow
)
{
    const nscd::ContactSettings& contact = properties.contact;
    const auto line = [&](const char* head, const string& text)
    {
        os << formatted("  %-9s", head).c_str() << text.c_str() << nl;
    };
    os << "Case" << nl;
    line("grains", describeGrains(grains, scene.space.shape));
    if (grains.real.number > 0) line("parcels", describeReal(grains));
    if (isRestart) line("", "from time " + mesh.time().timeName() + "; `grains` of grainProperties are for a new start only");
    if (properties.letsFixedGo() && properties.fixedUntil > mesh.time().value()) line("fixed", formatted("until %.6g s", properties.fixedUntil));
    for (const nscd::EntrySource& entry : properties.entries) line("entering", describeEntry(entry, scene.space.shape));
    line("walls", describeWalls(scene, mesh));
    if (areWallsUnseen(properties)) line("", "those of `walls` and `planes` are for the grains alone: the fluid flows through them");
    line("exits", namesOf(scene.roles.ofRole(PatchRole::exit), mesh));
    line("periodic", namesOf(scene.roles.ofRole(PatchRole::periodic), mesh));
    line("contacts", formatted
    (
        "%s, tolerance %.3g, at most %d sweeps, %s", contact.solver.c_str(), contact.tolerance, contact.maxSweeps,
        nscd::describeWork(properties.materials.table, scene.space.shape, contact).c_str()
    ));
    if (properties.time.mayCycle()) line("steps", describeSteps(properties.time));
    line("fluid", describeFluid(properties, scene.space.shape));
    if (properties.heat) line("heat", formatted("law %s, no heat of friction", properties.heat->law.c_str()));
    const string missing = forcesOfFluidAlone(properties);
    if (!missing.empty()) line("", missing + " off: the fluid loses momentum that no grain gets, which momentumError counts");
    for (const string& patch : inflow) line("inflow", patch);
    if (Pstream::parRun()) line("ranks", formatted("%d, load at most %.3g of the mean", Pstream::nProcs(), properties.maxLoadImbalance));
    os << endl;
}

} // namespace nscdCoupling
} // namespace Foam
