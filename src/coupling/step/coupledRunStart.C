// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// How a run starts: from grainProperties, or from a written time.
// Tested by tests/foam/program/caseProgramTest.C
#include "coupling/step/coupledRun.H"

#include "coupling/case/files/cloudFiles.H"
#include "coupling/case/files/processorFolders.H"
#include "coupling/case/log/grainTotals.H"
#include "coupling/case/log/inflow.H"
#include "coupling/case/log/sceneLog.H"
#include "coupling/case/start/filmViscosity.H"
#include "coupling/case/start/fluidSourcesCheck.H"
#include "coupling/case/start/initialChecks.H"
#include "coupling/case/start/movingMeshCheck.H"
#include "coupling/case/start/numericsCheck.H"
#include "coupling/case/start/rotatingZonesCheck.H"
#include "coupling/case/start/unsupportedFiles.H"
#include "coupling/case/start/parallelRefusal.H"
#include "coupling/step/ownWake.H"
#include "nscd/contacts/contactLaw.hpp"

#include "input/scene/drivenReader.hpp"
#include "input/start/startChecks.hpp"

#include "parallel/rankTree.hpp"

#include "PstreamReduceOps.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

constexpr bool isWritten = true;

// What each grain remembers from one step to the next.
const Remembered<Vec3> dragDebt{"dragDebt", "N s", Vec3::Zero(), isWritten, OnRestart::required};
const Remembered<Vec3> contactForce{"fContact", "N", Vec3::Zero(), isWritten, OnRestart::required};
const Remembered<Vec3> fluidForce{"fFluid", "N", Vec3::Zero(), isWritten, OnRestart::optional};
const Remembered<Vec3> ownWakeOfGrain{"ownWake", "m/s", Vec3::Zero(), isWritten, OnRestart::optional};

const Remembered<scalar> temperature
{
    "T", "K", GrainHeat::unknown, isWritten, OnRestart::optional, "the temperature of their material in `heat`"
};

const Remembered<scalar> coarseness{"coarseGraining", "-", 1.0, isWritten, OnRestart::optional};

/// The time that a directory's name gives has lost digits; a directory that was renamed, to start anew at 0 say, keeps its name.
void continueTime(Time& time, scalar written)
{
    if (Time::timeName(written) == time.timeName()) time.setTime(written, time.timeIndex());
}

bool areAllFixed(const ::nscd::Grains& grains, const ::nscd::Exchange& exchange)
{
    double anyMoves = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (!grains.isFixed[i] || grains.velocity[i] != Vec3::Zero()) anyMoves = 1;
    }
    exchange.max(&anyMoves, 1);
    return anyMoves == 0;
}

ForceConditions forceConditions(const GrainProperties& properties, const GrainScene& scene)
{
    return {properties.solvesFluid, ::nscd::actsOnSpins(properties.materials.table), scene.space.shape.dimensions == 3};
}

/// Edge of a cube, on a 2D mesh of a square, of the cells' mean volume [m].
scalar meanCellSize(const fvMesh& mesh)
{
    const scalar volume = gSum(mesh.V().field())/returnReduce(mesh.nCells(), sumOp<label>());
    const int empty = emptyAxis(mesh);
    return empty < 0 ? std::cbrt(volume) : std::sqrt(volume/mesh.bounds().span()[empty]);
}

/// How much is smoothed, and that the case does not say so.
void tellSmoothing(const VoidFractionSettings& settings, const DiffusionSmoother& smoother)
{
    if (!smoother.isOn()) return;
    Info<< "voidFraction: smoothed over " << smoother.largestLength() << " m, by " << smoother.stages() << " stages of diffusion";
    const label cells = returnReduce(label(sum(pos(smoother.areas()))), sumOp<label>());
    const label all = returnReduce(smoother.areas().size(), sumOp<label>());
    if (settings.diffusion == 0) Info<< ", to a width of " << settings.chosenWidth() << " mean diameters, in " << cells << " of " << all << " cells";
    if (settings.diffusion == 0 && !settings.filterWidth) Info<< ", which are small or thin beside grains";
    Info<< nl;
}

/// What the fluid and the heat do not know of clumps.
void checkClumps(const GrainProperties& properties, const ::nscd::Grains& grains, const Time& time)
{
    if (grains.clumps.shapes.empty()) return;
    const auto refuse = [&](const char* keyword, const char* what, const char* allowed)
    {
        fail({placeInDictionaryFile(time.globalPath()/time.constant()/"grainProperties", keyword), what, "", allowed});
    };
    if (properties.hasCoarseGrains) refuse("grains", "has sources with `coarseGraining` beside clumps, which no parcel is made of", "one of the two");
    if (properties.heat) refuse("heat", "stands beside clumps, whose temperatures are not followed", "single grains, or no heat");
    if (properties.solvesFluid && grains.shape.dimensions == 2)
    {
        refuse("fluid", "is solved around clumps of discs, of which drag laws know nothing", "none, or `shape sphere`");
    }
}

