// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Placing grains.
#include "coupling/base/vectorConversion.H"
#include "coupling/case/input/positionFiles.H"
#include "coupling/case/start/grainPlacement.H"
#include "coupling/case/walls/patchRoles.H"

#include "Random.H"

namespace Foam
{
namespace nscdCoupling
{

namespace
{

/// Grains of all sources on their way to whoever takes them, numbered one after the other.
class GrainStream
{
public:
    GrainStream(const nscd::GrainShape& shape, const GrainTaker& take)
    :
        take_(take)
    {
        batch_.shape = shape;
    }

    /// A new grain, the last of the batch that is returned.
    nscd::Grains& add(const vector& position, scalar radius, scalar density, int material)
    {
        if (batch_.size() == grainsInBatch) flush();
        batch_.add(toVec3(position), radius, density, material, number_++);
        return batch_;
    }

    void flush()
    {
        const nscd::GrainShape shape = batch_.shape;
        take_(batch_);
        batch_ = nscd::Grains();
        batch_.shape = shape;
    }

private:
    static constexpr std::size_t grainsInBatch = 10000;

    const GrainTaker& take_;
    nscd::Grains batch_;
    std::int64_t number_ = 0;
};


/// Adds grains of one source; keeps what they have in common.
class Placement
{
public:
    Placement(const GrainProperties& properties, const GrainSource& source, const GrainSpace& space, GrainStream& stream)
    :
        materials_(properties.materials),
        source_(source),
        space_(space),
        stream_(stream)
    {}

    void add(vector position, scalar diameter, int material)
    {
        if (space_.emptyAxis >= 0) position[space_.emptyAxis] = space_.midPlane;
        nscd::Grains& grains = stream_.add(position, 0.5*diameter, materials_.density[material], material);
        grains.velocity.back() = toVec3(source_.velocity);
        grains.omega.back() = toVec3(source_.omega);
        grains.isFixed.back() = source_.isFixed;
    }

    void addPositions(const fileName& path)
    {
        for (const vector& position : readPositionsFile(path, source_.place))
        {
            add(position, source_.diameter, source_.material);
        }
    }

    void addTable(const fileName& path)
    {
        for (const TableRow& row : readGrainTable(path, source_.place))
        {
            add(row.position, row.diameter, row.material.empty() ? source_.material : materialOf(row));
        }
    }

    void addLattice()
    {
        const LatticeSettings& lattice = source_.lattice;
        Random random(lattice.seed);
        Vector<label> count = lattice.count;
        if (space_.emptyAxis >= 0) count[space_.emptyAxis] = 1;
        for (label k = 0; k < count.z(); ++k)
        {
            for (label j = 0; j < count.y(); ++j)
            {
                for (label i = 0; i < count.x(); ++i) addSite(Vector<label>(i, j, k), count, random);
            }
        }
    }

private:
    void addSite(const Vector<label>& site, const Vector<label>& count, Random& random)
    {
        const LatticeSettings& lattice = source_.lattice;
        const scalar largest = lattice.diameter*(1 + lattice.spread);
        vector position;
        for (direction k = 0; k < 3; ++k)
        {
            const scalar spacing = (lattice.upper[k] - lattice.lower[k])/count[k];
            const scalar freeGap = max(scalar(0), spacing - largest);
            const scalar shift = lattice.jitter*freeGap*(random.sample01<scalar>() - 0.5);
            position[k] = lattice.lower[k] + (site[k] + 0.5)*spacing + shift;
        }
        const scalar offset = 2*random.sample01<scalar>() - 1;
        add(position, lattice.diameter*(1 + lattice.spread*offset), source_.material);
    }

    int materialOf(const TableRow& row) const
    {
        const int material = materials_.table.find(row.material);
        if (material < 0 || materials_.density[material] <= 0)
        {
            fail
            ({
                row.place, "names a material that is unknown or has no density", row.material, string::null,
                materials_.grainMaterials()
            });
        }
        return material;
    }

    const MaterialProperties& materials_;
    const GrainSource& source_;
    const GrainSpace& space_;
    GrainStream& stream_;
};


void checkPlanarMotion(const GrainSource& source, const GrainSpace& space)
{
    if (space.emptyAxis < 0) return;
    vector inPlane = source.omega;
    inPlane[space.emptyAxis] = 0;
    if (source.velocity[space.emptyAxis] != 0 || mag(inPlane) > 0)
    {
        InputPlace place = source.place;
        fail({place, "moves grains out of the plane of a 2D case by its velocity or omega"});
    }
}

} // namespace


GrainSpace grainSpace(const GrainProperties& properties, const polyMesh& mesh)
{
    GrainSpace space;
    space.shape = grainShape(properties, mesh);
    space.emptyAxis = emptyAxis(mesh);
    if (space.emptyAxis >= 0) space.midPlane = mesh.bounds().centre()[space.emptyAxis];
    return space;
}


void placeGrains
(
    const GrainProperties& properties, const GrainSpace& space, const fileName& constantPath, const GrainTaker& take
)
{
    GrainStream stream(space.shape, take);
    for (const GrainSource& source : properties.sources)
    {
        checkPlanarMotion(source, space);
        Placement placement(properties, source, space, stream);
        const fileName path = source.file.isAbsolute() ? source.file : constantPath/source.file;
        if (source.type == "positionsFile") placement.addPositions(path);
        if (source.type == "table") placement.addTable(path);
        if (source.type == "lattice") placement.addLattice();
    }
    stream.flush();
}


void appendGrains(nscd::Grains& grains, const nscd::Grains& more)
{
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    nscd::Grains::forEachMember([&](const char*, auto array) { append(grains.*array, more.*array); });
    grains.nOwned = grains.size();
}

} // namespace nscdCoupling
} // namespace Foam
