// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading, starting and running a scene.
#include "sceneRun.hpp"

#include "grainTable.hpp"
#include "resultsFolder.hpp"
#include "runLog.hpp"
#include "vtkFiles.hpp"
#include "wallTable.hpp"

#include "input/scene/drivenReader.hpp"
#include "nscd/base/folderLock.hpp"
#include "nscd/base/stopwatch.hpp"
#include "nscd/base/vtkPolyData.hpp"
#include "nscd/tools/contactFiles.hpp"
#include "nscd/tools/sceneCheckpoint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numeric>

namespace nscdGrains
{

using input::InputError;

namespace
{

/// Times are met to half a step.
bool isBefore(double time, double target, double deltaT) { return time + 0.5*deltaT < target; }

/// The time after a step. Whole numbers of steps are met exactly, so that errors of rounding do not add up.
double nextTime(double time, double deltaT)
{
    const double next = time + deltaT;
    const double onGrid = std::round(next/deltaT)*deltaT;
    return std::abs(onGrid - next) < 1e-6*deltaT ? onGrid : next;
}

/// States of a scene's sources by their names, since a scene may list them in another order; those of new ones are empty.
std::vector<nscd::EntryState> entryStates(const SceneSettings& scene, const nscd::SceneState& state)
{
    std::vector<nscd::EntryState> states(scene.entries.size());
    for (std::size_t s = 0; s < states.size(); ++s)
    {
        const auto name = std::find(state.entryNames.begin(), state.entryNames.end(), scene.entries[s].name);
        if (name != state.entryNames.end()) states[s] = state.entries[name - state.entryNames.begin()];
    }
    return states;
}

class SceneRun
{
public:
    /// The folder of results stays as it is until everybody has accepted the scene.
    SceneRun(const SceneSettings& scene, const ResultsFolder& results, nscd::SceneState start, bool goesOn, std::ostream& os)
    :
        scene_(scene),
        results_(results),
        time_(start.time),
        step_(start.step),
        forces_(nscd::gravityForces(start.grains, scene.gravity, scene.run.deltaT)),
        entry_(scene.entries, {scene.shape, scene.box}, entryStates(scene, start), start.nextId),
        held_(scene.fixedUntil),
        log_(os, start.time, scene.run.endTime),
        grainSeries_(results.grainSeries()),
        contactSeries_(results.contactSeries()),
        dynamics_(std::move(start.grains), scene.materials.table, scene.walls, scene.box, scene.contact)
    {
        log_.scene(scene, dynamics_.grains(), results);
        dynamics_.setTime(time_);
        if (goesOn) dynamics_.restore(start.impulses, start.lastDeltaT);
        const nscd::Stopwatch watch(output_);
        results.create();
        lock_ = std::make_unique<nscd::FolderLock>(results.path());
        if (goesOn) continueSeries();
        else results.clear();
        table_ = std::make_unique<StepTable>(results.report(), goesOn, time_);
        if (!scene.walls.patches.empty()) wallTable_ = std::make_unique<WallTable>(results.walls(), scene.walls, goesOn, time_);
        if (!goesOn) writeGrains();
    }

    void run()
    {
        while (isBefore(time_, scene_.run.endTime, scene_.run.deltaT)) advance();
        log_.finish(dynamics_.times(), output_, entry_);
    }

private:
    void continueSeries()
    {
        grainSeries_.readUpTo(time_);
        contactSeries_.readUpTo(time_);
    }

    void advance()
    {
        const double deltaT = scene_.run.deltaT;
        const double next = nextTime(time_, deltaT);
        dynamics_.setTime(time_);
        held_.letGo(time_, deltaT, scene_.driven, dynamics_);
        letIn(next);
        input::driveGrains(scene_.driven, dynamics_, time_, next);
        dynamics_.beginStep(deltaT);
        const nscd::StepReport report = dynamics_.advance(forces_);
        const bool isWritten = isWriteTime(next);
        time_ = next;
        ++step_;
        const nscd::Stopwatch watch(output_);
        const StepRow row = rowOf(report);
        table_->write(row);
        if (wallTable_) wallTable_->write(time_, dynamics_);
        if (isWritten) write();
        log_.step(row, step_, isWritten);
    }