GrainProperties readRunnable(const Time& time, const polyMesh& mesh)
{
    refuseCollatedFiles();
    checkMeshParts(mesh);
    GrainProperties properties = readGrainProperties(time, surroundingsIn(mesh));
    refuseUnsupportedFiles(time, properties.solvesFluid);
    if (properties.solvesFluid) setFilmViscosity(time, properties.materials.table);
    return properties;
}

} // namespace

CoupledRun::CoupledRun(Time& time, fvMesh& mesh)
:
    time_(time),
    mesh_(mesh),
    properties_(readRunnable(time, mesh)),
    held_(properties_.fixedUntil),
    gravity_(readGravity(time)),
    scene_(makeGrainScene(properties_, mesh, gravity_)),
    forces_(properties_.forces, forceConditions(properties_, scene_)),
    ranks_(properties_.maxLoadImbalance),
    access_(mesh, scene_.roles, scene_.box, properties_.materials.table),
    debt_(memory_.add(dragDebt)),
    lastContactForce_(memory_.add(contactForce)),
    fluidForce_(memory_.add(fluidForce)),
    slipHistory_(properties_.solvesFluid && properties_.forces.isOn("basset") ? std::make_unique<SlipHistory>(memory_) : nullptr),
    ownWake_(correctsOwnWake(properties_, scene_.space.shape) ? &memory_.add(ownWakeOfGrain) : nullptr),
    temperature_(properties_.heat ? &memory_.add(temperature) : nullptr),
    ownStressShare_(ownStressShare(properties_.forces)),
    log_(time, Info, properties_.solvesFluid)
{
    if (movesMesh()) checkMovingMesh(properties_, mesh);
    const RunNumbers numbers = startGrains();
    meanDiameter_ = meanDiameterOf(numbers);
    startHomes();
    if (properties_.solvesFluid) startFluid();
    if (properties_.hasEntries()) startEntries(numbers);
    if (properties_.heat) startHeat();
    if (properties_.forces.isOn("field")) field_ = std::make_unique<ForceField>(properties_.forces.field, mesh);
    const bool hasClumps = !dynamics_->grains().clumps.shapes.empty();
    report_ = std::make_unique<GrainReport>(time, properties_.heat != nullptr, coarse_ != nullptr, hasClumps);
    if (properties_.hasWalls || scene_.walls.anyMotion()) wallOutput_ = std::make_unique<WallOutput>(time, scene_.walls);
    const stringList inflow = hasFluid() ? describeInflow(immersion_->fluid->U(), immersion_->sources.fluidFraction) : stringList();
    logScene(Info, properties_, scene_, totals(), mesh, hasGrainState(mesh), inflow);
}

GrainState CoupledRun::readState() const
{
    RestartExpectation expected;
    memory_.expect(expected);
    expected.numbers = {"exited", "lastDeltaT", "time", "courant", "displacement"};
    expected.nWallRegions = label(scene_.walls.regions.size());
    return readGrainState(mesh_, properties_.materials, scene_.space.shape, expected);
}

GrainState CoupledRun::newState() const
{
    input::PlacedFactors factors;
    GrainState state{makeFirstGrains(properties_, scene_, mesh_, *ranks_.exchange(), &factors), {}, {}, {}, {}, {}};
    if (!properties_.hasCoarseGrains && factors.areAllOne()) return state;
    std::vector<scalar>& factor = state.extras.scalars[coarseness.name];
    for (const std::int64_t id : state.grains.id) factor.push_back(factors.of(id));
    return state;
}

/// Before a state is read, so that it is looked for there.
void CoupledRun::startCoarseGrains()
{
    checkCoarseGrains(properties_);
    coarse_ = std::make_unique<CoarseGrains>(memory_.add(coarseness));
}

