// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding a written time of another case, and reading its cloud without its mesh.
#include "coupling/case/input/writtenGrains.H"

#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/foamHeader.H"
#include "coupling/case/input/inputError.H"
#include "coupling/case/input/throwingErrors.H"

#include "input/dictionary/withoutTraps.hpp"

#include "Field.H"
#include "OSspecific.H"
#include "Time.H"
#include "point.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace nscdCoupling
{

namespace
{

using input::InputError;

/// A time that was written to its end, in the case itself or in parts.
struct WrittenTime
{
    scalar value;
    word name;
    std::vector<fileName> parts;   // folders that hold the folder of the time
};

/// Whether a time was completed: uniform/grainState gets its header then.
bool isComplete(const fileName& time)
{
    const fileName state = time/"uniform/grainState";
    if (!isFile(state)) return false;
    IFstream is(state);
    return readHeader(is);
}

void addTimes(const std::vector<fileName>& parts, std::vector<WrittenTime>& times)
{
    if (parts.empty()) return;
    for (const instant& at : Time::findTimes(parts[0]))
    {
        if (isComplete(parts[0]/at.name())) times.push_back({at.value(), at.name(), parts});
    }
}

std::vector<WrittenTime> writtenTimes(const fileName& folder)
{
    std::vector<WrittenTime> times;
    addTimes({folder}, times);
    std::vector<fileName> processors;
    for (label rank = 0; isDir(folder/("processor" + Foam::name(rank))); ++rank) processors.push_back(folder/("processor" + Foam::name(rank)));
    addTimes(processors, times);
    return times;
}

WrittenTime chosenTime(const fileName& folder, const input::GrainSource& source)
{
    const std::vector<WrittenTime> times = writtenTimes(folder);
    if (times.empty())
    {
        throw InputError({source.filePlace, "holds no time that nscdDEMFoam completed", folder, "a case with <time>/uniform/grainState, in it or in its processors"});
    }
    const auto isEarlier = [](const WrittenTime& a, const WrittenTime& b) { return a.value < b.value; };
    if (source.time == "latestTime") return *std::max_element(times.begin(), times.end(), isEarlier);
    const scalar wanted = std::stod(source.time);
    Words names = {"latestTime"};
    for (const WrittenTime& time : times)
    {
        if (std::abs(time.value - wanted) <= 1e-9*std::max(scalar(1), std::abs(wanted))) return time;
        names.push_back(time.name);
    }
    throw InputError({source.timePlace, "was not written", source.time, "", names});
}

/// The fields of lagrangian/grains, those of the parts one behind the other.
class WrittenCloud
{
public:
    explicit WrittenCloud(const WrittenTime& time)
    {
        for (const fileName& part : time.parts) folders_.push_back(part/time.name/"lagrangian/grains");
    }

    /// Whether a field was written that not every run has.
    bool has(const word& field) const
    {
        return std::any_of(folders_.begin(), folders_.end(), [&](const fileName& folder) { return isFile(folder/field); });
    }

    template<class Type>
    Field<Type> read(const word& field) const
    {
        DynamicList<Type> all;
        for (const fileName& folder : folders_)
        {
            // decomposePar writes nothing for a part of the mesh without grains.
            if (folders_.size() == 1 || isFile(folder/"origId")) all.append(readFile<Type>(folder/field));
        }
        if (size_ < 0) size_ = all.size();
        if (all.size() == size_) return Field<Type>(all);
        const string found = messageText(all.size(), " values"), allowed = messageText(size_, " values");
        throw InputError({placeInFile(folders_[0]/field, field), "does not fit the other files of this time", found, allowed});
    }

private:
    template<class Type>
    static Field<Type> readFile(const fileName& file)
    {
        string reason = "there is no such file";
        try
        {
            const ThrowingErrors throwing;
            IFstream is(file);
            if (readHeader(is)) return Field<Type>(is);
        }
        catch (const Foam::error& error)
        {
            reason = error.message();
        }
        throw InputError({placeInFile(file, file.name()), "cannot be read: the file is missing, truncated or damaged", reason});
    }

    std::vector<fileName> folders_;
    mutable label size_ = -1;   // of the first field that was read
};

dictionary stateOf(const WrittenTime& time)
{
    IFstream is(time.parts[0]/time.name/"uniform/grainState");
    readHeader(is);
    return dictionary(is.name(), dictionary::null, is);
}

/// Of a material at the time of writing its index among the present ones.
int materialOf(label written, const wordList& names, const input::GrainSource& source, const input::MaterialTable& materials)
{
    const word name = written >= 0 && written < names.size() ? names[written] : word("none");
    const int material = materials.table.find(name);
    if (material >= 0 && materials.density[material] > 0) return material;
    throw InputError({source.filePlace, "holds grains of a material that is unknown here or has no density", name, "", materials.grainMaterials()});
}

/// Files that are lost, or are those of another time.
void checkNumber(label found, const dictionary& state, const input::GrainSource& source)
{
    const label written = state.get<label>("grains");
    if (found == written) return;
    throw InputError({source.filePlace, "does not hold the grains that were written", messageText(found), messageText(written)});
}

void checkGrain(const point& x, scalar d, label id, const input::GrainSource& source)
{
    if (d > 0 && d < VGREAT && mag(x) < VGREAT) return;
    throw InputError({source.filePlace, messageText("holds a damaged grain, ", id), messageText("d ", d, ", position ", x), "finite positions and positive diameters"});
}

void checkOrientation(scalar w, const vector& axis, label id, const input::GrainSource& source)
{
    if (isUnitQuaternion(w, axis)) return;
    throw InputError({source.filePlace, messageText("holds a damaged grain, ", id), messageText("orientationW ", w, ", orientation ", axis), "a quaternion of length 1"});
}

scalar factorOf(scalar written, label id, const input::GrainSource& source)
{
    if (written >= 1 && written < VGREAT) return written;
    throw InputError({source.filePlace, messageText("holds a damaged grain, ", id), messageText("coarseGraining ", written), "numbers of 1 and more"});
}

/// Indices of the grains, ascending in their identities.
labelList byIdentity(const labelUList& ids)
{
    labelList order(identity(ids.size()));
    std::sort(order.begin(), order.end(), [&](label a, label b) { return ids[a] < ids[b]; });
    return order;
}

input::WrittenGrains readCloud(const WrittenTime& time, const input::GrainSource& source, const input::MaterialTable& materials)
{
    const dictionary state = stateOf(time);
    const wordList names = state.get<wordList>("materials");
    const WrittenCloud cloud(time);
    if (cloud.has("clump")) throw InputError({source.filePlace, "holds clumps, of which `time` takes the members alone", "", "a case of single grains"});
    const Field<label> id = cloud.read<label>("origId"), material = cloud.read<label>("material"), fixed = cloud.read<label>("isFixed");
    const Field<vector> x = cloud.read<vector>("position"), u = cloud.read<vector>("U"), omega = cloud.read<vector>("omega");
    const Field<vector> axis = cloud.read<vector>("orientation");
    const Field<scalar> d = cloud.read<scalar>("d"), w = cloud.read<scalar>("orientationW");
    const Field<scalar> factor = cloud.has("coarseGraining") ? cloud.read<scalar>("coarseGraining") : Field<scalar>();
    checkNumber(id.size(), state, source);
    input::WrittenGrains written;
    nscd::Grains& grains = written.grains;
    for (const label i : byIdentity(id))
    {
        if (factor.size()) written.coarseGraining.push_back(factorOf(factor[i], id[i], source));
        checkGrain(x[i], d[i], id[i], source);
        checkOrientation(w[i], axis[i], id[i], source);
        const int m = materialOf(material[i], names, source, materials);
        grains.add(toVec3(x[i]), 0.5*d[i], materials.density[m], m, id[i]);
        grains.velocity.back() = toVec3(u[i]);
        grains.omega.back() = toVec3(omega[i]);
        grains.orientation.back() = nscd::Quaternion(w[i], axis[i].x(), axis[i].y(), axis[i].z()).normalized();
        grains.isFixed.back() = fixed[i] != 0;
    }
    return written;
}

} // namespace


input::WrittenGrains grainsOfTime(const fileName& casePath, const input::GrainSource& source, const input::MaterialTable& materials)
{
    const input::WithoutTraps traps;
    const fileName path = source.file, folder = path.isAbsolute() ? path : casePath/path;
    if (!isDir(folder)) throw InputError({source.filePlace, "leads to no folder", folder, "the folder of a case"});
    return readCloud(chosenTime(folder, source), source, materials);
}

} // namespace nscdCoupling
} // namespace Foam
