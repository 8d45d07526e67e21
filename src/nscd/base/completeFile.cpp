// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Writing, then renaming.
#include "nscd/base/completeFile.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace nscd
{

void failToWrite(const std::string& path)
{
    const std::string reason = errno ? std::strerror(errno) : "is the disk full?";
    throw std::runtime_error("cannot write " + path + ": " + reason);
}

CompleteFile::CompleteFile(const std::string& path)
:
    path_(path),
    part_(path + ".part"),
    buffer_(std::size_t(1) << 20)
{
    errno = 0;
    file_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    file_.open(part_, std::ios::binary | std::ios::trunc);
    check();
}

CompleteFile::~CompleteFile()
{
    if (isComplete_) return;
    file_.close();
    std::remove(part_.c_str());
}

void CompleteFile::check()
{
    if (!file_) failToWrite(path_);
}

void CompleteFile::complete()
{
    file_.flush();
    check();
    file_.close();
    check();
    if (std::rename(part_.c_str(), path_.c_str()) != 0) failToWrite(path_);
    isComplete_ = true;
}

} // namespace nscd
