// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
//
// Messages between ranks, and plain values in and out of them.
#pragma once

#include <cstring>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace nscd
{

/// Bytes for a rank, or from one.
struct Message
{
    int rank = 0;
    std::vector<char> bytes;
};

/// Appends the bytes of `count` values. Eigen's types are not trivially copyable: std::array<double, 3> stands for a vector.
template<class T>
void pack(const T* values, std::size_t count, std::vector<char>& bytes)
{
    static_assert(std::is_trivially_copyable_v<T>, "messages hold plain values");
    const char* first = reinterpret_cast<const char*>(values);
    bytes.insert(bytes.end(), first, first + count*sizeof(T));
}

/// The values of a message behind those that are there already.
/// Errors: std::length_error where the bytes are no whole number of values
template<class T>
void unpack(const std::vector<char>& bytes, std::vector<T>& values)
{
    static_assert(std::is_trivially_copyable_v<T>, "messages hold plain values");
    if (bytes.size() % sizeof(T) != 0) throw std::length_error("a message holds no whole number of values");
    const std::size_t old = values.size();
    values.resize(old + bytes.size()/sizeof(T));
    if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data() + old), bytes.data(), bytes.size());
}

/// One message for each rank that occurs in `destination`, with the values for it in their order.
template<class T>
std::vector<Message> messagesByRank(const std::vector<T>& values, const std::vector<int>& destination)
{
    std::map<int, std::size_t> number;
    for (int rank : destination) ++number[rank];
    std::map<int, std::vector<char>> byRank;
    for (const auto& [rank, count] : number) byRank[rank].reserve(count*sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i) pack(&values[i], 1, byRank[destination[i]]);
    std::vector<Message> messages;
    for (auto& [rank, bytes] : byRank) messages.push_back({rank, std::move(bytes)});
    return messages;
}

/// The values of all messages, one message after the other.
template<class T>
std::vector<T> valuesOf(const std::vector<Message>& messages)
{
    std::size_t bytes = 0;
    for (const Message& message : messages) bytes += message.bytes.size();
    std::vector<T> values;
    values.reserve(bytes/sizeof(T));
    for (const Message& message : messages) unpack(message.bytes, values);
    return values;
}

} // namespace nscd
