// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Placing grains and clumps.
#include "input/start/placement.hpp"

#include "nscd/base/stopwatch.hpp"
#include "nscd/tools/filling.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace input
{

namespace
{

/// Uniform over all orientations (Shoemake 1992), or over the turns in the plane.
nscd::Quaternion randomOrientation(const nscd::RandomNumbers& uniform, int emptyAxis)
{
    const double turn = 2.0*3.14159265358979323846;
    if (emptyAxis >= 0) return nscd::Quaternion(Eigen::AngleAxisd(turn*uniform(), Vec3::Unit(emptyAxis)));
    const double u = uniform(), a = turn*uniform(), b = turn*uniform(), p = std::sqrt(1.0 - u), q = std::sqrt(u);
    return nscd::Quaternion(p*std::sin(a), p*std::cos(a), q*std::sin(b), q*std::cos(b));
}

/// Grains on their way to whoever takes them, numbered one after the other.
struct GrainStream
{
    const PlacementTools& tools;
    const GrainTaker& take;
    nscd::Grains batch;
    bool remembers = false;       // whether a filling has to know of all that came before
    nscd::Spheres placed = {};    // of batches before
    std::int64_t taken = 0;

    std::int64_t nextId() const { return taken + static_cast<std::int64_t>(batch.size()); }

    void makeRoom()
    {
        if (batch.size() >= tools.grainsInBatch) flush();
    }

    void reserve(std::size_t more) { batch.reserve(std::min(batch.size() + more, tools.grainsInBatch)); }

    void flush()
    {
        nscd::Grains next;
        next.shape = batch.shape;
        taken = nextId();
        if (remembers) appendTo(placed);
        take(batch);
        batch = std::move(next);
    }

    void appendTo(nscd::Spheres& spheres) const
    {
        spheres.center.insert(spheres.center.end(), batch.position.begin(), batch.position.end());
        spheres.radius.insert(spheres.radius.end(), batch.radius.begin(), batch.radius.end());
    }

    nscd::Spheres soFar() const
    {
        nscd::Spheres all = placed;
        appendTo(all);
        return all;
    }
};

/// As "packing bed: ..., 3.1 s".
std::string describe(const nscd::Filling& filling, double seconds)
{
    const std::string inside = filling.interiorFraction > 0.0 ? textOf(", in its interior ", filling.interiorFraction) : "";
    const std::string work = filling.rounds > 0 ? textOf("; ", filling.rounds, filling.rounds > 1 ? " packings, " : " packing, ", filling.sweeps, " sweeps") : "";
    return textOf("filling: ", filling.grains.size(), " grains, solid fraction ", filling.solidFraction, inside, work, ", ", seconds, " s");
}

/// Adds the grains of one source.
class Placement
{
public:
    Placement(const Scene& scene, const Surroundings& around, const GrainSource& source, GrainStream& stream)
    :
        materials_(scene.materials),
        walls_(scene.walls),
        around_(around),
        source_(source),
        stream_(stream),
        turns_(nscd::randomNumbers(source.clump.seed))
    {}

    /// Of the grains that come next.
    void setFactor(double factor) const
    {
        if (stream_.tools.factors) stream_.tools.factors->setFrom(stream_.nextId(), factor);
    }

    void addLattice()
    {
        const nscd::GrainLattice& lattice = source_.lattice;
        stream_.reserve(static_cast<std::size_t>(lattice.count[0])*lattice.count[1]*lattice.count[2]);
        const auto addHere = [this](const Vec3& position, double diameter) { add(position, diameter, source_.material); };
        nscd::forEachGrain(lattice, stream_.tools.randomNumbers(lattice.seed), addHere);
    }

    void addPositions()
    {
        const std::vector<Vec3> positions = stream_.tools.readPositions(around_.pathOfGrains(source_.file), source_.filePlace);
        stream_.reserve(positions.size());
        for (const Vec3& position : positions) add(position, source_.diameter, source_.material);
    }

    void addTable()
    {
        const std::string path = around_.pathOfGrains(source_.file);
        const std::vector<TableRow> rows = readGrainTable(path, source_.filePlace);
        stream_.reserve(rows.size());
        for (const TableRow& row : rows)
        {
            add(row.position, source_.coarseGraining*row.diameter, row.material.empty() ? source_.material : materialOf(row, path));
        }
    }

    /// Grains of the sources before are in the way.
    void addFilling(std::size_t number)
    {
        const nscd::Walls& walls = stream_.tools.walls ? *stream_.tools.walls : walls_;
        double seconds = 0.0;
        const nscd::Filling filling = [&]
        {
            const nscd::Stopwatch watch(seconds);
            return fill({walls, around_.box, around_.shape, around_.midPlane, number});
        }();
        stream_.tools.tell(describe(filling, seconds));
        stream_.reserve(filling.grains.size());
        for (std::size_t i = 0; i < filling.grains.size(); ++i) add(filling.grains.center[i], 2.0*filling.grains.radius[i], source_.material);
    }

    /// As they were written, but for their numbers; grains that `motion fixed` holds here and that were free there stand still.
    void addWritten()
    {
        const WrittenGrains all = around_.grainsOfTime(source_, materials_);
        const nscd::Grains& written = all.grains;
        stream_.reserve(written.size());
        for (std::size_t i = 0; i < written.size(); ++i)
        {
            checkInPlane(written, i);
            if (!all.coarseGraining.empty()) setFactor(all.coarseGraining[i]);
            add(written.position[i], 2.0*written.radius[i], written.material[i]);
            nscd::Grains& grains = stream_.batch;
            grains.orientation.back() = written.orientation[i];
            if (source_.isFixed && !written.isFixed[i]) continue;
            grains.velocity.back() = written.velocity[i];
            grains.omega.back() = written.omega[i];
            grains.isFixed.back() = written.isFixed[i];
        }
    }

private:
    nscd::Filling fill(const nscd::FillingPlace& place) const
    {
        try
        {
            return nscd::fill(source_.filling, place, stream_.soFar());
        }
        catch (const std::invalid_argument& error)
        {
            throw InputError({source_.amountPlace, error.what()});
        }
    }

    void checkInPlane(const nscd::Grains& written, std::size_t i) const
    {
        const int axis = around_.shape.emptyAxis;
        if (axis < 0 || written.velocity[i][axis] == 0.0) return;
        throw InputError({source_.filePlace, "holds grains that move out of the plane of this mesh", textOf("grain ", written.id[i])});
    }

    void add(Vec3 position, double diameter, int material)
    {
        if (around_.shape.emptyAxis >= 0) position[around_.shape.emptyAxis] = around_.midPlane;
        position = around_.box.wrap(position);
        stream_.makeRoom();
        if (source_.clump.members.empty()) addGrain(position, diameter, material);
        else addClump(position, material);
    }

    void addGrain(const Vec3& position, double diameter, int material)
    {
        nscd::Grains& grains = stream_.batch;
        grains.add(position, 0.5*diameter, materials_.density[material], material, stream_.nextId());
        grains.velocity.back() = source_.velocity;
        grains.omega.back() = source_.omega;
        grains.isFixed.back() = source_.isFixed;
    }

    void addClump(const Vec3& position, int material)
    {
        nscd::ClumpPlacement placement;
        placement.shape = shapeOf(material);
        placement.position = position;
        if (source_.clump.isRandom) placement.orientation = randomOrientation(turns_, around_.shape.emptyAxis);
        placement.velocity = source_.velocity;
        placement.omega = source_.omega;
        placement.material = material;
        placement.firstId = stream_.nextId();
        nscd::addClump(stream_.batch, placement, around_.box);
    }

    int shapeOf(int material)
    {
        std::vector<nscd::ClumpShape>& shapes = stream_.batch.clumps.shapes;
        const auto [shape, isNew] = shapeOfMaterial_.try_emplace(material, static_cast<int>(shapes.size()));
        if (isNew) shapes.push_back(nscd::makeClumpShape(source_.clump.members, materials_.density[material], around_.shape));
        return shape->second;
    }

    int materialOf(const TableRow& row, const std::string& path) const
    {
        const int material = materials_.table.find(row.material);
        if (material >= 0 && materials_.density[material] > 0) return material;
        const Place place = {path, row.line, source_.file};
        throw InputError({place, "names a material that is unknown or has no density", row.material, "", materials_.grainMaterials()});
    }

    const MaterialTable& materials_;
    const nscd::Walls& walls_;
    const Surroundings& around_;
    const GrainSource& source_;
    GrainStream& stream_;
    nscd::RandomNumbers turns_;            // of clumps
    std::map<int, int> shapeOfMaterial_;   // index into the clumps' shapes
};

} // namespace

void PlacedFactors::setFrom(std::int64_t number, double factor)
{
    if (of(number) != factor) steps_.push_back({number, factor});
}

double PlacedFactors::of(std::int64_t number) const
{
    const auto isBefore = [](std::int64_t one, const Step& step) { return one < step.first; };
    const auto next = std::upper_bound(steps_.begin(), steps_.end(), number, isBefore);
    return next == steps_.begin() ? 1.0 : std::prev(next)->factor;
}

void placeGrains(const Scene& scene, const Surroundings& around, const PlacementTools& tools, const GrainTaker& take)
{
    const auto isFilling = [](const GrainSource& source) { return source.type == "filling"; };
    GrainStream stream{tools, take, {}, std::any_of(scene.sources.begin(), scene.sources.end(), isFilling)};
    stream.batch.shape = around.shape;
    std::size_t fillings = 0;
    for (const GrainSource& source : scene.sources)
    {
        Placement placement(scene, around, source, stream);
        placement.setFactor(source.coarseGraining);
        if (source.type == "lattice") placement.addLattice();
        if (source.type == "positionsFile") placement.addPositions();
        if (source.type == "table") placement.addTable();
        if (source.type == "time") placement.addWritten();
        if (source.type == "filling") placement.addFilling(fillings++);
    }
    stream.flush();
}

} // namespace input
