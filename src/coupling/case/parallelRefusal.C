// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking at the command line and at what mpirun tells its processes.
#include "parallelRefusal.H"

#include "error.H"

#include <cstdlib>
#include <cstring>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

bool isOneOfMany()
{
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    {
        const char* size = std::getenv(variable);
        if (size && std::atoi(size) > 1) return true;
    }
    return false;
}

} // namespace


void refuseParallel(int argc, char* argv[])
{
    bool isParallel = isOneOfMany();
    for (int i = 1; i < argc; ++i) isParallel = isParallel || std::strcmp(argv[i], "-parallel") == 0;
    if (!isParallel) return;
    FatalErrorIn("nscdDEMFoam")
        << "This version of nscdDEMFoam runs on one rank only, without mpirun and without the option -parallel. "
        << "A decomposed case can be put together again by reconstructPar." << exit(FatalError);
}

} // namespace nscdCoupling
} // namespace Foam
