// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Binary files of named arrays: a head, sections of {name, number of bytes, bytes}, a checksum of all before it.
#pragma once

#include "nscd/base/completeFile.hpp"

#include <cstdint>
#include <type_traits>

namespace nscd
{

/// Hash over words of eight bytes, the last of each call filled up with zeros. A word is rotated before it is multiplied, so
/// that no bit is lost at the top: a change of any one word changes the sum.
class Checksum
{
public:
    void add(const char* bytes, std::size_t number);
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037ULL;
};

class SectionFileWriter
{
public:
    /// `kind`: eight letters at the head of the file.
    SectionFileWriter(const std::string& path, const char* kind, std::uint64_t version);

    /// Elements are written as they lie in memory: plain numbers, or structs and fixed-size vectors of these without padding.
    template<class T>
    void section(const char* name, const std::vector<T>& values);

    void complete();

private:
    void put(const void* bytes, std::size_t number);

    CompleteFile file_;
    Checksum checksum_;
};

/// Reads what SectionFileWriter wrote, in the same order, and never more than the file has.
class SectionFileReader
{
public:
    /// Errors: std::invalid_argument, as all of this class, for what is not a whole, unchanged file of this kind, version and byte order
    SectionFileReader(const std::string& path, const char* kind, std::uint64_t version);

    template<class T>
    void section(const char* name, std::vector<T>& values);

    /// To be called after the last section, before anything read is used.
    void finish();

    [[noreturn]] void refuse(const std::string& problem) const;

private:
    std::uint64_t beginSection(const char* name, std::size_t elementBytes);
    void get(void* bytes, std::size_t number);

    std::string path_;
    std::ifstream file_;
    std::uint64_t left_ = 0;
    Checksum checksum_;
};

namespace sectionFile
{
/// Fixed at sixteen bytes, filled with zeros.
struct Name
{
    char letters[16] = {};
    explicit Name(const char* text);
    bool operator==(const Name& other) const;
};
}

template<class T>
void SectionFileWriter::section(const char* name, const std::vector<T>& values)
{
    static_assert(std::is_trivially_destructible<T>::value, "arrays of plain numbers only");
    const sectionFile::Name padded(name);
    const std::uint64_t bytes = values.size()*sizeof(T);
    put(&padded, sizeof(padded));
    put(&bytes, sizeof(bytes));
    put(values.data(), bytes);
}

template<class T>
void SectionFileReader::section(const char* name, std::vector<T>& values)
{
    static_assert(std::is_trivially_destructible<T>::value, "arrays of plain numbers only");
    const std::uint64_t bytes = beginSection(name, sizeof(T));
    values.resize(bytes/sizeof(T));
    get(values.data(), bytes);
}

} // namespace nscd