    /// Nothing where no source lets grains in.
    void letIn(double next)
    {
        if (entry_.enter(dynamics_, next) > 0) forces_ = nscd::gravityForces(dynamics_.grains(), scene_.gravity, scene_.run.deltaT);
    }

    bool isWriteTime(double next) const
    {
        const double deltaT = scene_.run.deltaT;
        const auto intervals = [&](double time) { return std::floor((time + 0.5*deltaT)/scene_.run.writeInterval); };
        return intervals(next) > intervals(time_) || !isBefore(next, scene_.run.endTime, deltaT);
    }

    StepRow rowOf(const nscd::StepReport& report) const
    {
        const nscd::Grains& grains = dynamics_.grains();
        StepRow row{time_, scene_.run.deltaT, grains.size(), report, nscd::kineticEnergy(grains), nscd::massCenter(grains), Vec3::Zero()};
        for (const Vec3& force : dynamics_.wallForce()) row.wallForce += force;
        row.mass = std::accumulate(grains.mass.begin(), grains.mass.end(), 0.0);
        row.entries = nscd::totalOf(entry_.states());
        return row;
    }

    void writeGrains()
    {
        const std::string name = results_.grains(step_);
        writeGrainsVtp(results_.full(name), time_, dynamics_.grains(), dynamics_.contactForce());
        grainSeries_.add(time_, name);
    }

    void writeContacts()
    {
        const std::string name = results_.contacts(step_);
        nscd::writeForceChains(results_.full(name), time_, nscd::shownContacts(dynamics_.grains(), dynamics_.contacts(), scene_.run.deltaT));
        contactSeries_.add(time_, name);
    }

    /// The state comes last: where it is, all else is. (And it takes the contacts away.)
    void write()
    {
        writeGrains();
        writeContacts();
        nscd::SceneState state = nscd::takeState(dynamics_, time_, step_);
        state.materials = scene_.materials.table.names();
        state.nextId = entry_.nextId();
        state.entries = entry_.states();
        for (const nscd::EntrySource& source : entry_.sources()) state.entryNames.push_back(source.name);
        nscd::writeCheckpoint(results_.full(results_.state(step_)), state);
        if (scene_.run.purgeWrite > 0) results_.purgeStates(static_cast<std::size_t>(scene_.run.purgeWrite));
    }

