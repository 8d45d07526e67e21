// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Figures of validation programs of the core as CSV, beside the program.
#pragma once

#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace bars
{

/// One table of numbers, written as it grows: a run that is cut short leaves what it has.
class CsvFile
{
public:
    /// `program` is argv[0]: the table is <program>-<name>.csv.
    CsvFile(const std::string& program, const std::string& name, const std::string& head)
    : file_(std::fopen((program + "-" + name + ".csv").c_str(), "w"))
    {
        if (!file_) throw std::runtime_error("cannot write " + program + "-" + name + ".csv");
        std::fprintf(file_, "%s\n", head.c_str());
    }
    ~CsvFile() { std::fclose(file_); }
    CsvFile(const CsvFile&) = delete;
    CsvFile& operator=(const CsvFile&) = delete;

    void row(std::initializer_list<double> values)
    {
        const char* separator = "";
        for (double value : values)
        {
            std::fprintf(file_, "%s%.8g", separator, value);
            separator = ",";
        }
        std::fprintf(file_, "\n");
        std::fflush(file_);
    }

private:
    std::FILE* file_;
};

} // namespace bars
