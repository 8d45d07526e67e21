// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Figures of test programs as rows of a table, from which tests/accuracy/run makes its page.
#pragma once

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

namespace figures
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The table <program>.csv in the folder that ACCURACY_FOLDER names, begun anew; null where it names none.
inline std::FILE* newTable()
{
    const char* folder = std::getenv("ACCURACY_FOLDER");
    if (!folder) return nullptr;
    const std::string path = std::string(folder) + '/' + program_invocation_short_name + ".csv";
    std::FILE* table = std::fopen(path.c_str(), "w");
    if (!table) throw std::runtime_error("cannot write " + path);
    const char* origin = std::getenv("ACCURACY_ORIGIN");
    std::fprintf(table, "# SPDX-License-Identifier: GPL-3.0-or-later\n# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors\n");
    std::fprintf(table, "# origin: %s\n# larger is worse: error\n", origin ? origin : "not stated");
    std::fprintf(table, "scene,quantity,reference,error,ours,bar\n");
    return table;
}

inline std::string text(double value)
{
    if (std::isnan(value)) return "";
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    return digits;
}

/// One row. `scene` begins with the name of its case, if it has one; reference, ours and bar may be `none`. An error that is no number is
/// written as such.
inline void row(const std::string& scene, const std::string& quantity, double reference, double ours, double error, double bar)
{
    static std::FILE* const table = newTable();
    if (!table) return;
    std::fprintf(table, "\"%s\",\"%s\",%s,%.3g,%s,%s\n", scene.c_str(), quantity.c_str(), text(reference).c_str(), error, text(ours).c_str(), text(bar).c_str());
    std::fflush(table);
}

/// A row of a value that has a reference: error and bar as shares of it, unless it is 0.
inline void compared(const std::string& scene, const std::string& quantity, double ours, double reference, double tolerance)
{
    const double scale = reference == 0.0 ? 1.0 : std::abs(reference);
    row(scene, quantity, reference, ours, std::abs(ours - reference)/scale, tolerance/scale);
}

} // namespace figures
