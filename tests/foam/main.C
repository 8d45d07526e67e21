// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Runs the tests of the code that needs OpenFOAM; errors of OpenFOAM throw instead of ending the program.
// With -parallel, under mpirun, every rank runs the tests whose names end in Ranks; rank 0 prints, others tell only what failed.

#include "IOobject.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "error.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>

namespace
{

// An error that no test caught: say what it says. Reached with --gtest_catch_exceptions=0 (else GoogleTest goes on with
// the next test, but can only name the type).
[[noreturn]] void printUncaught()
{
    try
    {
        throw;
    }
    catch (const Foam::error& raised)
    {
        std::cerr << raised.message() << std::endl;
    }
    catch (const std::exception& raised)
    {
        std::cerr << raised.what() << std::endl;
    }
    std::abort();
}

class FailuresOfRank : public ::testing::EmptyTestEventListener
{
    void OnTestPartResult(const ::testing::TestPartResult& result) override
    {
        if (!result.failed()) return;
        std::fprintf
        (
            stderr, "rank %d, %s:%d: %s\n", Foam::Pstream::myProcNo(), result.file_name(), result.line_number(), result.message()
        );
    }
};

void startRanks(int argc, char** argv)
{
    Foam::UPstream::init(argc, argv, false);
    // Every rank reads its files itself: a SerialSection would wait for what rank 0 has read.
    Foam::IOobject::fileModificationChecking = Foam::IOobject::timeStamp;
    if (::testing::GTEST_FLAG(filter) == "*") ::testing::GTEST_FLAG(filter) = "?*Ranks.*";
    if (Foam::Pstream::master()) return;
    ::testing::TestEventListeners& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailuresOfRank);
}

bool isParallel(int argc, char** argv)
{
    return std::any_of(argv, argv + argc, [](const char* word) { return std::strcmp(word, "-parallel") == 0; });
}

} // End anonymous namespace

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    std::set_terminate(printUncaught);
    const bool isParallelRun = isParallel(argc, argv);
    if (isParallelRun) startRanks(argc, argv);
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    int failed = RUN_ALL_TESTS();
    if (!isParallelRun) return failed;
    Foam::reduce(failed, Foam::maxOp<int>());
    if (Foam::Pstream::master()) std::puts(failed ? "failed on some rank" : "passed on all ranks");
    Foam::UPstream::exit(failed);
    return failed;
}
