// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading transportProperties for films.
#include "coupling/case/start/filmViscosity.H"

#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/inputError.H"

#include "input/dictionary/checkedEntries.hpp"

#include "IOdictionary.H"

namespace Foam
{
namespace nscdCoupling
{

void setFilmViscosity(const Time& time, ::nscd::Materials& materials)
{
    if (!materials.lacksFilmViscosity()) return;
    const IOobject file("transportProperties", time.constant(), time, IOobject::MUST_READ, IOobject::NO_WRITE, false);
    checkText(file);
    const IOdictionary dict(file);
    const word model = dict.getOrDefault<word>("transportModel", "Newtonian");
    if (model != "Newtonian")
    {
        fail
        ({
            placeInDictionaryFile(file.objectPath(), "transportModel"), "has no one viscosity for the films of `roughness` in grainProperties", model,
            "Newtonian, or a lubricationViscosity beside each roughness"
        });
    }
    const input::Dictionary entries = valuesFromFoam(dict);
    const input::CheckedEntries given(entries);
    toldByFoam([&]
    {
        const scalar rho = given.number("rho", input::above(0, input::unit::density));
        materials.setFilmViscosity(rho*given.number("nu", input::above(0, input::unit::viscosity)));
    });
}

} // namespace nscdCoupling
} // namespace Foam
