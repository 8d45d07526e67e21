// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing VTK's XML files.
#include "numberText.hpp"
#include "vtkFiles.hpp"

#include "nscd/base/completeFile.hpp"

#include <cstdio>
#include <functional>
#include <stdexcept>

namespace nscdGrains
{

namespace
{

using nscd::Vec3;

template<class T> struct VtkType;
template<> struct VtkType<double> { static constexpr const char* name = "Float64"; static constexpr int components = 1; };
template<> struct VtkType<Vec3> { static constexpr const char* name = "Float64"; static constexpr int components = 3; };
template<> struct VtkType<nscd::Quaternion> { static constexpr const char* name = "Float64"; static constexpr int components = 4; };
template<> struct VtkType<int> { static constexpr const char* name = "Int32"; static constexpr int components = 1; };
template<> struct VtkType<std::int64_t> { static constexpr const char* name = "Int64"; static constexpr int components = 1; };

const char* byteOrder()
{
    const int one = 1;
    return *reinterpret_cast<const char*>(&one) == 1 ? "LittleEndian" : "BigEndian";
}

/// Poly data under construction; the arrays must live until write().
class PolyData
{
public:
    PolyData(std::size_t points, std::size_t verts, std::size_t lines) : points_(points), verts_(verts), lines_(lines) {}

    void open(const std::string& tag) { head_ += "      <" + tag + ">\n"; }
    void close(const std::string& tag) { head_ += "      </" + tag + ">\n"; }

    template<class T>
    void add(const std::string& name, const std::vector<T>& values)
    {
        head_ += "        <DataArray type=\"" + std::string(VtkType<T>::name) + "\" Name=\"" + name + "\" NumberOfComponents=\""
            + std::to_string(VtkType<T>::components) + "\" format=\"appended\" offset=\"" + std::to_string(offset_) + "\"/>\n";
        const std::uint64_t bytes = values.size()*sizeof(T);
        offset_ += sizeof(bytes) + bytes;
        writers_.push_back([&values, bytes](nscd::CompleteFile& file)
        {
            file.write(&bytes, 1);
            file.write(values.data(), values.size());
        });
    }

