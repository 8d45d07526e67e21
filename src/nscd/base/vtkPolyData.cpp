// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing VTK's XML files.
#include "nscd/base/vtkPolyData.hpp"

#include "nscd/base/numberText.hpp"

#include <cstdio>
#include <stdexcept>

namespace nscd
{

namespace
{

const char* byteOrder()
{
    const int one = 1;
    return *reinterpret_cast<const char*>(&one) == 1 ? "LittleEndian" : "BigEndian";
}

/// first, first + step, ...
std::vector<std::int64_t> counting(std::size_t number, std::int64_t first, std::int64_t step)
{
    std::vector<std::int64_t> values(number);
    for (std::size_t k = 0; k < number; ++k) values[k] = first + step*static_cast<std::int64_t>(k);
    return values;
}

} // namespace

VtkPolyData::VtkPolyData(const std::vector<Vec3>& points, std::int64_t pointsOfCell, const std::string& kind)
:
    points_(points.size()),
    connectivity_(counting(points.size(), 0, 1)),
    offsets_(counting(points.size()/static_cast<std::size_t>(pointsOfCell), pointsOfCell, pointsOfCell))
{
    open("Points");
    add("position", points);
    close("Points");
    open(kind);
    add("connectivity", connectivity_);
    add("offsets", offsets_);
    close(kind);
}

VtkPolyData VtkPolyData::ofVertices(const std::vector<Vec3>& points)
{
    VtkPolyData data(points, 1, "Verts");
    data.verts_ = points.size();
    return data;
}

VtkPolyData VtkPolyData::ofLines(const std::vector<Vec3>& ends)
{
    VtkPolyData data(ends, 2, "Lines");
    data.lines_ = ends.size()/2;
    return data;
}

void VtkPolyData::open(const std::string& tag) { head_ += "      <" + tag + ">\n"; }
void VtkPolyData::close(const std::string& tag) { head_ += "      </" + tag + ">\n"; }

void VtkPolyData::declare(const std::string& name, const char* type, int components, std::uint64_t bytes)
{
    head_ += "        <DataArray type=\"" + std::string(type) + "\" Name=\"" + name + "\" NumberOfComponents=\""
        + std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(offset_) + "\"/>\n";
    offset_ += sizeof(bytes) + bytes;
}

void VtkPolyData::write(const std::string& path, double time) const
{
    CompleteFile file(path);
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

void VtkSeries::readUpTo(double time)
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
            throw std::runtime_error(where + " is not what an earlier run wrote; remove the file to go on without it");
        }
        if (given <= time) lines_.push_back(line);
    }
}

void VtkSeries::add(double time, const std::string& file)
{
    lines_.push_back("    <DataSet timestep=\"" + exact(time) + "\" file=\"" + file + "\"/>");
    CompleteFile series(path_);
    series.stream()
        << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"" << byteOrder() << "\">\n  <Collection>\n";
    for (const std::string& line : lines_) series.stream() << line << '\n';
    series.stream() << "  </Collection>\n</VTKFile>\n";
    series.complete();
}

} // namespace nscd
