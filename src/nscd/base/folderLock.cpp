// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The system's lock of an open folder.
#include "nscd/base/folderLock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace nscd
{

FolderLock::FolderLock(const std::string& folder)
:
    // Programs that this one starts do not inherit it.
    descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    close(descriptor_);
    throw std::runtime_error("another run is writing into the folder " + folder + ": wait for its end, or run a copy");
}

FolderLock::~FolderLock()
{
    if (descriptor_ >= 0) close(descriptor_);
}

} // namespace nscd
