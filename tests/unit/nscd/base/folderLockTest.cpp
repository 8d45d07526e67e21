// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// A folder is held by one at a time, and by nobody who has ended.
#include "nscd/base/folderLock.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <memory>
#include <stdexcept>

TEST(FolderLock, isForOneAtATime)
{
    const std::string folder = std::filesystem::temp_directory_path()/("nscdFolderLock" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    auto lock = std::make_unique<nscd::FolderLock>(folder);
    EXPECT_THROW(nscd::FolderLock other(folder), std::runtime_error);
    lock.reset();
    EXPECT_NO_THROW(nscd::FolderLock other(folder));
    EXPECT_NO_THROW(nscd::FolderLock none(folder + "/isNotThere"));

    // One that is killed lets go.
    const pid_t child = fork();
    if (child == 0)
    {
        const nscd::FolderLock own(folder);
        raise(SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_NO_THROW(nscd::FolderLock other(folder));
    std::filesystem::remove_all(folder);
}
