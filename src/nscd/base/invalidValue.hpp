// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// The one form in which the library refuses a value: name, value, what is allowed.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace nscd
{

template<class Value>
std::invalid_argument invalidValue(const std::string& name, const Value& value, const std::string& allowed)
{
    std::ostringstream text;
    text << name << " is " << value << ", allowed: " << allowed;
    return std::invalid_argument(text.str());
}

} // namespace nscd
