// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Making and drawing from OpenFOAM's models.
#include "coupling/case/input/foamSizes.H"

#include "coupling/case/input/foamDictionary.H"
#include "coupling/case/input/inputError.H"
#include "coupling/case/input/throwingErrors.H"

#include "distributionModel.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// A model with the random numbers that it draws from.
struct FoamSizes
{
    Random numbers;
    autoPtr<distributionModel> model;

    explicit FoamSizes(const dictionary& dict) : numbers(0), model(distributionModel::New(dict, numbers)) {}

    /// The model's generator begins anew with each grain, so that the size of one does not hang on how many were drawn before.
    scalar draw(const nscd::RandomNumbers& random)
    {
        numbers = Random(label(random()*labelMax));
        return model->sample();
    }
};

std::shared_ptr<FoamSizes> makeModel(const input::CheckedEntries& given)
{
    try
    {
        const ThrowingErrors throwing;
        return std::make_shared<FoamSizes>(foamDictionary(given.dict()));
    }
    catch (const IOerror&)
    {
        throw;
    }
    catch (const Foam::error& error)
    {
        given.reject("type", "refuses its numbers: " + error.message());
    }
}

nscd::SizeDistribution readSizes(const input::CheckedEntries& given)
{
    const std::string name = given.text("type");
    given.sub(name + "Distribution");
    const std::shared_ptr<FoamSizes> sizes = makeModel(given);
    const scalar smallest = sizes->model->minValue(), largest = sizes->model->maxValue();
    if (!(smallest >= input::smallestPositive && largest <= input::largestNumber))
    {
        given.reject(name + "Distribution", messageText("has sizes from ", smallest, " to ", largest), "sizes above 0 [m]");
    }
    return {smallest, largest, [sizes](const nscd::RandomNumbers& random) { return sizes->draw(random); }};
}

} // namespace


std::map<std::string, input::ReadSizes> foamSizeModels()
{
    std::map<std::string, input::ReadSizes> models;
    for (const word& name : distributionModel::dictionaryConstructorTablePtr_->sortedToc()) models[name] = readSizes;
    return models;
}

} // namespace nscdCoupling
} // namespace Foam
