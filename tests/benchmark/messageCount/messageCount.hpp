// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Counts what a program sends by MPI, part by part of its work, without a change in it.
#pragma once

#include <string>

namespace messageCount
{

/// As long as this lives, what this rank sends counts for the part; parts may lie within each other, the innermost counts. Under
/// another part its name follows that of the outermost one.
class Part
{
public:
    explicit Part(const std::string& name);
    ~Part();
    Part(const Part&) = delete;
    void operator=(const Part&) = delete;
};

/// Forgets what was counted so far.
void reset();

} // namespace messageCount
