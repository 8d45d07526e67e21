// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a run on several ranks does beside the seven parts: grains change their owners, and go home to be written.
// Tested by tests/foam/program/ranksTest.C
#include "coupling/step/coupledRun.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/files/clumpParts.H"
#include "coupling/case/files/entryNumbers.H"

#include "nscd/base/formattedText.hpp"

#include "PstreamReduceOps.H"

namespace Foam
{
namespace nscdCoupling
{

using ::nscd::formatted;

/// The next step searches its contacts anew, as a restarted run does.
GrainState CoupledRun::takeState()
{
    GrainState state;
    state.numbers = {{"exited", scalar(exited_)}, {"time", time_.value()}, {"courant", reach_.courant}, {"displacement", reach_.displacement}};
    state.numbers["meanDiameter"] = meanDiameter_;
    if (properties_.time.maxGrainImpacts > 0) state.numbers["impactRate"] = reach_.impactRate;
    if (coarse_) state.numbers["realExited"] = coarse_->exited(*ranks_.exchange());
    if (entry_) addEntries(*entry_, state.numbers);
    state.contacts = dynamics_->checkpoint(state.numbers["lastDeltaT"]);
    state.grains = dynamics_->grains();
    memory_.copyTo(state);
    state.extras = bodies_.toGrains(std::move(state.extras));
    state.unwritten = bodies_.toGrains(std::move(state.unwritten));
    return state;
}

void CoupledRun::setState(const GrainState& state)
{
    dynamics_->setGrains(state.grains);
    bodies_.forgetForms();
    bodies_.update(dynamics_->grains());
    dynamics_->restore(state.contacts, state.numbers.at("lastDeltaT"));
    if (bodies_.areGrains()) memory_.takeFrom(state);
    else memory_.takeFrom({{}, bodies_.ofFirstGrains(state.extras), bodies_.ofFirstGrains(state.unwritten), {}, {}, {}});
    if (homes_) homes_->forget();
    if (hasFluid() && hasGrains()) updateWeights();
}

void CoupledRun::balanceRanks()
{
    const auto timer = timing_.time(StepPart::advanceGrains);
    if (!ranks_.isTimeToLook() || !hasGrains()) return;
    const std::vector<double> load = dynamics_->loads();
    const bool areMixed = ranks_.areMixed(dynamics_->ghosts(), dynamics_->grains().size());
    if (!ranks_.isUneven(load) && !areMixed) return;
    setState(ranks_.share(takeState(), load));
    Info<< formatted
        (
            "  grains shared out anew: largest over mean load of the ranks %.3g, was %.3g%s",
            ranks_.imbalanceAfter(), ranks_.imbalanceBefore(), areMixed ? "; the ranks' grains had mixed" : ""
        ).c_str() << endl;
}

void CoupledRun::bringHome()
{
    Immersion& fluid = *immersion_;
    // Round-off can put a grain on the face between two ranks into one's cell here and into the other's cell there: it goes where
    // the mapping wants it.
    for (int attempt = 0; attempt < 3; ++attempt)
    {
        fluid.atHome.update(dynamics_->grains(), homes_->homes(), bodies_.parts());
        fluid.mapping->lookFirstIn(fluid.atHome.cells());
        const MappingReport& report = fluid.mapping->update(fluid.atHome.grains(), scene_.box, fluid.atHome.bodies());
        if (returnReduce(report.away.empty() && report.outsideMesh.empty(), andOp<bool>())) return;
        std::vector<scalar> rank(fluid.atHome.cells().size(), Pstream::myProcNo());
        std::vector<scalar> cell(fluid.atHome.cells().begin(), fluid.atHome.cells().end());
        for (const AwayGrain& grain : report.away)
        {
            rank[grain.grain] = grain.home.rank;
            cell[grain.grain] = grain.home.cell;
        }
        fluid.atHome.grainsToOwners({{&rank, &cell}, {}});
        homes_->correct(rank, cell, bodies_.parts());
    }
    const MappingReport& report = fluid.mapping->report();
    for (const std::int64_t id : report.outsideMesh) Pout<< "grain " << label(id) << " is in no cell" << endl;
    for (const AwayGrain& grain : report.away) Pout<< "grain " << label(grain.id) << " is in a cell of rank " << grain.home.rank << endl;
    FatalErrorInFunction << "grains have no home in the mesh of any rank; their ids stand above" << exit(FatalError);
}

std::vector<label> CoupledRun::cellsElsewhere()
{
    std::vector<label> cells;
    for (const CellHome& home : homes_->update(dynamics_->grains())) cells.push_back(home.cell);
    return cells;
}

void CoupledRun::writeOnHomes(GrainState state)
{
    std::vector<int> rank;
    std::vector<label> cell;
    for (const CellHome& home : homes_->update(state.grains))
    {
        const std::size_t i = rank.size();
        if (home.rank < 0)
        {
            FatalErrorInFunction
                << "Grain " << label(state.grains.id[i]) << " at " << toFoam(state.grains.position[i])
                << " lies outside the mesh, and cannot be written." << exit(FatalError);
        }
        rank.push_back(home.rank);
        cell.push_back(home.cell);
    }
    if (returnReduce(!state.grains.clumps.empty(), orOp<bool>())) state.clumpParts = clumpParts(state.grains);
    state.grains.clumps = ::nscd::Clumps();
    state = ranks_.moved(state, rank);
    cell = ranks_.moved(cell, rank);
    writeGrainState(mesh_, state, properties_.materials.table, toLabelList(cell));
    // From here on as a restart, which finds the grains in this order and knows no loads.
    setState(ranks_.share(ranks_.joinClumps(std::move(state), mesh_, properties_.materials), {}));
}

} // namespace nscdCoupling
} // namespace Foam
