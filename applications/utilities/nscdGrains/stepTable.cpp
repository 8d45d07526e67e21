// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing report.csv: the table of columns, and rows in its order.
#include "stepTable.hpp"

#include "nscd/base/numberText.hpp"

namespace nscdGrains
{

namespace
{

struct Column
{
    const char* name;
    const char* unit;
    double (*value)(const StepRow&);
};

const Column columns[] =
{
    {"time", "s", [](const StepRow& r) { return r.time; }},
    {"deltaT", "s", [](const StepRow& r) { return r.deltaT; }},
    {"grains", "1", [](const StepRow& r) { return double(r.grains); }},
    {"contacts", "1", [](const StepRow& r) { return double(r.report.solve.contacts); }},
    {"sweeps", "1", [](const StepRow& r) { return double(r.report.solve.sweeps); }},
    {"converged", "1", [](const StepRow& r) { return double(r.report.solve.converged); }},
    {"residualRms", "m/s", [](const StepRow& r) { return r.report.solve.residualRms; }},
    {"residualMax", "m/s", [](const StepRow& r) { return r.report.solve.residualMax; }},
    {"overlapMax", "diameters", [](const StepRow& r) { return r.report.overlapMax; }},
    {"overlapMean", "diameters", [](const StepRow& r) { return r.report.overlapMean; }},
    {"kineticEnergy", "J", [](const StepRow& r) { return r.kineticEnergy; }},
    {"massCenterX", "m", [](const StepRow& r) { return r.massCenter.x(); }},
    {"massCenterY", "m", [](const StepRow& r) { return r.massCenter.y(); }},
    {"massCenterZ", "m", [](const StepRow& r) { return r.massCenter.z(); }},
    {"wallForceX", "N", [](const StepRow& r) { return r.wallForce.x(); }},
    {"wallForceY", "N", [](const StepRow& r) { return r.wallForce.y(); }},
    {"wallForceZ", "N", [](const StepRow& r) { return r.wallForce.z(); }},
    {"correctionSweeps", "1", [](const StepRow& r) { return double(r.report.correctionSweeps); }},
    {"forceError", "1", [](const StepRow& r) { return r.report.solve.forceError; }},
    {"overlapUncorrected", "diameters", [](const StepRow& r) { return r.report.overlapUncorrected; }},
    {"atCap", "1", [](const StepRow& r) { return double(r.report.solve.atCap); }},
    {"asleep", "1", [](const StepRow& r) { return double(r.report.asleep); }},
    {"mass", "kg", [](const StepRow& r) { return r.mass; }},
    {"entered", "1", [](const StepRow& r) { return double(r.entries.entered); }},
    {"enteredMass", "kg", [](const StepRow& r) { return r.entries.enteredMass; }},
    {"waiting", "1", [](const StepRow& r) { return double(r.entries.waiting()); }},
    {"waitingMass", "kg", [](const StepRow& r) { return r.entries.waitingMass(); }}
};

template<class Text>
std::string lineOf(const Text& text)
{
    std::string line;
    for (const Column& column : columns) line += (line.empty() ? "" : ",") + text(column);
    return line;
}

std::string headLines()
{
    return "# units: " + lineOf([](const Column& c) { return std::string(c.unit); }) + '\n'
        + lineOf([](const Column& c) { return std::string(c.name); }) + '\n';
}

} // namespace

StepTable::StepTable(const std::string& path, bool goesOn, double keepUpTo)
:
    file_(path, headLines(), goesOn, keepUpTo)
{}

void StepTable::write(const StepRow& row)
{
    file_.write(lineOf([&](const Column& column) { return nscd::exact(column.value(row)); }));
}

} // namespace nscdGrains
