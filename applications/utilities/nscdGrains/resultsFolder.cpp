// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Looking after the folder of results.
#include "resultsFolder.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace nscdGrains
{

namespace
{

namespace fs = std::filesystem;

const char* const kinds[] = {"grains", "contacts", "state"};

/// As grains/grains.000000120.vtp: as many digits for all, so that names are in the order of steps.
std::string numbered(const std::string& kind, std::int64_t step, const char* suffix)
{
    char number[24];
    std::snprintf(number, sizeof(number), "%09lld", static_cast<long long>(step));
    return kind + "/" + kind + "." + number + suffix;
}

bool isOurs(const std::string& name, const std::string& kind)
{
    const std::string suffix = kind == "state" ? "" : ".vtp";
    const std::size_t head = kind.size() + 1;
    if (name.compare(0, head, kind + ".") != 0 || name.size() <= head + suffix.size()) return false;
    const std::string number = name.substr(head, name.size() - head - suffix.size());
    return name == kind + "." + number + suffix && number.find_first_not_of("0123456789") == std::string::npos;
}

void remove(const std::string& path)
{
    std::error_code error;
    fs::remove(path, error);
    if (error) throw std::runtime_error("cannot remove " + path + ": " + error.message());
}

/// What a killed run left under a temporary name.
void removeUnfinished(const std::string& folder, const std::string& kind)
{
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    {
        if (entry.path().extension() == ".part" && isOurs(entry.path().stem(), kind)) found.push_back(entry.path());
    }
    for (const std::string& path : found) remove(path);
}

} // namespace

std::string ResultsFolder::grains(std::int64_t step) const { return numbered("grains", step, ".vtp"); }
std::string ResultsFolder::contacts(std::int64_t step) const { return numbered("contacts", step, ".vtp"); }
std::string ResultsFolder::state(std::int64_t step) const { return numbered("state", step, ""); }

std::vector<std::string> ResultsFolder::filesOf(const std::string& kind) const
{
    std::vector<std::string> names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(full(kind), error))
    {
        const std::string name = entry.path().filename();
        if (isOurs(name, kind)) names.push_back(kind + "/" + name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

bool ResultsFolder::hasResults() const
{
    std::error_code error;
    for (const std::string& file : {report(), walls(), grainSeries(), contactSeries()})
    {
        if (fs::exists(file, error)) return true;
    }
    return std::any_of(std::begin(kinds), std::end(kinds), [this](const char* kind) { return !filesOf(kind).empty(); });
}

std::string ResultsFolder::latestState() const
{
    const std::vector<std::string> states = filesOf("state");
    return states.empty() ? "" : full(states.back());
}

void ResultsFolder::create() const
{
    for (const char* const kind : kinds)
    {
        std::error_code error;
        fs::create_directories(full(kind), error);
        if (error) throw std::runtime_error("cannot make the folder " + full(kind) + ": " + error.message());
        removeUnfinished(full(kind), kind);
    }
}

void ResultsFolder::clear() const
{
    for (const char* const kind : kinds)
    {
        for (const std::string& name : filesOf(kind)) remove(full(name));
    }
    for (const std::string& file : {report(), walls(), grainSeries(), contactSeries()}) remove(file);
}

void ResultsFolder::purgeStates(std::size_t kept) const
{
    const std::vector<std::string> states = filesOf("state");
    for (std::size_t k = 0; k + kept < states.size(); ++k) remove(full(states[k]));
}

} // namespace nscdGrains
