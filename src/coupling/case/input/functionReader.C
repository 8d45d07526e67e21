// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reading functions of time.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/functionReader.H"

#include "Function1.H"

#include <memory>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

template<class Type>
std::shared_ptr<const Function1<Type>> readFunction(const CheckedDict& given, const word& keyword)
{
    if (!given.found(keyword))
    {
        fail({given.place(keyword), "is missing", string::null, "a constant or a function of time, as table ((0 0) (1 2.5))"});
    }
    // Functions of OpenFOAM may keep their numbers beside themselves.
    const word coefficients(keyword + "Coeffs");
    if (given.dict().found(coefficients)) given.found(coefficients);
    const std::shared_ptr<const Function1<Type>> function(Function1<Type>::New(keyword, given.dict()).release());
    if (!(mag(function->value(0)) < VGREAT)) given.reject(keyword, "is not finite at time 0");
    return function;
}

} // namespace


nscd::ScalarOfTime readScalarFunction(const CheckedDict& given, const word& keyword)
{
    return [function = readFunction<scalar>(given, keyword)](double time) { return function->value(time); };
}


nscd::VectorOfTime readVectorFunction(const CheckedDict& given, const word& keyword)
{
    return [function = readFunction<vector>(given, keyword)](double time) { return toVec3(function->value(time)); };
}

} // namespace nscdCoupling
} // namespace Foam
