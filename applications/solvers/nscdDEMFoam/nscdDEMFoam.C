// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// nscdDEMFoam: rigid grains with hard frictional contact in a volume-averaged incompressible fluid.
#include "coupling/case/files/decomposedTimes.H"
#include "coupling/case/files/processorFolders.H"
#include "coupling/case/start/caseText.H"
#include "coupling/case/start/controlEdits.H"
#include "coupling/case/start/functionTypes.H"
#include "coupling/case/start/meshCheck.H"
#include "coupling/case/start/parallelRefusal.H"
#include "coupling/case/start/toldErrors.H"
#include "coupling/step/coupledRun.H"

#include "nscd/base/folderLock.hpp"

#include "argList.H"

#include <memory>

namespace
{

void runSteps(Foam::Time& time, Foam::fvMesh& mesh)
{
    std::unique_ptr<nscd::FolderLock> lock;
    if (Foam::Pstream::master()) lock = std::make_unique<nscd::FolderLock>(time.globalPath());
    Foam::nscdCoupling::CoupledRun run(time, mesh);
    Foam::nscdCoupling::ControlEdits edits(time);
    while (run.nextStep())
    {
        run.sampleFluid();
        run.linearizeDrag();
        run.solveFluid();
        run.fluidForces();
        run.advanceGrains();
        run.depositGrains();
        run.reportStep();
        edits.check();
    }
    run.finish();
}

/// OpenFOAM keeps results of expressions, which boundary conditions such as exprFixedValue ask for, in a static object that is registered in the Time: at the end
/// of the program it would look for its place in a Time that is gone, and often ends the run with a segmentation fault then.
class ExpressionsLeaveInTime
{
public:
    explicit ExpressionsLeaveInTime(const Foam::Time& time) : time_(time) {}
    ~ExpressionsLeaveInTime()
    {
        for (const Foam::word& name : time_.names("exprResultGlobals")) time_.lookupObjectRef<Foam::regIOobject>(name).checkOut();
    }

private:
    const Foam::Time& time_;
};

void runCase(const Foam::argList& args)
{
    using namespace Foam;
    nscdCoupling::checkProcessorFolders(args);
    nscdCoupling::completeTimes(args);
    nscdCoupling::checkControlText(args);
    #include "createTime.H"
    const ExpressionsLeaveInTime expressions(runTime);
    nscdCoupling::checkStartText(runTime);
    nscdCoupling::checkFunctionTypes(runTime);
    autoPtr<fvMesh> mesh = nscdCoupling::readMesh(runTime);
    runSteps(runTime, *mesh);
}

} // namespace

int main(int argc, char* argv[])
{
    using namespace Foam;
    argList::addNote("Rigid grains (non-smooth contact dynamics) in a volume-averaged incompressible fluid");

    nscdCoupling::refuseLoneRanks(argc, argv);
    #include "setRootCase.H"
    nscdCoupling::runToldErrors([&] { runCase(args); });
    Info<< "End" << nl << endl;
    return 0;
}
