// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
// Runs the tests of OpenFOAM land; errors of OpenFOAM throw instead of ending the program.

#include "error.H"

#include <gtest/gtest.h>

#include <cstdlib>
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

} // End anonymous namespace

int main(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    std::set_terminate(printUncaught);
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    return RUN_ALL_TESTS();
}
