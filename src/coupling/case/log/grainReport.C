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
    {"waitingMass", "kg", [](const StepRow& r) { return double(r.entries.waitingMass()); }}
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

template<class Part>
void writeLine(std::ostream& os, bool hasHeat, bool hasParcels, const Part& part)
{
    const char* separator = "";
    const auto write = [&](const Column& column)
    {
        os << separator;
        part(column);
        separator = ",";
    };
    for (const Column& column : columns) write(column);
    if (hasHeat) for (const Column& column : heatColumns) write(column);
    if (hasParcels) for (const Column& column : parcelColumns) write(column);
    os << '\n' << std::flush;
}

} // namespace


GrainReport::GrainReport(const Time& time, bool hasHeat, bool hasParcels)
:
    path_(time.globalPath()/"postProcessing"/"grains"/time.timeName(time.startTime().value())/"report.csv"),
    hasHeat_(hasHeat),
    hasParcels_(hasParcels)
{
    if (!Pstream::master()) return;
    mkDir(path_.path());
    file_.open(path_);
    file_.precision(std::numeric_limits<double>::max_digits10);
    file_ << "# units: ";
    writeLine(file_, hasHeat_, hasParcels_, [&](const Column& column) { file_ << column.unit; });
    writeLine(file_, hasHeat_, hasParcels_, [&](const Column& column) { file_ << column.name; });
    check();
}


void GrainReport::write(const StepRow& row)
{
    if (!Pstream::master()) return;
    writeLine(file_, hasHeat_, hasParcels_, [&](const Column& column) { file_ << column.value(row); });
    check();
}


void GrainReport::check() const
{
    if (file_.good()) return;
    FatalErrorInFunction << "Cannot write to " << path_ << "; is the disk full?" << exit(FatalError);
}

} // namespace nscdCoupling
} // namespace Foam
