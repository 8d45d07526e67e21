// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Catching what ends a program.
#include "coupling/case/start/toldErrors.H"

#include "coupling/case/input/throwingErrors.H"

#include "IOstreams.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <csignal>
#include <cstdlib>
#include <memory>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

template<class Error>
void endWith(const Error& error)
{
    Perr<< nl << error << nl << "\nFOAM exiting\n" << endl;
    Pstream::exit(1);
}

/// Versions later than v1912 abort, once they have said their words, where v1912 throws. Any other abort stays the signal that it is.
void endWhereOpenFOAMAborts(int)
{
    if (!FatalError.message().empty() || !FatalIOError.message().empty()) std::_Exit(1);
    std::signal(SIGABRT, SIG_DFL);
    std::raise(SIGABRT);
}

/// Who sets FOAM_ABORT wants the signal.
void catchAborts()
{
    if (getEnv("FOAM_ABORT").empty()) std::signal(SIGABRT, endWhereOpenFOAMAborts);
}

} // namespace


void runToldErrors(const std::function<void()>& program)
{
    // On ranks OpenFOAM ends all of them where the error is: what unwinding would destroy may wait for the others.
    std::unique_ptr<ThrowingErrors> throwing;
    if (!Pstream::parRun())
    {
        throwing = std::make_unique<ThrowingErrors>();
        catchAborts();
    }
    try
    {
        program();
    }
    catch (const IOerror& error)
    {
        endWith(error);
    }
    catch (const Foam::error& error)
    {
        // Some functions of OpenFOAM put their words into FatalIOError, and end with a FatalError that has none.
        if (error.message().empty()) endWith(FatalIOError);
        else endWith(error);
    }
    catch (const std::exception& error)
    {
        Foam::error told("--> FOAM FATAL ERROR");
        told("nscdDEMFoam", __FILE__, __LINE__) << error.what();
        endWith(told);
    }
}

} // namespace nscdCoupling
} // namespace Foam
