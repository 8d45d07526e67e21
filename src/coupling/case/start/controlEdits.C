// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading controlDict apart from the run.
#include "coupling/case/start/controlEdits.H"

#include "coupling/case/input/throwingErrors.H"
#include "coupling/case/start/initialChecks.H"

#include "input/dictionary/withoutTraps.hpp"

#include "IFstream.H"
#include "OSspecific.H"

namespace Foam
{
namespace nscdCoupling
{

dictionary readIfWhole(const fileName& file)
{
    const ThrowingErrors throwing;
    const input::WithoutTraps traps;
    try
    {
        IFstream is(file);
        return dictionary(file, dictionary::null, is);
    }
    catch (const Foam::error&)
    {
        return dictionary();
    }
}


ControlEdits::ControlEdits(const Time& time)
:
    time_(time),
    file_(time.globalPath()/time.system()/"controlDict"),
    edited_(highResLastModified(file_))
{}


void ControlEdits::check()
{
    if (!Pstream::master() || !time_.runTimeModifiable()) return;
    const double edited = highResLastModified(file_);
    if (edited == edited_) return;
    edited_ = edited;
    const dictionary control = readIfWhole(file_);
    if (!control.empty()) checkTimeControls(control);
}

} // namespace nscdCoupling
} // namespace Foam
