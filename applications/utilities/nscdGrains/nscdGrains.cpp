// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// nscdGrains: dry scenes of rigid grains from a short dictionary, without OpenFOAM.
#include "sceneRun.hpp"

#include <cstring>
#include <exception>
#include <iostream>
#include <new>

namespace
{

const char* const usage =
    "usage: nscdGrains [scene] [-restart | -overwrite] [-pack table]\n"
    "  scene       the dictionary of the scene; left out: the file `scene` in this folder\n"
    "  -restart    goes on from the state written last\n"
    "  -overwrite  starts anew where results of an earlier run are\n"
    "  -pack       writes the first grains to a table, which sources of type `table` read, and runs nothing\n"
    "Keywords: scene.example beside the sources, applications/utilities/nscdGrains.\n";

} // namespace

int main(int argc, char* argv[])
{
    for (int i = 1; i < argc; ++i)
    {
        if (std::strcmp(argv[i], "-help") == 0 || std::strcmp(argv[i], "--help") == 0)
        {
            std::cout << usage;
            return 0;
        }
    }
    try
    {
        nscdGrains::refuseRanks();
        nscdGrains::runScene(nscdGrains::readOptions(argc - 1, argv + 1), std::cout);
        std::cout << "\nEnd" << std::endl;
        return 0;
    }
    catch (const std::bad_alloc&)
    {
        std::cerr << "nscdGrains: the memory of this machine does not hold the scene (about 1.6 GB for a million grains)" << std::endl;
        return 1;
    }
    catch (const std::exception& error)
    {
        std::cout << std::flush;
        std::cerr << "nscdGrains: " << error.what() << std::endl;
        return 1;
    }
}
