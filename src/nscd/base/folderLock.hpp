// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// One run at a time in a folder.
#pragma once

#include <string>

namespace nscd
{

/// Holds a folder for this process, until it ends in whatever way. Leaves no file; where the file system knows no locks, holds nothing.
class FolderLock
{
public:
    /// Errors: std::runtime_error where another process (or another lock) holds the folder
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_;   // -1: nothing is held
};

} // namespace nscd
