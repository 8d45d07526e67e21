// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing walls.csv and pictures of walls.
#include "coupling/case/files/writtenFiles.H"
#include "coupling/case/log/wallOutput.H"

#include "nscd/scene/wallFile.hpp"

#include "OSspecific.H"
#include "Pstream.H"

#include <limits>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

fileName pictureFolder(const Time& time) { return time.globalPath()/"postProcessing"/"walls"; }

bool hasPicture(const nscd::Walls& walls, int patch)
{
    if (!walls.patches[patch].motion) return false;
    for (const nscd::WallRegion& region : walls.regions)
    {
        if (region.patch == patch && !region.edges.empty()) return true;
    }
    return false;
}

/// Lists the pictures of all written times, those of earlier runs among them.
void writeSeries(const fileName& folder, const std::string& patch)
{
    const fileName path = folder/(patch + ".vtk.series");
    std::ofstream os(path);
    os << "{ \"file-series-version\" : \"1.0\", \"files\" : [";
    const char* separator = "\n";
    for (const instant& time : Time::findTimes(folder))
    {
        if (!isFile(folder/time.name()/(patch + ".vtk"))) continue;
        os << separator << "  { \"name\" : \"" << time.name() << '/' << patch << ".vtk\", \"time\" : " << time.value() << " }";
        separator = ",\n";
    }
    os << "\n] }\n";
    if (!os.flush()) refuseUnwritten(path);
}

} // namespace


WallOutput::WallOutput(const Time& time, const nscd::Walls& walls)
:
    path_(time.globalPath()/"postProcessing"/"grains"/time.timeName(time.startTime().value())/"walls.csv")
{
    if (!Pstream::master()) return;
    mkDir(path_.path());
    file_.open(path_);
    file_.precision(std::numeric_limits<double>::max_digits10);
    file_ << "# units: s";
    for (std::size_t k = 0; k < walls.patches.size(); ++k) file_ << ",N,N,N,N m,N m,N m";
    file_ << "\ntime";
    for (const nscd::WallPatch& patch : walls.patches)
    {
        for (const char* column : {"forceX", "forceY", "forceZ", "torqueX", "torqueY", "torqueZ"}) file_ << ',' << patch.name << '.' << column;
    }
    file_ << '\n' << std::flush;
    if (!file_) refuseUnwritten(path_);
}


void WallOutput::report(scalar time, const nscd::GrainDynamics& dynamics)
{
    if (!Pstream::master()) return;
    file_ << time;
    for (std::size_t k = 0; k < dynamics.wallForce().size(); ++k)
    {
        for (const nscd::Vec3& v : {dynamics.wallForce()[k], dynamics.wallTorque()[k]}) file_ << ',' << v[0] << ',' << v[1] << ',' << v[2];
    }
    file_ << '\n' << std::flush;
    if (!file_) refuseUnwritten(path_);
}


void WallOutput::writePictures(const Time& time, const nscd::Walls& walls) const
{
    if (!Pstream::master()) return;
    for (std::size_t k = 0; k < walls.patches.size(); ++k)
    {
        if (!hasPicture(walls, static_cast<int>(k))) continue;
        const fileName folder = pictureFolder(time)/time.timeName();
        mkDir(folder);
        const fileName path = folder/(walls.patches[k].name + ".vtk");
        std::ofstream os(path);
        nscd::writeVtk(os, walls, static_cast<int>(k));
        if (!os.flush()) refuseUnwritten(path);
        writeSeries(pictureFolder(time), walls.patches[k].name);
    }
}

} // namespace nscdCoupling
} // namespace Foam
