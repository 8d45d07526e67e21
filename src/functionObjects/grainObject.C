// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading OpenFOAM's own keywords.
#include "functionObjects/grainObject.H"

#include "functionObjects/functionEntries.H"

#include "timeControl.H"

#include <memory>

namespace Foam
{
namespace functionObjects
{

namespace
{

/// Says what OpenFOAM's own control of a function object says, if it is asked once in each step from the start on; always, where a clock decides. (timeStart
/// and others may then still keep the function object from it.)
std::function<bool()> isDueBy(const Time& time, const dictionary& dict, const word& prefix)
{
    const auto control = std::make_shared<timeControl>(time, dict, prefix);
    const auto type = control->control();
    const bool isByClock = type == timeControl::ocClockTime || type == timeControl::ocCpuTime;
    return [control, isByClock] { return isByClock || control->execute(); };
}

} // namespace


GrainObject::GrainObject(const word& name, const Time& runTime, const dictionary& dict)
:
    fvMeshFunctionObject(name, runTime, dict),
    access_(nscdCoupling::GrainAccess::of(mesh_, nscdCoupling::placeOf(dict)))
{}


bool GrainObject::read(const dictionary& dict)
{
    nscdCoupling::readFunction(dict, [](const input::CheckedEntries&) {});
    hasWriteControl_ = dict.found("writeControl") || dict.found("outputControl");
    return fvMeshFunctionObject::read(dict);
}


void GrainObject::followContactsToExecute(const dictionary& dict) const
{
    access_.followContacts(name(), isDueBy(time_, dict, "execute"));
}


void GrainObject::followContactsToWrite(const dictionary& dict) const
{
    const Time& time = time_;
    access_.followContacts(name(), hasWriteControl_ ? isDueBy(time_, dict, "write") : [&time] { return time.writeTime(); });
}


void GrainObject::requireFluid(const dictionary& dict) const
{
    if (access_.isMapped()) return;
    nscdCoupling::fail({nscdCoupling::placeOf(dict), "needs a fluid", "fluid none", "a run with a fluid: fields are made as its void fraction is"});
}

} // namespace functionObjects
} // namespace Foam
