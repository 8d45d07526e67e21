// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing report.csv: the table of columns, and rows in its order.
#include "coupling/case/log/grainReport.H"

#include "OSspecific.H"

#include <limits>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using Value = double (*)(const StepRow&);

struct Column
{
    const char* name;
    const char* unit;
    Value value;
};

const Column columns[] =
{
    {"time", "s", [](const StepRow& r) { return double(r.time); }},
    {"deltaT", "s", [](const StepRow& r) { return double(r.deltaT); }},
    {"grains", "1", [](const StepRow& r) { return double(r.grains); }},
    {"contacts", "1", [](const StepRow& r) { return double(r.report.solve.contacts); }},
    {"sweeps", "1", [](const StepRow& r) { return double(r.report.solve.sweeps); }},
    {"converged", "1", [](const StepRow& r) { return double(r.report.solve.converged); }},
    {"residualRms", "m/s", [](const StepRow& r) { return double(r.report.solve.residualRms); }},
    {"residualMax", "m/s", [](const StepRow& r) { return double(r.report.solve.residualMax); }},
    {"overlapMax", "diameters", [](const StepRow& r) { return double(r.report.overlapMax); }},
    {"overlapMean", "diameters", [](const StepRow& r) { return double(r.report.overlapMean); }},
    {"kineticEnergy", "J", [](const StepRow& r) { return double(r.kineticEnergy); }},
    {"massCenterX", "m", [](const StepRow& r) { return double(r.massCenter.x()); }},
    {"massCenterY", "m", [](const StepRow& r) { return double(r.massCenter.y()); }},
    {"massCenterZ", "m", [](const StepRow& r) { return double(r.massCenter.z()); }},
    {"wallForceX", "N", [](const StepRow& r) { return double(r.wallForce.x()); }},
    {"wallForceY", "N", [](const StepRow& r) { return double(r.wallForce.y()); }},
    {"wallForceZ", "N", [](const StepRow& r) { return double(r.wallForce.z()); }},
    {"grainVolume", "m3", [](const StepRow& r) { return double(r.grainVolume); }},
    {"momentumError", "1", [](const StepRow& r) { return double(r.momentumError); }},
    {"exited", "1", [](const StepRow& r) { return double(r.exited); }},
    {"correctionSweeps", "1", [](const StepRow& r) { return double(r.report.correctionSweeps); }},
    {"courantMax", "1", [](const StepRow& r) { return double(r.courantMax); }},
    {"forceError", "1", [](const StepRow& r) { return double(r.report.solve.forceError); }},
    {"momentumDebt", "1", [](const StepRow& r) { return double(r.momentumDebt); }},
    {"overlapUncorrected", "diameters", [](const StepRow& r) { return double(r.report.overlapUncorrected); }},
    {"solidVolume", "m3", [](const StepRow& r) { return double(r.solidVolume); }},
    {"volumeOutside", "m3", [](const StepRow& r) { return double(r.volumeOutside); }},
    {"volumeMoved", "m3", [](const StepRow& r) { return double(r.volumeMoved); }},
    {"volumeUnresolved", "m3", [](const StepRow& r) { return double(r.volumeUnresolved); }},
    {"volumeError", "1", [](const StepRow& r) { return double(r.volumeError); }},
    {"atCap", "1", [](const StepRow& r) { return double(r.report.solve.atCap); }},
    {"asleep", "1", [](const StepRow& r) { return double(r.report.asleep); }},
    {"entered", "1", [](const StepRow& r) { return double(r.entries.entered); }},
    {"enteredMass", "kg", [](const StepRow& r) { return double(r.entries.enteredMass); }},
    {"waiting", "1", [](const StepRow& r) { return double(r.entries.waiting()); }},
    {"waitingMass", "kg", [](const StepRow& r) { return double(r.entries.waitingMass()); }},
    {"subCycles", "1", [](const StepRow& r) { return double(r.subCycles); }},
    {"impacts", "1", [](const StepRow& r) { return double(r.report.solve.impacts); }}
};

const Column heatColumns[] =
{
    {"heatFluid", "J", [](const StepRow& r) { return double(r.heat.fluid); }},
    {"heatGrains", "J", [](const StepRow& r) { return double(r.heat.grains); }},
    {"heatIn", "J", [](const StepRow& r) { return double(r.heat.inflow); }},
    {"heatToGrains", "J", [](const StepRow& r) { return double(r.heat.toGrains); }},
    {"heatHeld", "J", [](const StepRow& r) { return double(r.heat.held); }},
    {"heatEntered", "J", [](const StepRow& r) { return double(r.heat.entered); }},
    {"heatShifted", "J", [](const StepRow& r) { return double(r.heat.shifted); }},
    {"heatError", "J", [](const StepRow& r) { return double(r.heat.error); }},
    {"fluidTMin", "K", [](const StepRow& r) { return double(r.heat.fluidMin); }},
    {"fluidTMax", "K", [](const StepRow& r) { return double(r.heat.fluidMax); }},
    {"grainTMin", "K", [](const StepRow& r) { return double(r.heat.grainMin); }},
    {"grainTMax", "K", [](const StepRow& r) { return double(r.heat.grainMax); }}
};

const Column parcelColumns[] =
{
    {"realGrains", "1", [](const StepRow& r) { return double(r.realGrains); }},
    {"realExited", "1", [](const StepRow& r) { return double(r.realExited); }},
    {"realEntered", "1", [](const StepRow& r) { return double(r.realEntered); }}
};

const Column clumpColumns[] = {{"clumps", "1", [](const StepRow& r) { return double(r.clumps); }}};

} // namespace


template<class Part>
void GrainReport::writeLine(const Part& part)
{
    const char* separator = "";
    const auto write = [&](const auto& all)
    {
        for (const Column& column : all)
        {
            file_ << separator;
            part(column);
            separator = ",";
        }
    };
    write(columns);
    if (hasHeat_) write(heatColumns);
    if (hasParcels_) write(parcelColumns);
    if (hasClumps_) write(clumpColumns);
    file_ << '\n' << std::flush;
}


GrainReport::GrainReport(const Time& time, bool hasHeat, bool hasParcels, bool hasClumps)
:
    path_(time.globalPath()/"postProcessing"/"grains"/time.timeName(time.startTime().value())/"report.csv"),
    hasHeat_(hasHeat),
    hasParcels_(hasParcels),
    hasClumps_(hasClumps)
{
    if (!Pstream::master()) return;
    mkDir(path_.path());
    file_.open(path_);
    file_.precision(std::numeric_limits<double>::max_digits10);
    file_ << "# units: ";
    writeLine([&](const Column& column) { file_ << column.unit; });
    writeLine([&](const Column& column) { file_ << column.name; });
    check();
}


void GrainReport::write(const StepRow& row)
{
    if (!Pstream::master()) return;
    writeLine([&](const Column& column) { file_ << column.value(row); });
    check();
}


void GrainReport::check() const
{
    if (file_.good()) return;
    FatalErrorInFunction << "Cannot write to " << path_ << "; is the disk full?" << exit(FatalError);
}

} // namespace nscdCoupling
} // namespace Foam