    void write(const std::string& path, double time) const
    {
        nscd::CompleteFile file(path);
        file.stream()
            << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"" << byteOrder()
            << "\" header_type=\"UInt64\">\n  <PolyData>\n    <FieldData>\n"
            << "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">" << exact(time)
            << "</DataArray>\n    </FieldData>\n    <Piece NumberOfPoints=\"" << points_ << "\" NumberOfVerts=\"" << verts_
            << "\" NumberOfLines=\"" << lines_ << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n" << head_
            << "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_";
        for (const auto& writeArray : writers_) writeArray(file);
        file.stream() << "\n  </AppendedData>\n</VTKFile>\n";
        file.complete();
    }

private:
    std::size_t points_, verts_, lines_;
    std::string head_;
    std::uint64_t offset_ = 0;
    std::vector<std::function<void(nscd::CompleteFile&)>> writers_;
};

/// first, first + step, ...
std::vector<std::int64_t> counting(std::size_t number, std::int64_t first, std::int64_t step)
{
    std::vector<std::int64_t> values(number);
    for (std::size_t k = 0; k < number; ++k) values[k] = first + step*static_cast<std::int64_t>(k);
    return values;
}

/// What a line of contacts shows.
struct ContactArrays
{
    std::vector<Vec3> ends, force, tangentialForce;
    std::vector<double> normalForce, normalImpulse, gap;
    std::vector<std::int64_t> idA, idB;
};

ContactArrays arraysOf(const nscd::Grains& grains, const std::vector<nscd::LoadedContact>& contacts, double deltaT)
{
    ContactArrays arrays;
    for (const nscd::LoadedContact& contact : contacts)
    {
        const Vec3& center = grains.position[contact.a];
        const double reach = contact.gap + grains.radius[contact.a] + (contact.b >= 0 ? grains.radius[contact.b] : 0.0);
        const double normalImpulse = contact.impulse.dot(contact.normal);
        arrays.ends.push_back(center);
        arrays.ends.push_back(center - reach*contact.normal);
        arrays.force.push_back(contact.impulse/deltaT);
        arrays.tangentialForce.push_back((contact.impulse - normalImpulse*contact.normal)/deltaT);
        arrays.normalForce.push_back(normalImpulse/deltaT);
        arrays.normalImpulse.push_back(normalImpulse);
        arrays.gap.push_back(contact.gap);
        arrays.idA.push_back(contact.idA);
        arrays.idB.push_back(contact.idB);
    }
    return arrays;
}

} // namespace

void writeGrainsVtp(const std::string& path, double time, const nscd::Grains& grains, const std::vector<Vec3>& contactForce)
{
    const std::size_t n = grains.size();
    std::vector<double> diameter(n);
    for (std::size_t i = 0; i < n; ++i) diameter[i] = 2.0*grains.radius[i];
    const std::vector<std::int64_t> connectivity = counting(n, 0, 1), offsets = counting(n, 1, 1);
    const std::vector<int> clumpOf = nscd::clumpOfGrains(grains);

    PolyData data(n, n, 0);
    data.open("Points");
    data.add("position", grains.position);
    data.close("Points");
    data.open("Verts");
    data.add("connectivity", connectivity);
    data.add("offsets", offsets);
    data.close("Verts");
    data.open("PointData Scalars=\"d\" Vectors=\"U\"");
    data.add("d", diameter);
    data.add("U", grains.velocity);
    data.add("omega", grains.omega);
    data.add("fContact", contactForce);
    data.add("id", grains.id);
    data.add("material", grains.material);
    if (!clumpOf.empty())
    {
        data.add("clump", clumpOf);
        data.add("orientation", grains.orientation);
    }
    data.close("PointData");
    data.write(path, time);
}

void writeContactsVtp
(
    const std::string& path, double time, const nscd::Grains& grains, const std::vector<nscd::LoadedContact>& contacts, double deltaT
)
{
    const std::size_t n = contacts.size();
    const ContactArrays arrays = arraysOf(grains, contacts, deltaT);
    const std::vector<std::int64_t> connectivity = counting(2*n, 0, 1), offsets = counting(n, 2, 2);

    PolyData data(2*n, 0, n);
    data.open("Points");
    data.add("position", arrays.ends);
    data.close("Points");
    data.open("Lines");
    data.add("connectivity", connectivity);
    data.add("offsets", offsets);
    data.close("Lines");
    data.open("CellData Scalars=\"normalForce\" Vectors=\"force\"");
    data.add("normalForce", arrays.normalForce);
    data.add("tangentialForce", arrays.tangentialForce);
    data.add("force", arrays.force);
    data.add("normalImpulse", arrays.normalImpulse);
    data.add("gap", arrays.gap);
    data.add("idA", arrays.idA);
    data.add("idB", arrays.idB);
    data.close("CellData");
    data.write(path, time);
}

void TimeSeries::readUpTo(double time)
{
    std::ifstream file(path_);
    if (!file) return;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number)
    {
        double given = 0.0;
        if (line.find("<DataSet") == std::string::npos) continue;
        if (std::sscanf(line.c_str(), " <DataSet timestep=\"%lf\"", &given) != 1)
        {
            const std::string where = path_ + ", line " + std::to_string(number);
            throw std::runtime_error(where + " is not what nscdGrains wrote; remove the file to go on without it");
        }
        if (given <= time) lines_.push_back(line);
    }
}

void TimeSeries::add(double time, const std::string& file)
{
    lines_.push_back("    <DataSet timestep=\"" + exact(time) + "\" file=\"" + file + "\"/>");
    nscd::CompleteFile series(path_);
    series.stream()
        << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"" << byteOrder() << "\">\n  <Collection>\n";
    for (const std::string& line : lines_) series.stream() << line << '\n';
    series.stream() << "  </Collection>\n</VTKFile>\n";
    series.complete();
}

} // namespace nscdGrains