    const SceneSettings& scene_;
    const ResultsFolder& results_;
    double time_;
    std::int64_t step_;
    nscd::ExternalForces forces_;
    nscd::GrainEntry entry_;
    input::HeldUntil held_;
    RunLog log_;
    std::unique_ptr<nscd::FolderLock> lock_;
    double output_ = 0.0;
    nscd::VtkSeries grainSeries_;
    nscd::VtkSeries contactSeries_;
    nscd::GrainDynamics dynamics_;
    std::unique_ptr<StepTable> table_;
    std::unique_ptr<WallTable> wallTable_;   // where there are walls
};

nscd::SceneState newStart(const SceneSettings& scene, std::ostream& log)
{
    nscd::SceneState state;
    state.grains = placeGrains(scene, [&](const std::string& line) { log << line << std::endl; });
    checkGrains(scene, state.grains);
    state.nextId = static_cast<std::int64_t>(state.grains.size());
    return state;
}

/// Materials of a state by their names, since a scene may list them in another order.
void renumberMaterials(nscd::SceneState& state, const SceneSettings& scene, const std::string& path)
{
    std::vector<int> numberOf;
    for (const std::string& name : state.materials) numberOf.push_back(scene.materials.table.find(name));
    for (int& material : state.grains.material)
    {
        const bool isKnown = material >= 0 && material < static_cast<int>(numberOf.size());
        const std::string name = isKnown ? state.materials[material] : "?";
        if (!isKnown || numberOf[material] < 0)
        {
            const input::Place place = {scene.file, 0, "materials"};
            throw InputError({place, "lacks a material of the grains in " + path, name, "", scene.materials.table.names()});
        }
        material = numberOf[material];
    }
}

nscd::SceneState storedStart(const SceneSettings& scene, const ResultsFolder& results)
{
    const std::string path = results.latestState();
    if (path.empty()) throw std::runtime_error(results.path() + " holds no state to go on from; without -restart the scene starts anew");
    nscd::SceneState state;
    try
    {
        state = nscd::readCheckpoint(path);
    }
    catch (const std::invalid_argument& error)
    {
        throw std::runtime_error(std::string(error.what()) + "; remove it to go on from the state before");
    }
    const nscd::GrainShape& shape = state.grains.shape;
    if (shape.dimensions != scene.shape.dimensions || (scene.isPlanar() && shape.thickness != scene.shape.thickness))
    {
        const std::string value = input::textOf("dimensions ", shape.dimensions, ", thickness ", shape.thickness, " in ", path);
        throw InputError({{scene.file, 0, "dimensions"}, "or thickness is not that of the state to go on from", value, "the same"});
    }
    renumberMaterials(state, scene, path);
    input::holdDriven(scene.driven, state.grains);
    for (Vec3& position : state.grains.position) position = scene.box.wrap(position);
    checkGrainsOfRestart(scene, state.grains, state.time);
    return state;
}

/// What the grain library refuses is a mistake in the scene.
std::unique_ptr<SceneRun> begin(const SceneSettings& scene, const ResultsFolder& results, nscd::SceneState start, bool goesOn, std::ostream& log)
{
    try
    {
        return std::make_unique<SceneRun>(scene, results, std::move(start), goesOn, log);
    }
    catch (const std::invalid_argument& error)
    {
        throw InputError({{scene.file}, std::string("makes a scene that cannot run: ") + error.what()});
    }
}

/// Grains that enter during a run are not among them.
void packScene(const RunOptions& options, const SceneSettings& scene, std::ostream& log)
{
    if (!options.overwrites && std::filesystem::exists(options.table)) throw std::runtime_error(options.table + " exists: -overwrite writes it anew");
    const nscd::Grains grains = newStart(scene, log).grains;
    writeGrainTable(options.table, scene, grains);
    log << options.table << ": " << grains.size() << " grains" << std::endl;
}

} // namespace

RunOptions readOptions(int argc, const char* const* argv)
{
    RunOptions options;
    bool hasScene = false;
    for (int i = 0; i < argc; ++i)
    {
        const std::string given = argv[i];
        if (given == "-restart") options.goesOn = true;
        else if (given == "-overwrite") options.overwrites = true;
        else if (given == "-pack" && i + 1 < argc && argv[i + 1][0] != '-') options.table = argv[++i];
        else if (given == "-pack") throw InputError({{"command line"}, "-pack lacks the file to be written", "", "nscdGrains scene -pack grains.txt"});
        else if (given[0] == '-' || hasScene)
        {
            const std::string problem = hasScene && given[0] != '-' ? "is a second scene" : "is no option of nscdGrains";
            throw InputError({{"command line"}, given + " " + problem, given, "", {"-restart", "-overwrite", "-pack", "-help"}});
        }
        else
        {
            options.scene = given;
            hasScene = true;
        }
    }
    if (options.goesOn && options.overwrites) throw InputError({{"command line"}, "-restart goes on, -overwrite starts anew", "", "one of the two"});
    if (options.goesOn && !options.table.empty()) throw InputError({{"command line"}, "-restart goes on, -pack writes first grains", "", "one of the two"});
    return options;
}

void refuseRanks()
{
    for (const char* const variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    {
        const char* const size = std::getenv(variable);
        if (!size || std::atoi(size) <= 1) continue;
        throw std::runtime_error
        (
            "mpirun started several processes, and nscdGrains runs on one: each would run the whole scene. "
            "nscdDEMFoam with `fluid none;` runs dry scenes on several ranks."
        );
    }
}

void runScene(const RunOptions& options, std::ostream& log)
{
    const SceneSettings scene = readScene(options.scene);
    if (!options.table.empty())
    {
        packScene(options, scene, log);
        return;
    }
    const ResultsFolder results(scene.pathOf(scene.run.results));
    if (!options.goesOn && !options.overwrites && results.hasResults())
    {
        throw std::runtime_error(results.path() + " holds results of an earlier run: nscdGrains -restart goes on, nscdGrains -overwrite starts anew");
    }
    nscd::SceneState start = options.goesOn ? storedStart(scene, results) : newStart(scene, log);
    if (!isBefore(start.time, scene.run.endTime, scene.run.deltaT))
    {
        log << "Time = " << start.time << " s: endTime is reached, there is nothing to do" << std::endl;
        return;
    }
    begin(scene, results, std::move(start), options.goesOn, log)->run();
}

} // namespace nscdGrains
