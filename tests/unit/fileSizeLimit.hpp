// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// What a test has of a full disk.
#pragma once

#include <sys/resource.h>

#include <csignal>

/// While it lives, writing beyond so many bytes of a file is an error of the writer, and no signal.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        isSet_ = setrlimit(RLIMIT_FSIZE, &limit) == 0;
    }
    ~FileSizeLimit()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    void operator=(const FileSizeLimit&) = delete;

    bool isSet() const { return isSet_; }

private:
    rlimit before_;
    void (*handler_)(int);
    bool isSet_ = false;
};
