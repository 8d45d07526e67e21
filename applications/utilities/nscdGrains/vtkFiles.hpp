// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that ParaView opens as they are: VTK's XML poly data, arrays appended as raw bytes, and a time series of them.
#pragma once

#include "nscd/step/grainDynamics.hpp"

#include <string>
#include <vector>

namespace nscdGrains
{

/// Grains as points: d, U, omega, fContact (net contact force, N), id, material.
/// Errors: std::runtime_error where the file cannot be written
void writeGrainsVtp(const std::string& path, double time, const nscd::Grains& grains, const std::vector<nscd::Vec3>& contactForce);

/// Contacts as lines from center to center, or to the wall: force (on the first grain, N), its parts normalForce >= 0 and
/// tangentialForce, normalImpulse [N s], gap [m], idA, idB (less than 0: wall). They are of the last step, of length deltaT.
void writeContactsVtp
(
    const std::string& path, double time, const nscd::Grains& grains, const std::vector<nscd::LoadedContact>& contacts, double deltaT
);

/// A .pvd file: the times written and their files.
class TimeSeries
{
public:
    explicit TimeSeries(const std::string& path) : path_(path) {}

    /// Takes over what an earlier run listed up to a time; nothing where there is no file.
    /// Errors: std::runtime_error for a file that no TimeSeries wrote
    void readUpTo(double time);

    /// Adds a file, named relative to the series, and writes the series anew.
    void add(double time, const std::string& file);

private:
    std::string path_;
    std::vector<std::string> lines_;
};

} // namespace nscdGrains
