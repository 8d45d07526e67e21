// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing report.csv: the table of columns, and rows in its order.
#include "numberText.hpp"
#include "stepTable.hpp"

#include "completeFile.hpp"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>

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
    {"correctionSweeps", "1", [](const StepRow& r) { return double(r.report.correctionSweeps); }}
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

/// The rows of an earlier file up to a time, under today's head, in a file that takes its place.
void keepRows(const std::string& path, double upTo)
{
    std::ifstream old(path);
    if (!old) throw std::runtime_error("cannot read " + path + ", which a run that goes on adds to");
    std::string units, names, line;
    std::getline(old, units);
    std::getline(old, names);
    if (units + '\n' + names + '\n' != headLines()) throw std::runtime_error(path + " has other columns than this version writes; move it away");
    nscd::CompleteFile kept(path);
    kept.stream() << headLines();
    while (std::getline(old, line) && std::strtod(line.c_str(), nullptr) <= upTo) kept.stream() << line << '\n';
    kept.complete();
}

} // namespace

StepTable::StepTable(const std::string& path, bool goesOn, double keepUpTo)
:
    path_(path)
{
    errno = 0;
    if (goesOn) keepRows(path, keepUpTo);
    file_.open(path, goesOn ? std::ios::app : std::ios::trunc);
    if (!goesOn) file_ << headLines() << std::flush;
    if (!file_) nscd::failToWrite(path_);
}

void StepTable::write(const StepRow& row)
{
    errno = 0;
    file_ << lineOf([&](const Column& column) { return exact(column.value(row)); }) << '\n' << std::flush;
    if (!file_) nscd::failToWrite(path_);
}

} // namespace nscdGrains
