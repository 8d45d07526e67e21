// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking at the command line, at what mpirun tells its processes, and at what the case asks for.
#include "parallelRefusal.H"

#include "Pstream.H"
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


void refuseLoneRanks(int argc, char* argv[])
{
    bool isParallel = false;
    for (int i = 1; i < argc; ++i) isParallel = isParallel || std::strcmp(argv[i], "-parallel") == 0;
    if (isParallel || !isOneOfMany()) return;
    FatalErrorIn("nscdDEMFoam")
        << "mpirun started several processes without the option -parallel: each would run the whole case on one rank only and "
        << "write to the same files. Use decomposePar, then mpirun -np <ranks> nscdDEMFoam -parallel." << exit(FatalError);
}


void refuseGrainsInFluidOnRanks(std::int64_t nGrains)
{
    if (!Pstream::parRun() || nGrains == 0) return;
    FatalErrorIn("nscdDEMFoam")
        << "Grains in a fluid work on one rank only in this version; several ranks can run a fluid without grains, or grains alone, "
        << "with `fluid none;` in constant/grainProperties. A decomposed case can be put together again by reconstructPar." << exit(FatalError);
}

} // namespace nscdCoupling
} // namespace Foam