RunNumbers CoupledRun::startGrains()
{
    const bool isRestart = hasGrainState(mesh_);
    if (isRestart && (properties_.hasCoarseGrains || CloudReader(mesh_, "grains").found(coarseness.name))) startCoarseGrains();
    GrainState state = isRestart ? ranks_.joinClumps(ranks_.joinContacts(readState(), mesh_), mesh_, properties_.materials) : newState();
    if (isRestart) checkRestart(state.grains, state.numbers.at("time"), scene_, properties_, mesh_, *ranks_.exchange());
    toldByFoam([&] { input::holdDriven(properties_.driven, state.grains, *ranks_.exchange(), isRestart && hasExits()); });
    nGrains_ = sumGrains(state.grains, *ranks_.exchange()).number;
    if (state.extras.scalars.count(coarseness.name) && !coarse_) startCoarseGrains();
    state = ranks_.share(state, {});
    dynamics_ = std::make_unique<::nscd::GrainDynamics>
    (
        std::move(state.grains), properties_.materials.table, scene_.walls, scene_.box, properties_.contact, ranks_.exchange()
    );
    checkClumps(properties_, dynamics_->grains(), time_);
    bodies_.update(dynamics_->grains());
    memory_.start(bodies().size());
    if (coarse_ && !isRestart) coarse_->start(state.extras.scalars.at(coarseness.name));
    access_.show(dynamics_->grains());
    if (ranks_.isParallel()) access_.showRanks(ranks_.tree().all());
    if (!isRestart) return {};
    goOnFrom(state);
    return state.numbers;
}

void CoupledRun::goOnFrom(const GrainState& state)
{
    memory_.recall(bodies_.ofFirstGrains(state.extras), Info);
    if (coarse_ && !coarse_->isSound())
    {
        fail({placeInFile(time_.timePath()/"lagrangian/grains", coarseness.name), "is damaged", "", "numbers of 1 and more"});
    }
    exited_ = static_cast<std::int64_t>(state.numbers.at("exited"));
    continueTime(time_, state.numbers.at("time"));
    const auto impactRate = state.numbers.find("impactRate");
    reach_ = {state.numbers.at("courant"), state.numbers.at("displacement"), true, impactRate == state.numbers.end() ? 0 : impactRate->second};
    dynamics_->restore(state.contacts, state.numbers.at("lastDeltaT"));
    const auto realExited = state.numbers.find("realExited");
    if (coarse_ && Pstream::master() && realExited != state.numbers.end()) coarse_->setExited(realExited->second);
}

void CoupledRun::startHomes()
{
    if (ranks_.isParallel()) homes_ = std::make_unique<GrainHomes>(mesh_, ranks_.tree(), findHome());
    else if (!properties_.solvesFluid && (hasExits() || properties_.hasEntries())) locations_ = std::make_unique<GrainLocations>(mesh_);
}

void CoupledRun::startFluid()
{
    const ::nscd::Grains& grains = dynamics_->grains();
    immersion_ = std::make_unique<Immersion>(mesh_, ranks_.isParallel() ? GrainsAtHome(ranks_.tree()) : GrainsAtHome());
    access_.showMapping(immersion_->mapping, immersion_->atHome);
    if (mayHaveGrains())
    {
        const scalar cellSize = meanCellSize(mesh_);
        voidFraction_ = properties_.voidFraction.forMapping(meanDiameter_, cellSize);
        relativeCellSize_ = cellSize/meanDiameter_;
        largestDiameter_ = returnReduce(input::largestDiameter(properties_, grains), maxOp<scalar>());
        makeMapping();
        tellSmoothing(properties_.voidFraction, immersion_->mapping->smoother());
    }
    GrainSources& sources = immersion_->sources;
    sources.hasGrains = feedsBack();
    sources.isStatic = hasGrains() && !movesMesh() && !properties_.hasEntries() && properties_.driven.empty()
        && !properties_.letsFixedGo() && areAllFixed(grains, *ranks_.exchange());
    sources.isModelB = properties_.forces.isOn("modelB");
    sources.hasResponse = feedsBack() && (!sources.isStatic || sources.isModelB);
    if (hasGrains()) updateWeights();
    // Text files round positions: what was before an exit may be behind it.
    if (hasGrains() && !homes_) removeThoseOutside();
    checkFieldDimensions(mesh_);
    checkTransportProperties(time_);
    checkRotatingZones(mesh_, scene_.roles, Info);
    immersion_->fluid = std::make_unique<FluidSolver>(mesh_, sources, properties_.meanFlowDict());
    checkFluidSources(fv::options::New(mesh_), sources.fluidFraction.name());
    const bool mayFeedBack = properties_.hasFeedback && mayHaveGrains();
    checkNumerics(immersion_->fluid->phi(), mayFeedBack || properties_.holdsMeanFlow);
    if (mayFeedBack && (hasExits() || !hasGrains())) checkNumerics(immersion_->fluid->phi(), properties_.holdsMeanFlow);
}

void CoupledRun::startHeat()
{
    checkTemperature(mesh_);
    checkHeatNumerics(immersion_->fluid->phi());
    heat_ = std::make_unique<GrainHeat>
    (
        *properties_.heat, *immersion_->fluid, immersion_->sources.fluidFraction, dynamics_->grains(), *temperature_, ranks_.newExchange()
    );
}

} // namespace nscdCoupling
} // namespace Foam
