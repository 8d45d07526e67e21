// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Grains by samples, summed over ranks.
#include "functionObjects/mixingIndex.H"

#include "functionObjects/functionEntries.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(MixingIndex, 0);
addToRunTimeSelectionTable(functionObject, MixingIndex, dictionary);

namespace
{

constexpr double mostSamples = 1e7;

struct Mixture
{
    scalar index = 0;
    scalar share = 0;     ///< p
    label samples = 0;
    scalar perSample = 0; ///< n
};

/// `all` grains of each sample, and those of the material among them.
Mixture mixtureOf(const scalarList& all, const scalarList& ofMaterial)
{
    Mixture mixture;
    const scalar number = sum(all);
    if (number == 0) return mixture;
    mixture.share = sum(ofMaterial)/number;
    scalar deviation = 0;
    forAll(all, i)
    {
        if (all[i] == 0) continue;
        ++mixture.samples;
        deviation += all[i]*sqr(ofMaterial[i]/all[i] - mixture.share);
    }
    mixture.perSample = number/mixture.samples;
    const scalar segregated = mixture.share*(1 - mixture.share), random = segregated/mixture.perSample;
    if (segregated > random) mixture.index = (segregated - deviation/number)/(segregated - random);
    return mixture;
}

} // namespace


MixingIndex::MixingIndex(const word& name, const Time& runTime, const dictionary& dict)
:
    GrainTable(name, runTime, dict, typeName)
{
    read(dict);
    writeHead("Lacey's mixing index", {"index", "share", "samples", "grainsPerSample"});
}


bool MixingIndex::read(const dictionary& dict)
{
    nscdCoupling::readFunction(dict, [this](const input::CheckedEntries& entries)
    {
        const input::Words& names = access().materials().names();
        const std::string material = entries.choice("material", names);
        material_ = int(std::find(names.begin(), names.end(), material) - names.begin());
        const std::array<::nscd::Vec3, 2> box = entries.twoVecs("box", input::unit::length);
        lower_ = box[0];
        upper_ = box[1];
        if (!((upper_ - lower_).array() > 0).all()) entries.reject("box", "holds nothing", "its lower corner, then its upper one");
        const std::vector<long> count = entries.integers("count", 1);
        if (count.size() != 3) entries.reject("count", "does not have three numbers", "samples along each axis, as (4 4 8)");
        if (double(count[0])*double(count[1])*double(count[2]) > mostSamples) entries.reject("count", "makes too many samples", "10 million");
        for (int k = 0; k < 3; ++k) count_[k] = label(count[k]);
    });
    return GrainTable::read(dict);
}


label MixingIndex::sampleOf(const ::nscd::Vec3& position) const
{
    label sample = 0;
    for (int k = 2; k >= 0; --k)
    {
        const scalar place = (position[k] - lower_[k])/(upper_[k] - lower_[k])*count_[k];
        if (!(place >= 0 && place < count_[k])) return -1;
        sample = sample*count_[k] + label(place);
    }
    return sample;
}


bool MixingIndex::write()
{
    const label samples = count_[0]*count_[1]*count_[2];
    scalarList all(samples, scalar(0)), ofMaterial(samples, scalar(0));
    const ::nscd::Grains& grains = access().grains();
    for (std::size_t i = 0; i < grains.nOwned; ++i)
    {
        const label sample = sampleOf(grains.position[i]);
        if (sample < 0) continue;
        all[sample] += 1;
        if (grains.material[i] == material_) ofMaterial[sample] += 1;
    }
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineGather(ofMaterial, plusEqOp<scalar>());
    if (!hasFile()) return true;
    const Mixture mixture = mixtureOf(all, ofMaterial);
    writeCurrentTime(file());
    file() << tab << mixture.index << tab << mixture.share << tab << mixture.samples << tab << mixture.perSample << endl;
    return true;
}

} // namespace functionObjects
} // namespace Foam
