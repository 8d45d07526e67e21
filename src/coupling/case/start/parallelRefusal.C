// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking at the command line, at what mpirun tells its processes, and at what the case asks for.
#include "coupling/case/start/parallelRefusal.H"

#include "Pstream.H"
#include "error.H"
#include "uncollatedFileOperation.H"

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


void refuseCollatedFiles()
{
    if (!Pstream::parRun()) return;
    if (fileHandler().type() != fileOperations::uncollatedFileOperation::typeName)
    {
        FatalErrorIn("nscdDEMFoam")
            << "Grains on several ranks are written and read with `-fileHandler uncollated` only, one folder for each processor; this "
            << "run asks for " << fileHandler().type() << "." << exit(FatalError);
    }
}

} // namespace nscdCoupling
} // namespace Foam
