// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that ParaView opens as they are: VTK's XML poly data, arrays appended as raw bytes, and a time series of them.
// Tested by tests/unit/nscdGrains/sceneRunTest.cpp, tests/unit/nscd/tools/contactFilesTest.cpp
#pragma once

#include "nscd/base/completeFile.hpp"
#include "nscd/base/vec3.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace nscd
{

template<class T> struct VtkType;
template<> struct VtkType<double> { static constexpr const char* name = "Float64"; static constexpr int components = 1; };
template<> struct VtkType<Vec3> { static constexpr const char* name = "Float64"; static constexpr int components = 3; };
template<> struct VtkType<Quaternion> { static constexpr const char* name = "Float64"; static constexpr int components = 4; };
template<> struct VtkType<int> { static constexpr const char* name = "Int32"; static constexpr int components = 1; };
template<> struct VtkType<std::int64_t> { static constexpr const char* name = "Int64"; static constexpr int components = 1; };

/// Poly data under construction; the arrays must live until write().
class VtkPolyData
{
public:
    /// Each point with a vertex of its own.
    static VtkPolyData ofVertices(const std::vector<Vec3>& points);
    /// Points 2k and 2k + 1 are the ends of line k.
    static VtkPolyData ofLines(const std::vector<Vec3>& ends);

    VtkPolyData(VtkPolyData&&) = default;

    /// Between these, arrays of points ("PointData ...") or of lines ("CellData ..."), and no others.
    void open(const std::string& tag);
    void close(const std::string& tag);

    template<class T>
    void add(const std::string& name, const std::vector<T>& values);

    /// `time` is what ParaView shows [s].
    /// Errors: std::runtime_error where the file cannot be written
    void write(const std::string& path, double time) const;

private:
    VtkPolyData(const std::vector<Vec3>& points, std::int64_t pointsOfCell, const std::string& kind);

    void declare(const std::string& name, const char* type, int components, std::uint64_t bytes);

    std::size_t points_, verts_ = 0, lines_ = 0;
    std::vector<std::int64_t> connectivity_, offsets_;
    std::string head_;
    std::uint64_t offset_ = 0;
    std::vector<std::function<void(CompleteFile&)>> writers_;
};

template<class T>
void VtkPolyData::add(const std::string& name, const std::vector<T>& values)
{
    const std::uint64_t bytes = values.size()*sizeof(T);
    declare(name, VtkType<T>::name, VtkType<T>::components, bytes);
    const T* data = values.data();
    const std::size_t number = values.size();
    writers_.push_back([data, number, bytes](CompleteFile& file)
    {
        file.write(&bytes, 1);
        file.write(data, number);
    });
}

/// A .pvd file: the times written and their files.
class VtkSeries
{
public:
    explicit VtkSeries(const std::string& path) : path_(path) {}

    /// Takes over what an earlier run listed up to a time; nothing where there is no file.
    /// Errors: std::runtime_error for a file that no VtkSeries wrote
    void readUpTo(double time);

    /// Adds a file, named relative to the series, and writes the series anew.
    void add(double time, const std::string& file);

private:
    std::string path_;
    std::vector<std::string> lines_;
};

} // namespace nscd
