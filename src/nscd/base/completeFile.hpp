// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Files that are there whole or not at all, whatever happens while they are written.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace nscd
{

/// A file written under the name <path>.part and renamed by complete(); without, nothing of it stays.
/// Errors: std::runtime_error with path and the system's reason, where it cannot be opened, written or renamed
class CompleteFile
{
public:
    explicit CompleteFile(const std::string& path);
    ~CompleteFile();
    CompleteFile(const CompleteFile&) = delete;
    CompleteFile& operator=(const CompleteFile&) = delete;

    std::ostream& stream() { return file_; }
    /// As stream().write, with the bytes of an array.
    template<class T>
    void write(const T* values, std::size_t number);

    /// Closes the file, makes sure that all of it was written, and gives it its name.
    void complete();

private:
    void check();

    std::string path_;
    std::string part_;
    std::vector<char> buffer_;
    std::ofstream file_;
    bool isComplete_ = false;
};

/// Refuses to go on after a failed write. Errors: std::runtime_error with the path and the system's reason
[[noreturn]] void failToWrite(const std::string& path);

template<class T>
void CompleteFile::write(const T* values, std::size_t number)
{
    file_.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(number*sizeof(T)));
    if (!file_) check();
}

} // namespace nscd
