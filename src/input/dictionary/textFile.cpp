// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Finding and reading files that a user names.
#include "input/dictionary/textFile.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace input
{

void checkIsFile(const std::string& path, const Place& place)
{
    namespace fs = std::filesystem;
    std::error_code error;
    if (fs::is_regular_file(path, error)) return;
    Words beside;
    const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    {
        if (entry.is_regular_file(error)) beside.push_back(entry.path().filename());
    }
    std::sort(beside.begin(), beside.end());
    throw InputError({place, "names a file that does not exist, " + path, fs::path(path).filename(), "a file that can be read", beside});
}

std::string readText(const std::string& path, const Place& place)
{
    checkIsFile(path, place);
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    std::string text(file ? static_cast<std::size_t>(file.tellg()) : 0, ' ');
    file.seekg(0);
    file.read(&text[0], static_cast<std::streamsize>(text.size()));
    if (!file) throw InputError({place, "names a file that cannot be read, " + path});
    return text;
}

} // namespace input
