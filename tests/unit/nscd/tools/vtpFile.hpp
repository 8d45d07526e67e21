// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Reads back the arrays of a .vtp file, for tests.
#pragma once

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace vtp
{

/// A file of poly data whose arrays are appended as raw bytes.
class VtpFile
{
public:
    explicit VtpFile(const std::string& path)
    {
        std::ifstream file(path);
        text_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        const std::string mark = "<AppendedData encoding=\"raw\">\n_";
        data_ = text_.find(mark);
        if (data_ == std::string::npos) throw std::runtime_error(path + " has no appended data");
        data_ += mark.size();
    }

    /// A number in the head, as NumberOfPoints.
    long number(const std::string& attribute) const { return std::stol(text_.substr(text_.find(attribute + "=\"") + attribute.size() + 2)); }

    /// T: double, int or std::int64_t, as the file has it.
    template<class T>
    std::vector<T> array(const std::string& name) const
    {
        const std::size_t found = text_.find("Name=\"" + name + "\" NumberOfComponents");
        if (found == std::string::npos || found > data_) throw std::runtime_error("no array " + name);
        const std::size_t at = data_ + std::stoul(text_.substr(text_.find("offset=\"", found) + 8));
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, &text_.at(at), sizeof(bytes));
        std::vector<T> values(bytes/sizeof(T));
        if (at + sizeof(bytes) + bytes > text_.size()) throw std::runtime_error("array " + name + " is cut off");
        if (bytes > 0) std::memcpy(values.data(), &text_[at + sizeof(bytes)], bytes);
        return values;
    }

private:
    std::string text_;
    std::size_t data_ = 0;
};

} // namespace vtp
