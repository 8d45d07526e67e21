// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing and checking files of named arrays.
#include "nscd/base/sectionFile.hpp"

#include "nscd/base/invalidValue.hpp"

#include <algorithm>
#include <cstring>

namespace nscd
{

namespace
{

constexpr std::size_t kindLetters = 8;
constexpr std::uint64_t byteOrderMark = 0x0102030405060708ULL;

} // namespace

namespace sectionFile
{

Name::Name(const char* text)
{
    std::copy_n(text, std::min(std::strlen(text), sizeof(letters)), letters);
}

bool Name::operator==(const Name& other) const { return std::memcmp(letters, other.letters, sizeof(letters)) == 0; }

} // namespace sectionFile

void Checksum::add(const char* bytes, std::size_t number)
{
    for (std::size_t k = 0; k < number; k += 8)
    {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + k, std::min<std::size_t>(8, number - k));
        const std::uint64_t mixed = value_ ^ word;
        value_ = ((mixed << 29) | (mixed >> 35))*0x9E3779B97F4A7C15ULL;
    }
}

SectionFileWriter::SectionFileWriter(const std::string& path, const char* kind, std::uint64_t version)
:
    file_(path)
{
    put(kind, kindLetters);
    put(&byteOrderMark, sizeof(byteOrderMark));
    put(&version, sizeof(version));
}

void SectionFileWriter::put(const void* bytes, std::size_t number)
{
    const char* start = static_cast<const char*>(bytes);
    checksum_.add(start, number);
    file_.write(start, number);
}

void SectionFileWriter::complete()
{
    const std::uint64_t sum = checksum_.value();
    file_.write(&sum, 1);
    file_.complete();
}

SectionFileReader::SectionFileReader(const std::string& path, const char* kind, std::uint64_t version)
:
    path_(path),
    file_(path, std::ios::binary | std::ios::ate)
{
    const std::streamoff size = file_ ? std::streamoff(file_.tellg()) : -1;
    if (size < 0) refuse("missing or not readable");
    left_ = static_cast<std::uint64_t>(size);
    file_.seekg(0);

    char found[kindLetters] = {};
    std::uint64_t order = 0, number = 0;
    if (left_ > 0) get(found, std::min<std::uint64_t>(left_, kindLetters));
    if (std::memcmp(found, kind, kindLetters) != 0) refuse("another kind of file");
    get(&order, sizeof(order));
    if (order != byteOrderMark) refuse("from a machine of another byte order, or damaged");
    get(&number, sizeof(number));
    if (number != version) refuse("of version " + std::to_string(number));
}

void SectionFileReader::refuse(const std::string& problem) const
{
    throw invalidValue(path_, problem, "a file that is whole and as it was written by this version");
}

void SectionFileReader::get(void* bytes, std::size_t number)
{
    if (number > left_) refuse("cut short");
    char* start = static_cast<char*>(bytes);
    file_.read(start, static_cast<std::streamsize>(number));
    if (!file_) refuse("not readable to its end");
    checksum_.add(start, number);
    left_ -= number;
}

std::uint64_t SectionFileReader::beginSection(const char* name, std::size_t elementBytes)
{
    sectionFile::Name found("");
    std::uint64_t bytes = 0;
    get(&found, sizeof(found));
    get(&bytes, sizeof(bytes));
    if (!(found == sectionFile::Name(name))) refuse(std::string("damaged where '") + name + "' should begin");
    if (bytes > left_) refuse("cut short");
    if (bytes % elementBytes != 0) refuse(std::string("damaged in the size of '") + name + "'");
    return bytes;
}

void SectionFileReader::finish()
{
    const std::uint64_t expected = checksum_.value();
    std::uint64_t sum = 0;
    get(&sum, sizeof(sum));
    if (sum != expected) refuse("damaged: its checksum does not fit");
    if (left_ != 0) refuse("longer than it should be");
}

} // namespace nscd
