// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing and reading clouds.
#include "coupling/case/files/cloudFiles.H"
#include "coupling/case/files/processorNames.H"
#include "coupling/case/files/writtenFiles.H"
#include "coupling/case/input/inputError.H"
#include "coupling/case/input/throwingErrors.H"

#include "IOField.H"
#include "IOPosition.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "Time.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

void writeNow(const regIOobject& object)
{
    const Time& time = object.time();
    const auto write = [&] { return object.writeObject(time.writeFormat(), time.writeVersion(), time.writeCompression(), true); };
    writeOrRefuse(object.objectPath(), write);
}

/// In which of the two forms the points are written, and how many names of points each rank has given away: for OpenFOAM's readers.
void writeProperties(const CloudOfPoints& cloud)
{
    labelList counts(Pstream::nProcs(), Zero);
    counts[Pstream::myProcNo()] = particle::particleCount_;
    Pstream::gatherList(counts);
    Pstream::scatterList(counts);
    const fileName folder = "uniform"/cloud::prefix/cloud.name();
    IOdictionary properties(IOobject("cloudProperties", cloud.time().timeName(), folder, cloud.db(), IOobject::NO_READ, IOobject::NO_WRITE, false));
    properties.add("geometry", cloud::geometryTypeNames[cloud::geometryType::COORDINATES]);
    forAll(counts, rank)
    {
        dictionary numbers;
        numbers.add("particleCount", counts[rank]);
        properties.add(word("processor" + Foam::name(rank)), numbers);
    }
    const auto write = [&]
    {
        return properties.writeObject(IOstream::ASCII, IOstream::currentVersion, cloud.time().writeCompression(), true);
    };
    writeOrRefuse(properties.objectPath(), write);
}

/// For a cloud without points too, which readers of a case would miss otherwise.
void writePoints(const CloudOfPoints& cloud)
{
    writeNow(IOPosition<CloudOfPoints>(cloud));
    if (particle::writeLagrangianPositions) writeNow(IOPosition<CloudOfPoints>(cloud, cloud::geometryType::POSITIONS));
}

} // namespace


CloudOfPoints::CloudOfPoints(const polyMesh& mesh, const word& name)
:
    cloud(mesh, name),
    mesh_(mesh)
{
    mesh.tetBasePtIs();   // collective, so not to be left to the first point
}


IOobject CloudOfPoints::file(const word& field) const
{
    return IOobject(field, time().timeName(), *this, IOobject::NO_READ, IOobject::NO_WRITE, false);
}


CloudWriter::CloudWriter
(
    const polyMesh& mesh, const word& name, const List<vector>& positions, const labelUList& cells, const labelUList& ids
)
:
    cloud_(mesh, name)
{
    forAll(positions, i) cloud_.append(new passiveParticle(mesh, positions[i], cells[i]));
    writeProperties(cloud_);
    writePoints(cloud_);
    write("origId", ids);
    write("origProcId", labelList(positions.size(), Pstream::myProcNo()));
}


template<class Type>
void CloudWriter::writeField(const word& field, const UList<Type>& values) const
{
    writeNow(IOField<Type>(cloud_.file(field), Field<Type>(values)));
}


void CloudWriter::write(const word& field, const UList<scalar>& values) const { writeField(field, values); }
void CloudWriter::write(const word& field, const UList<vector>& values) const { writeField(field, values); }
void CloudWriter::write(const word& field, const UList<label>& values) const { writeField(field, values); }


CloudReader::CloudReader(const polyMesh& mesh, const word& name)
:
    mesh_(mesh),
    name_(name),
    // decomposePar writes nothing for a part of the mesh without points.
    isAbsent_(Pstream::parRun() && !isFile(file("origId").objectPath()))
{}


IOobject CloudReader::file(const word& field) const
{
    return IOobject
    (
        field, mesh_.time().timeName(), cloud::prefix/name_, mesh_, IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
}


template<class Type>
Field<Type> CloudReader::read(const word& field) const
{
    if (isAbsent_) return Field<Type>();
    const Place place = placeInFile(file(field).objectPath(), field);
    string reason;
    Field<Type> values;
    try
    {
        const ThrowingErrors throwing;
        values = IOField<Type>(file(field));
    }
    catch (const Foam::error& error)
    {
        reason = error.message();
    }
    if (!reason.empty()) fail({place, "cannot be read for the restart: the file is missing, truncated or damaged", reason});
    if (size_ < 0) size_ = values.size();
    if (values.size() != size_)
    {
        fail
        ({
            place, "does not fit the other files of this time", Foam::name(values.size()) + " values",
            Foam::name(size_) + " values"
        });
    }
    return values;
}


scalarField CloudReader::scalars(const word& field) const { return read<scalar>(field); }
vectorField CloudReader::vectors(const word& field) const { return read<vector>(field); }
labelList CloudReader::labels(const word& field) const { return read<label>(field); }


bool CloudReader::found(const word& field) const
{
    return returnReduce(isFile(file(field).objectPath()), orOp<bool>());
}


void CloudReader::checkTotal(const word& field, label total) const
{
    const label found = returnReduce(max(size_, label(0)), sumOp<label>());
    if (found == total) return;
    const string absent = processorsWhere(isAbsent_);
    fail
    ({
        placeInFile(file(field).objectPath(), field), "does not fit uniform/grainState: files are missing, or what moved them lost some",
        Foam::name(found) + " values" + (Pstream::parRun() ? " on all processors" : "")
            + (absent.empty() ? string() : ", no file on " + absent),
        Foam::name(total) + " values"
    });
}

} // namespace nscdCoupling
} // namespace Foam
